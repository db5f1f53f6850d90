"""Parameter files as rcl_yaml_param_parser reads them.

The events of the file go through ``param_state`` exactly as they go through rcl. Where rcl would give up, the entry is
left out with a problem, and reading goes on behind it.
"""

from __future__ import annotations

import re

from bringup_lint.model.params import NOT_SET
from bringup_lint.model.params import Block
from bringup_lint.model.params import Parameter
from bringup_lint.model.params import ParameterFile
from bringup_lint.model.params import Value
from bringup_lint.model.yaml_node import Alias
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.model.yaml_node import YamlCode
from bringup_lint.parsers import yaml_nodes
from bringup_lint.parsers.param_scalar import scalar
from bringup_lint.parsers.param_state import HEADER
from bringup_lint.parsers.param_state import Refused
from bringup_lint.parsers.param_state import Saved
from bringup_lint.parsers.param_state import State
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

MISSPELT = regex(r"ros?_{1,4}para?m[a-z]{0,8}\Z", re.I)
"""A node key that can only mean ``ros__parameters``."""
_STAR = regex(r"[ \t]*(\*[^\s:]*)[ \t]*:(?:[ \t\r\n]|\Z)")
_VERSION = regex(r"^%YAML[ \t]+(?!1\.1[ \t]*(?:#|$))[^\r\n]*", re.M)


def parse(source: Source) -> ParameterFile:
    """Read a parameter file. Every problem stops the process that loads the file; the detail is in the words of rcl.

    Problems: those of ``YamlCode``, ``yaml-version``, ``unquoted-star``,
    ``no-key``, ``list-at-root``, ``no-node-name``, ``node-key``, ``misspelt-header``, ``value-before-parameters``,
    ``empty-block``, ``after-empty-map``, ``no-value``, ``alias``, ``mixed-list``, ``nested-list``, ``list-of-maps``,
    ``list-as-key``, ``list-before-parameters``, ``internal``.
    """
    return _Reader(source).read()


