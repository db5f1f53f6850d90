"""Members of a C++ node that a callback reads before anything has given them a value."""

from __future__ import annotations

from collections.abc import Collection
from collections.abc import Iterator
from itertools import chain
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import BareMember
from bringup_lint.model.cpp_source import UnsetMember
from bringup_lint.model.node_source import Callback
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

MEMBERS = 100
"""Members of one file that are looked at."""
_NUMBER = regex(
    r"(?:std::)?(?:bool|double|float|int|long|short|unsigned(?:\s+(?:int|long|char|short))?|u?int(?:8|16|32|64)_t|size_t)\Z"
)
_TARGET = regex(r"(?:this->)?([A-Za-z_]\w*)\Z")
_DECLARES = frozenset(
    "init_declarator declaration parameter_declaration optional_parameter_declaration lambda_capture_specifier "
    "structured_binding_declarator for_range_loop reference_declarator pointer_declarator".split()
)
_LEAVES = ("return_statement", "throw_statement", "co_return_statement", "goto_statement")
_CONDITIONAL = frozenset(
    "if_statement for_statement for_range_loop while_statement do_statement switch_statement catch_clause "
    "conditional_expression lambda_expression try_statement".split()
)
_SHORT = frozenset({"&&", "||", "and", "or"})


class _Member(NamedTuple):
    name: str
    declared: Node | None
    owner: str


class _Run(NamedTuple):
    """What an executor runs when it calls a callback."""

    callback: Callback
    body: Node
    functions: frozenset[int]
    """The body and the functions of the file that it calls, also through others."""


def unset_members(code: Code, classes: list[str], callbacks: list[Callback]) -> Iterator[UnsetMember]:
    """Members that no function but callbacks names, where one of these reads them in each case before it sets them:
    numbers that the file declares without a value, and members that another file declares."""
    bodies = Bodies(code) if callbacks else None
    runs = list(_runs(code, bodies, callbacks)) if bodies is not None else []
    if runs:
        constructors = _constructors(code)
        found = _members(code, {name: constructors[name] for name in classes if constructors.get(name)})
        foreign = _foreign(code, runs, constructors.keys() - set(classes))
        for member in islice(chain(found, foreign), MEMBERS):
            read = _read(code, member, runs)
            if read is not None:
                yield read


def bare_members(code: Code, classes: list[str]) -> Iterator[BareMember]:
    """The members of classes of nodes that may be unset, as far as their file says."""
    for member in islice(_members(code, classes), MEMBERS):
        if sum(1 for _ in code.uses(member.name)) == 1 and member.declared is not None:
            span = code.span(member.declared)
            yield BareMember(code.source.located(span.start, span.end), member.owner)


def _constructors(code: Code) -> dict[str, bool]:
    """The classes whose constructors the file defines, and whether one of them has a body."""
    found: dict[str, bool] = {}
    for each in code.written.get("function", ()):
        *scope, name = (code.defined_name(each) or "").split("::")
        if each.child_by_field_name("type") is None and name and (not scope or scope[-1] == name):
            found[name] = found.get(name, False) or _has_body(each)
    return found


def _foreign(code: Code, runs: list[_Run], owners: set[str]) -> Iterator[_Member]:
    """What callbacks set of the one class that the file defines and does not declare."""
    if len(owners) == 1:
        (owner,) = owners
        bodies = [run.body for run in runs]
        targets = (
            _TARGET.match(code.text(each.child_by_field_name("left")))
            for each in code.written.get("assignment", ())
            if any(body.start_byte < each.start_byte < body.end_byte for body in bodies)
        )
        yield from (_Member(name, None, owner) for name in dict.fromkeys(found[1] for found in targets if found))


def _members(code: Code, owners: Collection[str]) -> Iterator[_Member]:
    """The plain numbers that classes declare without a value."""
    for node in code.written.get("class", ()):
        owner, body = code.text(node.child_by_field_name("name")), node.child_by_field_name("body")
        if body is not None and owner in owners:
            for each in body.named_children:
                yield from (_Member(code.text(name), name, owner) for name in _without_value(code, each))


def _has_body(definition: Node) -> bool:
    return definition.child_by_field_name("body") is not None


def _without_value(code: Code, node: Node) -> Iterator[Node]:
    kind = " ".join(code.text(node.child_by_field_name("type")).split())
    if node.type != "field_declaration" or not _NUMBER.match(kind) or node.child_by_field_name("default_value"):
        return
    if not any(each.type in ("storage_class_specifier", "type_qualifier", "bitfield_clause") for each in node.children):
        yield from (each for each in node.children_by_field_name("declarator") if each.type == "field_identifier")


