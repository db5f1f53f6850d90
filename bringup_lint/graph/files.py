"""Files: the sources of one run, and what every layer may ask of them. It knows no layer."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Mapping
from functools import cached_property
from itertools import chain
from types import FunctionType

from bringup_lint import budget
from bringup_lint.budget import OutOfTime
from bringup_lint.budget import limited
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.purpose import Purposes
from bringup_lint.graph.purpose import by_names
from bringup_lint.graph.target import Target
from bringup_lint.graph.target import find_target
from bringup_lint.graph.variants import Variants
from bringup_lint.pattern import has_one
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import TypeVar

if TYPE_CHECKING:
    from datetime import date

    from bringup_lint.discover.tree import Tree
    from bringup_lint.model.env_file import EnvFile

Model = TypeVar("Model")

_PYTHON_FILE = regex(r"(?<![\w.-])[\w.-]{1,200}\.py\b", hints=".py")
_CONFIGURES_MIDDLEWARE = regex(
    r"""CYCLONEDDS_URI["']?\s*[:=](?:[^\n]{0,300}|["']\s*)<|RMW_IMPLEMENTATION["']?\s*[:=]\s*["']?rmw_fastrtps_""",
    hints="CYCLONEDDS_URI rmw_fastrtps_",
)
_FEW = 16
"""Files that are searched for a word before a rule is loaded."""
_ROS_KINDS = (
    "launch-python",
    "launch-xml",
    "launch-yaml",
    "python-node",
    "cpp-node",
    "params",
    "cyclonedds",
    "fastdds",
    "sros2",
)


