"""Components that a CMakeLists.txt registers under a name which no source of their package registers."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import kept
from bringup_lint.graph.memo import memo
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Package

_REGISTERED = regex(
    r"^[ \t]*(?:RCLCPP_COMPONENTS_REGISTER_NODE|CLASS_LOADER_REGISTER_CLASS)\w{0,20}[ \t]{0,8}"
    r"\(\s{0,80}(?P<class>[\w:]+)\s{0,80}[,)]",
    re.M,
    "REGISTER_",
)
_OTHERS = regex(r"^[^/\n]{0,200}REGISTER_(?:NODE|CLASS)\w{0,20}[ \t]{0,8}\(", re.M, "REGISTER_")
"""These, and macros that make or use the macro."""
_MADE = regex(
    r"\bmake_(?:shared|unique)\s{0,8}<\s{0,8}(?:\w{1,80}::){0,8}(\w{1,80})\s{0,8}>", hints="make_shared make_unique"
)


class Unregistered(NamedTuple):
    name: Located
    """The class, as the build calls it."""
    registered: Located
    """The class that a source registers."""
    is_same: bool
    """Whether that one has another namespace only."""
    first: Located | None = None
    """Where the build registers the same class before, while nothing registers ``registered``."""
    is_spare: bool = False
    """No executable of the build and no launch file loads the component: a program makes an object of the class."""


def unregistered(files: Files, launch: Launch, package: Package) -> Iterator[Unregistered]:
    """The components of a package none of whose sources registers them, where it registers others in plain words."""
    if not package.complete or not package.plugins:
        return
    found = _registered(files, package)
    loaded = _loaded(launch, package) if found else frozenset()
    for plugin in package.plugins:
        if not found or "$" in plugin or str(plugin) in found:
            continue
        same = [each for name, each in found.items() if _class(name) == _class(plugin)]
        meant = (same or [*found.values()])[0]
        is_spare = plugin not in loaded and _class(meant) in _made(files, package)
        yield Unregistered(plugin, meant, len(same) == 1, is_spare=is_spare)
    yield from _doubled(package, found)


def _doubled(package: Package, found: dict[str, Located]) -> Iterator[Unregistered]:
    """A class that stands for another one, too: it is registered twice, and one class of the sources not at all. Twice
    with one program is a component that has a program as well."""
    first: dict[str, Located] = {}
    twice = [each for each in package.plugins if first.setdefault(str(each), each) is not each]
    left = [each for name, each in found.items() if name not in first]
    if len(twice) != 1 or len(left) != 1 or not _is_built(package, left[0]):
        return
    programs = [name for build in package.builds for name in build.main_plugins.values() if name == twice[0]]
    if len(programs) != 1 and not any("$" in name for name in first):
        yield Unregistered(twice[0], left[0], False, first[str(twice[0])])


def _is_built(package: Package, registered: Located) -> bool:
    """Whether the build names the source that registers a class, or takes all there are."""
    texts = [build.source.text for build in package.builds]
    return any(registered.span.source.basename in each or "GLOB" in each for each in texts)


def _loaded(launch: Launch, package: Package) -> frozenset[str]:
    """The components that an executable of the build or a launch file loads."""
    by_programs = (str(each) for build in package.builds for each in build.main_plugins.values())
    return frozenset(by_programs) | _launched(launch)


@kept
def _launched(launch: Launch) -> frozenset[str]:
    return frozenset(str(literal_text(node.plugin)) for node in launch.nodes if node.plugin is not None)


@memo
def _made(files: Files, package: Package) -> frozenset[str]:
    """The classes, without their namespaces, of which the sources of a package make objects by themselves."""
    below = (path for path in files.tree.walked_below(package.folder) if path.endswith(CPP))
    sources = (files.tree.read(path, judged=False) for path in below)
    return frozenset(name for source in sources if source is not None for name in _MADE.findall(source.text))


def _registered(files: Files, package: Package) -> dict[str, Located]:
    """What the sources of a package register; nothing where one of them does so in a way that is not understood."""
    found: dict[str, Located] = {}
    for path in files.tree.walked_below(package.folder):
        source = files.tree.read(path, judged=False) if path.endswith(CPP) else None
        if source is None or "REGISTER_" not in source.text:
            continue
        plain = list(_REGISTERED.finditer(source.text))
        if len(plain) < len(_OTHERS.findall(source.text)):
            return {}
        found.update((each["class"], source.located(*each.span("class"))) for each in plain)
    return found


def _class(name: str) -> str:
    return name.rpartition(":")[2]
