"""The parameters that a launched node is given, in the order in which they win."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import Any

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.params.loads import path_of
from bringup_lint.graph.topics.resolved.process_arguments import RosArguments
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.model.launch_values import Value
from bringup_lint.model.params import matches
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import ParameterFile as File


_REWRITING = "RewrittenYaml"
_SECTION = ".ros__parameters."
Plain = str | int | float | bool | list[Any] | None


class Given(NamedTuple):
    """A value, None when it is not known, and where it is written."""

    value: Plain
    where: Span


@dataclass(eq=False)
class GivenParameters:
    values: dict[str, Given] = field(default_factory=dict)
    open: bool = False
    """More may be given than is known."""

    def forget(self) -> None:
        self.values.clear()
        self.open = True


@dataclass(frozen=True, eq=False)
class ParameterSources:
    """Where the values of parameters come from besides the node in the launch file."""

    launch: Launch
    params: Callable[[], Params]

    def file(self, value: Value) -> File | None:
        """The parameter file that a value names, when all of it is known."""
        path = path_of(self.launch, value.file if isinstance(value, ParameterFile) else value)
        found = self.params().at_path(path) if path is not None else None
        if found is None or found.uncertain or not found.accepted or found.source.template:
            return None
        return found


def given_parameters(
    sources: ParameterSources, node: Started, fqn: str | None, arguments: RosArguments
) -> GivenParameters:
    """What a node is given when its launch file is started without arguments."""
    found = GivenParameters(open=not arguments.known)
    for name, text, where in arguments.parameters:
        found.values[name] = Given(_plain(text), where)
    for source in node.parameters:
        base = source.file if isinstance(source, ParameterFile) else source
        if isinstance(source, DictValue):
            _inline(found, source, "")
        elif isinstance(base, DerivedFile):
            _take_derived(found, sources, base, fqn)
        elif not _take_file(found, sources.file(source), fqn):
            found.forget()
    return found


def _take_derived(found: GivenParameters, sources: ParameterSources, source: DerivedFile, fqn: str | None) -> None:
    """What a file gives of which some values are written anew; these are not known."""
    file, rewrites = sources.file(source.base), source.rewrites
    root = text_of(source.root_key) if source.root_key is not None else ""
    known = rewrites is None or (isinstance(rewrites, DictValue) and not rewrites.open)
    keys = [text_of(key) for key, _ in rewrites.items] if isinstance(rewrites, DictValue) else []
    if source.helper != _REWRITING or root is None or not known or None in keys:
        found.forget()
        return
    fresh = GivenParameters()
    if not _take_file(fresh, file, fqn, root):
        found.forget()
        return
    for key in keys:
        name = str(key).rpartition(_SECTION)[2]
        same = (each for each in fresh.values if f".{each}".endswith(f".{name.rpartition('.')[2]}"))
        for each in list(same):
            fresh.values[each] = Given(None, fresh.values[each].where)
        if _SECTION in str(key) and name not in fresh.values:
            fresh.values[name] = Given(None, source.span)
    found.values.update(fresh.values)


def _plain(text: str) -> Plain:
    """A word that YAML reads as the text it is; everything else is left open."""
    from bringup_lint.parsers.param_scalar import scalar

    value = scalar(text, "", "") if text and text[0] not in "[{\"'!&*" else None
    return value.data if value is not None else None


def _inline(found: GivenParameters, values: DictValue, prefix: str) -> None:
    for key, value in values.items:
        name = text_of(key)
        if name is None:
            found.forget()
            continue
        inner = value.value if isinstance(value, TypedValue) else value
        if isinstance(inner, DictValue):
            _inline(found, inner, f"{prefix}{name}.")
        else:
            data = inner.value if isinstance(inner, Literal) else None
            found.values[prefix + name] = Given(str(data) if isinstance(data, str) else data, value.span)
    if values.open:
        found.forget()


def _take_file(found: GivenParameters, file: File | None, fqn: str | None, root: str = "") -> bool:
    """Whether what a file gives is known; ``root``: the namespace under which all of its blocks are."""
    if file is None:
        return False
    for block in file.blocks:
        name = f"{root}/{block.name.lstrip('/')}" if root else block.name
        if fqn is None and "*" not in name:
            return False
        if fqn is not None and not matches(name, fqn):
            continue
        if fqn is None and name.strip("/") != "**":
            return False
        for parameter in block.parameters:
            data = parameter.value.data
            known = not (isinstance(data, str) and "$(" in data)
            found.values[parameter.name] = Given(data if known else None, parameter.span)
    return True


def names(given: GivenParameters, pattern: str) -> Iterator[str]:
    """The parameters that a pattern means: ``*`` is a number, or a part between dots."""
    head, _, rest = pattern.partition("*")
    for name in given.values:
        if name.startswith(head) and name.endswith(rest) and len(name) > len(head) + len(rest):
            middle = name[len(head) : len(name) - len(rest)]
            if middle.isdecimal() if not rest else "." not in middle:
                yield name
