"""Tags of XML and YAML launch files as actions."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from typing import Any

from bringup_lint.model.launch import Action
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import DeclareArgument
from bringup_lint.model.launch import Emit
from bringup_lint.model.launch import Group
from bringup_lint.model.launch import Include
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import LoadComponents
from bringup_lint.model.launch import Log
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import Other
from bringup_lint.model.launch import Process
from bringup_lint.model.launch import PushNamespace
from bringup_lint.model.launch import SetArgument
from bringup_lint.model.launch import SetEnv
from bringup_lint.model.launch import SetParameter
from bringup_lint.model.launch import SetParametersFromFile
from bringup_lint.model.launch import SetRemap
from bringup_lint.model.launch import Timer
from bringup_lint.model.launch import UnsetArgument
from bringup_lint.model.launch import UnsetEnv
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import Value
from bringup_lint.parsers.launch_frontend.entity import Entity
from bringup_lint.parsers.launch_frontend.substitutions import read
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_OPTIONS = {
    name: name
    for name in (
        "respawn respawn_delay respawn_max_retries output cwd shell emulate_tty exec_name sigterm_timeout "
        "sigkill_timeout"
    ).split()
} | {"launch-prefix": "prefix"}
_NUMBER = regex(r"[-+]?(?:\d+|(?P<real>\d*\.\d+|\d+\.\d*)(?:[eE][-+]?\d+)?|(?P<power>\d+[eE][-+]?\d+))\Z")
_WORDS = regex(r"""\s+|(?P<quote>["'])[^"']*(?P=quote)(?!\S)|(?:"[^"]*"|'[^']*'|[^\s"'])+|["']""")
"""Blanks, a word in quotes, and one that may hold some."""
_ROS1_ATTRIBUTES = {
    "node": ("type", "ns", "required", "machine", "clear_params"),
    "include": ("ns", "pass_all_args", "clear_params"),
    "group": ("ns", "clear_params"),
    "param": ("command", "textfile", "binfile"),
    "arg": (),
}
_ROS1_TAGS = frozenset(("rosparam", "machine", "test", "env-loader"))


class Builder:
    """Makes the actions of one file."""

    def __init__(self, file: LaunchFile) -> None:
        self.file = file

    def actions(self, entities: Iterable[Entity]) -> tuple[Action, ...]:
        return tuple(action for entity in entities for action in self.action(entity))

    def action(self, entity: Entity) -> tuple[Action, ...]:
        tag = str(entity.tag).replace("-", "_")
        self.note_ros1(entity, tag, top=True)
        build = _TAGS.get(tag)
        if build is None:
            return (Other(span=entity.span, why=f"tag {entity.tag}"),)
        return build(self, entity)

    def note_ros1(self, entity: Entity, tag: str, top: bool = False) -> None:
        if tag in _ROS1_TAGS or (tag == "param" and top):
            self.file.ros1.append(entity.tag)
        if not top or tag == "node":
            self.file.ros1 += [child.tag for child in entity.children if child.tag in _ROS1_TAGS]
        for name in _ROS1_ATTRIBUTES.get(tag, ()):
            if name in entity.keys:
                self.file.ros1.append(entity.keys[name])

    def value(self, entity: Entity, *names: str) -> Value:
        text = entity.get(*names)
        return Unknown(f"no {names[0]}", entity.span) if text is None else read(text, self.file)

    def optional(self, entity: Entity, *names: str) -> Value | None:
        text = entity.get(*names)
        return None if text is None else read(text, self.file)

    def conditions(self, entity: Entity) -> tuple[Condition, ...]:
        result = []
        for kind in ("if", "unless"):
            text = entity.get(kind)
            if text is not None:
                result.append(Condition(read(text, self.file), kind == "if", kind, text.span))
        return tuple(result)

    def base(self, entity: Entity) -> dict[str, Any]:
        return {"span": entity.span, "conditions": self.conditions(entity)}

    def pairs(self, entities: Iterable[Entity], first: str, second: str) -> tuple[tuple[Value, Value], ...]:
        return tuple((self.value(each, first), self.value(each, second)) for each in entities)

    def words(self, entity: Entity, name: str) -> tuple[Value, ...]:
        """A command line, split at the blanks of its literal text that no quotes hold."""
        text = entity.get(name)
        if text is None:
            return ()
        value = read(text, self.file)
        words: list[list[Value]] = [[]]
        for part in value.parts if isinstance(value, Concat) else (value,):
            if not isinstance(part, Literal):
                words[-1].append(part)
                continue
            for match in _WORDS.finditer(part.text):
                if match[0].isspace():
                    words.append([])
                else:
                    quotes = len(match["quote"] or "")
                    piece = part.text.part(match.start() + quotes, match.end() - quotes)
                    words[-1].append(Literal(piece, piece.span))
        return tuple(word[0] if len(word) == 1 else Concat(tuple(word), word[0].span) for word in words if word)

    def process(self, entity: Entity) -> dict[str, Any]:
        shutdown = entity.get("on_exit") == "shutdown"
        return self.base(entity) | {
            "name": self.optional(entity, "name"),
            "additional_env": self.pairs(entity.named("env"), "name", "value"),
            "options": {
                python: read(text, self.file)
                for name, python in _OPTIONS.items()
                if (text := entity.get(name)) is not None
            },
            "on_exit": (Emit(span=entity.span, event="shutdown"),) if shutdown else (),
        }

    def parameters(self, entity: Entity) -> tuple[Value, ...]:
        result: list[Value] = []
        for each in entity.named("param"):
            if each.get("from") is not None:
                allow = self.optional(each, "allow_substs")
                result.append(ParameterFile(self.value(each, "from"), allow, each.span))
            else:
                self.note_ros1(each, "param")
                result.append(DictValue((self.parameter(each),), each.span))
        return tuple(result)

    def parameter(self, entity: Entity) -> tuple[Value, Value]:
        name = self.value(entity, "name")
        nested = list(entity.named("param"))
        if nested and "value" not in entity.attributes:
            return name, DictValue(tuple(self.parameter(each) for each in nested), entity.span)
        kind = entity.get("type")
        raw = entity.attributes.get("value")
        separator = entity.get("value-sep")
        if isinstance(raw, list):
            value: Value = ListValue(tuple(typed(read(item, self.file)) for item in raw), entity.span)
        elif isinstance(raw, Located) and separator:
            value = ListValue(tuple(typed(read(part, self.file)) for part in split(raw, separator)), raw.span)
        else:
            value = self.value(entity, "value")
            value = value if kind == "str" else typed(value)
        return name, value if kind is None else TypedValue(value, str(kind), entity.span)

    def node(self, entity: Entity) -> dict[str, Any]:
        return self.process(entity) | {
            "package": self.optional(entity, "pkg"),
            "executable": self.optional(entity, "exec", "type"),
            "namespace": self.optional(entity, "namespace"),
            "parameters": self.parameters(entity),
            "remappings": self.pairs(entity.named("remap"), "from", "to"),
            "arguments": self.words(entity, "args"),
            "ros_arguments": self.words(entity, "ros_args"),
        }

    def components(self, entity: Entity) -> tuple[ComposableNode, ...]:
        return tuple(self.component(each) for each in entity.named("composable_node", "composable_lifecycle_node"))

    def component(self, entity: Entity) -> ComposableNode:
        extra = self.pairs(entity.named("extra_arg"), "name", "value")
        return ComposableNode(
            **self.base(entity),
            package=self.optional(entity, "pkg"),
            plugin=self.optional(entity, "plugin"),
            name=self.optional(entity, "name"),
            namespace=self.optional(entity, "namespace"),
            parameters=self.parameters(entity),
            remappings=self.pairs(entity.named("remap"), "from", "to"),
            extra_arguments=tuple(DictValue((pair,), entity.span) for pair in extra),
            lifecycle=entity.tag == "composable_lifecycle_node",
        )


def split(text: Located, separator: str) -> list[Located]:
    """The parts of a text between separators, each with its place."""
    parts = []
    start = 0
    while True:
        at = text.find(separator, start)
        if at < 0:
            parts.append(text.part(start, len(text)))
            return parts
        parts.append(text.part(start, at))
        start = at + len(separator)


def typed(value: Value) -> Value:
    """A literal as launch's front ends guess its type: whole number, real number, truth value, else text."""
    if not isinstance(value, Literal) or not isinstance(value.value, str):
        return value
    text = value.value.strip()
    if text.lower() in ("true", "false"):
        return Literal(text.lower() == "true", value.span)
    match = _NUMBER.match(text) if len(text) < 40 else None
    if match is not None:
        real = match["real"] or match["power"]
        return Literal(float(text) if real else int(text), value.span)
    return value


def _declare(self: Builder, entity: Entity) -> tuple[Action, ...]:
    choices = tuple(self.value(each, "value") for each in entity.named("choice"))
    if entity.get("value") is not None and entity.get("default") is None:
        self.file.ros1.append(entity.keys.get("value", entity.tag))
    return (
        DeclareArgument(
            **self.base(entity),
            name=self.value(entity, "name"),
            default=self.optional(entity, "default"),
            description=self.optional(entity, "description"),
            choices=choices or None,
        ),
    )


def _include(self: Builder, entity: Entity) -> tuple[Action, ...]:
    arguments = self.pairs(entity.named("arg", "let"), "name", "value")
    return (Include(**self.base(entity), file=self.value(entity, "file"), arguments=arguments),)


def _group(self: Builder, entity: Entity) -> tuple[Action, ...]:
    inner = [child for child in entity.children if child.tag != "keep"]
    scoped, forwarding = self.optional(entity, "scoped"), self.optional(entity, "forwarding")
    kept = self.pairs(entity.named("keep"), "name", "value")
    base = self.base(entity)
    return (Group(**base, actions=self.actions(inner), scoped=scoped, forwarding=forwarding, arguments=kept),)


def _node(self: Builder, entity: Entity) -> tuple[Action, ...]:
    return (Node(**self.node(entity)),)


def _lifecycle(self: Builder, entity: Entity) -> tuple[Action, ...]:
    return (Node(**self.node(entity), lifecycle=True, autostart=self.optional(entity, "autostart")),)


def _container(self: Builder, entity: Entity) -> tuple[Action, ...]:
    return (Node(**self.node(entity), container=True, components=self.components(entity)),)


def _load(self: Builder, entity: Entity) -> tuple[Action, ...]:
    target = self.value(entity, "target")
    return (LoadComponents(**self.base(entity), target=target, components=self.components(entity)),)


def _executable(self: Builder, entity: Entity) -> tuple[Action, ...]:
    return (Process(**self.process(entity), cmd=self.words(entity, "cmd")),)


def _timer(self: Builder, entity: Entity) -> tuple[Action, ...]:
    return (Timer(**self.base(entity), period=self.value(entity, "period"), actions=self.actions(entity.children)),)


def _set_env(mode: str) -> Callable[[Builder, Entity], tuple[Action, ...]]:
    def build(self: Builder, entity: Entity) -> tuple[Action, ...]:
        prepend = mode == "append" and (entity.get("prepend") or "").lower() == "true"
        name, value = self.value(entity, "name"), self.value(entity, "value")
        way, separator = "prepend" if prepend else mode, self.optional(entity, "separator")
        return (SetEnv(**self.base(entity), name=name, value=value, mode=way, separator=separator),)

    return build


def _named_value(kind: Callable[..., Action]) -> Callable[[Builder, Entity], tuple[Action, ...]]:
    def build(self: Builder, entity: Entity) -> tuple[Action, ...]:
        return (kind(**self.base(entity), name=self.value(entity, "name"), value=self.value(entity, "value")),)

    return build


def _let(self: Builder, entity: Entity) -> tuple[Action, ...]:
    return (
        SetArgument(**self.base(entity), name=self.value(entity, "name", "var"), value=self.value(entity, "value")),
    )


def _set_remap(self: Builder, entity: Entity) -> tuple[Action, ...]:
    return (SetRemap(**self.base(entity), src=self.value(entity, "from"), dst=self.value(entity, "to")),)


def _push_namespace(self: Builder, entity: Entity) -> tuple[Action, ...]:
    return (PushNamespace(**self.base(entity), namespace=self.value(entity, "namespace")),)


def _parameters_file(self: Builder, entity: Entity) -> tuple[Action, ...]:
    return (SetParametersFromFile(**self.base(entity), file=self.value(entity, "filename")),)


def _use_sim_time(self: Builder, entity: Entity) -> tuple[Action, ...]:
    name = Literal(Located("use_sim_time", entity.tag.span), entity.tag.span)
    return (SetParameter(**self.base(entity), name=name, value=self.value(entity, "value")),)


def _log_dir(self: Builder, entity: Entity) -> tuple[Action, ...]:
    name = Literal(Located("ROS_LOG_DIR", entity.tag.span), entity.tag.span)
    return (SetEnv(**self.base(entity), name=name, value=self.value(entity, "new_log_dir")),)


def _simple(kind: type[Action], **values: Any) -> Callable[[Builder, Entity], tuple[Action, ...]]:
    def build(self: Builder, entity: Entity) -> tuple[Action, ...]:
        return (kind(**self.base(entity), **values),)

    return build


def _log(self: Builder, entity: Entity) -> tuple[Action, ...]:
    return (Log(**self.base(entity), message=self.optional(entity, "message")),)


def _unset_env(self: Builder, entity: Entity) -> tuple[Action, ...]:
    return (UnsetEnv(**self.base(entity), name=self.value(entity, "name")),)


_TAGS: dict[str, Callable[[Builder, Entity], tuple[Action, ...]]] = {
    "arg": _declare,
    "let": _let,
    "include": _include,
    "group": _group,
    "node": _node,
    "lifecycle_node": _lifecycle,
    "node_container": _container,
    "load_composable_node": _load,
    "load_composable_nodes": _load,
    "executable": _executable,
    "timer": _timer,
    "ros_timer": _timer,
    "set_env": _set_env("set"),
    "append_env": _set_env("append"),
    "unset_env": _unset_env,
    "reset_env": _simple(UnsetEnv),
    "reset": _simple(UnsetArgument),
    "set_parameter": _named_value(SetParameter),
    "set_parameters_from_file": _parameters_file,
    "set_remap": _set_remap,
    "set_use_sim_time": _use_sim_time,
    "set_ros_log_dir": _log_dir,
    "push_ros_namespace": _push_namespace,
    "shutdown": _simple(Emit, event="shutdown"),
    "log": _log,
    "log_info": _log,
    "log_warning": _log,
    "log_error": _log,
    "log_debug": _log,
}
