"""Constructors of C++ nodes that log an error and return before they have made anything."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import GivenUp
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.owners import class_made
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

LOGS = regex(r"\bRCLCPP_(?:ERROR|FATAL)\w{0,40}\s{0,4}\(", hints="RCLCPP_ERROR RCLCPP_FATAL")
STAYS = regex(
    r"\b(?:[Ww]ill|[Nn]ode)\s[^\"'\n]{0,40}\b(?:stay|remain|keep)s?\b|\b(?:[Ss]tay|[Rr]emain)(?:s|ing)\s(?:up|idle|alive)\b",
    hints="tay emain keep",
)
"""What is said by a node that is meant to stay without its work."""
_BASE = regex(r"(?:rclcpp::)?Node\Z")
_ENDS = regex(r"\b(?:shutdown|throw|\w{0,20}exit|abort|terminate|assert|raise|kill)\b|[^=!<>]=(?!=)")
"""By what a program ends, or may learn that its node is of no use."""
_MAKES = regex(r"create_(?:(?:wall_)?timer|(?:generic_)?(?:publisher|subscription|client|service)|server)\Z")
_MAY_MAKE = regex(
    r"\bcreate_|Subscriber\b|Publisher\b|Server\b|[tT]hread\b|async|spin|[tT]imer|Handler\b|Listener\b|Updater\b"
    r"|\badd_\w{1,40}_callback",
    hints="create_ ubscriber ublisher erver hread async spin imer andler istener pdater add_",
)
"""What may run something later."""
_OF_NODES = regex(
    r"(?:declare_|get_|has_|set_|undeclare_|(?:now|exit|printf|u?sleep)\Z|\w{1,20}_cast\Z|[A-Z][A-Z0-9_]{0,60}\Z)"
)
"""The names of calls of a node that make nothing, and of macros."""
_FLAG = regex(r"=\s{0,4}true\s{0,4};", hints="true")
_HANDED = regex(r"\bthis\b(?!\s{0,4}->)|shared_from_this", hints="this")
_POINTERS = ("shared_ptr", "unique_ptr")
"""They keep the node that they are handed, and run nothing."""
_COMPARED = regex(r"\((?:!?(?P<empty>\w+)\.empty\(\)|(?P<name>\w+)(?:[=!]=|[<>]=?)[\w:.\[\]\"'-]{1,120})\)\Z")
"""A condition that compares one variable with a constant."""
_READ = (
    r"\b{0}\s{{0,4}}=\s{{0,8}}(?:this->)?(?:get|declare)_parameter\s{{0,4}}(?:<[^<>;]{{0,80}}>)?"
    r"\((?:[^;()]|\([^;()]{{0,80}}\)){{0,200}}\)"
    r"(?:\.get_parameter_value\(\))?(?:\.(?:as_\w{{1,20}}|get(?:_value)?<[^<>;]{{0,80}}>)\(\))?\s{{0,4}};"
    r"|\bget_parameter(?:_or)?\s{{0,4}}(?:<[^<>;]{{0,80}}>)?\([^;(),]{{0,80}},\s{{0,8}}{0}\s{{0,4}}[,)]"
)
"""What gives a variable the value of a parameter as it is."""
_BRANCHES = frozenset({"if_statement", "else_clause", "catch_clause"})


def given_up(code: Code) -> Iterator[GivenUp]:
    """The first return of each constructor after which its node has neither timer nor topic nor service."""
    if not LOGS.search(code.source.text):
        return
    bodies = Bodies(code)
    returns = _returns(code)
    making = _Making(code, bodies)
    for function in code.written.get("function", ()):
        owner = _made(code, function)
        calls = list(bodies.own(function)) if owner is not None else []
        lost = next((each for each in calls if making.may(each)), None)
        if owner is None or lost is None or _FLAG.search(blanked(code.text(function))):
            continue
        idle = _idle_until(code, function, lost)
        early = (each for each in returns.get(function.id, ()) if code.span(each).start < idle)
        left = next((each for each in early if _gives_up(code, each)), None)
        if left is not None:
            yield GivenUp(code.span(left), code.span(lost.node), owner, _is_setting(code, function, left))


def _made(code: Code, function: Node) -> str | None:
    """The class of which a definition is the constructor, when it is a plain node that no member is handed."""
    lists = (each for each in function.children if each.type == "field_initializer_list")
    members = [each for outer in lists for each in outer.named_children if each.named_child_count > 1]
    names = ("".join(code.text(each.named_children[0]).split()) for each in members)
    if not any(map(_BASE.match, names)) or any(_HANDED.search(code.text(each)) for each in members):
        return None
    return class_made(code, function)


class _Making:
    """What the calls of constructors may make that runs later."""

    def __init__(self, code: Code, bodies: Bodies) -> None:
        self._code = code
        self._bodies = bodies
        self._known: dict[int, bool] = {}

    def may(self, call: Call) -> bool:
        """Whether a call may make it itself, in a method, or in what is handed the node."""
        given = (each for each in call.arguments if each.type != "lambda_expression")
        if call.name in _POINTERS:
            return False
        if any(_HANDED.search(self._code.text(each)) for each in given):
            return True
        if call.qualified not in (call.name, f"this->{call.name}") or _OF_NODES.match(call.name):
            return False
        methods = self._bodies.functions.get(call.name, ())
        return len(methods) != 1 or self._makes(methods[0])

    def _makes(self, method: Node) -> bool:
        if method.id not in self._known:
            self._known[method.id] = _MAY_MAKE.search(blanked(self._code.text(method))) is not None
        return self._known[method.id]


def _idle_until(code: Code, function: Node, made: Call) -> int:
    """The place in a constructor up to which the node surely has nothing that may run later."""
    whole = code.span(function)
    first = _MAY_MAKE.search(blanked(whole.text))
    return min(code.span(made.node).start, whole.start + first.start() if first is not None else whole.end)


def _returns(code: Code) -> dict[int, list[Node]]:
    """The returns of each function, in the order of the text."""
    found: dict[int, list[Node]] = {}
    for left in code.written.get("return", ()):
        function = code.body_of(left)
        if function is not None:
            found.setdefault(function.id, []).append(left)
    return found


def _gives_up(code: Code, left: Node) -> bool:
    """Whether a return is in a branch that logs an error, and leaves nothing by which anybody else would know."""
    block = left.parent
    if block is None or block.type != "compound_statement" or block.parent is None:
        return False
    before = blanked(code.text(block))
    if STAYS.search(code.text(block)):
        return False
    return block.parent.type in _BRANCHES and bool(LOGS.search(before)) and not _ENDS.search(before)


def _is_setting(code: Code, function: Node, left: Node) -> bool:
    """Whether all conditions of the chain of branches that a return is in compare one parameter with constants."""
    conditions = ("".join(code.text(each).split()) for each in _conditions(left))
    found = [_COMPARED.match(each) for each in conditions]
    names = {each["empty"] or each["name"] if each is not None else None for each in found}
    name = next(iter(names)) if len(names) == 1 else None
    text = code.text(function)
    read = re.search(_READ.format(re.escape(name)), text) if name is not None else None
    return read is not None and not re.search(rf"\b{name}\s{{0,4}}=[^=]", text[read.end() :])


def _conditions(left: Node) -> Iterator[Node | None]:
    """Those of the ``if`` that a return is in, and of those whose ``else`` that is."""
    block = left.parent
    node = block.parent if block is not None else None
    while node is not None and node.type in ("if_statement", "else_clause"):
        if node.type == "if_statement":
            yield node.child_by_field_name("condition")
            if node.parent is None or node.parent.type != "else_clause":
                return
        node = node.parent
