"""The state in which rcl_yaml_param_parser reads the events of a YAML file, with all that it forgets and mixes up.

The real parser keeps no tree: it has a level, a depth, two name stacks and a table. What odd files lead to follows
from these alone (an empty mapping ends the block, a dotted prefix loses one part too few), so they are kept here as
they are.
"""

from __future__ import annotations

from bisect import insort

from bringup_lint.model.params import Entry
from bringup_lint.model.params import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

HEADER = "ros__parameters"
_NAME = regex(r"[A-Za-z_][A-Za-z0-9_]*\Z")
LONGEST_NAME = 255
LONGEST_NAMESPACE = 245


class Refused(Exception):
    """rcl gives up: a stable code and its own words."""

    def __init__(self, code: str, detail: str) -> None:
        super().__init__(detail)
        self.code = code
        self.detail = detail


class Saved(NamedTuple):
    """All that changes while a file is read, but the table."""

    in_parameters: bool
    depth: int
    is_key: bool
    in_list: bool
    new_map: bool
    node: int
    parameter: int
    names: tuple[str | None, int]
    prefixes: tuple[str | None, int]


class Stack:
    """A joined name and how many parts it is thought to have."""

    __slots__ = ("count", "separator", "text")

    def __init__(self, separator: str) -> None:
        self.separator = separator
        self.text: str | None = None
        self.count = 0

    def push(self, name: str) -> None:
        if not self.count:
            self.text = name
        else:
            text = self.text or ""
            self.text = text + name if text.endswith(self.separator) else f"{text}{self.separator}{name}"
        self.count += 1

    def pop(self) -> None:
        if self.count == 1:
            self.text = None
        elif self.count:
            head, separator, _ = (self.text or "").rpartition(self.separator)
            self.text = head if separator else self.text
        self.count = max(0, self.count - 1)


class Table:
    """The parameters of one node; a name is looked up among those that it has at that moment."""

    __slots__ = ("at", "entries")

    def __init__(self) -> None:
        self.entries: list[Entry] = []
        self.at: dict[str, list[int]] = {}

    def find(self, name: str) -> int:
        found = self.at.get(name)
        if found:
            return found[0]
        self.entries.append(Entry(name))
        insort(self.at.setdefault(name, []), len(self.entries) - 1)
        return len(self.entries) - 1

    def rename(self, index: int, name: str) -> None:
        entry = self.entries[index]
        self.at[entry.name].remove(index)
        insort(self.at.setdefault(name, []), index)
        entry.name = name