class _Reader:
    def __init__(self, source: Source) -> None:
        self.source = source
        self.file = ParameterFile(source)
        self.state = State()
        self.keys: list[Located] = []

    def read(self) -> ParameterFile:
        tree = yaml_nodes.parse(self.source, follow_aliases=False)
        self.file.uncertain = any(problem.code == YamlCode.TOO_DEEP for problem in tree.problems)
        for problem in tree.problems:
            if problem.code != YamlCode.TOO_DEEP:
                found = self.starred(problem)
                self.problem(found.code, found.where, found.detail)
        version = _VERSION.search(self.source.text) if "%YAML" in self.source.text else None
        if version:
            where = self.source.span(version.start(), version.end())
            self.problem("yaml-version", where, "found incompatible YAML document")
        for document in tree.documents:
            if document.root is not None:
                self.root(document.root)
        state = self.state
        self.file.nodes = {name: state.tables[index].entries for name, index in state.nodes.items()}
        return self.file

    def starred(self, problem: Problem) -> Problem:
        """A node key such as ``*:`` without quotes looks to YAML like a broken alias."""
        line = self.source.line_text(problem.where.line)
        match = _STAR.match(line) if problem.code == YamlCode.SYNTAX else None
        if match is None:
            return problem
        start = self.source.line_starts[problem.where.line - 1] + match.start(1)
        return Problem("unquoted-star", self.source.located(start, start + len(match[1])), problem.detail)

    def root(self, node: Node) -> None:
        saved = self.state.save()
        try:
            if isinstance(node, Mapping):
                self.mapping(node, None)
            else:
                self.feed(node)
        except Refused as refused:
            self.refuse(refused, node, "list-at-root" if isinstance(node, Sequence) else refused.code)
            self.state.restore(saved)

    def mapping(self, node: Mapping, block: Block | None) -> None:
        """A mapping whose entries can be left out one by one."""
        self.state.open_map()
        for key, value in node.pairs:
            before = self.state.save()
            depth = len(self.keys)
            self.pair(key, value, block, before)
            del self.keys[depth:]
        self.state.close_map()

    def pair(self, key: Node, value: Node, block: Block | None, before: Saved) -> None:
        state = self.state
        if block is not None and not before.in_parameters:
            self.after_empty_map(key, value, block, before)
            return
        try:
            self.feed(key)
        except Refused as refused:
            if refused.code != "node-key":
                self.refuse(refused, key)
                state.restore(before)
                return
            self.refuse(refused, self.keys[-1])
            state.is_key = False
        if not isinstance(key, Scalar):
            block = None
        elif block is None and state.in_parameters:
            names = tuple(self.keys)
            name = state.node_names[state.node]
            block = Block(name, names[-1] if names else key.value, names, key.value, value)
            self.file.blocks.append(block)
            self.header(value, block, before)
            return
        elif block is not None and state.in_parameters:
            self.parameter(key, value, block)
            return
        else:
            self.keys.append(key.value)
        self.inside(value, block, before)

    def header(self, value: Node, block: Block, before: Saved) -> None:
        """What is after ``ros__parameters``."""
        empty = isinstance(value, Scalar) and value.value == "" and not value.style
        if empty:
            self.problem("empty-block", block.header, f"Cannot have a value before {HEADER}")
            self.state.restore(before)
        else:
            self.inside(value, block, before)

    def inside(self, value: Node, block: Block | None, before: Saved) -> None:
        if isinstance(value, Mapping):
            self.mapping(value, block)
            return
        try:
            self.feed(value)
        except Refused as refused:
            self.early(refused, value)
            self.state.restore(before)

    def early(self, refused: Refused, value: Node) -> None:
        """A value before ``ros__parameters``: nothing at all, below a misspelt word, or really one."""
        if refused.code in ("value-before-parameters", "list-before-parameters"):
            misspelt = next((key for key in self.keys if MISSPELT.match(key) and not key.startswith(HEADER)), None)
            if misspelt is not None:
                if all(problem.where is not misspelt for problem in self.file.problems):
                    self.problem("misspelt-header", misspelt, refused.detail)
                return
            if isinstance(value, Scalar) and value.value == "" and not value.style and self.keys:
                self.problem("empty-block", self.keys[-1], refused.detail)
                return
        self.refuse(refused, value)

    def parameter(self, key: Scalar, value: Node, block: Block) -> None:
        state = self.state
        entry = state.entry
        name = entry.name if entry else str(key.value)
        if isinstance(value, Mapping):
            if not value.pairs:
                block.parameters.append(Parameter(name, key.value, Value(NOT_SET, None), value, block))
            self.mapping(value, block)
            return
        saved = None if isinstance(value, Scalar) else state.save()
        try:
            found = self.feed(value)
        except Refused as refused:
            self.refuse(refused, value)
            if saved is not None:
                state.restore(saved)
            state.is_key, state.in_list = True, False
            found = None
        if not isinstance(value, Alias):
            block.parameters.append(Parameter(name, key.value, found or Value(NOT_SET, None), value, block))

    def after_empty_map(self, key: Node, value: Node, block: Block, before: Saved) -> None:
        """An empty mapping ended the block early: rcl takes what follows for node names."""
        try:
            self.feed(key)
            self.feed(value)
        except Refused as refused:
            empty = next((p.node for p in reversed(block.parameters) if isinstance(p.node, Mapping)), key)
            if not any(problem.code == "after-empty-map" for problem in self.file.problems[-1:]):
                self.problem("after-empty-map", empty.span, refused.detail)
            self.state.restore(before)

    def feed(self, node: Node) -> Value | None:
        """Hand a node to the state; gives the value of a scalar or a plain list."""
        state = self.state
        if isinstance(node, Scalar):
            value = None if state.is_key else scalar(node.value, node.style, node.tag)
            state.scalar(node.value, node.style, value)
            return value
        if isinstance(node, Sequence):
            state.open_list()
            values = [self.feed(item) for item in node.items]
            state.close_list()
            plain = [value for value in values if value is not None and not value.type.endswith("_array")]
            if plain and len(plain) == len(values):
                return Value(f"{plain[0].type}_array", [value.data for value in plain])
            return None
        if isinstance(node, Mapping):
            state.open_map()
            for key, inner in node.pairs:
                self.feed(key)
                self.feed(inner)
            state.close_map()
            return None
        raise Refused("alias", "Will not support aliasing")

    def refuse(self, refused: Refused, where: Node | Located, code: str = "") -> None:
        if isinstance(where, Sequence) and not code and refused.code != "list-before-parameters":
            code = _list_code(where)
        place = where if isinstance(where, Located) else where.span
        self.problem(code or refused.code, place, refused.detail)

    def problem(self, code: str, where: Located | Span, detail: str) -> None:
        if len(self.file.problems) < 1000:
            self.file.problems.append(Problem(code, where, detail))


def _list_code(node: Sequence) -> str:
    if any(isinstance(item, Mapping) for item in node.items):
        return "list-of-maps"
    return "nested-list" if any(isinstance(item, Sequence) for item in node.items) else ""
