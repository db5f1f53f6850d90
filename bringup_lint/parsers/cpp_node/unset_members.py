"""Members of a C++ node that a callback reads before anything has given them a value."""

from __future__ import annotations

from collections.abc import Collection
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from itertools import chain
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import BareMember
from bringup_lint.model.cpp_source import UnsetMember
from bringup_lint.model.node_source import Callback
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.owners import class_of
from bringup_lint.parsers.cpp_node.plain_guards import PlainGuards
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

MEMBERS = 100
"""Members of one file that are looked at."""
USES = 200
"""Uses of one member that are looked at."""
LOOPS = 50
"""Methods of one file that run in a cycle, and are looked at."""
_NUMBER = regex(
    r"(?:std::)?(?:bool|double|float|int|long|short|unsigned(?:\s+(?:int|long|char|short))?|u?int(?:8|16|32|64)_t|size_t)\Z"
)
_TARGET = regex(r"(?:this->)?([A-Za-z_]\w*)(?:\[[^\[\]]{1,80}\])?\Z")
_DECLARES = frozenset(
    "init_declarator declaration parameter_declaration optional_parameter_declaration lambda_capture_specifier "
    "structured_binding_declarator for_range_loop reference_declarator pointer_declarator".split()
)
_LEAVES = ("return_statement", "throw_statement", "co_return_statement", "goto_statement")
_TAKERS = frozenset("argument_list pointer_expression subscript_argument_list for_range_loop sizeof_expression".split())
_LOOP = frozenset({"read", "write", "update"})
"""What the controller manager calls of hardware and controllers in each cycle."""
_LOOP_TYPE = regex(r"(?:^|::)return_type\Z")
_PLUGINS = regex(r"(?:^|::)(?:(?:System|Actuator|Sensor)Interface|(?:Chainable)?ControllerInterface)\Z")
"""Classes of ros2_control, whose objects pluginlib makes with a plain ``new``."""


class _Body:
    """What a function or lambda has in the order of its text."""

    def __init__(self, code: Code, body: Node) -> None:
        guards = PlainGuards(code, body)
        self.reaches = guards.reaches
        self.calls: dict[str, int] = {}
        """Name of a function -> where the body calls it first."""
        self.left = body.end_byte
        """Where the body may first end because of what the object has lived through."""
        for node in sorted(_below(body), key=lambda each: -each.start_byte):
            call = code.call(node) if node.type == "call_expression" else None
            if call is not None:
                self.calls[call.name] = node.start_byte
            if node.type in _LEAVES and not guards.reaches(node):
                self.left = node.start_byte


class _Member(NamedTuple):
    name: str
    declared: Node | None
    owner: str


class _Run(NamedTuple):
    """What an executor or the controller manager runs."""

    what: str
    """In a sentence: ``on_timer()``, ``a lambda``."""
    body: Node
    functions: frozenset[int]
    """The body and the functions of the file that it calls, also through others."""
    owner: str | None
    """The class of hardware or of a controller whose method it is; None for a callback."""
    handed: int | None = None
    """Where a callback is handed over."""
    is_timer: bool = False


class _Functions:
    """What is known of the functions of a file, read once for all its members."""

    def __init__(self, code: Code, runs: list[_Run]) -> None:
        self.code = code
        self.runs = runs
        self.allowed: frozenset[int] = frozenset().union(*(run.functions for run in runs))
        """What callbacks and cycles reach."""
        self._bodies: dict[int, _Body] = {}

    @cached_property
    def _names(self) -> dict[int, str]:
        functions = self.code.written.get("function", ())
        return {each.id: (self.code.defined_name(each) or "").rpartition("::")[2] for each in functions}

    def names(self, ids: Iterable[int | None]) -> set[str]:
        """The last names of some functions."""
        return {self._names[each] for each in ids if each in self._names}

    def body(self, run: _Run) -> _Body:
        if run.body.id not in self._bodies:
            self._bodies[run.body.id] = _Body(self.code, run.body)
        return self._bodies[run.body.id]

    def is_late(self, run: _Run) -> bool:
        """Whether a callback is only handed over by another, or when a timer is started by hand: others have run
        before."""
        if run.handed is None:
            return False
        if run.is_timer and self._restarts:
            return True
        at = run.handed
        return any(start < at < end for start, end in self._inside)

    @cached_property
    def _restarts(self) -> bool:
        calls = self.code.calls
        stopped = {each.qualified[: -len("cancel")] for each in calls if each.qualified.endswith("->cancel")}
        return any(each.qualified[: -len("reset")] in stopped for each in calls if each.name == "reset")

    @cached_property
    def _inside(self) -> list[tuple[int, int]]:
        """Where what runs in callbacks and cycles begins and ends."""
        reached = (each for each in self.code.written.get("function", ()) if each.id in self.allowed)
        spans = map(self.code.span, (*(run.body for run in self.runs), *reached))
        return [(each.start, each.end) for each in spans]

    @cached_property
    def called_elsewhere(self) -> set[str]:
        """What something else than callbacks calls."""
        return {call.name for call in self.code.calls if _holder(self.code, call.node) not in self.allowed}


