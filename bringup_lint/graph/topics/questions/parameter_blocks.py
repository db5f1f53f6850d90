"""Which blocks of a parameter file reach which nodes, by the names that launch files and sources give them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.facts.ros.parameters import OF_EVERY_NODE
from bringup_lint.facts.ros.parameters import PublicNode
from bringup_lint.facts.ros.parameters import public_node
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.loads import PYYAML
from bringup_lint.graph.params.loads import REPLACED
from bringup_lint.graph.params.loads import REWRITTEN
from bringup_lint.graph.params.loads import Load
from bringup_lint.graph.plugins.controllers import is_manager
from bringup_lint.model.launch import Node
from bringup_lint.model.params import Block
from bringup_lint.model.params import ParameterFile
from bringup_lint.model.params import matches
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.spelling import nearest
from bringup_lint.spelling import numbered

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.parameter_words import ParameterWords

VALUES = ("nested-list", "mixed-list", "list-of-maps")
"""Problems of single values: the blocks around them are read all the same."""
_MOST = 4_000
"""Pairs of a block and a node that gets its file; with more, a file is not looked at."""
_MANAGER = "controller_manager"
"""How ros2_control_node is called; its process has the controllers as further nodes (ros2_control_node.cpp)."""
_TELLING = 2
"""Parameters that say together for which program a block is."""


class Mismatch(NamedTuple):
    """A block that is meant for a node and does not reach it."""

    file: ParameterFile
    block: Block
    load: Load
    name: str
    """The node's fully qualified name."""
    misspelt: bool
    """Another name; else the same name in another namespace."""

    def changes_nothing(self, topics: Topics) -> bool:
        """Whether the block holds what the program of the node takes by itself."""
        node = self.load.node
        public = _public(self.load)
        defaults = public.defaults if public is not None else topics.defaults_beside(node) | topics.defaults(node)
        given = [(each.name, each.value.data) for each in self.block.parameters if each.name not in OF_EVERY_NODE]
        if public is not None:
            given = [(name, value) for name, value in given if public.declares(name)]
        return bool(given) and all(name in defaults and defaults[name] == value for name, value in given)


def unreached(topics: Topics) -> Iterator[Mismatch]:
    """Nodes that get a file of which no block matches them, though one is meant for them."""
    return _Matching(topics).unreached()


def unused(topics: Topics) -> Iterator[Mismatch]:
    """Blocks that match no node that gets the file, and are nearly the name of one that another block matches."""
    matching = _Matching(topics)
    missed = {found.block for found in matching.unreached()}
    return (found for found in matching.unmatched() if found.block not in missed)


@dataclass(frozen=True, eq=False)
class _Matching:
    topics: Topics

    @property
    def params(self) -> Params:
        return self.topics.params()

    def unreached(self) -> Iterator[Mismatch]:
        for file, loads in certain(self.params):
            known = set(map(id, loads))
            missed = [each for each in loads if not any(self._reaches(block, each) for block in file.blocks)]
            if not missed:
                continue
            for same in self._by_node(loads):
                names = [self._name(load) for load in same]
                if None in names or any(self._reaches(block, load) for block in file.blocks for load in same):
                    continue
                others = [load for load in self.params.loads(file) if load.node.action is not same[0].node.action]
                others = [load for load in others if id(load) in known or self._name(load) is not None]
                free = [block for block in file.blocks if not any(self._reaches(block, load) for load in others)]
                yield from islice(self._mismatches(file, free, same[0], loads, missed), 1)

    def _by_node(self, loads: list[Load]) -> Iterator[list[Load]]:
        """The loads of each node; not those of files that another file includes, where there are others."""
        by_node: dict[int, list[Load]] = {}
        for load in loads:
            by_node.setdefault(load.node.action.key, []).append(load)
        for every in by_node.values():
            yield [load for load in every if not self.params.is_included(load)] or every

    def _mismatches(
        self, file: ParameterFile, blocks: list[Block], load: Load, loads: list[Load], missed: list[Load]
    ) -> Iterator[Mismatch]:
        """``missed``: those of the loads that no block reaches."""
        name = str(self._name(load))
        kinds = [(block, _meant(block, name)) for block in blocks]
        yield from (Mismatch(file, block, load, name, kind) for block, kind in kinds if kind is not None)
        for block in blocks:
            named = _is_named_after(block, load, missed)
            if named or self._is_declared(block, load, loads) or self._is_of_public(block, load, missed):
                yield Mismatch(file, block, load, name, True)
        twins = [block for block in blocks if self._is_twin(file, block, load, loads)]
        if len(twins) == 1 and all(each.node.action is load.node.action for each in missed):
            yield Mismatch(file, twins[0], load, name, True)

    def _is_twin(self, file: ParameterFile, block: Block, load: Load, loads: list[Load]) -> bool:
        """Whether a block has the parameters of one that reaches another node of the same program."""
        names = {str(each.name) for each in block.parameters}
        program = _program(load)
        others = [each for each in loads if each.node.action is not load.node.action and _program(each) == program]
        same = [each for each in file.blocks if {str(one.name) for one in each.parameters} == names]
        return len(names) >= _TELLING and any(self._reaches(each, other) for each in same for other in others)

    def _is_declared(self, block: Block, load: Load, loads: list[Load]) -> bool:
        """Whether the program of a node, and of no other one that gets the file, names all parameters of a block."""
        names = _telling(block)
        if not names:
            return False
        programs = {id(each.node.action): self.topics.parameter_words(each.node) for each in loads}
        own = programs.pop(id(load.node.action))
        others = [words for words in programs.values() if words is None or _names_most(words, names)]
        return own is not None and names <= own.texts and not others

    def _is_of_public(self, block: Block, load: Load, missed: list[Load]) -> bool:
        """Whether a block is for the public program of a node, and of no other one that no block reaches: it has a name
        that the program gives itself, or holds only what this program declares."""
        public, names = _public(load), _telling(block)
        if public is None or not names:
            return False
        declared = not public.has_plugins and all(map(public.declares, names))
        others = [each for each in missed if each.node.action is not load.node.action]
        return (declared or block.name.strip("/") in public.names) and not any(
            self._may_declare(each, names) for each in others
        )

    def _may_declare(self, load: Load, names: frozenset[str]) -> bool:
        """Whether a node may declare most of some parameters."""
        public = _public(load)
        if public is not None:
            return len(list(filter(public.declares, names))) > len(names) / 2
        words = self.topics.parameter_words(load.node)
        return words is None or _names_most(words, names)

    def unmatched(self) -> Iterator[Mismatch]:
        for file, loads in certain(self.params):
            named = [load for load in loads if self._name(load) is not None]
            unnamed = [load for load in loads if self._name(load) is None]
            if any(map(self._is_any, unnamed)) or read_elsewhere(self.params, file, loads):
                continue
            names = {str(self._name(load)): load for load in named}
            for block in file.blocks:
                if any(self._reaches(block, load) for load in named) or _may_be_for(block, unnamed):
                    continue
                found = next(((name, kind) for name in names if (kind := _meant(block, name)) is not None), None)
                if found is not None:
                    yield Mismatch(file, block, names[found[0]], found[0], found[1])

    def _is_any(self, load: Load) -> bool:
        """Whether a node of unknown name may be called anything: its program is elsewhere, or an argument names it."""
        is_own = str(literal_text(load.node.package)) in self.topics.launch.workspace.packages
        return load.node.name is not None or not is_own

    def _reaches(self, block: Block, load: Load) -> bool:
        name = self._name(load)
        return name is None or matches(block.name, name)

    def _name(self, load: Load) -> str | None:
        """The full name of a node that gets a file: as launched, else the one that its program gives itself."""
        node = self.topics.node(load.node)
        space = node.namespace or load.node.usual_namespace
        called = node.name or (_MANAGER if load.node.name is None and is_manager(load.node) else None)
        return f"{space.rstrip('/')}/{called}" if called and space is not None else None


