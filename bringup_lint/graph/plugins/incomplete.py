"""Controllers of ros2_controllers that lack a parameter without which they are not configured."""

from __future__ import annotations

from collections.abc import Container
from collections.abc import Iterator
from collections.abc import Mapping
from fnmatch import fnmatchcase
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.controllers import controller_needs
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.plugins.controllers import FILE_OPTIONS
from bringup_lint.graph.plugins.controllers import spawned_by
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.facts.ros.controllers import ControllerNeeds
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile
    from bringup_lint.source import Source
    from bringup_lint.source import Span


class IncompleteController(NamedTuple):
    name: str
    typed: Parameter
    """Its class, as the controller manager is given it."""
    where: Span
    """The block of the controller, or the value that is refused."""
    missing: str
    """The parameter."""
    refused: Parameter | None
    """The same, where its value must be above 0."""
    near: Parameter | None
    """A parameter of nearly the same name."""
    used: bool
    """Another file names the controller: something may spawn it."""
    stray: str = ""
    """The block that has its parameters, and is that of no controller."""


class _Launched:
    """What the launch files of the tree start."""

    def __init__(self, launch: Launch) -> None:
        self._launch = launch

    @cached_property
    def nodes(self) -> set[str]:
        """The names of nodes."""
        return {str(literal_text(node.name)).rpartition("/")[2] for node in self._launch.nodes}

    @cached_property
    def with_files(self) -> set[str]:
        """The controllers whose spawner is given a file of parameters for them."""
        spawners = (node for node in self._launch.nodes if _gives_file(node))
        return {str(name) for node in spawners for name in spawned_by(node)}


def incomplete_controllers(
    params: Params, launch: Launch, packages: Container[str]
) -> Iterator[list[IncompleteController]]:
    """Those of one controller together, only where one file has both its class and its block, and no other file gives
    it anything. ``packages``: those of the tree, whose controllers are others."""
    given: dict[str, list[Parameter]] = {}
    sources: dict[str, set[Source]] = {}
    for file in params.parameter_files:
        for each in file.parameters:
            given.setdefault(each.block.node_name, []).append(each)
            sources.setdefault(each.name.removesuffix(".type"), set())
            if each.name.endswith(".type"):
                sources[each.name.removesuffix(".type")].add(each.span.source)
    launched = _Launched(launch)
    for file in params.judged:
        if file.accepted and not file.uncertain:
            yield from _of_file(file, given, sources, params, launched, packages)


def _of_file(
    file: ParameterFile,
    given: dict[str, list[Parameter]],
    sources: Mapping[str, Container[Source]],
    params: Params,
    launched: _Launched,
    packages: Container[str],
) -> Iterator[list[IncompleteController]]:
    blocks = {block.node_name: block for block in file.blocks}
    wild = any(map(_is_wild, blocks))
    others: dict[int, tuple[Block, list[str]]] = {
        id(block): (block, []) for tail, block in blocks.items() if tail not in sources
    }
    for each in file.parameters:
        if id(each.block) in others:
            others[id(each.block)][1].append(each.name)
    fitting: dict[str, list[Block]] = {}
    for typed in file.parameters:
        name, kind = typed.name.removesuffix(".type"), str(typed.value.data)
        needs = controller_needs().get(kind) if typed.name.endswith(".type") else None
        block = blocks.get(name)
        if needs is None or kind.partition("/")[0] in packages:
            continue
        own = given.get(name, [])
        if block is None:
            # A file that has the class of the controller, too, is there in place of this one.
            if not wild and all(each.span.source in sources[name] for each in own):
                if kind not in fitting:
                    fitting[kind] = [block for block, names in others.values() if _has_all(names, needs)]
                if len(fitting[kind]) == 1 and not _is_meant(name, fitting[kind][0], launched):
                    yield _stray(name, typed, fitting[kind][0], file, params)
            continue
        if any(each.span.source is not file.source for each in own):
            continue
        used = params.named_elsewhere(name, {file.source})
        every = [*own, *given.get("**", ()), *given.get("*", ())]
        lacking = [
            IncompleteController(name, typed, where, group[0], refused, _near(group[0], own), used)
            for group in needs.parameters
            for where, refused in _lacking(group, group[0] in needs.positive, every, block)
        ]
        if lacking:
            yield lacking


def _is_meant(name: str, block: Block, launched: _Launched) -> bool:
    """Whether a block is that of a node, or the controller has its parameters from elsewhere."""
    return block.node_name in launched.nodes or name in launched.with_files


def _gives_file(node: Started) -> bool:
    return any(literal_text(word) in FILE_OPTIONS for word in node.arguments)


def _is_wild(tail: str) -> bool:
    return "*" in tail or "$" in tail or "{" in tail


def _has_all(names: list[str], needs: ControllerNeeds) -> bool:
    return all(any(fnmatchcase(name, one) for name in names for one in group) for group in needs.parameters)


def _stray(
    name: str, typed: Parameter, block: Block, file: ParameterFile, params: Params
) -> list[IncompleteController]:
    """The one block that has all that a controller needs, and that no controller is called like."""
    used = params.named_elsewhere(name, {file.source})
    return [IncompleteController(name, typed, block.key.span, "", None, None, used, block.node_name)]


def _lacking(
    group: tuple[str, ...], positive: bool, given: list[Parameter], block: Block
) -> Iterator[tuple[Span, Parameter | None]]:
    """Where a parameter is missing, or its value is refused."""
    found = [each for each in given if any(fnmatchcase(each.name, name) for name in group)]
    if not found:
        yield block.key.span, None
    elif positive and all(map(_is_refused, found)):
        yield found[0].span, found[0]


def _near(name: str, given: list[Parameter]) -> Parameter | None:
    """The parameter whose name may be a misspelling of another one."""
    near = nearest(name, [each.name for each in given], 3)
    return next((each for each in given if near and each.name == near[0]), None)


def _is_refused(parameter: Parameter) -> bool:
    data = parameter.value.data
    return isinstance(data, (int, float)) and not isinstance(data, bool) and data <= 0
