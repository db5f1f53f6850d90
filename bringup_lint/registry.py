"""Finds the rule files and loads them by path.

Rules live in ``rules/<family>/<rule_name>.py``: in a wheel below this package, in a checkout beside it. A rule's id
is its path. A family's files are loaded only when the tree holds something that concerns the family
(``family.toml``).
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from functools import cache
from functools import cached_property
from types import ModuleType

from bringup_lint.api import Check
from bringup_lint.api import Metadata
from bringup_lint.api import rule
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.discover import disk
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.discover.starters import STARTING
from bringup_lint.finding import Severity
from bringup_lint.graph.purpose import Purpose
from bringup_lint.importing import Loader
from bringup_lint.pattern import regex
from bringup_lint.robot import Robot
from bringup_lint.rule_index.described import Described
from bringup_lint.rule_index.described import described as read_description
from bringup_lint.rule_index.described import documentation
from bringup_lint.rule_index.described import missing_headings
from bringup_lint.rule_index.met import is_met
from bringup_lint.rule_index.stored import Index
from bringup_lint.rule_index.stored import index_of
from bringup_lint.toml import read_toml
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import Any

if TYPE_CHECKING:
    from pathlib import Path

    from bringup_lint.report import RuleDoc

DOCS = "https://bringup-lint.github.io/bringup-lint/rules/{}/"
"""Where a built-in rule is documented on the web: its page of the site."""
_KINDS = {"runners": STARTING, "launch": LAUNCH}
"""Words of ``family.toml`` that stand for several kinds."""


class RuleError(Exception):
    """A rule file that cannot be loaded, or says too little about itself."""


@dataclass(frozen=True)
class Rule:
    """A rule file, loaded or known from the index."""

    id: str
    folder: str
    file: str
    title: str
    check: Check
    metadata: Callable[[], Metadata]
    text: str | None = None
    """The documentation, where it is read already."""
    asks: frozenset[str] | None = None
    """What of the robot the file names; None where only the loaded file knows."""

    @property
    def path(self) -> Path:
        return _path(self.folder, self.file)

    @cached_property
    def meta(self) -> Metadata:
        return self.metadata()

    @cached_property
    def doc(self) -> str:
        """The documentation of the file."""
        return documentation(self.path.read_text("utf-8")) if self.text is None else self.text

    @property
    def family(self) -> str:
        return self.id.partition("/")[0]

    @property
    def builtin(self) -> bool:
        """Whether the rule came with the package, not from a user's own folder."""
        return os.path.dirname(self.folder) == builtin_folder()

    @property
    def severity(self) -> Severity:
        return self.meta.severity


@dataclass(frozen=True)
class Family:
    """A folder of rules and the kinds of source without which they have nothing to say."""

    name: str
    title: str
    description: str
    reads: frozenset[str]
    folder: str
    mentions: re.Pattern[str] | None = None
    """What a file of any kind says when it concerns the family."""
    purposes: dict[Purpose, Severity | None] = field(default_factory=dict)
    """What a purpose other than the robot makes of findings on deployment: the severity to which it lowers them, or
    None when it silences them."""
    deployment: frozenset[str] = frozenset()
    """The rule files that judge how a robot is deployed; the others hold for every file, whatever it is for."""
    test_data: Severity | None = None
    """The severity to which all findings in files that tests read are lowered."""
    unreached: Severity | None = None
    """The same in files to which nothing of the robot's own leads, or that the tree switches off."""
    joins: dict[str, frozenset[str]] = field(default_factory=dict)
    """Rule file -> kinds of other families that give this rule something to say."""
    indexed: tuple[str, ...] | None = None
    """The names of the rule files, where the index knows them."""

    def ids_for(self, robot: Robot) -> Iterator[str]:
        """The rules that can say something about the robot."""
        kinds = robot.kinds
        concerned = bool(self.reads & kinds) or not (self.reads or self.mentions)
        if not concerned and self.mentions:
            concerned = robot.mentions(self.mentions)
        if concerned or self.joins:
            for rule_id, name in self.files.items():
                if concerned or self.joins.get(name.removesuffix(".py"), frozenset()) & kinds:
                    yield rule_id

    @cached_property
    def files(self) -> dict[str, str]:
        """Rule id -> name of the file."""
        names = self.indexed
        if names is None:
            names = tuple(
                name for name in sorted(os.listdir(self.folder)) if name.endswith(".py") and name[0] not in "._"
            )
        return {f"{self.name}/{name.removesuffix('.py').replace('_', '-')}": name for name in names}

    @property
    def rule_paths(self) -> list[Path]:
        return [_path(self.folder, name) for name in self.files.values()]

    def rule_id(self, path: Path) -> str:
        return f"{self.name}/{path.stem.replace('_', '-')}"


@cache
def builtin_folder() -> str:
    package = os.path.dirname(os.path.realpath(__file__))
    packaged = os.path.join(package, "rules")
    return packaged if os.path.isdir(packaged) else os.path.join(os.path.dirname(package), "rules")


