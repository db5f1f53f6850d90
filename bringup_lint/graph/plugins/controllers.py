"""Controllers that a launch file spawns, and the types that its controller manager is given."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.loads import path_of
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ParameterFile as LaunchedFile
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.launch_values import Value
    from bringup_lint.source import Located
    from bringup_lint.source import Span

_PACKAGE = "controller_manager"
_SPAWNERS = ("spawner", "spawner.py")
FILE_OPTIONS = ("-p", "--param-file")
"""Options by which a spawner gives a controller a file of parameters."""
_TYPED = (*FILE_OPTIONS, "-t", "--controller-type")
"""Options by which a spawner gives the type itself."""
_WITH_VALUE = (
    *("-c", "--controller-manager", "-n", "--namespace", "--controller-manager-timeout", "--switch-timeout"),
    *("--service-call-timeout", "--controller-ros-args", "--fallback_controllers"),
)
"""Options of the spawner with a value. Source: spawner.py of controller_manager, Humble to Kilted."""
_NAMING = (".yaml", ".yml", ".xacro", ".urdf", ".sdf", ".json", ".xml", ".em", ".j2", ".cpp", ".hpp")
"""Files that may give a controller manager its controllers."""
_DESCRIPTIONS = (".xacro", ".urdf", ".sdf")
_SIMULATED = regex(r"(?:gz|ign|gazebo)_ros2_control", hints="_ros2_control")
_PARAMETER_FILE = regex(r"(?<![\w.-])[\w.-]+\.ya?ml(?![\w.])", hints=".yaml .yml")
_FOR_ALL = frozenset(("*.type", "**.type"))
"""What a block for every node gives, and one for every node without a namespace."""
_MOST = 4000
_SEVERAL = 2


class UntypedController(NamedTuple):
    """A controller whose type the manager is not given."""

    name: Located
    spawner: Started
    manager: Started
    files: tuple[Span, ...]
    """The parameter files of the manager, where the launch file names them."""


def untyped_controllers(launch: Launch, params: Params) -> Iterator[UntypedController]:
    seen: set[tuple[Span, str]] = set()
    for expansion in launch.entries:
        managers = [node for node in expansion.nodes if is_manager(node)]
        if len(managers) != 1 or managers[0].by_default is False or managers[0].arguments:
            continue
        typed = _typed(launch, params, managers[0])
        if typed is None:
            continue
        for spawner, name in _spawned_untyped(launch, params, expansion.nodes):
            if name not in typed and (name.span, str(name)) not in seen:
                seen.add((name.span, str(name)))
                yield UntypedController(
                    name, spawner, managers[0], tuple(value.span for value in managers[0].parameters)
                )


def _spawned_untyped(launch: Launch, params: Params, nodes: Iterable[Started]) -> Iterator[tuple[Started, Located]]:
    """The controllers of spawners whose own files, where they have some, give them no type either."""
    yield from spawned(nodes)
    for node in nodes:
        if node.parameters or node.by_default is False:
            continue
        brought = _brought(launch, params, node)
        if brought is not None:
            yield from ((node, name) for name in spawned_by(node) if name not in brought)


def _brought(launch: Launch, params: Params, spawner: Started) -> set[str] | None:
    """The controllers whose type the files of a spawner give; None when it has none, or these are not all known."""
    found: set[str] | None = None
    before = ""
    for value in spawner.arguments:
        word = literal_text(value)
        if before in FILE_OPTIONS:
            names = _names(launch, params, value)
            if names is None or not _FOR_ALL.isdisjoint(names):
                return None
            found = (found or set()).union(_typed_by(names))
        elif word is None or (word.partition("=")[0] in _TYPED and word not in FILE_OPTIONS):
            return None
        before = str(word)
    return found


def _typed_by(names: Iterable[str]) -> Iterator[str]:
    """The controllers of whose parameters some give the type."""
    return (name.rpartition(".")[0] for name in names if name.endswith(".type"))


def unnamed_controllers(launch: Launch, files: Files) -> Iterator[tuple[Located, Started, Located]]:
    """Controllers that launch files without a manager of their own spawn, as for a simulator, and that nothing of the
    tree names, with the spawner and another controller of the launch that a parameter file of the tree names."""
    texts: list[tuple[str, str]] | None = None
    given: list[str] = []
    seen: set[str] = set()
    for expansion in launch.entries:
        spawns = [] if any(map(is_manager, expansion.nodes)) else list(spawned(expansion.nodes))
        if len(spawns) < _SEVERAL:
            continue
        if texts is None:
            paths = [path for path in files.tree.paths if path.endswith(_NAMING) and ".launch." not in path][:_MOST]
            sources = (files.tree.read(path, judged=False) for path in paths)
            texts = [(source.basename, source.text) for source in sources if source is not None]
            given = list(_given_in_simulation(texts))
        named = [name for _, name in spawns if any(name in text for text in given)]
        for spawner, name in spawns:
            if not named or str(name) in seen or any(name in text for _, text in texts):
                continue
            if sum(name in each.text for each in files.sources) == 1 and spawner.file.source.judged:
                seen.add(str(name))
                yield name, spawner, named[0]


def _given_in_simulation(texts: list[tuple[str, str]]) -> Iterator[str]:
    """The parameter files that the plugins of a simulator in the descriptions of a tree give to their managers."""
    descriptions = (text for name, text in texts if name.endswith(_DESCRIPTIONS) and _SIMULATED.search(text))
    given = {match[0] for text in descriptions for match in _PARAMETER_FILE.finditer(text)}
    return (text for name, text in texts if name in given)


def _is(node: Started, *executables: str) -> bool:
    return literal_text(node.package) == _PACKAGE and str(literal_text(node.executable)) in executables


def is_manager(node: Started) -> bool:
    return _is(node, "ros2_control_node")


def spawned(nodes: Iterable[Started]) -> Iterator[tuple[Started, Located]]:
    """The controllers of spawners that give the manager nothing else; newer ones hand over their own parameters."""
    for node in nodes:
        words = [literal_text(word) for word in node.arguments]
        if (
            node.parameters
            or node.by_default is False
            or any(word is None or word.partition("=")[0] in _TYPED for word in words)
        ):
            continue
        yield from ((node, name) for name in spawned_by(node))


def spawned_by(node: Started) -> Iterator[Located]:
    """The controllers of a spawner, also of one that is given their parameters."""
    if not _is(node, *_SPAWNERS):
        return
    before = ""
    for word in map(literal_text, node.arguments):
        if word == "--ros-args":
            return
        if word and not word.startswith("-") and before not in (*_WITH_VALUE, *_TYPED):
            yield word
        before = str(word)


def _typed(launch: Launch, params: Params, manager: Started) -> set[str] | None:
    """The controllers whose type the parameters of a manager give; None when these are not all known."""
    found: set[str] = set()
    for value in manager.parameters:
        names = _names(launch, params, value)
        if names is None:
            return None
        found.update(_typed_by(names))
    return found


def _names(launch: Launch, params: Params, value: Value) -> list[str] | None:
    if isinstance(value, DictValue):
        names = [text_of(key) for key, _ in value.items]
        return None if value.open or None in names else [str(name) for name in names]
    path = path_of(launch, value.file if isinstance(value, LaunchedFile) else value)
    file = params.at_path(path) if path is not None else None
    if file is None or not file.accepted:
        return None
    blocks = [f"{each.block.node_name}.type" for each in file.parameters if each.name == "type"]
    return blocks + [each.name for each in file.parameters]