def unset_members(code: Code, classes: list[str], callbacks: list[Callback]) -> Iterator[UnsetMember]:
    """Members that no function but callbacks names, where one of these reads them before anything can have set them:
    numbers that the file declares without a value, and members that another file declares. The same for what the
    controller manager calls of hardware and controllers."""
    loops = list(islice(_loops(code), LOOPS))
    bodies = Bodies(code) if callbacks or loops else None
    if bodies is None:
        return
    runs = [*_runs(code, bodies, callbacks), *(_loop_run(code, bodies, each) for each in loops)]
    functions = _Functions(code, runs)
    first = [run for run in runs if not functions.is_late(run)]
    if not first:
        return
    constructors = _constructors(code)
    plugins = plugin_classes(code)
    owners = constructors.keys() | {run.owner for run in runs if run.owner is not None}
    found = _members(code, {*(name for name in classes if constructors.get(name)), *plugins})
    foreign = _foreign(code, runs, owners - {*classes, *plugins})
    for member in islice(chain(found, foreign), MEMBERS):
        read = _read(functions, member, first)
        if read is not None:
            yield read


def plugin_classes(code: Code) -> list[str]:
    """The classes of a file that build on hardware or a controller of ros2_control."""
    return [
        code.text(node.child_by_field_name("name"))
        for node in code.written.get("class", ())
        for clause in node.named_children
        if clause.type == "base_class_clause"
        and any(_PLUGINS.search("".join(code.text(base).split())) for base in clause.named_children)
    ]


def bare_members(code: Code, classes: list[str]) -> Iterator[BareMember]:
    """The members of classes of nodes, hardware and controllers that may be unset, as far as their file says."""
    for member in islice(_members(code, {*classes, *plugin_classes(code)}), MEMBERS):
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
    if node.type != "field_declaration" or not _NUMBER.match(kind):
        return
    if any(each.type in ("storage_class_specifier", "type_qualifier", "bitfield_clause") for each in node.children):
        return
    values = {each.prev_named_sibling for each in node.children_by_field_name("default_value")}
    for each in node.children_by_field_name("declarator"):
        plain = each.child_by_field_name("declarator") if each.type == "array_declarator" else each
        if each not in values and plain is not None and plain.type == "field_identifier":
            yield plain


def _runs(code: Code, bodies: Bodies, callbacks: list[Callback]) -> Iterator[_Run]:
    for callback in callbacks:
        body = bodies.of(callback)
        if body is not None:
            runs = _handed_on(bodies, body)
            name = (code.defined_name(runs) or "").rpartition("::")[2] if runs.type == "function_definition" else ""
            what = f"{name}()" if name else "a lambda"
            yield _Run(what, runs, _reached(bodies, body), None, callback.span.start, callback.role == "timer")


def _handed_on(bodies: Bodies, body: Node) -> Node:
    """The method to which a lambda only hands its arguments on; else the body itself."""
    block = body.child_by_field_name("body")
    if body.type == "lambda_expression" and block is not None and block.named_child_count == 1:
        only = block.named_children[0]
        call = next((each for each in bodies.own(body) if only.type == "expression_statement"), None)
        if call is not None and call.node.parent == only and call.qualified in (call.name, f"this->{call.name}"):
            named = bodies.functions.get(call.name, [])
            return named[0] if len(named) == 1 else body
    return body


def _reached(bodies: Bodies, body: Node) -> frozenset[int]:
    names = {each.name for each in bodies.reached(body) if isinstance(each, Call)}
    return frozenset((body.id, *(each.id for name in names for each in bodies.functions.get(name, ()))))


def _loops(code: Code) -> Iterator[tuple[Node, str]]:
    """The methods of hardware and controllers that the controller manager calls in each cycle, with their class."""
    for each in code.written.get("function", ()):
        if _LOOP_TYPE.search("".join(code.text(each.child_by_field_name("type")).split())):
            qualifier, _, name = (code.defined_name(each) or "").rpartition("::")
            owner = class_of(code, each, qualifier) if name in _LOOP else ""
            if owner:
                yield each, owner


