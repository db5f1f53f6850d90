"""Which blocks of a parameter file reach which nodes, where both names are known for certain."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.loads import PYYAML
from bringup_lint.graph.params.loads import REWRITTEN
from bringup_lint.graph.params.loads import Load
from bringup_lint.model.launch import Node
from bringup_lint.model.params import Block
from bringup_lint.model.params import ParameterFile
from bringup_lint.model.params import matches
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.spelling import nearest
from bringup_lint.spelling import numbered

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params

VALUES = ("nested-list", "mixed-list", "list-of-maps")
"""Problems of single values: the blocks around them are read all the same."""


class Mismatch(NamedTuple):
    """A block that is meant for a node and does not reach it."""

    file: ParameterFile
    block: Block
    load: Load
    name: str
    """The node's fully qualified name."""
    misspelt: bool
    """Another name; else the same name in another namespace."""


def unreached(params: Params) -> Iterator[Mismatch]:
    """Nodes that get a file of which no block matches them, though one is nearly theirs."""
    for file, loads in _certain(params):
        by_node: dict[int, list[Load]] = {}
        for load in loads:
            by_node.setdefault(load.node.action.key, []).append(load)
        for every in by_node.values():
            same = [load for load in every if not params.is_included(load)] or every
            names = [_name(load) for load in same]
            if None in names or any(reaches(block, load) for block in file.blocks for load in same):
                continue
            others = [load for load in loads if load.node.action is not same[0].node.action]
            for block in file.blocks:
                kind = _meant(block, str(names[0]))
                if kind is not None and not any(reaches(block, load) for load in others):
                    yield Mismatch(file, block, same[0], str(names[0]), kind)
                    break


def unused(params: Params) -> Iterator[Mismatch]:
    """Blocks that match no node that gets the file, and are nearly the name of one that another block matches."""
    missed = {found.block for found in unreached(params)}
    return (found for found in _unmatched(params) if found.block not in missed)


def _unmatched(params: Params) -> Iterator[Mismatch]:
    for file, loads in _certain(params):
        if any(_name(load) is None for load in loads) or _read_elsewhere(params, file, loads):
            continue
        names = {str(_name(load)): load for load in loads}
        for block in file.blocks:
            if any(reaches(block, load) for load in loads):
                continue
            found = next(((name, kind) for name in names if (kind := _meant(block, name)) is not None), None)
            if found is not None:
                yield Mismatch(file, block, names[found[0]], found[0], found[1])


def _certain(params: Params) -> Iterator[tuple[ParameterFile, list[Load]]]:
    for file in params.judged:
        loads = params.loads(file)
        odd = any(sign in block.name for block in file.blocks for sign in "$<>{}%@")
        read = all(problem.code in VALUES for problem in file.problems)
        if loads and read and not file.uncertain and not odd and all(map(_plain, loads)):
            yield file, loads


def _plain(load: Load) -> bool:
    """Whether the node reads the file itself: no component, no container, no namespace put around the file."""
    action = load.node.action
    if load.how == PYYAML or not isinstance(action, Node) or action.container or action.components:
        return False
    if literal_text(load.node.executable) is None or "container" in str(literal_text(load.node.executable)):
        return False
    return load.how != REWRITTEN or load.root_key is None or text_of(load.root_key) == ""


def _name(load: Load) -> str | None:
    return load.node.fqn if load.node.namespace is not None else None


def reaches(block: Block, load: Load) -> bool:
    name = _name(load)
    return name is None or matches(block.name, name)


def _meant(block: Block, name: str) -> bool | None:
    """True for a misspelt name, False for another namespace, None when the block is for something else."""
    space, _, tail = block.name.rpartition("/")
    own_space, _, own = name.rpartition("/")
    if "*" in tail or "**" in space:
        return None
    if tail == own:
        return False
    if "*" in space:
        return None
    same_space = not space.strip("/") or space.strip("/") == own_space.strip("/")
    is_like = bool(nearest(tail, [own])) or _words(tail) == _words(own)
    return True if same_space and is_like and not numbered(tail, own) else None


def _words(name: str) -> frozenset[str]:
    """The words of a name, whatever their order, without the one that says that it is a node."""
    return frozenset(name.split("_")) - {"node"}


def _read_elsewhere(params: Params, file: ParameterFile, loads: list[Load]) -> bool:
    """Whether another file of the tree mentions the file by name, so that somebody else may load it."""
    known = {load.node.file.source for load in loads} | {load.where.source for load in loads}
    known |= {span.source for load in loads for span in load.node.chain}
    return params.named_elsewhere(file.source.basename, known)
