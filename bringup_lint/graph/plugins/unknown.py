"""Plugins that files name and that no package exports under this name."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from collections.abc import Iterator
from functools import cache
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.facts import table
from bringup_lint.facts.ros import distros
from bringup_lint.graph.plugins.exports import exports
from bringup_lint.graph.plugins.unbrought import Unbrought
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.urdf import Description
from bringup_lint.parsers.urdf import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.spelling import nearest
from bringup_lint.spelling import numbered

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.workspace import Workspace

_NAME = regex(r"(?P<package>[a-z][a-z0-9_]*)(?:/|::)(?:\w+(?:/|::))*(?P<class>\w+)\Z")
_KEYS = ("plugin", "type")
_RENAMED = {
    "nav2_recoveries": "nav2_behaviors",
    "fake_components": "mock_components",
    "joint_state_controller": "joint_state_broadcaster",
}
"""Packages whose successor has the same classes, but for the name of the package in them."""
_CLEAR = 3
"""How many names of a distribution there must be for each name that it does not have."""
_DEAD = ("recoveries_server",)
"""Nodes that a newer distribution starts no more: what their blocks name is never loaded."""


class UnknownPlugin(NamedTuple):
    name: Located
    package: str
    exported: Located | str | None
    """The name that is meant; with its place when a package of the tree exports it."""
    distribution: str | None
    """The distribution that has no such name; None when a package of the tree should have it, or none has it."""
    loaded: bool
    """A description of the robot, or a parameter file that a launch file loads or another file names, and there no
    section that is switched off or that no list of plugins has."""
    unbrought: bool = False
    """Nothing of the tree declares, builds, fetches or installs the package."""


class Named:
    """The plugins that files name."""

    def __init__(self, files: Files, workspace: Workspace, params: Callable[[], Params]) -> None:
        self._files = files
        self._workspace = workspace
        self._params = params

    @cached_property
    def descriptions(self) -> list[Description]:
        return self._files.parsed(parse, (each for each in self._files.of_kind("urdf") if each.judged))

    @cached_property
    def _exported(self) -> dict[str, dict[str, Located]]:
        return exports(self._files.tree, self._workspace)

    @cached_property
    def unknown(self) -> list[UnknownPlugin]:
        found = (self._unknown(name, loaded) for name, loaded in self._named())
        return [each for each in found if each is not None]

    def _named(self) -> Iterator[tuple[Located, bool]]:
        for description in self.descriptions:
            yield from ((name, True) for name in description.plugins)
        if not self._files.of_kind("params"):
            return
        params = self._params()
        for file, parameter in params.parameters:
            value = parameter.value.data
            if parameter.name.rpartition(".")[2] in _KEYS and isinstance(value, str):
                if parameter.block.key.rpartition("/")[2] not in _DEAD:
                    is_loaded = params.is_used(file) and not params.is_switched_off(parameter)
                    yield Located(value, parameter.span), is_loaded

    def _unknown(self, name: Located, loaded: bool) -> UnknownPlugin | None:
        match = _NAME.match(name)
        if match is None or any(name in classes for classes in self._exported.values()):
            return None
        package = match["package"]
        if package in self._workspace.packages or package in self._workspace.ambiguous:
            return self._unknown_in_tree(name, package, match["class"], loaded)
        distributions = self._distributions(name)
        distribution = distributions[-1] if distributions else None
        known = frozenset().union(*map(_known, distributions)) if distributions else _known(None)
        if str(name) in known:
            return None
        meant = _meant(known, package, match["class"]) or _misspelt(name)
        if meant is not None:
            return UnknownPlugin(name, package, meant, distribution, loaded)
        is_public = any(each.startswith((f"{package}::", f"{package}/")) for each in _distributions())
        if is_public or not loaded or name.span.source.kind == "urdf" or not self._unbrought.is_unbrought(package):
            return None
        same = [each for each in known if each.endswith((f"/{match['class']}", f":{match['class']}"))]
        meant = same[0] if len(same) == 1 else None
        return UnknownPlugin(name, package, meant, None, loaded, unbrought=True)

    def _distributions(self, name: Located) -> list[str]:
        """Those that a name has to be in one of, oldest first: that in the path of the file, of the robot, or that the
        other names mean, else all that the tree names, where the table has them."""
        by_path = distros.named_in(name.span.source.name)
        one = by_path or self._files.target.ros or self._implied.get(name.span.path)
        if one is not None:
            return [one]
        named = self._files.target.named
        return [each for each in distros.supported() if each in named] if named <= _in_table() else []

    @cached_property
    def _unbrought(self) -> Unbrought:
        return Unbrought(self._files.tree, self._workspace)

    @cached_property
    def _implied(self) -> dict[str, str]:
        """The files whose names no single distribution has, each with the one that has all names but one or two."""
        found: dict[str, set[str]] = {}
        for name, _ in self._named():
            if str(name) in _distributions():
                found.setdefault(name.span.path, set()).add(str(name))
        implied = {path: _implied_by(names) for path, names in found.items()}
        return {path: distribution for path, distribution in implied.items() if distribution is not None}

    def _unknown_in_tree(self, name: Located, package: str, cls: str, loaded: bool) -> UnknownPlugin | None:
        classes = self._exported.get(package, {})
        if not classes:
            return None
        same = [each for each in classes.values() if each.endswith((f"/{cls}", f":{cls}"))]
        meant = same[0] if len(same) == 1 else next(iter(nearest(name, classes.values(), 4)), None)
        return UnknownPlugin(name, package, meant, None, loaded)


def _known(distribution: str | None) -> frozenset[str]:
    """The names that the packages of the table export in a distribution; in any when it is not known."""
    rows = (row for row in table("ros/plugins") if distribution is None or distribution in row["distributions"].split())
    return frozenset(row["name"] for row in rows)


@cache
def _in_table() -> frozenset[str]:
    return frozenset().union(*_distributions().values())


@cache
def _distributions() -> dict[str, frozenset[str]]:
    """Name -> the distributions that have it."""
    return {row["name"]: frozenset(row["distributions"].split()) for row in table("ros/plugins")}


def _implied_by(names: set[str]) -> str | None:
    """The distribution that most names mean, where no distribution has all of them."""
    counts = Counter(each for name in names for each in _distributions()[name])
    most = max(counts.values(), default=0)
    is_clear = most < len(names) and most >= _CLEAR * (len(names) - most)
    best = [each for each, count in counts.items() if count == most]
    missing = {name for name in names for each in best[:1] if each not in _distributions()[name]}
    is_one = all(name not in _known(each) for each in best for name in missing)
    return min(best) if is_clear and is_one else None


def _meant(known: frozenset[str], package: str, cls: str) -> str | None:
    """The same class in the package itself, or in the one that replaced it; else one of nearly the same name."""
    packages = {package, _RENAMED.get(package, package)}
    packages |= {old for old, new in _RENAMED.items() if new == package}
    cls = cls.replace("JointStateController", "JointStateBroadcaster")
    found = sorted(each for each in known if (match := _NAME.match(each)) and match["package"] in packages)
    same = next((each for each in found if each.endswith((f"/{cls}", f":{cls}"))), None)
    return same or next(iter(_nearest(package, cls, found)), None)


def _misspelt(name: str) -> str | None:
    """The name of any distribution that is a letter away from one which none has."""
    near = nearest(name, sorted(_distributions()), 1) if name not in _distributions() else []
    return near[0] if len(near) == 1 and not numbered(near[0], name) else None


def _nearest(package: str, cls: str, names: list[str]) -> list[str]:
    """The names of a package whose class is misspelt, the first of each class."""
    classes: dict[str, str] = {}
    for each in names:
        if each.startswith(package):
            classes.setdefault(_class(each), each)
    return [classes[each] for each in nearest(cls, classes, 2)]


def _class(name: str) -> str:
    return name.rpartition("/")[2].rpartition(":")[2]