class State:
    """What the real parser keeps between two events."""

    def __init__(self) -> None:
        self.in_parameters = False
        self.depth = 0
        self.is_key = True
        self.in_list = False
        self.list_type: str | None = None
        self.new_map = False
        self.node = 0
        self.parameter = 0
        self.names = Stack("/")
        self.prefixes = Stack(".")
        self.nodes: dict[str, int] = {}
        self.node_names: list[str] = []
        """In the order of their numbers."""
        self.tables: list[Table] = []

    def save(self) -> Saved:
        names, prefixes = self.names, self.prefixes
        return Saved(
            self.in_parameters,
            self.depth,
            self.is_key,
            self.in_list,
            self.new_map,
            self.node,
            self.parameter,
            (names.text, names.count),
            (prefixes.text, prefixes.count),
        )

    def restore(self, saved: Saved) -> None:
        self.in_parameters, self.depth, self.is_key, self.in_list, self.new_map, self.node, self.parameter, *rest = (
            saved
        )
        (self.names.text, self.names.count), (self.prefixes.text, self.prefixes.count) = rest

    @property
    def entry(self) -> Entry | None:
        """The parameter that the next value is for."""
        entries = self.tables[self.node].entries if self.node < len(self.tables) else []
        return entries[self.parameter] if self.parameter < len(entries) else None

    def scalar(self, text: str, style: str, value: Value | None) -> None:
        """``value`` is needed only where no key is due."""
        if self.is_key:
            if not text:
                raise Refused("no-key", "No key")
            self.key(text.partition("\0")[0] if "\0" in text else str(text))
            self.is_key = False
            return
        if not self.in_parameters or not self.tables or not self.tables[self.node].entries:
            raise Refused("value-before-parameters", f"Cannot have a value before {HEADER}")
        if not text and style not in ("'", '"'):
            raise Refused("no-value", "No value")
        if value is not None:
            self.store(value)
        if not self.in_list:
            self.is_key = True

    def store(self, value: Value) -> None:
        entry = self.entry
        if entry is None:
            raise Refused("internal", "Internal error: Invalid mem")
        if not self.in_list:
            entry.slots[value.type] = value.data
            return
        if self.list_type is None:
            self.list_type = value.type
            entry.slots[f"{value.type}_array"] = []
        elif self.list_type != value.type:
            raise Refused("mixed-list", f"Sequence should be of same type. Value type '{value.type}' do not belong")
        items = entry.slots.setdefault(f"{value.type}_array", [])
        if isinstance(items, list):
            items.append(value.data)

    def key(self, name: str) -> None:
        if self.in_parameters:
            self.parameter_key(name)
        elif not name.startswith(HEADER):
            self.names.push(name)
        elif not self.names.count:
            raise Refused("no-node-name", f"There are no node names before {HEADER}")
        else:
            name = self.names.text or ""
            if name not in self.nodes:
                self.nodes[name] = len(self.tables)
                self.node_names.append(name)
                self.tables.append(Table())
            self.node = self.nodes[name]
            self.names.pop()
            self.in_parameters = True
            why = invalid_key(name)
            if why:
                raise Refused("node-key", why)

    def parameter_key(self, name: str) -> None:
        if self.new_map:
            entry = self.entry
            if entry is None:
                raise Refused("internal", "Internal error creating param namespace")
            self.prefixes.text = entry.name
            self.prefixes.count += 1
            self.new_map = False
        table = self.tables[self.node]
        prefix = self.prefixes.text
        self.parameter = table.find(name if prefix is None else prefix)
        if prefix is not None:
            table.rename(self.parameter, f"{prefix}.{name}")

    def open_list(self) -> None:
        if self.is_key:
            raise Refused("list-as-key", "Sequences cannot be key")
        if not self.in_parameters:
            raise Refused("list-before-parameters", "Sequences can only be values and not keys in params")
        self.in_list = True
        self.list_type = None

    def close_list(self) -> None:
        self.in_list = False
        self.is_key = True

    def open_map(self) -> None:
        self.depth += 1
        self.is_key = True
        self.new_map = not (self.in_parameters and self.depth - (self.names.count + 1) == 2)

    def close_map(self) -> None:
        if self.in_parameters:
            if self.prefixes.count:
                self.prefixes.pop()
            else:
                self.in_parameters = False
        elif self.depth == self.names.count + 1:
            self.names.pop()
        self.depth -= 1


def invalid_key(name: str) -> str:
    """Why rcl refuses a node key, in its words; empty when it takes it."""
    if name in ("/**", "/*"):
        return ""
    folder, slash, node = name.rpartition("/")
    if slash:
        folder = folder if folder.startswith("/") or not folder else f"/{folder}"
        for token in folder.split("/")[1:]:
            if not token:
                return f"{folder}/ contains repeated forward slash"
            if token not in ("*", "**"):
                why = _invalid_token(token, "namespace")
                if why or len(token) + 1 > LONGEST_NAMESPACE:
                    return why or f"namespace should not exceed '{LONGEST_NAMESPACE}'"
    if node in ("*", "**"):
        return ""
    if not node:
        return "node name must not be empty"
    if len(node) > LONGEST_NAME:
        return f"node name length should not exceed '{LONGEST_NAME}'"
    return _invalid_token(node, "node name")


def _invalid_token(token: str, what: str) -> str:
    if _NAME.match(token):
        return ""
    if any(not (char.isascii() and (char.isalnum() or char == "_")) for char in token):
        return f"{what} must not contain characters other than alphanumerics or '_'"
    return f"{what} must not start with a number"
