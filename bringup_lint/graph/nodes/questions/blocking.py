"""What a node does while an executor waits for it: the code of its callbacks, and calls in it that block."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import NamedTuple

from bringup_lint.graph.nodes.questions.short_programs import is_short
from bringup_lint.graph.nodes.questions.stopping import statements_of
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.sending import called
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import Group
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import PlacedNode

DEPTH = 3
UNTIL_TIMEOUT = "until its timeout"
"""How long a call with a time-out lasts whose length is not known."""
SHORT = 0.1
"""Seconds; a shorter sleep delays nothing that matters."""
_PROGRAMS = frozenset(
    {"subprocess.run", "subprocess.call", "subprocess.check_call", "subprocess.check_output", "os.system"}
)
_REQUESTS = frozenset(
    f"requests.{verb}" for verb in ("get", "post", "put", "delete", "patch", "head", "options", "request")
)
_OPENS = frozenset({*_REQUESTS, "urllib.request.urlopen"})
_SPINS = {"rclpy.spin": 99, "rclpy.spin_until_future_complete": 3, "rclpy.spin_once": 99}
"""Functions that run the executor, and the position of their time-out."""
_SERIAL_READS = frozenset({"read", "readline", "readlines", "read_until"})


class Blocking(NamedTuple):
    """A call in a callback that gives the executor nothing back for a while."""

    callback: Callback
    name: str
    """The method or function that is the callback."""
    call: PlacedNode
    what: str
    """What it is, in words: ``time.sleep(2)``."""
    how_long: str
    """``for 2 s``, ``as long as the program runs``; empty when it waits for what the same executor must do."""
    partner: Group | None = None
    """The group of the callback that it waits for."""
    nested: bool = False
    """It runs the executor itself, so that only a shared group keeps its partner from running."""


def code_of(ending: Ending, cls: NodeClass, callback: Callback) -> tuple[str, list[ast.AST]]:
    """The name and the statements of a callback that stands in the file of its class."""
    if callback.function is not None:
        return "a lambda", [callback.function.body]
    if callback.name is None:
        return "", []
    method = cls.methods.get(callback.name)
    if method is not None:
        return callback.name, body_of(method.node)
    return callback.name, statements_of(ending, ast.Name(callback.name), None)


def reached(syntax: Syntax, body: list[ast.AST], cls: NodeClass) -> Iterator[ast.AST]:
    """The syntax that a callback runs: its own, and that of the methods and functions of the file that it calls."""
    seen: set[ast.AST] = set()
    todo = [(body, 0)]
    while todo:
        statements, depth = todo.pop()
        for node in own(statements):
            yield node
            if isinstance(node, ast.Call) and depth < DEPTH and _is_plain(node):
                for function, owner in called(syntax, node, cls):
                    if function not in seen and (owner is None or owner.source is cls.source):
                        seen.add(function)
                        todo.append((body_of(function), depth + 1))


def _is_plain(call: ast.Call) -> bool:
    """Whether a call is one of ``self`` or of a function, of which it is known what it runs."""
    function = call.func
    return isinstance(function, ast.Name) or (
        isinstance(function, ast.Attribute) and isinstance(function.value, ast.Name) and function.value.id == "self"
    )


def deadlocks(found: Blocking, threads: str) -> bool:
    """Whether what a call waits for can surely never run, as tried with rclpy (Jazzy)."""
    ours, theirs = found.callback.group, found.partner
    if found.what.endswith(".sleep()"):
        return threads == "one"
    shared = ours == theirs and (ours is None or ours.reentrant is False)
    return shared if found.nested or threads != "one" else True


def only_stores(ending: Ending, cls: NodeClass, callback: Callback) -> bool:
    """Whether a callback does no more than keep what it got, so that nothing is lost when it runs later."""
    name, body = code_of(ending, cls, callback)
    kept = (ast.Assign, ast.AnnAssign, ast.AugAssign, ast.Pass)
    return bool(name and body) and all(_is_docstring(each) or isinstance(each, kept) for each in body)


def _is_docstring(node: ast.AST) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)


def blocking(ending: Ending, cls: NodeClass) -> Iterator[Blocking]:
    """The calls that block in the callbacks of a class."""
    seen: set[ast.AST] = set()
    told: set[tuple[str, str]] = set()
    for callback in cls.callbacks:
        if callback.role == "shutdown":
            continue
        name, body = code_of(ending, cls, callback)
        for node in reached(ending.syntax, body, cls):
            if node in seen or not isinstance(node, (ast.Call, ast.While)):
                continue
            found = _blocks(ending, node, cls)
            if found is not None:
                seen.add(node)
                clients = [each for each in cls.all_endpoints if each.role.endswith("client")]
                nested = found[0].startswith("rclpy.spin")
                if nested and not any(each.callback_group is None for each in clients):
                    continue
                kept = [each for each in clients if found[0] == f"{each.attribute}.call()"]
                partner = kept[0].callback_group if kept else None
                if (name, found[0]) in told and not found[1]:
                    continue
                told.add((name, found[0]))
                yield Blocking(callback, name, node, *found, partner, nested)


def _blocks(ending: Ending, node: ast.AST, cls: NodeClass) -> tuple[str, str] | None:
    if isinstance(node, ast.While):
        return ("'while True'", "forever") if _never_ends(node) else None
    if not isinstance(node, ast.Call) or any(isinstance(above, ast.Await) for above, _ in _next(ending, node)):
        return None
    name = ending.syntax.qualified(node)
    if name == "time.sleep":
        return _sleep(ending, node)
    if name in _PROGRAMS and not _has(node, "timeout") and not is_short(ending, node):
        return None if _ends_behind(ending, node) else (name, "as long as the program runs")
    if name in _OPENS:
        return _open(ending, node, name)
    if name in _SPINS and _is_of(node, cls):
        until = "until another callback is ready" if name == "rclpy.spin_once" else ""
        return f"{name}(self)", _timeout(ending, node, _SPINS[name]) or until
    if isinstance(node.func, ast.Name) and node.func.id == "input" and ending.file.imports.get("input") is None:
        return "input()", "until somebody types"
    if isinstance(node.func, ast.Attribute) and node.func.attr == "read_loop" and not node.args and _has_evdev(ending):
        return "read_loop()", "until a key is pressed"
    if isinstance(node.func, ast.Attribute) and isinstance(node.func.value, ast.Attribute):
        return _method(ending, node, node.func.value, cls)
    return None


def _has_evdev(ending: Ending) -> bool:
    return any((name or "").partition(".")[0] == "evdev" for name in ending.file.imports.values())


def _next(ending: Ending, node: ast.AST) -> list[tuple[ast.AST, str]]:
    first = next(ending.syntax.above(node), None)
    return [first] if first is not None else []


def _sleep(ending: Ending, call: ast.Call) -> tuple[str, str] | None:
    seconds = ending.file.constant(call.args[0], ending.syntax.function(call)) if len(call.args) == 1 else None
    if not isinstance(seconds, (int, float)) or isinstance(seconds, bool) or _ends_behind(ending, call):
        return None
    loops = [above for above, _ in ending.syntax.within(call) if isinstance(above, (ast.For, ast.While))]
    turns = _turns(ending, loops[0]) if len(loops) == 1 else None
    total = seconds * turns if turns is not None else seconds
    if total < SHORT:
        return None
    each_turn = " a turn of its loop" if loops and turns is None else ""
    return f"time.sleep({seconds:g})", f"for {total:g} s{each_turn}"


def _ends_behind(ending: Ending, call: ast.Call) -> bool:
    """Whether the node ends in the function that waits, so that nothing else of it is to run."""
    function = ending.syntax.function(call)
    if any(
        isinstance(each, ast.Raise) and _is_exit(each) and each.lineno > call.lineno for each in own(body_of(function))
    ):
        return True
    last = (each for each in own_calls(body_of(function)) if each.lineno > call.lineno)
    return any(ending.syntax.qualified(each) in ("rclpy.shutdown", "rclpy.try_shutdown", "sys.exit") for each in last)


def _is_exit(statement: ast.Raise) -> bool:
    raised = statement.exc.func if isinstance(statement.exc, ast.Call) else statement.exc
    return isinstance(raised, ast.Name) and raised.id == "SystemExit"


def _turns(ending: Ending, loop: ast.For | ast.While) -> int | None:
    """How often a ``for ... in range(n)`` runs."""
    given = loop.iter if isinstance(loop, ast.For) else None
    if not isinstance(given, ast.Call) or not isinstance(given.func, ast.Name) or given.func.id != "range":
        return None
    number = ending.file.constant(given.args[0], ending.syntax.function(loop)) if len(given.args) == 1 else None
    return number if isinstance(number, int) else None


def _timeout(ending: Ending, call: ast.Call, index: int) -> str:
    """How long a call with a time-out lasts; empty when it has none."""
    given = call.args[index] if len(call.args) > index else None
    given = next((each.value for each in call.keywords if each.arg == "timeout_sec"), given)
    if given is None:
        return ""
    seconds = ending.file.constant(given, ending.syntax.function(call))
    return f"for {seconds:g} s" if isinstance(seconds, (int, float)) else UNTIL_TIMEOUT


def _open(ending: Ending, call: ast.Call, name: str) -> tuple[str, str]:
    given = next((each.value for each in call.keywords if each.arg == "timeout"), None)
    seconds = ending.file.constant(given, ending.syntax.function(call)) if given is not None else None
    if isinstance(seconds, (int, float)):
        return name, f"for up to {seconds:g} s"
    return name, UNTIL_TIMEOUT if given is not None else "forever when the other side is silent"


def _has(call: ast.Call, keyword: str) -> bool:
    return any(each.arg in (keyword, None) for each in call.keywords)


def _is_of(call: ast.Call, cls: NodeClass) -> bool:
    return bool(call.args) and isinstance(call.args[0], ast.Name) and call.args[0].id == "self" and cls.name is not None


def _method(ending: Ending, call: ast.Call, owner: ast.Attribute, cls: NodeClass) -> tuple[str, str] | None:
    """``self.x.method()``."""
    if not isinstance(owner.value, ast.Name) or owner.value.id != "self":
        return None
    kept, name = f"self.{owner.attr}", call.func.attr if isinstance(call.func, ast.Attribute) else ""
    clients = [each for each in cls.all_endpoints if each.role == "client" and each.attribute == kept]
    if name == "call" and clients:
        return f"{kept}.call()", _timeout(ending, call, 1)
    if name == "sleep" and not call.args and _is_rate(ending, owner.attr):
        return f"{kept}.sleep()", ""
    if name in _SERIAL_READS and _waits_for_ever(ending, owner, call):
        return f"{kept}.{name}()", "until a byte arrives"
    return None


def _is_rate(ending: Ending, attribute: str) -> bool:
    """Whether an attribute is a Rate of the node, whose timer the same executor must run."""
    for call in ending.syntax.calls:
        if isinstance(call.func, ast.Attribute) and call.func.attr == "create_rate":
            for above, _ in _next(ending, call):
                targets = above.targets if isinstance(above, ast.Assign) else []
                return any(isinstance(each, ast.Attribute) and each.attr == attribute for each in targets)
    return False


def _waits_for_ever(ending: Ending, owner: ast.Attribute, call: ast.Call) -> bool:
    """Whether an attribute is a serial port that was opened without a time-out."""
    if (
        ending.file.named(owner, ending.syntax.function(call)) != "serial.Serial"
        or "in_waiting" in ending.file.source.text
    ):
        return False
    made = ending.syntax.named.get("serial.Serial", [])
    text = ending.file.source.text
    return len(made) == 1 and len(made[0].args) < 7 and not _has(made[0], "timeout") and ".timeout" not in text


class Endless(NamedTuple):
    """A loop without an end in the constructor of a node."""

    loop: ast.While
    test: str


def endless_constructors(ending: Ending, cls: NodeClass) -> Iterator[Endless]:
    """Loops that keep a node from ever being handed to an executor; none where a thread or the loop runs one."""
    init = cls.methods.get("__init__")
    if init is None or "Thread" in ending.file.source.text or "multiprocessing" in ending.file.source.text:
        return
    for node in reached(ending.syntax, body_of(init.node), cls):
        if isinstance(node, ast.While) and _is_forever(ending, node) and _has_no_exit(node):
            calls = own_calls(node.body)
            if not any("spin" in ast.unparse(call.func) for call in calls):
                yield Endless(node, ast.unparse(node.test))


def _is_forever(ending: Ending, node: ast.While) -> bool:
    if isinstance(node.test, ast.Call):
        return ending.syntax.qualified(node.test) == "rclpy.ok"
    return isinstance(node.test, ast.Constant) and bool(node.test.value)


def _never_ends(node: ast.While) -> bool:
    if not isinstance(node.test, ast.Constant) or not node.test.value:
        return False
    return _has_no_exit(node)


def _has_no_exit(node: ast.While) -> bool:
    leaves = (ast.Break, ast.Return, ast.Raise, ast.Await, ast.Yield, ast.YieldFrom)
    exits = [call for call in own_calls(node.body) if isinstance(call.func, ast.Attribute) and call.func.attr == "exit"]
    return not exits and not any(isinstance(each, leaves) for each in own(node.body))


def awaits_asyncio(ending: Ending, cls: NodeClass) -> Iterator[tuple[Callback, str, ast.Call, str]]:
    """``await asyncio.sleep(...)`` and the like in callbacks: callback, its name, the call, the function's name."""
    if not _LOOPS.isdisjoint(ending.syntax.named):
        return
    seen: set[ast.AST] = set()
    for callback in cls.callbacks:
        name, body = code_of(ending, cls, callback)
        for node in reached(ending.syntax, body, cls):
            if not isinstance(node, ast.Await) or not isinstance(node.value, ast.Call) or node in seen:
                continue
            wanted = ending.syntax.qualified(node.value) or ""
            if wanted in _NEED_A_LOOP and not _is_zero(node.value):
                seen.add(node)
                yield callback, name, node.value, wanted


