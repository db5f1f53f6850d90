"""The texts of a C++ file, and whether all names that it declares parameters under are among them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.parameter_words import LOOSE
from bringup_lint.model.parameter_words import PLAIN
from bringup_lint.model.parameter_words import Asked
from bringup_lint.model.parameter_words import ParameterWords
from bringup_lint.parsers.cpp_node.parameters import DECLARING
from bringup_lint.parsers.cpp_node.parameters import reads
from bringup_lint.parsers.cpp_node.values import declared
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from tree_sitter import Node

    from bringup_lint.parsers.cpp_node.syntax import Call
    from bringup_lint.parsers.cpp_node.syntax import Code

TEXT = 400_000
"""Code points of a file."""
_READ = regex(r"\b(?:get_parameter(?:_or|_value)?|has_parameter|undeclare_parameter)\s*(?:<[^;(){}]{0,80}>\s*)?\(\Z")
"""What is before the name of a parameter that is only read."""
_TOKEN = regex(r'"(?P<text>(?:\\.|[^"\\\n])*)"(?P<after>\s*\+)?' r"|'(?:\\.|[^'\\\n])'|//[^\n]*|/\*.*?(?:\*/|\Z)", re.S)
_MACRO = regex(r"^(?<!\\\n)[ \t]*#[ \t]*define\b(?:\\\n|[^\n])*parameter", re.M)
_OWN = regex(r"(?:(?:this|self|\w{0,64}node\w{0,64}|p?nh_?)(?:->|\.))?get_parameter\w*\Z", re.I)
_QUIET = ("get_parameter", "get_parameter_or")
_OWN_DECLARING = regex(r"(?:(?:this|self|\w{0,64}node\w{0,64}|p?nh_?)(?:->|\.))?declare_parameter\Z", re.I)
_TYPE = regex(r"(?:rclcpp::)?(?:ParameterType::)?PARAMETER_[A-Z_]+\Z")
_HELPER = regex(r"(?=\w+\Z)\w*(?:param|declare)\w*", re.I)
"""The name of a function that may declare parameters for others."""
_CALLED = regex(r"(?:param|declare)\w{0,64}\s*[<(]", re.I, hints="param declare")
_FUNCTION = regex(r"\b(\w+)\s*\(")
_WORD = regex(r'"[^"\n]*\w[^"\n]*"')
"""A text that says something: one that only joins two names does not."""
_LOOPS = frozenset({"for_range_loop", "for_statement", "while_statement"})


def parse(source: Source) -> ParameterWords:
    """Never raises."""
    text = source.text
    if len(text) > TEXT:
        return ParameterWords(open=True)
    found = list(_texts(text))
    texts = frozenset(each for each, _ in found)
    pieces = frozenset(each for each, joined in found if joined)
    if "_parameter" not in text and not _CALLED.search(text):
        return ParameterWords(texts, pieces, declared=frozenset())
    if LOOSE.search(text) or _MACRO.search(text):
        return ParameterWords(texts, pieces, open=True)
    from bringup_lint.parsers.cpp_node.syntax import Code

    code = Code(source)
    asked = tuple(_asked(code))
    unset = tuple(_unset(code, {str(each.name) for each in asked if each.required}))
    opened = any(_is_open(code, call) for call in code.calls)
    helpers, handed = frozenset(_helpers(code)), frozenset(_handed(code))
    return ParameterWords(texts, pieces, asked, unset, opened, helpers, handed, _declared(code))


def _declared(code: Code) -> frozenset[str] | None:
    """The names of the declarations; None where a call makes one of something else than a text."""
    found = set()
    for call in code.calls:
        if call.name in DECLARING:
            name = declared(code, call)[0] if call.name != "declare_parameters" else None
            if name is None:
                return None
            found.add(str(name))
        elif _HELPER.fullmatch(call.name) and not PLAIN.fullmatch(call.name):
            if any(_WORD.search(code.text(each)) for each in call.arguments):
                return None
    return frozenset(found)


def _texts(text: str) -> Iterator[tuple[str, bool]]:
    """The texts outside of comments, and whether each is put together with something."""
    last = 0
    for found in _TOKEN.finditer(text):
        if found["text"] is not None:
            before = text[last : found.start()].rstrip()
            joined = before.endswith("+")
            if not _is_read(before[:-1].rstrip() if joined else before):
                yield found["text"], joined or found["after"] is not None
        last = found.end()


def _is_read(before: str) -> bool:
    """Whether a text is the name of a parameter that is only read, by what is written before it."""
    return before.endswith("(") and "_parameter" in before and _READ.search(before) is not None


def _asked(code: Code) -> Iterator[Asked]:
    """What a node is asked for; parameter clients ask other nodes."""
    looked = {str(read.name) for call in code.calls if call.name == "has_parameter" for read in reads(code, call)}
    for call in code.calls:
        if _OWN.match(call.qualified):
            tried = _is_tried(code, call)
            for read in reads(code, call):
                is_looked = read.name in looked
                quiet = call.name in _QUIET and len(call.arguments) > 1 and not is_looked
                yield Asked(read.name, read.required and not tried and not is_looked, quiet)


def _unset(code: Code, used: set[str]) -> Iterator[Located]:
    """What is declared with a type alone: with a template at once, else when it is asked for, no value raises."""
    for call in code.calls:
        name = code.literal(call.arguments[0]) if call.arguments and call.name == "declare_parameter" else None
        if name is None or not _OWN_DECLARING.match(call.qualified) or _is_tried(code, call):
            continue
        typed = call.template is not None and len(call.arguments) == 1
        if typed or (len(call.arguments) == 2 and name in used and _TYPE.match(code.text(call.arguments[1]))):
            yield name


def _is_tried(code: Code, call: Call) -> bool:
    """Whether a condition decides about a call, or its exception is handled."""
    return code.is_conditional(call.node) or any(each.type == "try_statement" for each in code.above(call.node))


def _is_open(code: Code, call: Call) -> bool:
    """Whether a declaration takes its name from something that is not written in the file."""
    if call.name not in DECLARING or not call.arguments:
        return False
    given = call.arguments[:2] if call.name in ("declare_parameters", "declare_parameter_if_not_declared") else []
    return not any(_is_written(code, each) for each in (given or call.arguments[:1]))


def _is_written(code: Code, node: Node) -> bool:
    """Whether a text, a constant, or the parameter of a helper gives the name."""
    text = code.text(node)
    if _WORD.search(text):
        return True
    name = text.strip()
    if not re.fullmatch(r"[A-Za-z_]\w*(?:\.c_str\(\))?", name):
        return bool(re.fullmatch(r"(?:\w+::)*[A-Z][A-Z0-9_]*|(?:\w+::)*k[A-Z]\w*", name))
    return name.isupper() or _is_constant(code, name) or _is_of_helper(code, node, name.removesuffix(".c_str()"))


def _is_constant(code: Code, name: str) -> bool:
    for made in code.written.get("made", ()):
        declared = code.text(made.child_by_field_name("declarator")).lstrip("*& ").removesuffix("[]")
        if declared == name and _WORD.search(code.text(made.child_by_field_name("value"))):
            return True
    return False


def _helpers(code: Code) -> Iterator[str]:
    """The functions that hand a name which they are given to a declaration, or to a function that may declare."""
    for call in code.calls:
        if call.arguments and (call.name in DECLARING or _HELPER.fullmatch(call.name)):
            header = _giving(code, call.arguments[0], code.text(call.arguments[0]).removesuffix(".c_str()"))
            named = _FUNCTION.search(header)
            if named is not None:
                yield named[1]


def _handed(code: Code) -> Iterator[str]:
    """The functions that may declare parameters, and are given a name which comes from somewhere else."""
    for call in code.calls:
        if call.arguments and _HELPER.fullmatch(call.name) and call.name not in DECLARING:
            if not any(_is_written(code, each) for each in call.arguments[:2]):
                yield call.name


def _is_of_helper(code: Code, node: Node, name: str) -> bool:
    """Whether a name is a parameter of the function around it, which is not gone through in a loop."""
    return bool(_giving(code, node, name))


def _giving(code: Code, node: Node, name: str) -> str:
    """The head of the function around a name that is one of its parameters; empty where it is none."""
    written = re.escape(name)
    for outer in code.above(node):
        if outer.type in _LOOPS and re.search(rf"\b{written}\b", code.text(outer).partition("{")[0]):
            return ""
        if outer.type in ("lambda_expression", "function_definition"):
            header = code.text(outer).partition("{")[0]
            if re.search(rf"\b(?:string|string_view|char)\b[\s&*]*{written}\b|\bauto\b[\s&*]*{written}\b", header):
                return header
    return ""