def _program(load: Load) -> tuple[str, str]:
    return str(literal_text(load.node.package)), str(literal_text(load.node.plugin or load.node.executable))


def _names_most(words: ParameterWords, names: frozenset[str]) -> bool:
    return len(names & words.texts) > len(names) / 2


def _public(load: Load) -> PublicNode | None:
    return public_node(*_program(load))


def _telling(block: Block) -> frozenset[str]:
    """The parameters of a block that say for which program it is; none where its name is for a namespace or for several
    nodes."""
    names = frozenset(str(each.name) for each in block.parameters).difference(OF_EVERY_NODE)
    is_plain = "/" not in block.name.strip("/") and "*" not in block.name
    return names if is_plain and len(names) >= _TELLING else frozenset()


def certain(params: Params) -> Iterator[tuple[ParameterFile, list[Load]]]:
    """Files with the nodes that get them; without those that never start, as nothing builds their program."""
    for file in params.judged:
        loads = [load for load in params.loads(file) if not params.launch().never_runs(load.node)]
        odd = any(sign in block.name for block in file.blocks for sign in "$<>{}%@")
        read = all(problem.code in VALUES for problem in file.problems)
        few = len(loads) * len(file.blocks) <= _MOST
        if loads and few and read and not file.uncertain and not odd and all(map(_plain, loads)):
            yield file, loads


def _plain(load: Load) -> bool:
    """Whether the node reads the file itself: no component, no container, no namespace put around the file,
    and no helper that may change its names."""
    action = load.node.action
    if load.how in (PYYAML, REPLACED) or not isinstance(action, Node) or action.container or action.components:
        return False
    if literal_text(load.node.executable) is None or "container" in str(literal_text(load.node.executable)):
        return False
    return load.how != REWRITTEN or load.root_key is None or text_of(load.root_key) == ""


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


def _is_named_after(block: Block, load: Load, unreached: list[Load]) -> bool:
    """Whether a block is called as the package or program of a node, and of no other one that no block reaches."""
    own = _programs(load)
    others = [each for each in unreached if each.node.action is not load.node.action]
    return block.name.strip("/") in own and not any(block.name.strip("/") in _programs(each) for each in others)


def _may_be_for(block: Block, unnamed: list[Load]) -> bool:
    """Whether a node whose program gives it a name that is not known may be called as a block."""
    words = _words(block.name.rpartition("/")[2])
    return any(words & _words("_".join(_programs(load))) for load in unnamed)


def _programs(load: Load) -> frozenset[str]:
    words = (literal_text(load.node.package), literal_text(load.node.executable))
    return frozenset(str(word).removesuffix(".py") for word in words if word)


def _words(name: str) -> frozenset[str]:
    """The words of a name, whatever their order, without the one that says that it is a node."""
    return frozenset(name.split("_")) - {"node"}


def read_elsewhere(params: Params, file: ParameterFile, loads: list[Load]) -> bool:
    """Whether another file of the tree mentions the file by name, so that somebody else may load it."""
    known = {load.node.file.source for load in loads} | {load.where.source for load in loads}
    known |= {span.source for load in loads for span in load.node.chain}
    return params.named_elsewhere(file.source.basename, known)
