"""What follows from the types that the sources of the workspace declare for the values of parameter files."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.memo import memo

if TYPE_CHECKING:
    from bringup_lint.graph.params.declared import Declared
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.params.values import Item
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter


def declarations(params: Params, name: str) -> list[Declared]:
    """Every declaration in the sources of a package of the workspace, in the order of the files."""
    from bringup_lint.graph.params.declared import declarations_in

    workspace = params.launch().workspace
    package = workspace.packages.get(name)
    return list(declarations_in(workspace, package)) if package else []


def declared_type(params: Params, parameter: Parameter) -> str | None:
    """The type that the workspace's sources declare for a parameter; None when it is not known."""
    found = params.declared(parameter)
    return found.type if found else None


def of_wrong_type(params: Params, given: str, declared: str) -> Iterator[tuple[Parameter, Declared, list[Item]]]:
    """The values of one type that the workspace declares as another, each with its items; arrays of them too."""
    pairs = ((given, declared), (f"{given}_array", f"{declared}_array"))
    for parameter, found in params.typed:
        if (parameter.value.type, found.type) in pairs:
            yield parameter, found, params.items(parameter)


_SURE, _MOST = 3, 0.6
"""Parameters of a block that sources of the tree name, and the part of the block that these are, where the sources are
those of its nodes."""


def is_never_read(params: Params, parameter: Parameter) -> bool:
    """Whether the sources of every node that gets a value are in the workspace, and none of them names it: by the
    launch files that load it, or because the sources name nearly all that is beside it."""
    from bringup_lint.graph.params.declared import mentions

    if _is_unnamed(params, parameter):
        return True

    file = params.of_source(parameter.span.source)
    loads = params.loads(file) if file else []
    names = {text_of(load.node.package) if load.node.package is not None else None for load in loads}
    packages = [params.launch().workspace.packages.get(name or "") for name in names]
    word = str(parameter.key).rpartition(".")[2]
    return bool(packages) and all(each and not mentions(params.files, each, word) for each in packages)


def _is_unnamed(params: Params, parameter: Parameter) -> bool:
    """Whether sources of the tree name nearly all values of a block, and not this one."""
    return not params.is_named_in_code(str(parameter.name)) and _is_mostly_named(params, parameter.block)


@memo
def _is_mostly_named(params: Params, block: Block) -> bool:
    named = sum(params.is_named_in_code(str(each.name)) for each in block.parameters)
    return named >= max(_SURE, _MOST * len(block.parameters))