def _loop_run(code: Code, bodies: Bodies, loop: tuple[Node, str]) -> _Run:
    body, owner = loop
    name = (code.defined_name(body) or "").rpartition("::")[2]
    return _Run(f"{name}()", body, _reached(bodies, body), owner)


def _read(functions: _Functions, member: _Member, first: list[_Run]) -> UnsetMember | None:
    """The first read of a member by a callback, when all that names it runs in callbacks, and one of them sets it."""
    code = functions.code
    uses: list[Node] = []
    for node in code.uses(member.name):
        if len(uses) == USES:
            return None
        if member.declared is not None and node.start_byte == member.declared.start_byte:
            continue
        outer = node.parent
        if outer is None or (outer.type in _DECLARES and _is_declared(outer, node)):
            return None
        if outer.type != "field_expression" or code.text(outer.child_by_field_name("argument")) == "this":
            uses.append(node)
        elif any(each.type == "->" for each in outer.children) and _may_be_set(code, outer):
            return None
    holders = {_holder(code, node) for node in uses}
    if not uses or not holders <= functions.allowed:
        return None
    names = functions.names(holders)
    for run in first:
        own = [node for node in uses if run.body.start_byte < node.start_byte < run.body.end_byte]
        if own and _is_early(functions, run, own[0], names):
            # what something else than callbacks calls, as a constructor may, has perhaps set it
            return _found(code, member, run, own[0], uses) if names.isdisjoint(functions.called_elsewhere) else None
    return None


def _found(code: Code, member: _Member, run: _Run, read: Node, uses: list[Node]) -> UnsetMember | None:
    written = [node for node in uses if _is_written(code, node)]
    others = [node for node in written if not run.body.start_byte < node.start_byte < run.body.end_byte]
    if not written:
        return None
    declared = code.span(member.declared) if member.declared is not None else None
    later = code.span(others[0]) if others else None
    return UnsetMember(declared, code.span(read), member.name, member.owner, run.what, later)


def _is_declared(outer: Node, node: Node) -> bool:
    """Whether a declaration declares a name, rather than to use it as a value."""
    value = outer.child_by_field_name("value") or outer.child_by_field_name("right")
    return value is None or not value.start_byte <= node.start_byte < value.end_byte


def _holder(code: Code, node: Node) -> int | None:
    """The function that a place is in, by its id."""
    body = code.body_of(node)
    return body.id if body is not None else None


def _is_early(functions: _Functions, run: _Run, first: Node, names: set[str]) -> bool:
    """Whether a callback reads a member before it may have set it, whatever came before: no condition that may know of
    that keeps it from there. ``names``: the functions that name the member."""
    if _is_written(functions.code, first) or _is_given_away(functions.code, first):
        return False
    body = functions.body(run)
    is_called = any(body.calls.get(name, first.start_byte) < first.start_byte for name in names)
    return not is_called and body.left >= first.start_byte and body.reaches(first)


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


def _may_be_set(code: Code, node: Node) -> bool:
    """Whether ``other->name`` may get a value."""
    return node.parent is not None and (node.parent.type == "assignment_expression" or _is_given_away(code, node))


def _is_given_away(code: Code, node: Node) -> bool:
    """Whether something may set the member: what takes it by reference or address, or a stream that is read."""
    inner, outer = _whole(node)
    if outer is None or outer.type in _TAKERS:
        return True
    if outer.type == "init_declarator":
        declarator = outer.child_by_field_name("declarator")
        return declarator is not None and declarator.type == "reference_declarator"
    is_stream = outer.type == "binary_expression" and code.text(outer.child_by_field_name("operator")) == ">>"
    return is_stream and outer.child_by_field_name("right") == inner


def _whole(node: Node) -> tuple[Node, Node | None]:
    """``this->name``, ``name`` or an element of it, and what it is in."""
    outer = node.parent
    if outer is not None and outer.type == "field_expression":
        node, outer = outer, outer.parent
    if outer is not None and outer.type == "subscript_expression" and outer.child_by_field_name("argument") == node:
        node, outer = outer, outer.parent
    if outer is not None and outer.type == "parenthesized_expression":
        node, outer = outer, outer.parent
    return node, outer


def _below(body: Node) -> Iterator[Node]:
    stack = [body]
    while stack:
        current = stack.pop()
        yield current
        stack += current.named_children
