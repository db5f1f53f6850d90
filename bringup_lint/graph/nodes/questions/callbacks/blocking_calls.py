"""Calls and loops that give the executor nothing back for a while."""

from __future__ import annotations

import ast

from bringup_lint.graph.nodes.questions.callbacks.awaited import Awaited
from bringup_lint.graph.nodes.questions.callbacks.awaited import awaited
from bringup_lint.graph.nodes.sources.device_reads import UNTIL_END
from bringup_lint.graph.nodes.sources.device_reads import device_read
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.endless_loops import has_no_exit
from bringup_lint.graph.nodes.sources.endless_loops import is_endless
from bringup_lint.graph.nodes.sources.short_programs import is_short
from bringup_lint.graph.nodes.sources.stored_values import stored
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import is_self
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

UNTIL_TIMEOUT = "until its timeout"
"""How long a call with a time-out lasts whose length is not known."""
FOREVER = "forever"
LONG = 60
"""Code points of a condition that is shown."""
SHORT = 0.1
"""Seconds; a shorter sleep delays nothing that matters."""
_PROGRAMS = frozenset(
    {"subprocess.run", "subprocess.call", "subprocess.check_call", "subprocess.check_output", "os.system"}
)
_REQUESTS = frozenset(
    f"requests.{verb}" for verb in ("get", "post", "put", "delete", "patch", "head", "options", "request")
)
_SESSIONS = ("requests.Session", "requests.session")
_OPENS = frozenset({*_REQUESTS, "urllib.request.urlopen"})
_MEASURES = frozenset({"psutil.cpu_percent", "psutil.cpu_times_percent"})
"""Functions that wait as long as their first argument says."""
_SPINS = {"rclpy.spin": 99, "rclpy.spin_until_future_complete": 3, "rclpy.spin_once": 99}
"""Functions that run the executor, and the position of their time-out."""
UNTIL_KEY = "until a key is pressed"


class Blocked(NamedTuple):
    """What a call or loop is, and how long it gives the executor nothing back."""

    what: str
    """In words: ``time.sleep(2)``."""
    how_long: str
    """``for 2 s``, ``as long as the program runs``; empty when it waits for what the same executor must do."""
    awaited: Awaited | None = None
    """The callback whose work a loop waits for."""
    made: ast.expr | None = None
    """What opens the port, makes the socket or starts the program that a call waits for."""


def blocked(ending: Ending, node: ast.Call | ast.While, cls: NodeClass) -> Blocked | None:
    """What a call or loop in a callback waits for; None when it does not block, or that is not known."""
    if isinstance(node, ast.While):
        return _loop(ending, node, cls)
    if any(isinstance(above, ast.Await) for above, _ in _next(ending, node)):
        return None
    name = ending.syntax.qualified(node)
    found = _of_library(ending, node, name, cls) if name is not None else None
    if found is not None:
        return found
    found = _of_keyboard(ending, node) or _of_local_rate(ending, node) or _of_attribute(ending, node, cls)
    if found is not None:
        return found
    read = device_read(ending, node, cls)
    return Blocked(read.what, read.how_long, made=read.made) if read is not None else None


def blocked_by_library(ending: Ending, call: ast.Call) -> Blocked | None:
    """What a call of the standard library or of requests waits for; None when it does not block, or not for long."""
    name = ending.syntax.qualified(call)
    if name == "time.sleep":
        return _sleep(ending, call)
    if name in _PROGRAMS and not _has(call, "timeout") and not is_short(ending, call):
        return None if _ends_behind(ending, call) else Blocked(str(name), UNTIL_END)
    return _open(ending, call, name) if name in _OPENS else None


def _loop(ending: Ending, node: ast.While, cls: NodeClass) -> Blocked | None:
    what = f"'while {written(node.test)}'"
    if is_endless(ending, node):
        return Blocked(what, FOREVER)
    found = awaited(ending, node, cls)
    if found is None or len(what) > LONG:
        return None
    return Blocked(what, "" if found.by or found.is_answer else FOREVER, found)


def _of_library(ending: Ending, call: ast.Call, name: str, cls: NodeClass) -> Blocked | None:
    """A function of rclpy, of the standard library or of requests."""
    if name in _MEASURES:
        return _measure(ending, call, name)
    found = blocked_by_library(ending, call)
    if found is not None:
        return found
    if name in _SPINS and _is_of(call, cls):
        until = "until another callback is ready" if name == "rclpy.spin_once" else ""
        return Blocked(f"{name}(self)", _timeout(ending, call, _SPINS[name]) or until)
    return None


def _of_keyboard(ending: Ending, call: ast.Call) -> Blocked | None:
    function = call.func
    if isinstance(function, ast.Name) and function.id == "input" and ending.file.imports.get("input") is None:
        return Blocked("input()", "until somebody types")
    if isinstance(function, ast.Attribute) and function.attr == "read_loop" and not call.args and _has_evdev(ending):
        loops = [outer for outer, name in _next(ending, call) if isinstance(outer, ast.For) and name == "iter"]
        is_endless = any(has_no_exit(each) for each in loops)
        return Blocked("read_loop()", FOREVER if is_endless else UNTIL_KEY)
    return None