_NEED_A_LOOP = frozenset(
    f"asyncio.{name}" for name in ("sleep", "gather", "wait", "wait_for", "to_thread", "create_task")
)
_LOOPS = frozenset(
    f"asyncio.{name}"
    for name in ("run", "get_event_loop", "new_event_loop", "set_event_loop", "Runner", "ensure_future")
)


def _is_zero(call: ast.Call) -> bool:
    return bool(call.args) and isinstance(call.args[0], ast.Constant) and call.args[0].value == 0


class Waiting(NamedTuple):
    """``wait_for_service()`` or ``wait_for_server()`` without a time-out, in the constructor or in a callback."""

    call: ast.Call
    service: str | None
    where: str
    logged: bool
    """A message right before it says what the node waits for."""


def waits(ending: Ending, cls: NodeClass) -> Iterator[Waiting]:
    """The waits for a service that may last forever."""
    init = cls.methods.get("__init__")
    places = [("__init__", body_of(init.node))] if init is not None else []
    places += [code_of(ending, cls, callback) for callback in cls.callbacks]
    seen: set[ast.AST] = set()
    for where, body in places:
        for node in reached(ending.syntax, body, cls):
            if not isinstance(node, ast.Call) or node.args or node.keywords or node in seen:
                continue
            function = node.func
            if not isinstance(function, ast.Attribute) or function.attr not in ("wait_for_service", "wait_for_server"):
                continue
            kept = ast.unparse(function.value)
            found = [each for each in cls.all_endpoints if each.attribute == kept and each.role.endswith("client")]
            if found:
                seen.add(node)
                yield Waiting(node, found[0].name, where, _is_announced(ending.syntax, node))


_LOGS = frozenset({"info", "warn", "warning", "error", "debug", "fatal"})


def _is_announced(syntax: Syntax, call: ast.Call) -> bool:
    """Whether one of the two statements before a call logs or prints something."""
    for outer, _ in syntax.within(call):
        if not isinstance(outer, ast.stmt):
            continue
        above = next(syntax.above(outer), None)
        block = getattr(*above) if above is not None else None
        if isinstance(block, list):
            at = block.index(outer)
            return any(_is_message(each) for each in own_calls(block[max(0, at - 2) : at]))
    return False


def _is_message(call: ast.Call) -> bool:
    function = call.func
    if isinstance(function, ast.Name):
        return function.id == "print"
    return isinstance(function, ast.Attribute) and function.attr in _LOGS
