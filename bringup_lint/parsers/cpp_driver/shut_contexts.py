"""Functions of a C++ file that shut the context down and go on as if they had left."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import ShutContext
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.parsers.cpp_node.owners import class_made
from bringup_lint.parsers.cpp_node.owners import class_of
from bringup_lint.parsers.cpp_node.syntax import LOOPS
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from tree_sitter import Node

SHUTS = regex(
    r"\brclcpp::shutdown\s{0,4}\([^()]{0,80}\)\s{0,4};[^{}]{0,300}\}\s{0,200}[^\s}]|\)\s{0,40}rclcpp::shutdown\s{0,4}\(",
    hints="rclcpp::shutdown",
)
"""In a branch, behind which there is something: not as most programs end."""
MOST = 50
"""Calls of one file that are looked at."""
DEPTH = 3
"""Calls of methods of the file that are followed."""
_LEAVES = regex(r"\b(?:return|throw|break|continue|goto|\w{0,20}exit|abort|terminate|raise|kill)\b|\brclcpp::ok\b")
_ABORTS = regex(r"\b(?:throw|\w{0,20}exit|abort|terminate|raise|kill)\b")
_MAKES = regex(r"create_(?:(?:wall_)?timer|(?:generic_)?(?:publisher|subscription|client|service)|server)\Z")
_UNFIT = regex(
    r"\(!(?P<not>\w+)(?:(?:->|\.)(?i:is_?(?:open|opened|connected|valid|initialized)|connected|connect|open|init\w*|good)"
    r"\([^()]*\))?\)\Z|\((?P<null>\w+)(?:==(?:nullptr|NULL|-1)|<0)\)\Z"
)
"""The condition of a branch that is there because something cannot be used."""
_NULL = regex(r"\A\((?:!\w+|\w+==(?:nullptr|NULL))\)\Z")
_USE = (
    r"(?<![\w.>])(?:this->)?{0}\s{{0,4}}(?:(?:->|\.)(?!(?:close|release|reset|disconnect|stop|shutdown)\b)|<<|>>)"
    r"|[(,=]\s{{0,4}}\*\s{{0,4}}(?:this->)?{0}\b(?!\s{{0,4}}(?:->|[.\[]))|[(,*]\s{{0,4}}{0}\s{{0,4}}[,)]"
)
_FOLLOWED = regex(r"->\Z|\A[(,=]\s{0,4}\*")
"""A use of what a pointer points to."""
_ANEW = r"(?<![\w.>])(?:this->)?{0}\s{{0,4}}(?:=(?!=)|\.\s{{0,4}}reset\s{{0,4}}\(\s{{0,4}}[^)\s])"
"""What gives it something else."""


class _Functions:
    """The functions of a file by their last name, and what each was found to make."""

    def __init__(self, code: Code) -> None:
        self.named = Bodies(code).functions
        self.made: dict[tuple[int, int], Node | None] = {}
        """Method, and how many calls are followed from it -> the call that makes something."""


def shut_contexts(code: Code) -> Iterator[ShutContext]:
    """One for each call of ``rclcpp::shutdown()`` behind which the function makes what needs the context, or uses what
    it has found to be of no use."""
    functions = _Functions(code)
    for call in islice((each for each in code.calls if each.qualified == "rclcpp::shutdown"), MOST):
        statement = call.node.parent
        if statement is None or statement.type != "expression_statement":
            continue
        function = code.body_of(call.node)
        found = _behind(code, functions, statement, function) if function is not None else None
        if found is None and function is not None:
            found = _behind_method(code, functions, statement, function)
        if found is not None:
            yield ShutContext(code.span(call.node), *found, _is_null(code, statement, found[0]))


def _behind(code: Code, functions: _Functions, statement: Node, function: Node) -> tuple[Span, str, str | None] | None:
    owner = class_made(code, function) if function.type == "function_definition" else None
    condition = _unfit(code, statement)
    unfit = (condition["not"] or condition["null"]) if condition is not None else None
    current: Node = statement
    for outer in code.above(statement):
        if outer.type in LOOPS or outer.type in ("switch_statement", "lambda_expression", "case_statement"):
            return None
        if outer.type == "compound_statement":
            behind = [each for each in outer.named_children if each.start_byte >= current.end_byte]
            found, leaves = _among(code, functions, behind, owner, unfit)
            if found is not None or leaves:
                return found
        if outer.id == function.id:
            return None
        current = outer
    return None


def _behind_method(
    code: Code, functions: _Functions, statement: Node, function: Node
) -> tuple[Span, str, str | None] | None:
    """What a constructor makes behind a call of the method which shuts down and leaves, and answers nothing."""
    qualifier, _, name = (code.defined_name(function) or "").rpartition("::")
    owner = class_of(code, function, qualifier) if function.type == "function_definition" else ""
    block = statement.parent
    if not owner or code.text(function.child_by_field_name("type")) != "void" or block is None:
        return None
    behind = code.source.span(code.span(statement).end, code.span(block).end)
    if _ABORTS.search(behind.text):
        return None
    for call in code.calls:
        outer, made = call.node.parent, code.body_of(call.node)
        if call.name != name or call.qualified not in (name, f"this->{name}") or outer is None or made is None:
            continue
        if outer.type == "expression_statement" and class_made(code, made) == owner:
            return _behind(code, functions, outer, made)
    return None


def _among(
    code: Code, functions: _Functions, behind: list[Node], owner: str | None, unfit: str | None
) -> tuple[tuple[Span, str, str | None] | None, bool]:
    """What statements make or use; and whether one of them may leave before."""
    plain = plain_of(code.source)
    use, anew = (re.compile(each.format(re.escape(unfit))) if unfit is not None else None for each in (_USE, _ANEW))
    for following in behind:
        span = code.span(following)
        if following.type in ("expression_statement", "declaration"):
            made = _made(code, functions, following, DEPTH) if owner is not None else None
            if made is not None:
                return (code.span(made), code.text(made.child_by_field_name("function")).partition("<")[0], owner), True
            if anew is not None and anew.search(plain, span.start, span.end):
                return None, True
            is_log = plain.startswith("RCLCPP_", span.start)
            used = use.search(plain, span.start, span.end) if use is not None and not is_log else None
            if used is not None and unfit is not None:
                return (code.source.span(*used.span()), unfit, None), True
        if _LEAVES.search(plain, span.start, span.end):
            return None, True
    return None, False


def _made(code: Code, functions: _Functions, statement: Node, depth: int) -> Node | None:
    """The call of a statement that makes a topic, service or timer, itself or in a method that surely does."""
    stack = [statement]
    while stack:
        node = stack.pop()
        if node.type in ("lambda_expression", "conditional_expression"):
            continue
        call = code.call(node) if node.type == "call_expression" else None
        if call is not None and _MAKES.match(call.name):
            return node
        named = functions.named.get(call.name, []) if call is not None and depth else []
        if call is not None and len(named) == 1 and call.qualified in (call.name, f"this->{call.name}"):
            known = (named[0].id, depth - 1)
            if known not in functions.made:
                functions.made[known] = _made_in(code, functions, named[0], depth - 1)
            made = functions.made[known]
            if made is not None:
                return made
        stack += node.named_children
    return None


def _made_in(code: Code, functions: _Functions, method: Node, depth: int) -> Node | None:
    """What a method makes before it may leave."""
    plain, body = plain_of(code.source), method.child_by_field_name("body")
    if body is None:
        return None
    for statement in body.named_children:
        if statement.type in ("expression_statement", "declaration"):
            made = _made(code, functions, statement, depth)
            if made is not None:
                return made
        span = code.span(statement)
        if _LEAVES.search(plain, span.start, span.end):
            return None
    return None


def _is_null(code: Code, statement: Node, used: Span) -> bool:
    """Whether the condition only asks whether a pointer is null, and what is used behind is what it points to."""
    found = _unfit(code, statement) if _FOLLOWED.search(used.text) else None
    return found is not None and bool(_NULL.search(found.string))


def _unfit(code: Code, statement: Node) -> re.Match[str] | None:
    """What the condition of the branch that shuts down finds to be of no use."""
    block = statement.parent
    branch = block.parent if block is not None and block.type == "compound_statement" else block
    if branch is None or branch.type != "if_statement":
        return None
    if branch.child_by_field_name("consequence") not in (block, statement):
        return None
    return _UNFIT.match("".join(code.text(branch.child_by_field_name("condition")).split()))