def _path(folder: str, file: str) -> Path:
    """For those who ask for more than its text: ``pathlib`` takes as long to import as forty modules."""
    from pathlib import Path

    return Path(folder, file)


def families(folders: Iterable[str]) -> list[Family]:
    """Every family below the folders. A folder without ``family.toml`` is read whatever the tree holds."""
    found = []
    for folder in folders:
        if not os.path.isdir(folder):
            raise RuleError(f"{folder} is not a folder of rules")
        for name in sorted(os.listdir(folder)):
            path = os.path.join(folder, name)
            if os.path.isdir(path) and not name.startswith((".", "_")):
                found.append(_family(path))
    return found


def _family(folder: str) -> Family:
    description = _path(folder, "family.toml")
    return _described_family(folder, read_toml(description.read_text("utf-8")) if description.is_file() else {})


def _described_family(folder: str, data: Mapping[str, Any], indexed: tuple[str, ...] | None = None) -> Family:
    name = os.path.basename(folder)
    return Family(
        name.replace("_", "-"),
        data.get("title", name),
        data.get("description", ""),
        _kinds(data.get("reads", ())),
        folder,
        regex(data["mentions"], hints=data.get("hints", "")) if "mentions" in data else None,
        _purposes(data.get("purpose", {})),
        frozenset(data.get("purpose", {}).get("rules", ())),
        Severity.INFO if data.get("purpose", {}).get("test_data") == "info" else None,
        None if data.get("purpose", {}).get("unreached") == "same" else Severity.INFO,
        {stem: _kinds(kinds) for stem, kinds in data.get("joins", {}).items()},
        indexed,
    )


def _indexed_families(folder: str, index: Index) -> list[Family]:
    """The same families as ``families`` finds, without a look at the folder."""
    names: dict[str, list[str]] = {name: [] for name in index.families}
    for file in index.rules:
        family, _, name = file.partition("/")
        names.setdefault(family, []).append(name)
    return [
        _described_family(os.path.join(folder, name), index.families.get(name, {}), tuple(names[name]))
        for name in sorted(names)
    ]


def _kinds(names: Iterable[str]) -> frozenset[str]:
    """Kinds of file; ``runners`` stands for all that start processes, ``launch`` for the launch files of ROS 2."""
    return frozenset(kind for name in names for kind in _KINDS.get(name, (name,)))


def _purposes(table: Mapping[str, Any]) -> dict[Purpose, Severity | None]:
    """``silent = ["ci"]`` and ``info = ["example"]`` of a family's ``[purpose]``."""
    lowered: dict[Purpose, Severity | None] = {Purpose(name): Severity.INFO for name in table.get("info", ())}
    return lowered | {Purpose(name): None for name in table.get("silent", ())}


def load(path: Path, rule_id: str) -> Rule:
    """Load one rule file. Raises RuleError when the file fails or lacks its metadata."""
    module = _module(str(path), rule_id)
    meta = _metadata(module, str(path))
    doc = module.__doc__ or _docstring(path)
    missing = missing_headings(doc)
    if missing:
        raise RuleError(f"{path}: the docstring lacks the heading {', '.join(missing)}")
    return Rule(rule_id, str(path.parent), path.name, _title(doc), meta.check, lambda: meta, doc)


def _module(path: str, rule_id: str) -> ModuleType:
    name = "bringup_lint_rules." + rule_id.replace("-", "_").replace("/", ".")
    module = ModuleType(name)
    module.__file__ = path
    try:
        Loader(name, path).exec_module(module)
    except Exception as error:
        raise RuleError(f"{path}: {type(error).__name__}: {error}") from error
    return module


def _metadata(module: ModuleType, path: str) -> Metadata:
    found = [value for value in vars(module).values() if isinstance(value, Metadata)]
    if len(found) != 1:
        raise RuleError(f"{path}: a rule file holds exactly one @rule, this one holds {len(found)}")
    return found[0]


def _title(doc: str) -> str:
    return doc.strip().partition("\n")[0].rstrip(".")


def described(path: Path, rule_id: str) -> Rule:
    """A rule by what its file says of itself, without what the file imports, which comes with the first check: to list
    all rules takes a sixth of the time. A file of an unusual form is loaded. Raises RuleError as ``load`` does."""
    try:
        text = path.read_text("utf-8")
        return _unloaded(str(path.parent), path.name, rule_id, read_description(text), None, documentation(text))
    except (ValueError, TypeError, KeyError):
        return load(path, rule_id)


def _unloaded(folder: str, file: str, rule_id: str, found: Described, needs: Any, doc: str | None = None) -> Rule:
    """A rule that is loaded when a robot has what it needs; all have where nothing is known of its needs."""

    loaded: list[Check] = []

    def check(robot: Any) -> Iterator[Any]:
        if needs is not None and not is_met(needs, robot):
            return iter(())
        if not loaded:
            path = os.path.join(folder, file)
            loaded.append(_metadata(_module(path, rule_id), path).check)
        return loaded[0](robot)

    def metadata() -> Metadata:
        return rule(found.severity, **found.options)(check)

    return Rule(rule_id, folder, file, found.title, check, metadata, doc, frozenset(found.asks))


