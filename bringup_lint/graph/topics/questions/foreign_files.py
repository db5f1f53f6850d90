"""Parameter files of another node: the one that a node gets has no block for it, and one beside it has."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch_values import DictValue
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.params.loads import Load
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import ParameterFile
    from bringup_lint.source import Span


class Foreign(NamedTuple):
    """A node that gets the file of another one."""

    file: ParameterFile
    load: Load
    name: str
    """What the node, or its program, is called."""
    better: Block
    """A block of that name in the file that is meant."""
    where: Span


def foreign(topics: Topics) -> Iterator[Foreign]:
    return _Foreign(topics, topics.params()).found()


@dataclass(frozen=True, eq=False)
class _Foreign:
    topics: Topics
    params: Params

    def found(self) -> Iterator[Foreign]:
        beside: dict[tuple[str, str], list[Block]] = {}
        for file in self.params.judged:
            for block in file.blocks:
                beside.setdefault((_folder(file), _tail(block)), []).append(block)
        for file in self.params.judged:
            loads = self.params.loads(file)
            if (
                not loads
                or not file.blocks
                or file.problems
                or file.uncertain
                or any("*" in block.name for block in file.blocks)
            ):
                continue
            own = [_words(_tail(block)) for block in file.blocks]
            by_file: dict[int, list[Load]] = {}
            for load in loads:
                by_file.setdefault(id(load.node.file), []).append(load)
            for together in by_file.values():
                names = [self._name(load) for load in together]
                if None in names or any(_words(str(name)) & words for name in names for words in own):
                    continue
                found = beside.get((_folder(file), str(names[0])), [])
                if len(set(names)) == 1 and len(found) == 1 and all(self._alone(load) for load in together):
                    yield Foreign(file, together[0], str(names[0]), found[0], self._where(together[0]))

    def _name(self, load: Load) -> str | None:
        """The name of a node, or that of its program where nothing says how this calls its node."""
        node = load.node
        name = self.topics.node(node).name
        if name is None and node.name is None and not isinstance(node.action, ComposableNode):
            return literal_text(node.executable)
        return name

    def _alone(self, load: Load) -> bool:
        """Whether a node gets no other file."""
        rest = [each for each in load.node.parameters if not isinstance(each, DictValue)]
        return load.certain and len(rest) == 1 and not self.params.launch().never_runs(load.node)

    def _where(self, load: Load) -> Span:
        """The name of the file in the launch file, else its path."""
        launch = self.topics.launch
        for each in launch.references(load.node.file):
            if each.kind == "parameters" and each.found.file == load.path:
                return each.where
        return load.where


def _folder(file: ParameterFile) -> str:
    return os.path.dirname(file.source.absolute)


def _tail(block: Block) -> str:
    return block.name.rpartition("/")[2]


def _words(name: str) -> frozenset[str]:
    return frozenset(name.split("_")) - {"node", "driver"} or frozenset({name})
