"""Values in parameter and launch files that have another type than their node declares."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.parameters import public_node
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import kept
from bringup_lint.graph.params.declared_types import of_wrong_type
from bringup_lint.graph.params.questions.joint_limits import integer_limits
from bringup_lint.graph.params.questions.public import of_wrong_public_type
from bringup_lint.graph.params.values import Item
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.params.declared import Declared
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.params.questions.launched_values import LaunchedValue
    from bringup_lint.graph.workspace import Package

_MOVEIT = "MoveIt"


class WrongType(NamedTuple):
    name: str
    """Of the parameter."""
    text: str
    """The value as written."""
    where: Span
    items: list[Item]
    """Those of an array; a single value is one."""
    package: str = ""
    """The public package of which a node declares it, or MoveIt; empty for a node of the workspace."""
    declared: Located | None = None
    """Where the workspace declares it."""
    started: Started | None = None
    """The node to which a launch file gives it."""
    is_controller: bool = False
    """The controller manager loads it, and goes on without it."""

    @property
    def node(self) -> str:
        return self.package or "the node"

    @property
    def outcome(self) -> str:
        exception = "InvalidParameterTypeException"
        if self.package == _MOVEIT:
            return f"move_group ends with {exception}, or drops the limits of the joint"
        return f"it is not loaded ({exception})" if self.is_controller else f"it exits with {exception}"


def wrong_types(params: Params, given: str, declared: str) -> Iterator[WrongType]:
    """The values of one type that a node of the workspace or a public one declares as another; arrays of them too."""
    for parameter, found, items in of_wrong_type(params, given, declared):
        yield WrongType(parameter.name, parameter.text, parameter.span, items, declared=found.place)
    for parameter, node, items in of_wrong_public_type(params, given, declared):
        yield WrongType(
            parameter.name, parameter.text, parameter.span, items, node.package, is_controller=node.is_controller
        )
    if (given, declared) == ("integer", "double"):
        for name, value in integer_limits(params):
            item = Item(given, value.integer, str(value.value), value.span, False)
            yield WrongType(name, item.text, item.span, [item], _MOVEIT)
    if params.is_typed:
        yield from _launched(params, given, declared)


def _launched(params: Params, given: str, declared: str) -> Iterator[WrongType]:
    pairs = ((given, declared), (f"{given}_array", f"{declared}_array"))
    launch = params.launch()
    for each, found, public in _declared_launched(params):
        text = ", ".join(item.text for item in each.items)
        text = f"[{text}]" if each.type.endswith("_array") else text
        if (
            found is not None
            and (each.type, found.type) in pairs
            and not _is_of_another(launch, each.node, found.place)
        ):
            yield WrongType(each.name, text, each.where, each.items, declared=found.place, started=each.node)
        if (each.type, public) in pairs:
            package = str(literal_text(each.node.package))
            yield WrongType(each.name, text, each.where, each.items, package, started=each.node)


@kept
def _declared_launched(params: Params) -> list[tuple[LaunchedValue, Declared | None, str | None]]:
    """The values of launch files, each with what the workspace declares, or the type that a public node does."""
    from bringup_lint.graph.params.questions.launched_values import launched_values

    packages = params.launch().workspace.packages
    found: list[tuple[LaunchedValue, Declared | None, str | None]] = []
    for each in launched_values(params):
        package = str(literal_text(each.node.package))
        declared = params.declared_by(package).get(each.name)
        public = _public_type(each.node, each.name) if package not in packages else None
        if declared is not None or public is not None:
            found.append((each, declared, public))
    return found


def _is_of_another(launch: Launch, started: Started, place: Located) -> bool:
    """Whether the source of another program of the package declares a parameter: that is another node."""
    package = launch.workspace.packages[str(literal_text(started.package))]
    if _is_built_into_another(package, str(literal_text(started.executable)), place.span.source.basename):
        return True
    points = package.entry_points
    modules = {name: target.partition(":")[0].rpartition(".")[2] for name, target in points.items()}
    own = modules.get(str(literal_text(started.executable)))
    declaring = place.span.source.basename.removesuffix(".py")
    return own is not None and declaring != own and declaring in modules.values()


def _is_built_into_another(package: Package, program: str, file: str) -> bool:
    """Whether CMake makes another program, and not this one, of a file."""
    for build in package.builds:
        users = {
            name for name, files in build.targets.items() if any(file == each.rpartition("/")[2] for each in files)
        }
        if program in build.targets and program not in users:
            return not users.isdisjoint(build.executables)
    return False


def _public_type(started: Started, name: str) -> str | None:
    """The type of a parameter of a public node, but not of one in the section of a plugin."""
    node = public_node(str(literal_text(started.package)), str(started.program))
    return node.type_of(name) if node is not None and not (node.has_plugins and "." in name) else None