def _docstring(path: Path) -> str:
    """The documentation of a rule file, which ``python -OO`` leaves out of the module."""
    import ast

    return ast.get_docstring(ast.parse(path.read_text("utf-8")), clean=False) or ""


@dataclass(frozen=True)
class Registry:
    """All rule files of the built-in folder and of the user's own ones."""

    families: list[Family]
    index: Index | None = None
    """What is known of the built-in rules."""

    @classmethod
    def of(cls, extra: Iterable[str | Path] = ()) -> Registry:
        """The built-in rules, which a process reads once, and those of a user's folders."""
        folders = list(map(str, extra))
        if folders:
            disk.depends_on_more()
        own = families(folders)
        return cls([*_builtin().families, *own], _builtin().index) if own else _builtin()

    @cached_property
    def family_of(self) -> dict[str, Family]:
        """Rule id -> family. Raises RuleError when a user's rule takes the id of another."""
        owners: dict[str, Family] = {}
        for family in self.families:
            for rule_id in family.files:
                if rule_id in owners:
                    path, other = (_path(each.folder, each.files[rule_id]) for each in (family, owners[rule_id]))
                    raise RuleError(f"{path}: the id {rule_id} is taken by {other}")
                owners[rule_id] = family
        return owners

    @property
    def paths(self) -> dict[str, Path]:
        """Rule id -> file. Raises RuleError when a user's rule takes the id of another."""
        return {rule_id: _path(family.folder, family.files[rule_id]) for rule_id, family in self.family_of.items()}

    @cached_property
    def _loaded(self) -> dict[str, Rule]:
        return {}

    def __getitem__(self, rule_id: str) -> Rule:
        """A rule, always the same. One of the index is loaded when it is first run."""
        if rule_id not in self._loaded:
            family = self.family_of[rule_id]
            found = self._from_index(family, rule_id)
            self._loaded[rule_id] = found or load(_path(family.folder, family.files[rule_id]), rule_id)
        return self._loaded[rule_id]

    def _from_index(self, family: Family, rule_id: str) -> Rule | None:
        if self.index is None or family.indexed is None:
            return None
        file = family.files[rule_id]
        entry = self.index.entry(f"{os.path.basename(family.folder)}/{file}")
        return None if entry is None else _unloaded(family.folder, file, rule_id, entry.described, entry.needs)

    def purposes(self, rule_id: str) -> Mapping[Purpose, Severity | None]:
        """What a purpose makes of the findings of a rule (``family.toml``: purpose)."""
        name = rule_id.partition("/")[2]
        found = self.family_of.get(rule_id)
        return found.purposes if found is not None and name.replace("-", "_") in found.deployment else {}

    def in_test_data(self, rule_id: str) -> Severity | None:
        """To which severity findings of a rule are lowered in files that tests read (``family.toml``: test_data)."""
        found = self.family_of.get(rule_id)
        return found.test_data if found is not None else None

    def unreached(self, rule_id: str) -> Severity | None:
        """To which severity findings of a rule are lowered in files to which nothing of the robot's own leads
        (``family.toml``: unreached)."""
        found = self.family_of.get(rule_id)
        return found.unreached if found is not None else None

    def get(self, rule_id: str) -> Rule | None:
        return self[rule_id] if rule_id in self.family_of else None

    def ids_for(self, robot: Robot) -> list[str]:
        """The rules that can say something about a robot (``family.toml``: reads, mentions, joins)."""
        return [rule_id for family in self.families for rule_id in family.ids_for(robot)]

    @cached_property
    def aliases(self) -> dict[str, str]:
        """Former name -> the rule that has it now."""
        return {alias: rule.id for rule in self.all() for alias in rule.meta.aliases}

    def all(self) -> Iterator[Rule]:
        """All rules, the built-in ones not loaded yet."""
        builtin = builtin_folder()
        for rule_id, family in self.family_of.items():
            path = _path(family.folder, family.files[rule_id])
            if os.path.dirname(family.folder) != builtin:
                yield load(path, rule_id)
            else:
                yield self._from_index(family, rule_id) or described(path, rule_id)


@cache
def _builtin() -> Registry:
    folder = builtin_folder()
    index = index_of(folder)
    return Registry(families([folder]) if index is None else _indexed_families(folder, index), index)


def doc_of(rule: Rule) -> RuleDoc:
    """A rule's documentation."""
    from bringup_lint.report import RuleDoc

    meta = rule.meta
    return RuleDoc(
        rule.id,
        rule.doc,
        meta.severity,
        meta.confidence,
        meta.fix,
        meta.since,
        meta.symptoms,
        meta.silent,
        meta.tags,
        meta.aliases,
        DOCS.format(rule.id) if rule.builtin else "",
    )
