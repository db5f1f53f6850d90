"""Loops that read a serial port and go on at once whatever the read returns.

Once a USB adapter is unplugged, ``read`` returns at once: 0 after the hang-up (Linux, ``hung_up_tty_read``), or -1."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import IdleRead
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

SERIAL = regex(r"\btcsetattr\b|\btermios", hints="tcsetattr termios")
_READ = ("read", "::read")
_LOOPS = ("while_statement", "for_statement")
_BOUNDED = regex(r"[<>]|(?i:time|elapsed|deadline|count|tries|retr)")
"""What of a condition may end a loop by itself."""
_PASSIVE = regex(
    r"(?i)(?:rclcpp_|ros_|log|spd|std::c(?:err|out)|f?printf|perror|fputs|lock|unlock|memset|bzero|fflush)"
)
"""The beginnings of statements that alter nothing: logs, locks and empty buffers."""
_WAITS = regex(r"(?i)sleep|wait|poll|select|spin|rate|yield|throttled_|open")
_FAILED = (0, -1)
"""What the read of a port that is gone returns."""
_AGAIN = ("EAGAIN", "EWOULDBLOCK", "EINTR", "ETIMEDOUT")
_KEYBOARD = ("0", "STDIN_FILENO")
_ORDERS = {
    "<": lambda left, right: left < right,
    ">": lambda left, right: left > right,
    "<=": lambda left, right: left <= right,
    ">=": lambda left, right: left >= right,
    "==": lambda left, right: left == right,
    "!=": lambda left, right: left != right,
}
_UNSIGNED = regex(r"(?:unsigned|size_t|uint\d+_t)\b")
_SOME = 64
"""Stands for the size of what is read, which is never 0."""


def idle_reads(code: Code) -> Iterator[IdleRead]:
    for call in code.calls:
        name = _result(code, call) if call.qualified in _READ and len(call.arguments) == 3 else None
        loop = _loop(code, call) if name is not None else None
        if loop is None or code.text(call.arguments[0]) in _KEYBOARD:
            continue
        body = loop.child_by_field_name("body")
        if body is not None and all(_Turn(code, str(name), value).idles(body) for value in _FAILED):
            whole = code.span(loop)
            head = code.source.span(whole.start, code.span(body).start)
            yield IdleRead(code.span(call.node), head)


def _result(code: Code, call: Call) -> str | None:
    """The variable that alone gets what a read returns."""
    outer = call.node.parent
    if outer is None or outer.type not in ("init_declarator", "assignment_expression"):
        return None
    field = "declarator" if outer.type == "init_declarator" else "left"
    node = outer.child_by_field_name(field)
    return code.text(node) if node is not None and node.type == "identifier" else None


def _loop(code: Code, call: Call) -> Node | None:
    """The loop around a read that does not end by itself."""
    for outer in code.above(call.node):
        if outer.type in _LOOPS:
            condition = outer.child_by_field_name("condition")
            return None if _BOUNDED.search(code.text(condition)) else outer
        if outer.type in ("function_definition", "lambda_expression", "do_statement", "for_range_loop"):
            return None
    return None


class _Turn:
    """One turn of a loop in which the read returns a value."""

    def __init__(self, code: Code, name: str, value: int) -> None:
        self._code = code
        self._name = name
        self._value = value
        self._is_over = False

    def idles(self, body: Node) -> bool:
        """Whether the turn surely alters nothing, waits for nothing and stays in the loop."""
        if body.type == "compound_statement":
            return all(self._is_over or self._passes(each) for each in body.named_children)
        return self._passes(body)

    def _passes(self, statement: Node) -> bool:
        if statement.type == "continue_statement":
            self._is_over = True
            return True
        if statement.type in ("comment", "declaration", "compound_statement"):
            return self.idles(statement) if statement.type == "compound_statement" else self._is_plain(statement)
        if statement.type == "if_statement":
            return self._chooses(statement)
        if statement.type == "expression_statement":
            return self._is_plain(statement) and self._is_passive(statement)
        return False

    def _chooses(self, statement: Node) -> bool:
        condition = self._code.text(statement.child_by_field_name("condition"))
        if _WAITS.search(condition):
            return False
        holds = self._holds(statement.child_by_field_name("condition"))
        then, other = (statement.child_by_field_name(field) for field in ("consequence", "alternative"))
        inside = [each for each in other.named_children if each.type != "comment"] if other is not None else []
        ways = [[then] if then is not None else []] * (holds is not False) + [inside] * (holds is not True)
        if len(ways) == 1:
            return all(self.idles(each) for each in ways[0])
        return all(_Turn(self._code, self._name, self._value).idles(each) for way in ways for each in way)

    def _is_plain(self, statement: Node) -> bool:
        return not _WAITS.search(blanked(self._code.text(statement)))

    def _is_passive(self, statement: Node) -> bool:
        text = self._code.text(statement)
        inner = statement.named_children[0] if statement.named_child_count else None
        is_read = inner is not None and inner.type == "assignment_expression" and text.startswith(self._name)
        call = self._code.call(inner) if inner is not None and inner.type == "call_expression" else None
        return is_read or bool(_PASSIVE.match(call.name if call is not None else text))

    def _holds(self, node: Node | None) -> bool | None:
        """Whether a condition holds; None when that is not known."""
        node = _bare(node)
        if node is None:
            return None
        if node.type == "unary_expression" and self._code.text(node.child_by_field_name("operator")) == "!":
            inner = self._holds(node.child_by_field_name("argument"))
            return None if inner is None else not inner
        if node.type == "binary_expression":
            return self._compares(node)
        value = self._number(node)
        return None if value is None else value != 0

    def _compares(self, node: Node) -> bool | None:
        left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
        operator = self._code.text(node.child_by_field_name("operator"))
        if operator in ("&&", "and", "||", "or"):
            decides = operator in ("||", "or")
            found = [self._holds(left), self._holds(right)]
            return decides if decides in found else None if None in found else not decides
        if self._code.text(left) == "errno" and self._code.text(right) in _AGAIN and self._value < 0:
            return operator == "!="
        sides = self._number(left), self._number(right)
        if None in sides or operator not in _ORDERS:
            return None
        return bool(_ORDERS[operator](*sides))

    def _number(self, node: Node | None) -> int | None:
        node = _bare(node)
        text = self._code.text(node)
        if text == self._name:
            return self._value
        if text.startswith("sizeof"):
            return _SOME
        if node is not None and node.type in ("cast_expression", "call_expression"):
            return self._cast(node)
        try:
            return int(text.rstrip("uUlL"), 0)
        except ValueError:
            return None

    def _cast(self, node: Node) -> int | None:
        """The value of ``(int)name`` or ``static_cast<int>(name)``; that of a negative number as an unsigned one is not
        known."""
        call = self._code.call(node) if node.type == "call_expression" else None
        if call is not None and (call.template is None or len(call.arguments) != 1 or not call.name.endswith("_cast")):
            return None
        to = self._code.text(call.template if call is not None else node.child_by_field_name("type"))
        value = self._number(call.arguments[0] if call is not None else node.child_by_field_name("value"))
        return None if value is not None and value < 0 and _UNSIGNED.search(to) else value


def _bare(node: Node | None) -> Node | None:
    """A condition without its parentheses."""
    while node is not None and node.type in ("condition_clause", "parenthesized_expression"):
        inner = [each for each in node.named_children if each.type != "comment"]
        node = inner[0] if len(inner) == 1 else None
    return node
