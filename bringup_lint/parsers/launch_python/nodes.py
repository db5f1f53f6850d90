"""Processes, nodes and components."""

from __future__ import annotations

from typing import Any

from bringup_lint.model.launch import Action
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import LoadComponents
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import OldKeyword
from bringup_lint.model.launch import Other
from bringup_lint.model.launch import Process
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Command
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.model.launch_values import Value
from bringup_lint.parsers.launch_python import freeze
from bringup_lint.parsers.launch_python.actions import conditions
from bringup_lint.parsers.launch_python.arguments import Arguments
from bringup_lint.parsers.launch_python.objects import Function
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.state import Builder
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.substitutions import parameter
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Span

_OPTIONS = (
    "respawn respawn_delay respawn_max_retries output output_format prefix cwd shell emulate_tty exec_name "
    "cached_output"
    " sigterm_timeout sigkill_timeout log_cmd arguments_file"
).split()


_NO_LISTS = (Argument, PathJoin, PackageShare, DerivedFile, ParameterFile, TypedValue, Command, Env)
"""Values that are one file, or one value."""
OLD_KEYWORDS = ("node_executable", "node_name", "node_namespace", "node_plugin")
_OLD = regex(rf"\b({'|'.join(OLD_KEYWORDS)})\s*=(?!=)")


def _common(state: State, args: Arguments) -> dict[str, Any]:
    """What every process may have."""
    additional, more = freeze.pairs(state, args.get("additional_env"))
    env = args.get("env")
    own, unseen = freeze.pairs(state, env)
    on_exit = args.get("on_exit")
    return {
        "span": args.span,
        "conditions": conditions(args),
        "name": freeze.optional_text(state, args.get("name")),
        "env": None if env is None or freeze.is_none(env) else own,
        "additional_env": additional,
        "options": {
            name: freeze.text(state, args.keywords[name])
            for name in _OPTIONS
            if name in args.keywords and not freeze.is_none(args.keywords[name])
        },
        "on_exit": handler_actions(state, on_exit, args),
        "open": args.more or more or unseen,
    }


def handler_actions(state: State, thing: Any, args: Arguments) -> tuple[Action, ...]:
    """Actions of a handler: given as such, or by a function of event and context."""
    if thing is None or freeze.is_none(thing):
        return ()
    if isinstance(thing, Function):
        state.deferred += 1
        try:
            thing = state.call(thing, [], {}, False, args.span)
        finally:
            state.deferred -= 1
    return freeze.actions(state, thing)


def parameters(state: State, thing: Any) -> tuple[Value, ...]:
    """A ``parameters=`` list: dictionaries, ``ParameterFile``, everything else names a file."""
    if isinstance(thing, Mapping):
        return (dictionary(state, thing),)
    if isinstance(thing, Sequence) and not thing.open:
        return tuple(freeze.conditional(state, guards, _source(state, item)) for guards, item in thing.items)
    return freeze.sources(state, thing)


def _source(state: State, item: Any) -> Value:
    if isinstance(item, Mapping):
        return dictionary(state, item)
    if isinstance(item, Options):
        options = [
            (guards, dictionary(state, one) if isinstance(one, Mapping) else one) for guards, one in item.options
        ]
        return freeze.value(state, Options(options, item.span))
    return freeze.text(state, item)


def dictionary(state: State, mapping: Mapping) -> Value:
    """A dictionary of parameters; nested dictionaries stay nested."""
    shaped = Mapping(mapping.span, open=mapping.open)
    for key, item in mapping.pairs():
        state.tick()
        value = dictionary(state, item) if isinstance(item, Mapping) else parameter(state, item)
        shaped.others.append((freeze.text(state, key), value))
    return freeze.value(state, shaped)


def _process(state: State, args: Arguments) -> Any:
    return Process(cmd=freeze.values(state, args.need("cmd", 0)), **_common(state, args))


def _local(state: State, args: Arguments) -> Any:
    description = args.get("process_description", 0)
    if isinstance(description, Process):
        return description
    return Process(**_common(state, args))


def _note_old(state: State, args: Arguments, owner: str) -> None:
    """Keep the keywords that launch_ros had until Foxy, with their places."""
    if args.keywords.keys().isdisjoint(OLD_KEYWORDS):
        return
    for match in _OLD.finditer(args.span.text):
        start = args.span.start + match.start(1)
        place = Located(match[1], args.span.source.span(start, start + len(match[1])))
        known = any(start == other.name.span.start for other in state.file.keywords)
        if match[1] in args.keywords and not known:
            now = place.removeprefix("node_")
            state.file.keywords.append(OldKeyword(owner, place, now, now in args.keywords))


def _note_refused(state: State, args: Arguments) -> None:
    """Keep what ``parameters=`` may not be: anything but a list, and in its dictionaries keys that are not strings and
    lists with lists of numbers."""
    thing = args.get("parameters")
    if isinstance(thing, (Mapping, *_NO_LISTS)) or _is_text(thing):
        is_here = args.span.start <= thing.span.start < args.span.end
        _refuse(state, "not-a-list" if is_here else "no-list", thing.span if is_here else args.span)
    if not isinstance(thing, Sequence) or thing.open:
        return
    for _, item in thing.items:
        if isinstance(item, Action):
            _refuse(state, "action", item.span)
        if isinstance(item, Literal) and not _is_text(item):
            _refuse(state, "value", item.span)
    dictionaries = (item for _, item in thing.items if isinstance(item, Mapping))
    for key, value in (pair for dictionary in dictionaries for pair in dictionary.pairs()):
        if isinstance(key, Literal) and not _is_text(key):
            _refuse(state, "key", key.span)
        if freeze.is_none(value):
            _refuse(state, "nothing", value.span)
        if isinstance(value, Sequence) and any(_holds_numbers(item) for _, item in value.items):
            _refuse(state, "nested-list", value.span)
        if isinstance(value, Sequence) and any(isinstance(item, Mapping) for _, item in value.items):
            _refuse(state, "list-of-maps", value.span)


