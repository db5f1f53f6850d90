"""Blocks of parameters for a node that is started beside the one that gets their file, and does not get it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.parameters import OF_EVERY_NODE
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.topics.questions.parameter_blocks import Mismatch
from bringup_lint.graph.topics.questions.parameter_blocks import certain
from bringup_lint.graph.topics.questions.parameter_blocks import read_elsewhere
from bringup_lint.model.params import matches
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.params.loads import Load
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import ParameterFile


class Unhanded(NamedTuple):
    block: Block
    node: LaunchedNode
    load: Load
    """How another node gets the file."""


def unhanded(topics: Topics) -> Iterator[Unhanded]:
    """Each block once, where all nodes that get the file are known, and no other file mentions it."""
    params = topics.params()
    for file, loads in certain(params):
        names = [topics.node(load.node).fqn for load in loads]
        blocks = [block for block in file.blocks if "*" not in block.name and block.parameters]
        free = [block for block in blocks if not any(name is None or matches(block.name, name) for name in names)]
        if not free or read_elsewhere(params, file, loads):
            continue
        runs = {id(load.expansion): load for load in loads}
        for block in free:
            lacking = ((node, load) for load in runs.values() for node in _lacking(topics, block, load))
            node, load = next(lacking, (None, None))
            if node is not None and load is not None and _has_use(topics, file, block, node, load):
                yield Unhanded(block, node, load)


def _lacking(topics: Topics, block: Block, load: Load) -> Iterator[LaunchedNode]:
    """The nodes of one launch that a block is for, and that are not given one of its values."""
    given = {str(each.name) for each in block.parameters}
    for started in load.expansion.nodes:
        node = topics.node(started) if started.is_node and started.by_default is True else None
        if node is None or node.fqn is None or not matches(block.name, node.fqn) or node.given is None:
            continue
        if any(literal_text(each) is None for each in started.arguments):
            continue  # it may get the file as an argument
        if not node.given.open and not given & set(node.given.values) and not topics.launch.never_runs(started):
            yield node


def _has_use(topics: Topics, file: ParameterFile, block: Block, node: LaunchedNode, load: Load) -> bool:
    """Whether the node would do something else with the block: it declares one of the values, and not with this one."""
    if Mismatch(file, block, load._replace(node=node.started), "", False).changes_nothing(topics):
        return False
    words = topics.parameter_words(node.started)
    names = [str(each.name) for each in block.parameters if each.name not in OF_EVERY_NODE]
    return words is not None and any(map(words.name, names))