def _has_evdev(ending: Ending) -> bool:
    return any((name or "").partition(".")[0] == "evdev" for name in ending.file.imports.values())


def _next(ending: Ending, node: ast.AST) -> list[tuple[ast.AST, str]]:
    first = next(ending.syntax.above(node), None)
    return [first] if first is not None else []


def _sleep(ending: Ending, call: ast.Call) -> Blocked | None:
    seconds = ending.file.constant(call.args[0], ending.syntax.function(call)) if len(call.args) == 1 else None
    if not isinstance(seconds, (int, float)) or isinstance(seconds, bool) or _ends_behind(ending, call):
        return None
    loops = [above for above, _ in ending.syntax.within(call) if isinstance(above, (ast.For, ast.While))]
    turns = _turns(ending, loops[0]) if len(loops) == 1 else None
    total = seconds * turns if turns is not None else seconds
    if total < SHORT:
        return None
    each_turn = " a turn of its loop" if loops and turns is None else ""
    return Blocked(f"time.sleep({seconds:g})", f"for {total:g} s{each_turn}")


def _measure(ending: Ending, call: ast.Call, name: str) -> Blocked | None:
    given = next((each.value for each in call.keywords if each.arg == "interval"), next(iter(call.args), None))
    seconds = ending.file.constant(given, ending.syntax.function(call)) if given is not None else None
    if not isinstance(seconds, (int, float)) or seconds < SHORT:
        return None
    return Blocked(f"{name}({seconds:g})", f"for {seconds:g} s")


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


def _open(ending: Ending, call: ast.Call, name: str) -> Blocked:
    given = next((each.value for each in call.keywords if each.arg == "timeout"), None)
    seconds = ending.file.constant(given, ending.syntax.function(call)) if given is not None else None
    if isinstance(seconds, (int, float)):
        return Blocked(name, f"for up to {seconds:g} s")
    return Blocked(name, UNTIL_TIMEOUT if given is not None else "forever when the other side is silent")


def _has(call: ast.Call, keyword: str) -> bool:
    return any(each.arg in (keyword, None) for each in call.keywords)


def _is_of(call: ast.Call, cls: NodeClass) -> bool:
    return bool(call.args) and is_self(call.args[0]) and cls.name is not None


def _of_attribute(ending: Ending, call: ast.Call, cls: NodeClass) -> Blocked | None:
    """``self.x.method()``."""
    if not isinstance(call.func, ast.Attribute) or not isinstance(call.func.value, ast.Attribute):
        return None
    owner, name = call.func.value, call.func.attr
    if not isinstance(owner.value, ast.Name) or owner.value.id != "self":
        return None
    kept = f"self.{owner.attr}"
    clients = [each for each in cls.all_endpoints if each.role == "client" and each.attribute == kept]
    if name == "call" and clients:
        return Blocked(f"{kept}.call()", _timeout(ending, call, 1))
    if name == "sleep" and not call.args and _is_rate(ending, owner.attr):
        return Blocked(f"{kept}.sleep()", "")
    if f"requests.{name}" in _REQUESTS and _is_session(ending, owner, cls):
        return _open(ending, call, f"{kept}.{name}()")
    return None


def _is_session(ending: Ending, owner: ast.Attribute, cls: NodeClass) -> bool:
    """Whether an attribute is a session of requests."""
    made = stored(ending.syntax, cls, owner)
    calls = [each for each in made if isinstance(each, ast.Call) and ending.syntax.qualified(each) in _SESSIONS]
    return bool(made) and len(calls) == len(made)


def _of_local_rate(ending: Ending, call: ast.Call) -> Blocked | None:
    """``rate.sleep()`` on a variable that the same function makes with ``create_rate``."""
    function, body = call.func, body_of(ending.syntax.function(call))
    if not isinstance(function, ast.Attribute) or function.attr != "sleep" or not isinstance(function.value, ast.Name):
        return None
    name = function.value.id
    stores = [each for each in own(body) if isinstance(each, ast.Name) and each.id == name]
    stores = [each for each in stores if isinstance(each.ctx, ast.Store)]
    made = [each for each, _ in (above for store in stores for above in _next(ending, store))]
    return Blocked(f"{name}.sleep()", "") if made and all(_makes_rate(each) for each in made) else None


def _makes_rate(statement: ast.AST) -> bool:
    value = statement.value if isinstance(statement, ast.Assign) else None
    return isinstance(value, ast.Call) and isinstance(value.func, ast.Attribute) and value.func.attr == "create_rate"


def _is_rate(ending: Ending, attribute: str) -> bool:
    """Whether an attribute is a Rate of the node, whose timer the same executor must run."""
    for call in ending.syntax.calls:
        if isinstance(call.func, ast.Attribute) and call.func.attr == "create_rate":
            for above, _ in _next(ending, call):
                targets = above.targets if isinstance(above, ast.Assign) else []
                return any(isinstance(each, ast.Attribute) and each.attr == attribute for each in targets)
    return False