def _note_remappings(state: State, thing: Any) -> None:
    """Keep what ``remappings=`` may not be: anything but tuples of two."""
    if isinstance(thing, Mapping):
        _refuse(state, "remapping", thing.span)
    items = thing.items if isinstance(thing, Sequence) else []
    for _, item in items:
        if _is_text(item) or (isinstance(item, Sequence) and not _is_pair(item)):
            _refuse(state, "remapping", item.span)


def _is_pair(item: Sequence) -> bool:
    """Whether this may be a tuple of two; written as a list or set it is none."""
    plain = item.plain()
    return item.span.text[:1] not in ("[", "{") and (plain is None or len(plain) == 2)


def _is_text(thing: Any) -> bool:
    return isinstance(thing, Literal) and isinstance(thing.value, str)


def _holds_numbers(thing: Any) -> bool:
    """Whether this is a list with a number; a list of texts and substitutions is one text."""
    items = thing.items if isinstance(thing, Sequence) else []
    return any(isinstance(item, Literal) and isinstance(item.value, (bool, int, float)) for _, item in items)


def _refuse(state: State, code: str, where: Span) -> None:
    if all(problem.span.start != where.start for problem in state.file.refused):
        state.file.refused.append(Problem(code, where))


def _node_fields(state: State, args: Arguments) -> dict[str, Any]:
    fields = _common(state, args)
    _note_old(state, args, "Node")
    _note_refused(state, args)
    _note_remappings(state, args.get("remappings"))
    remappings, more = freeze.pairs(state, args.get("remappings"))
    old_name = args.get("node_name")
    if fields["name"] is None and old_name is not None:
        fields["name"] = freeze.optional_text(state, old_name)
    namespace = args.get("namespace") or args.get("node_namespace")
    return fields | {
        "package": freeze.optional_text(state, args.get("package", 1)),
        "executable": freeze.optional_text(state, args.get("executable", 0) or args.get("node_executable")),
        "namespace": freeze.optional_text(state, namespace),
        "parameters": parameters(state, args.get("parameters")),
        "remappings": remappings,
        "arguments": freeze.values(state, args.get("arguments")),
        "ros_arguments": freeze.values(state, args.get("ros_arguments")),
        "open": fields["open"] or more,
    }


def _node(state: State, args: Arguments) -> Any:
    return Node(**_node_fields(state, args))


def _lifecycle_node(state: State, args: Arguments) -> Any:
    autostart = freeze.optional_text(state, args.get("autostart"))
    return Node(lifecycle=True, autostart=autostart, **_node_fields(state, args))


def _container(state: State, args: Arguments) -> Any:
    fields = _node_fields(state, args)
    components = _components(state, args.get("composable_node_descriptions"))
    return Node(container=True, components=components, **fields)


def _load(state: State, args: Arguments) -> Any:
    target = args.get("target_container", 1)
    named = not isinstance(target, Action)
    return LoadComponents(
        span=args.span,
        conditions=conditions(args),
        target=freeze.optional_text(state, target) if named else None,
        target_key=None if named else target.key,
        components=_components(state, args.get("composable_node_descriptions", 0)),
    )


def _components(state: State, thing: Any) -> tuple[ComposableNode | Other, ...]:
    return tuple(
        action if isinstance(action, (ComposableNode, Other)) else Other(span=action.span, why="not a component")
        for action in freeze.actions(state, thing)
    )


def _component(lifecycle: bool) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        remappings, more = freeze.pairs(state, args.get("remappings"))
        _note_old(state, args, "ComposableNode")
        _note_refused(state, args)
        _note_remappings(state, args.get("remappings"))
        return ComposableNode(
            span=args.span,
            conditions=conditions(args),
            package=freeze.optional_text(state, args.get("package")),
            plugin=freeze.optional_text(state, args.get("plugin") or args.get("node_plugin")),
            name=freeze.optional_text(state, args.get("name") or args.get("node_name")),
            namespace=freeze.optional_text(state, args.get("namespace") or args.get("node_namespace")),
            parameters=parameters(state, args.get("parameters")),
            remappings=remappings,
            extra_arguments=parameters(state, args.get("extra_arguments")),
            lifecycle=lifecycle,
            autostart=freeze.optional_text(state, args.get("autostart")),
            open=args.more or more,
        )

    return builder


NODES = {
    "launch.ExecuteProcess": _process,
    "launch.ExecuteLocal": _local,
    "launch.Executable": _process,
    "launch.Node": _node,
    "launch.LifecycleNode": _lifecycle_node,
    "launch.ComposableNodeContainer": _container,
    "launch.ComposableLifecycleNode": _component(True),
    "launch.ComposableNode": _component(False),
    "launch.LoadComposableNodes": _load,
}