@dataclass(eq=False)
class Files:
    """What every layer may ask: the sources by kind, their models, what a file is for. It knows no layer."""

    tree: Tree
    configured_ros: str | None = None
    configured_systemd: int | None = None
    configured_purposes: Mapping[str, str] = field(default_factory=dict)
    configured_today: date | None = None
    failures: list[tuple[Source, Exception]] = field(default_factory=list)
    """Sources on which a parser failed inside."""
    unfinished: list[Source] = field(default_factory=list)
    """Sources that a parser did not end with in its time."""
    _ended: set[tuple[object, Source]] = field(default_factory=set, init=False)
    """The parsers that are not asked again about a source: each question would take the whole time anew."""
    installed: set[str] = field(default_factory=set)
    """The paths on the robot of all that scripts and plays of the tree copy or write there, of whatever kind."""

    @property
    def sources(self) -> list[Source]:
        return self.tree.sources

    @cached_property
    def _by_kind(self) -> dict[str, list[Source]]:
        by_kind: dict[str, list[Source]] = {}
        for source in self.sources:
            by_kind.setdefault(source.kind, []).append(source)
        return by_kind

    def join(self, source: Source) -> None:
        """Take in a source that comes later, of a kind that nothing asked for before."""
        self._by_kind.setdefault(source.kind, []).append(source)
        self.__dict__.pop("_by_folder", None)
        self.sources.append(source)
        self._mentioned.clear()

    def of_kind(self, *kinds: str) -> list[Source]:
        return list(chain.from_iterable(self._by_kind.get(kind, ()) for kind in kinds))

    def beside(self, source: Source) -> list[Source]:
        """The other files in the folder of one."""
        return [each for each in self._by_folder.get(os.path.dirname(source.name), ()) if each is not source]

    @cached_property
    def _by_folder(self) -> dict[str, list[Source]]:
        by_folder: dict[str, list[Source]] = {}
        for source in self.sources:
            by_folder.setdefault(os.path.dirname(source.name), []).append(source)
        return by_folder

    def parsed(self, parse: Callable[[Source], Model], sources: Iterable[Source]) -> list[Model]:
        """The models of the sources. A parser that fails costs its own source: it is noted in ``failures``, or in
        ``unfinished`` when it takes too long."""
        models = []
        for source in sources:
            if (parse, source) in self._ended:
                continue
            try:
                models.append(_model(parse, source))
            except Exception as error:
                self.failures.append((source, error))
            except OutOfTime:
                self.unfinished.append(source)
                self._ended.add((parse, source))
        return models

    @property
    def kinds(self) -> frozenset[str]:
        """The kinds of file in the tree."""
        return frozenset(self._by_kind)

    @cached_property
    def names_python(self) -> bool:
        """Whether a unit, or a script beside units, names a Python file of the tree."""
        if not self.of_kind("systemd-unit"):
            return False
        texts = (each.text for each in self.of_kind("systemd-unit", "shell-script") if ".py" in each.text)
        return any(True for text in texts for name in _PYTHON_FILE.findall(text) for _ in self.tree.named(name))

    def mentions(self, pattern: re.Pattern[str]) -> bool:
        """Whether the text of a judged file matches."""
        if pattern not in self._mentioned:
            texts = (each for each in self.sources if each.judged)
            # The answer for a pattern that is compiled for one name is not kept: there may be many.
            if isinstance(pattern, re.Pattern):
                self._mentioned[pattern] = any(pattern.search(each.said) for each in texts)
            else:
                self._mentioned[pattern] = any(each.says(pattern) for each in texts)
        return self._mentioned[pattern]

    def may_hold(self, *words: str) -> bool:
        """Whether a file may hold one of some words. Taken for granted where there are many files: there, a rule more
        costs little, and the search much."""
        return len(self.sources) > _FEW or any(has_one(source.text, words) for source in self.sources)

    @cached_property
    def _mentioned(self) -> dict[re.Pattern[str], bool]:
        """What ``mentions`` answered, as long as no source joins."""
        return {}

    @property
    def problems(self) -> list[Problem]:
        """What could not be read at all: unreadable, oversized or binary files."""
        return self.tree.problems

    @cached_property
    def today(self) -> date:
        """The day for which validity dates are judged."""
        from datetime import date

        return self.configured_today or date.today()

    @cached_property
    def target(self) -> Target:
        return find_target(self.sources, self.configured_ros, self.configured_systemd)

    @cached_property
    def is_ros(self) -> bool:
        """Whether the tree has to do with ROS 2: something of it names a distribution, configures a middleware in the
        environment, or is a kind that only ROS has."""
        return (
            self.target.ros_named
            or any(kind.startswith(_ROS_KINDS) for kind in self.kinds)
            or self.mentions(_CONFIGURES_MIDDLEWARE)
        )

    @cached_property
    def _purposes(self) -> Purposes:
        return Purposes(self.tree, self.configured_purposes)

    def purpose(self, place: Source | Located | Span, *names: str) -> Purpose:
        """What a file is for, by the configuration and its path; or something in it, by its names."""
        own = self._purposes.of(_source_of(place))
        return by_names(names) if own is Purpose.ROBOT and self.tree.root is None else own

    def is_test_data(self, place: Source | Located | Span) -> bool:
        """Whether a place is in a file that tests read."""
        return self._purposes.is_test_data(_source_of(place))

    def is_configured(self, source: Source) -> bool:
        """Whether the configuration says what a file is for."""
        return self._purposes.is_configured(source)

    @cached_property
    def variants(self) -> Variants:
        """The robots and variants that the tree holds."""
        return Variants(self.tree)

    def same_robot(self, one: Source | Located, other: Source | Located) -> bool:
        """Whether two files may be joined though neither names the other: they are for the same robot."""
        return self.variants.same_robot(_source_of(one), _source_of(other))

    def find(self, robot_path: str, asked_by: Source) -> Source | None:
        """The file at a path on the robot that another file names; none of another robot or variant.

        Of several files of this name in a repository, it is the one in the folder of the file that asks.
        """
        found = self.tree.find(robot_path) or self._of_several(robot_path, asked_by)
        return found if found is not None and self.variants.names(robot_path, asked_by, found) else None

    def _of_several(self, robot_path: str, asked_by: Source) -> Source | None:
        name = posixpath.basename(robot_path)
        several = not self.tree.complete and len(list(self.tree.named(name))) > 1
        return self.tree.beside(asked_by, name) if several and "." in name else None

    def environment_file(self, robot_path: str) -> EnvFile | None:
        """The environment file at a path on the robot, when the tree holds it."""
        from bringup_lint.parsers.env_file import parse

        source = self.tree.find(robot_path)
        return next(iter(self.parsed(parse, [source])), None) if source else None


def _model(parse: Callable[[Source], Model], source: Source) -> Model:
    """The model of a source, made once for all layers; the one of an earlier run where the source outlives a run. Only
    a function of a module is known again: one with a context may answer otherwise the next time."""
    if not isinstance(parse, FunctionType) or parse.__closure__ or parse.__name__ == "<lambda>":
        return _in_time(parse, source)
    return source.once(parse, lambda: _in_time(parse, source))


def _in_time(parse: Callable[[Source], Model], source: Source) -> Model:
    with limited(budget.FILE):
        return parse(source)


def _source_of(place: Source | Located | Span) -> Source:
    if isinstance(place, Located):
        return place.span.source
    return place if isinstance(place, Source) else place.source