def _runs(code: Code, bodies: Bodies, callbacks: list[Callback]) -> Iterator[_Run]:
    for callback in callbacks:
        body = bodies.of(callback)
        if body is not None:
            names = {each.name for each in bodies.reached(body) if isinstance(each, Call)}
            inner = (each.id for name in names for each in bodies.functions.get(name, ()))
            yield _Run(callback, body, frozenset((body.id, *inner)))


def _read(code: Code, member: _Member, runs: list[_Run]) -> UnsetMember | None:
    """The first read of a member by a callback, when all that names it runs in callbacks, and one of them sets it."""
    uses = []
    for node in code.uses(member.name):
        if member.declared is not None and node.start_byte == member.declared.start_byte:
            continue
        outer = node.parent
        if outer is None or (outer.type in _DECLARES and _is_declared(outer, node)):
            return None
        if outer.type != "field_expression" or code.text(outer.child_by_field_name("argument")) == "this":
            uses.append(node)
    holders = {node.id: _holder(code, node) for node in uses}
    allowed = frozenset().union(*(run.functions for run in runs)) if runs else frozenset()
    if not uses or not all(holders[node.id] in allowed for node in uses):
        return None
    for run in runs:
        own = [node for node in uses if run.body.start_byte < node.start_byte < run.body.end_byte]
        if own and _is_early(code, run, own[0], uses, holders):
            return _found(code, member, run, own[0], uses)
    return None


def _found(code: Code, member: _Member, run: _Run, read: Node, uses: list[Node]) -> UnsetMember | None:
    written = [node for node in uses if _is_written(code, node)]
    others = [node for node in written if not run.body.start_byte < node.start_byte < run.body.end_byte]
    if not written:
        return None
    callback = f"{run.callback.name}()" if run.callback.name else "a lambda"
    declared = code.span(member.declared) if member.declared is not None else None
    later = code.span(others[0]) if others else None
    return UnsetMember(declared, code.span(read), member.name, member.owner, callback, later)


def _is_declared(outer: Node, node: Node) -> bool:
    """Whether a declaration declares a name, rather than to use it as a value."""
    value = outer.child_by_field_name("value") or outer.child_by_field_name("right")
    return value is None or not value.start_byte <= node.start_byte < value.end_byte


def _holder(code: Code, node: Node) -> int | None:
    """The function that a place is in, by its id."""
    body = code.body_of(node)
    return body.id if body is not None else None


def _is_early(code: Code, run: _Run, first: Node, uses: list[Node], holders: dict[int, int | None]) -> bool:
    """Whether a callback reads a member in each case, and before it may have set it."""
    if _is_written(code, first) or _is_given_away(first) or not _is_reached(code, run.body, first):
        return False
    before = [node for node in _below(run.body) if node.start_byte < first.start_byte]
    if any(node.type in _LEAVES for node in before):
        return False
    naming = {holders[node.id] for node in uses}
    functions = (each for each in code.written.get("function", ()) if each.id in naming)
    names = {(code.defined_name(each) or "").rpartition("::")[2] for each in functions}
    calls = (code.call(node) for node in before if node.type == "call_expression")
    return not any(call is not None and call.name in names for call in calls)


def _is_reached(code: Code, body: Node, node: Node) -> bool:
    """Whether no condition decides about a place: one in a condition itself is read in each case."""
    inner = node
    for outer in code.above(node):
        if outer.id == body.id:
            return True
        condition = outer.child_by_field_name("condition") or outer.child_by_field_name("initializer")
        if outer.type in _CONDITIONAL and (condition is None or condition.id != inner.id):
            return False
        if outer.type == "binary_expression" and code.text(outer.child_by_field_name("operator")) in _SHORT:
            if outer.child_by_field_name("right") == inner:
                return False
        inner = outer
    return False


def _is_written(code: Code, node: Node) -> bool:
    """``name = ...``: other assignments read it first."""
    inner, outer = _whole(node)
    if (
        outer is None
        or outer.type != "assignment_expression"
        or code.text(outer.child_by_field_name("operator")) != "="
    ):
        return False
    return outer.child_by_field_name("left") == inner


def _is_given_away(node: Node) -> bool:
    """Whether something may take the member by reference or address."""
    _, outer = _whole(node)
    return outer is None or outer.type in ("argument_list", "pointer_expression", "subscript_argument_list")


def _whole(node: Node) -> tuple[Node, Node | None]:
    """``this->name`` or ``name``, and what it is in."""
    outer = node.parent
    if outer is not None and outer.type == "field_expression":
        return outer, outer.parent
    return node, outer


def _below(body: Node) -> Iterator[Node]:
    stack = [body]
    while stack:
        current = stack.pop()
        yield current
        stack += current.named_children
