"""Defaults of ``bool`` parameters that are string literals, whose address converts to true."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.cpp_source import TextAsBool
from bringup_lint.parsers.cpp_node.parameters import DECLARING
from bringup_lint.parsers.cpp_node.parameters import constant
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.values import declared
from bringup_lint.source import Located

_DEFAULTS = {"declare_parameter": 1, "get_parameter_or": -1}
"""Where calls take the value of a parameter that nothing sets."""
_UNCONDITIONAL = frozenset(
    "expression_statement declaration init_declarator assignment_expression call_expression field_expression "
    "argument_list".split()
)
"""What is between a call and its block where each run of the block makes it."""

Declarations = dict[tuple[str, str], dict[int, int]]
"""Object and parameter -> block -> where the block first declares it and gives it a value."""


def texts_as_bool(code: Code) -> Iterator[TextAsBool]:
    texts = [(call, text) for call in code.calls if (text := _text(code, call)) is not None]
    known = _declarations(code) if texts else {}
    for call, text in texts:
        name = code.literal(call.arguments[0])
        yield TextAsBool(name, text, name is not None and _is_declared_before(code, call, name, known))


def _text(code: Code, call: Call) -> Located | None:
    """The string literal that a call takes for the value of a ``bool``."""
    at = _DEFAULTS.get(call.name)
    if at is None or len(call.arguments) < 2 or "".join(code.text(call.template).split()) != "<bool>":
        return None
    given = call.arguments[at]
    return code.literal(given) if given.type == "string_literal" else None


def _declarations(code: Code) -> Declarations:
    found: Declarations = {}
    for call in code.calls:
        name, default = declared(code, call) if call.name in DECLARING else (None, None)
        if name is not None and (call.template is not None or constant(code, default) is not None):
            start = call.node.start_byte
            blocks = found.setdefault((_owner(call), str(name)), {})
            block = _block_of(code, call)
            blocks[block] = min(start, blocks.get(block, start))
    return found


def _is_declared_before(code: Code, call: Call, name: str, known: Declarations) -> bool:
    """Whether a statement before a call, in a block around it, has declared the parameter and given it a value."""
    blocks = known.get((_owner(call), name), {})
    start = call.node.start_byte
    return any(blocks.get(outer.id, start) < start for outer in code.above(call.node))


def _owner(call: Call) -> str:
    return call.qualified.removesuffix(call.name).removeprefix("this->")


def _block_of(code: Code, call: Call) -> int:
    """The block of which each run makes a call; 0 where something decides about it."""
    for outer in code.above(call.node):
        if outer.type == "compound_statement":
            return outer.id
        if outer.type not in _UNCONDITIONAL:
            return 0
    return 0
