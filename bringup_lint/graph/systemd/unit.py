"""A unit as systemd would load it: the file that wins, then its drop-ins."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.facts.systemd.directives import SECTION_OF_TYPE
from bringup_lint.graph.systemd.identity import Identity
from bringup_lint.graph.systemd.settings import Setting
from bringup_lint.graph.systemd.settings import setting_of
from bringup_lint.model.unit import Assignment
from bringup_lint.model.unit import Section
from bringup_lint.model.unit import UnitFile
from bringup_lint.parsers.systemd_values import parse_bool
from bringup_lint.parsers.systemd_values import parse_timespan
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.type_names import TypeVar

Value = TypeVar("Value")

DEPENDENCIES = frozenset(
    {
        "After",
        "Before",
        "BindsTo",
        "Conflicts",
        "JoinsNamespaceOf",
        "OnFailure",
        "OnSuccess",
        "PartOf",
        "PropagatesReloadTo",
        "PropagatesStopTo",
        "ReloadPropagatedFrom",
        "Requires",
        "RequiresMountsFor",
        "Requisite",
        "StopPropagatedFrom",
        "Upholds",
        "Wants",
        "WantsMountsFor",
    }
)
"""Settings that an empty assignment does not reset (systemd.unit(5))."""


@dataclass(eq=False)
class Unit:
    """One unit of one manager, with its settings merged."""

    name: str
    manager: str
    """``system`` or ``user``."""
    fragment: UnitFile | None = None
    """The unit file; None when the tree holds only drop-ins for a unit of the distribution."""
    dropins: list[UnitFile] = field(default_factory=list)
    """In the order in which they apply."""
    masked: Source | None = None
    """The link to /dev/null or the empty file that masks the unit."""
    aliases: list[str] = field(default_factory=list)
    place: str = ""
    """The overlay root or folder that the unit belongs to; tells variants of one name apart."""

    @cached_property
    def type(self) -> str:
        return self.name.rpartition(".")[2]

    @cached_property
    def stem(self) -> str:
        return self.name.rpartition(".")[0]

    @cached_property
    def section(self) -> str:
        """The section of the unit's own type, e.g. ``Service``; empty for a target."""
        return SECTION_OF_TYPE.get(self.type, "")

    @property
    def is_template(self) -> bool:
        return self.stem.endswith("@")

    @property
    def instance(self) -> str:
        """What is between ``@`` and the type; empty for a template and for a plain unit."""
        return self.stem.partition("@")[2]

    @cached_property
    def files(self) -> list[UnitFile]:
        return [*filter(None, [self.fragment]), *self.dropins]

    @property
    def judged(self) -> bool:
        return any(file.source.judged for file in self.files)

    @property
    def uncertain(self) -> bool:
        """Whether a setting that is not there may still come from a template's control flow."""
        return any(file.uncertain for file in self.files)

    @property
    def complete(self) -> bool:
        """Whether everything that the unit sets is in the tree, so that a setting that is not there is not
        set."""
        return self.fragment is not None and not self.uncertain

    @property
    def editable(self) -> bool:
        """Whether a fix may change its files: they are no templates."""
        return not any(file.source.template for file in self.files if file.source.judged)

    @property
    def where(self) -> Span:
        """The header that a finding about the whole unit points at: [Service] and the like, else the first
        section."""
        for file in self.files:
            if not file.source.judged:
                continue
            named = [section for section in file.sections if section.name == self.section]
            for section in named or file.sections:
                return section.header
        source = self.files[0].source if self.files else self.masked
        if source is None:
            raise LookupError(f"{self.name} has no file")
        return source.whole

    @cached_property
    def _settings(self) -> dict[tuple[str, str], list[Assignment]]:
        settings: dict[tuple[str, str], list[Assignment]] = {}
        for file in self.files:
            for assignment in file.assignments:
                settings.setdefault((assignment.section, assignment.key), []).append(assignment)
        return settings

    def assignments(self, key: str, section: str | None = None) -> list[Assignment]:
        """Every line that assigns the key, in the order in which they apply, resets included."""
        return self._settings.get((self._section_of(key, section), key), [])

    def _section_of(self, key: str, section: str | None) -> str:
        if section is not None:
            return section
        return "Unit" if key in DEPENDENCIES else self.section

    def values(self, key: str, section: str | None = None) -> list[Located]:
        """The values of a list setting; an empty assignment resets it, except for dependencies. ``section``
        is
        [Unit] for dependencies and the unit type's own section for other keys unless it is given."""
        assignments = self.assignments(key, section)
        if not assignments:
            return []
        values: list[Located] = []
        for assignment in assignments:
            if assignment.value:
                values.append(assignment.value)
            elif key not in DEPENDENCIES:
                values.clear()
        return values

    @property
    def reset_lines(self) -> Iterator[Assignment]:
        """The lines of list settings that a later empty assignment takes back."""
        for (_, key), assignments in self._settings.items():
            last = max((at for at, one in enumerate(assignments) if not one.value), default=0)
            if key not in DEPENDENCIES:
                yield from assignments[:last]

    def get(self, key: str, section: str | None = None) -> Located | None:
        """The value of a scalar setting as written: the last assignment, or None when it is unset or reset. For
        booleans, numbers and times see ``flag``, ``setting`` and ``seconds``."""
        assignments = self.assignments(key, section)
        return assignments[-1].value or None if assignments else None

    def flag(self, key: str, section: str | None = None) -> Setting[bool]:
        """A boolean."""
        return self.setting(parse_bool, key, section=section)

    def seconds(self, *keys: str, section: str | None = None) -> Setting[float]:
        """A time span in seconds; several keys are spellings of one setting (TimeoutSec= and TimeoutStopSec=)."""
        return self.setting(parse_timespan, *keys, section=section)

    def setting(self, read: Callable[[str], Value | None], *keys: str, section: str | None = None) -> Setting[Value]:
        """The last assignment to one of the keys that ``read`` accepts (it gives None for what systemd ignores)."""
        return self.setting_of(read, *((key, self._section_of(key, section)) for key in keys))

    def setting_of(self, read: Callable[[str], Value | None], *keys: tuple[str, str]) -> Setting[Value]:
        """The same for (key, section) pairs, for settings that have moved from one section to another."""
        set_here = [found for key, section in keys if (found := self._settings.get((section, key)))]
        if len(set_here) < 2:
            return setting_of(set_here[0] if set_here else (), read)
        lines = (line for file in self.files for line in file.assignments)
        return setting_of((line for line in lines if (str(line.key), str(line.section)) in keys), read)

    @cached_property
    def identity(self) -> Identity:
        """Who its processes run as."""
        user, dynamic = self.get("User"), self.flag("DynamicUser")
        return Identity(
            self.name,
            self.manager,
            user,
            dynamic,
            self.get("Group"),
            tuple(self.words("SupplementaryGroups")),
            opaque=user is not None and self.is_opaque(user),
            certain=not self.uncertain and (self.fragment is not None or user is not None or bool(dynamic)),
        )

    def words(self, key: str, section: str | None = None) -> list[Located]:
        """The blank-separated words of a list setting."""
        known = self._words.get((key, section))
        if known is None:
            values = self.values(key, section)
            if not values:
                return []
            known = self._words[key, section] = [word for value in values for word in value.words()]
        return list(known)

    @cached_property
    def _words(self) -> dict[tuple[str, str | None], list[Located]]:
        """The words of the list settings that the unit has."""
        return {}

    def naming(self, key: str, *names: str, section: str | None = None) -> Iterator[tuple[Assignment, Located]]:
        """The lines of a list setting that hold one of the words, with the word."""
        for assignment in self.assignments(key, section):
            for word in assignment.value.words():
                if word in names:
                    yield assignment, word

    def unsure_of(self, *keys: str, section: str | None = None) -> bool:
        """Whether these settings may hold more than is known: the unit file itself is not in the tree, or a
        template is still to be filled in."""
        if self.uncertain or self.fragment is None:
            return True
        return any(assignment.opaque for key in keys for assignment in self.assignments(key, section))

    def new_line(self, section: str, line: str) -> tuple[Span, str]:
        """The edit that adds a line to a section of the unit's file, and the section when there is none."""
        file = next(file for file in self.files if file.source.judged)
        text = file.source.text
        for found in reversed(file.sections):
            if found.name == section:
                lead = "" if text[: found.end].endswith("\n") else "\n"
                return file.source.span(found.end, found.end), f"{lead}{line}\n"
        lead = "" if text.endswith("\n") or not text else "\n"
        return file.source.span(len(text), len(text)), f"{lead}\n[{section}]\n{line}\n"

    def has(self, key: str, section: str | None = None) -> bool:
        return bool(self.values(key, section))

    def is_opaque(self, value: Located) -> bool:
        """Whether a value still holds a template's placeholder."""
        return bool(self._opaque) and value.span in self._opaque

    @cached_property
    def _opaque(self) -> frozenset[Span]:
        """Where values with placeholders are."""
        lines = (line for lines in self._settings.values() for line in lines)
        return frozenset(line.value.span for line in lines if line.opaque)

    def sections(self, name: str) -> Iterator[Section]:
        for file in self.files:
            for section in file.sections:
                if section.name == name:
                    yield section

    def __repr__(self) -> str:
        return f"<Unit {self.name}>"
