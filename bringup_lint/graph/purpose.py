"""What a file is for: the robot itself, or development, simulation, tests, CI, examples, an archive.

The configuration decides first (``[purpose]``), then the path. A whole root file system is a robot. What a purpose
silences or lowers is said in the ``family.toml`` of each family of rules.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from collections.abc import Mapping
from enum import Enum
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.facts.ros import simulation
from bringup_lint.graph.memo import memo
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.templates import final_name
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree


class Purpose(Enum):
    ROBOT = "robot"
    DEVELOPMENT = "development"
    SIMULATION = "simulation"
    TEST = "test"
    CI = "ci"
    EXAMPLE = "example"
    ARCHIVE = "archive"


def _word(words: str, hints: str = "") -> re.Pattern[str]:
    """One of the words as a part of a path, between slashes, dots, dashes or underscores."""
    return regex(rf"(?:^|[/_.-])(?:{words})(?=[/_.-]|$)", re.I, hints)


def _folder(words: str, hints: str = "") -> re.Pattern[str]:
    return regex(rf"(?:^|/)(?:{words})/", re.I, hints)


SIMULATION = _word(
    rf"sim|{simulation.WORDS}|{simulation.SIMULATORS}|netem|mock|fake|replay|playback|rosbag2?|xil|sitl|hitl",
    f"{simulation.HINTS} netem mock fake replay playback rosbag xil sitl hitl",
)
"""Words for simulators and for recorded or made-up data."""

PATHS: tuple[tuple[Purpose, re.Pattern[str]], ...] = (
    (Purpose.CI, _folder(r"\.github|\.gitlab|\.circleci|(?:[^/]*[._-])?ci|jenkins", "github/ gitlab/ ci/ jenkins/")),
    (Purpose.CI, regex(r"[._-]ci(?=\.[a-z]+$|$)", re.I, ".ci _ci -ci")),
    (Purpose.CI, _folder(r"(?:self[_-]?hosted|actions|github|gitlab|ci)[_-]runners?", "runner")),
    (
        Purpose.ARCHIVE,
        regex(
            r"(?<!roles)(?:^|/)(?:(?:[^/]+[_-])?(?:old|archived?|deprecated|obsolete|unused|attic|backups?)|legacy"
            r"|old[_ -]?(?:docs?|files?|scripts?|code|programs?|versions?|configs?|setup|stuff)(?![a-z])[^/]{0,100}"
            r"|unported(?:[_-][^/]*)?)/",
            re.I,
            "old archive deprecated obsolete unused attic backup legacy unported",
        ),
    ),
    (
        Purpose.ARCHIVE,
        regex(
            r"[_-](?:old|deprecated|archived)(?=(?:\.[a-z]+){0,3}$)|\.(?:old|bak|orig)$",
            re.I,
            "old deprecated archived .bak .orig",
        ),
    ),
    (
        Purpose.TEST,
        _folder(
            r"tests?|testing|test_?data|test[_-][^/]*|[^/]*[_-]tests?|[^/]*fixtures?|fuzz(?:ing)?|e2e|unittests?|test(?:files|cases)[^/]*|attack[^/]*",
            "test fixture fuzz e2e attack",
        ),
    ),
    (
        Purpose.TEST,
        regex(r"(?:^|/)(?:test[_-][^/]*|attack[^/]*|[^/]*[_.-](?:tests?|testing))\.[a-z.]+$", re.I, "test attack"),
    ),
    (Purpose.TEST, _word("mitm|attacker|adversary", "mitm attacker adversary")),
    (
        Purpose.ROBOT,
        regex(
            r"(?:^|/)\.devcontainer/(?:.*/)?(?:(?:release|deploy)[^/]*dockerfile|dockerfile[._-](?:release|deploy))$",
            re.I,
            ".devcontainer/",
        ),
    ),
    (Purpose.DEVELOPMENT, _folder(r"\.?devcontainer|\.vscode", "devcontainer/ .vscode/")),
    (
        Purpose.DEVELOPMENT,
        _word("dev|devel|develop|development|devcontainer|laptop|workstation|wsl2?", "dev laptop workstation wsl"),
    ),
    (Purpose.DEVELOPMENT, _word("(?:docker|monitoring|operator|remote)[_-]pc", "-pc _pc")),
    (Purpose.DEVELOPMENT, _folder(r"(?:[^/]*[_-])?train(?:ing)?(?:[_-][^/]*)?|(?:torch|onnx)2trt", "train 2trt")),
    (Purpose.DEVELOPMENT, regex(r"(?:^|/)docker/(?:[^/]*[_-])?pc(?:[_-][^/]*)?/", re.I, "docker/")),
    (Purpose.SIMULATION, SIMULATION),
    (Purpose.EXAMPLE, _word("examples?|demos?|tutorials?|samples?", "example demo tutorial sample")),
    (Purpose.EXAMPLE, _folder("docs?", "doc/ docs/")),
    (
        Purpose.EXAMPLE,
        _folder(
            r"(?:[^/]*[_-])?(?:package|pkg|node|module|driver)[_-]template|template[_-](?:package|pkg|node|module)",
            "template",
        ),
    ),
)
"""The first pattern that a path matches decides."""

_ANY = regex(
    rf"(?:^|(?=[/_.-]))(?:{'|'.join(pattern.pattern for _, pattern in PATHS)})",
    re.I,
    " ".join(getattr(pattern, "hints", "") for _, pattern in PATHS),
)
"""One of them, all of which begin where a word may: most paths match none, which is found out sooner together."""

SOURCES: tuple[tuple[Purpose, re.Pattern[str]], ...] = (
    (Purpose.TEST, regex(r"(?:^|[/_-])tests?(?:[/_.-]|$)|(?:^|/)(?:testing|integration_tests?)/", re.I)),
    (Purpose.EXAMPLE, regex(r"(?:^|[/_-])(?:examples?|demos?|tutorials?|samples?|benchmarks?)(?:[/_.-]|$)", re.I)),
    (Purpose.EXAMPLE, _folder(r"docs?|tools|(?<!src/)tool")),  # src/tool/ beside src/arm/: what the arm holds
    (Purpose.SIMULATION, regex(rf"(?:^|[/_-])(?:{simulation.WORDS}|{simulation.SIMULATORS})(?:[/_.-]|$)", re.I)),
)
"""The same for the path of a node's source in its package, where more folders hold what no robot runs."""


