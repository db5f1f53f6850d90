"""Controllers of ros2_controllers that lack a parameter without which they are not configured."""

from __future__ import annotations

from collections.abc import Container
from collections.abc import Iterator
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.controllers import controller_needs
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.facts.ros.controllers import ControllerNeeds
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile
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


def incomplete_controllers(params: Params, packages: Container[str]) -> Iterator[list[IncompleteController]]:
    """Those of one controller together, only where one file has both its class and its block, and no other file gives
    it anything. ``packages``: those of the tree, whose controllers are others."""
    given: dict[str, list[Parameter]] = {}
    for file in params.parameter_files:
        for each in file.parameters:
            given.setdefault(_tail(str(each.block.key)), []).append(each)
    typed = {each.name.removesuffix(".type") for of_name in given.values() for each in of_name}
    for file in params.judged:
        if file.accepted and not file.uncertain:
            yield from _of_file(file, given, typed, params, packages)


def _of_file(
    file: ParameterFile,
    given: dict[str, list[Parameter]],
    typed_names: set[str],
    params: Params,
    packages: Container[str],
) -> Iterator[list[IncompleteController]]:
    blocks = {_tail(str(block.key)): block for block in file.blocks}
    for typed in file.parameters:
        name, kind = typed.name.removesuffix(".type"), str(typed.value.data)
        needs = controller_needs().get(kind) if typed.name.endswith(".type") else None
        block = blocks.get(name)
        if needs is None or kind.partition("/")[0] in packages:
            continue
        own = given.get(name, [])
        if block is None:
            # A file that has the class of the controller, too, is there in place of this one.
            instead = {each.span.source for of in given.values() for each in of if each.name == typed.name}
            if all(each.span.source in instead for each in own) and not any(_is_wild(tail) for tail in blocks):
                others = [blocks[tail] for tail in blocks if tail not in typed_names]
                yield from _stray(name, typed, needs, others, file, params)
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


def _is_wild(tail: str) -> bool:
    return "*" in tail or "$" in tail or "{" in tail


def _stray(
    name: str, typed: Parameter, needs: ControllerNeeds, others: list[Block], file: ParameterFile, params: Params
) -> Iterator[list[IncompleteController]]:
    """The one block that has all that a controller needs, and that no controller is called like."""
    fitting = []
    for block in others:
        own = [each for each in file.parameters if each.block is block]
        if all(any(fnmatchcase(each.name, one) for each in own for one in group) for group in needs.parameters):
            fitting.append(block)
    if len(fitting) == 1:
        used = params.named_elsewhere(name, {file.source})
        tail = _tail(str(fitting[0].key))
        yield [IncompleteController(name, typed, fitting[0].key.span, "", None, None, used, tail)]


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


def _tail(key: str) -> str:
    return key.rpartition("/")[2]
