"""Netplan YAML: every key and value compared with netplan's own grammar."""

from __future__ import annotations

from bringup_lint.model.netplan import Definition
from bringup_lint.model.netplan import NetplanFile
from bringup_lint.model.schema import Code
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.parsers import yaml_nodes
from bringup_lint.parsers.netplan_schema import mapping_of
from bringup_lint.parsers.netplan_values import NAME
from bringup_lint.parsers.netplan_values import check
from bringup_lint.pattern import regex
from bringup_lint.schema.walk import level
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

NAMED = regex(r"\{(?P<key>\w+):(?P<value>[\w-]+)\}\Z")


def parse(source: Source) -> NetplanFile:
    """Read a netplan file, or the ``network:`` of a cloud-init configuration.

    Problems: those of YAML, and those of ``Code``; the item of an unknown name is the mapping that it is in.
    """
    yaml = yaml_nodes.parse(source)
    file = NetplanFile(source, yaml, embedded=source.kind == "cloud-init-network")
    file.problems.extend(yaml.problems)
    root = yaml.root
    if file.embedded and isinstance(root, Mapping):
        network = root.mapping("network") or (root if root.get("version") else None)
        if network is not None and _is_version_2(network):
            _Reader(file).network(network)
    elif root is not None:
        _Reader(file).mapping(root, "root")
    return file


def _text(node: Node) -> str | None:
    return str(node.value) if isinstance(node, Scalar) else None


def _is_version_2(network: Mapping) -> bool:
    version = network.scalar("version")
    return version is not None and version.value == "2"


class _Reader:
    def __init__(self, file: NetplanFile) -> None:
        self.file = file

    def problem(self, code: Code, where: Located | Span, detail: str) -> None:
        self.file.problems.append(Problem(code, where, detail))

    def mapping(self, node: Node, table: str) -> None:
        inside = mapping_of(table)
        if not isinstance(node, Mapping) or inside is None:
            self.shape(node, "mapping")
            return
        for key, value in node.pairs:
            if not isinstance(key, Scalar):
                self.shape(key, "scalar")
                continue
            found = level([(key.value, value)], inside.children, inside)
            for remark in found.remarks:
                (self.file.newer if remark.code is Code.TOO_NEW else self.file.problems).append(remark)
            for _, known in found.known:
                if table == "root":
                    self.network(value)
                elif table == "network" and known.type.startswith("{id:"):
                    self.devices(value, known.name)
                elif not (table == "vlans" and key.value == "renderer" and _text(value) == "sriov"):
                    self.value(value, known.name, known.type)
                self.remember(table, key, value)

    def network(self, node: Node) -> None:
        self.mapping(node, "network")

    def remember(self, table: str, key: Scalar, value: Node) -> None:
        if table == "network" and isinstance(value, Scalar):
            if key.value == "renderer":
                self.file.renderer = value.value
            elif key.value == "version":
                self.file.version = value.value
        elif table == "ovs-global" and key.value == "ports" and isinstance(value, Sequence):
            pairs = (pair for pair in value.items if isinstance(pair, Sequence))
            self.file.ports.extend(port.value for pair in pairs for port in pair.scalars)

    def devices(self, node: Node, kind: str) -> None:
        if not isinstance(node, Mapping):
            self.shape(node, "mapping")
            return
        renderer = None
        for key, value in node.pairs:
            if not isinstance(key, Scalar):
                self.shape(key, "scalar")
            elif not NAME.match(key.value):
                self.problem(Code.NAME, key.value, "is not an interface name")
            elif set("*[]?") & set(key.value):
                self.problem(Code.NAME, key.value, "must not contain a glob; use match instead")
            elif key.value == "renderer":
                renderer = self.renderer(value)
            elif not isinstance(value, Mapping):
                self.shape(value, "mapping", key)
            else:
                self.file.definitions.append(Definition(kind, key.value, value, renderer))
                self.mapping(value, kind)

    def renderer(self, node: Node) -> Located | None:
        self.value(node, "renderer", "renderer")
        return node.value if isinstance(node, Scalar) else None

    def value(self, node: Node, key: str, grammar: str) -> None:
        if grammar == "string or {tunnel-keys}":
            grammar = "{tunnel-keys}" if isinstance(node, Mapping) else "string"
        elif grammar == "driver" and isinstance(node, Sequence):
            grammar = "[driver]"
            if not node.items:
                self.problem(Code.VALUE, node.span, "is an empty sequence")
        if grammar.startswith("["):
            self.sequence(node, key, grammar[1:-1])
        elif grammar == "{*}":
            self.free(node, "string", key)
        elif named := NAMED.match(grammar):
            self.named(node, named["value"], key)
        elif grammar.startswith("{"):
            self.mapping(node, grammar[1:-1])
        elif isinstance(node, Scalar):
            self.scalar(node, grammar)
        else:
            self.shape(node, "scalar")

    def sequence(self, node: Node, key: str, item: str) -> None:
        if not isinstance(node, Sequence):
            self.shape(node, "sequence")
            return
        if key == "port-range" and len(node.items) != 2:
            self.problem(Code.VALUE, node.span, "needs exactly two values")
        for entry in node.items:
            if item == "address" or item == "allowed-ip":
                self.address(entry, item)
            elif item == "[id]" and isinstance(entry, Sequence) and len(entry.items) != 2:
                self.problem(Code.VALUE, entry.span, "needs exactly two ports")
            else:
                self.value(entry, key, item)

    def address(self, node: Node, grammar: str) -> None:
        """An address, or a mapping of one address to its options."""
        if isinstance(node, Mapping) and node.pairs:
            text, options = node.pairs[0]
            if isinstance(text, Scalar):
                self.scalar(text, grammar)
            self.mapping(options, "address-options")
        elif isinstance(node, Scalar):
            self.scalar(node, grammar)
        else:
            self.shape(node, "scalar")

    def named(self, node: Node, value: str, key: str) -> None:
        """A mapping of names to a table, or to scalars of one kind."""
        if mapping_of(value) is None:
            self.free(node, value, key)
        elif isinstance(node, Mapping):
            for name, body in node.pairs:
                if isinstance(name, Scalar):
                    self.mapping(body, value)
                else:
                    self.shape(name, "scalar")
        else:
            self.shape(node, "mapping")

    def free(self, node: Node, grammar: str, key: str) -> None:
        if not isinstance(node, Mapping):
            self.shape(node, "mapping")
            return
        for name, value in node.pairs:
            if isinstance(name, Scalar):
                self.value(value, key, grammar)
            else:
                self.shape(name, "scalar")

    def scalar(self, node: Scalar, grammar: str) -> None:
        fault, since = check(grammar, node)
        if since:
            self.file.newer.append(Problem(Code.TOO_NEW, node.value, since))
        if fault is not None:
            self.problem(fault.code, node.value if node.value else node.span, fault.detail)

    def shape(self, node: Node, expected: str, key: Scalar | None = None) -> None:
        where = node.value if isinstance(node, Scalar) and node.value else node.span
        if isinstance(node, Scalar) and not node.value and key is not None:
            where = key.value
        self.problem(Code.SHAPE, where, expected)