_DEVCONTAINER = _folder(r"\.devcontainer")
_RESTARTS = regex(r"^[ \t]*restart:[ \t]*[\"']?(?:always|unless-stopped|on-failure)", re.M, hints="restart:")
_STARTS_ROS = regex(r"\bros2[ \t]+(?:launch|run)\b", hints="ros2")


def _starts_by_itself(compose: Source) -> bool:
    """Whether services of a compose file run nodes, and come back after each boot: nobody develops in these."""
    return compose.says(_RESTARTS) and compose.says(_STARTS_ROS)


_TEST_DATA = _folder(r"tests?|test[_-]?data|test[_-]?(?:files|cases)[^/]*|[^/]*fixtures?|fuzz(?:ing)?|e2e|unittests?")
"""Folders for what tests read, which is often wrong on purpose."""

_COPIED = ("systemd-unit", "systemd-dropin")
"""Kinds of which people copy a sample as it is: that it is called one says nothing."""

_VERSION = regex(r"[vV]?\d{1,4}\.\d{1,4}\.\d{1,4}")


def _version(name: str) -> tuple[int, ...]:
    return tuple(map(int, name.lstrip("vV").split(".")))


def by_path(path: str) -> Purpose:
    """What the words of a path, relative to the top of the tree, say."""
    if _ANY.search(path) is None:
        return Purpose.ROBOT
    return next((purpose for purpose, pattern in PATHS if pattern.search(path)), Purpose.ROBOT)


def of_source(path: str, general: Purpose) -> Purpose:
    """What the path of a node's source in its package says; ``general`` is what the path of the file says."""
    return next((purpose for purpose, pattern in SOURCES if pattern.search(path)), general)


def by_names(names: Iterable[str]) -> Purpose:
    """What names of a service, a profile or a program say."""
    found = (by_path(name) for name in names)
    return next((purpose for purpose in found if purpose is not Purpose.ROBOT), Purpose.ROBOT)


@dataclass(eq=False)
class Purposes:
    """The purposes of the files of one tree. ``configured`` maps files and folders, relative to where the command
    runs, to the name of a purpose."""

    tree: Tree
    configured: Mapping[str, str] = field(default_factory=dict)

    @memo
    def of(self, source: Source) -> Purpose:
        own = self._configured(source)
        if own is not None:
            return own
        if self.tree.root is not None:
            return Purpose.ROBOT
        path = self._path(source)
        if source.kind in _COPIED:
            path = final_name(path)
        if self._is_superseded(path):
            return Purpose.ARCHIVE
        found = by_path(path)
        is_started = found is Purpose.DEVELOPMENT and source.kind == "compose" and _starts_by_itself(source)
        return Purpose.ROBOT if is_started and _DEVCONTAINER.search(path) else found

    def is_test_data(self, source: Source) -> bool:
        """Whether a file lies where tests keep what they read. The configuration may say that it is the robot's."""
        if self.of(source) is Purpose.ROBOT:
            return False
        return self._configured(source) is None and bool(_TEST_DATA.search(self._path(source)))

    def is_configured(self, source: Source) -> bool:
        """Whether the configuration says what a file is for."""
        return self._configured(source) is not None

    def _is_superseded(self, path: str) -> bool:
        """Whether a folder of the path is called after a version, and one beside it after a newer one."""
        folders = path.split("/")[:-1]
        for at, name in enumerate(folders):
            newest = self._newest.get("/".join(folders[:at])) if _VERSION.fullmatch(name) else None
            if newest is not None and _version(name) < newest:
                return True
        return False

    @cached_property
    def _newest(self) -> dict[str, tuple[int, ...]]:
        """Folder -> the newest version after which a folder in it is called."""
        found: dict[str, tuple[int, ...]] = {}
        for source in self.tree.sources:
            folders = self._path(source).split("/")[:-1]
            for at, name in enumerate(folders):
                if _VERSION.fullmatch(name):
                    above = "/".join(folders[:at])
                    found[above] = max(found.get(above, ()), _version(name))
        return found

    def _configured(self, source: Source) -> Purpose | None:
        """What the configuration says of the file, or of the nearest of its folders."""
        path = os.path.normpath(source.name) if self.configured else ""
        while path not in ("", "/", "."):
            if path in self._by_path:
                return self._by_path[path]
            path = os.path.dirname(path)
        return None

    @cached_property
    def _by_path(self) -> dict[str, Purpose]:
        return {os.path.normpath(path): Purpose(name) for path, name in self.configured.items()}

    def _path(self, source: Source) -> str:
        """The path below the folder that holds the whole tree: where a checkout lies says nothing about its files."""
        if not os.path.isabs(source.name):
            return source.name
        return os.path.relpath(source.name, self._top)

    @cached_property
    def _top(self) -> str:
        folders = {os.path.dirname(source.absolute) for source in self.tree.sources}
        return os.path.commonpath(folders) if folders else "/"
