"""How a node source ends: who handles the signals, what runs when ``spin`` is over.

As tried with rclpy (Jazzy): unless ``rclpy.init`` is told otherwise, SIGINT and SIGTERM invalidate the context before
any ``except`` or ``finally`` runs. A handler of ``signal.signal`` runs only when the interpreter gets control, and a
spin that nothing wakes keeps waiting in C.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.facts.ros.simulation import is_simulator
from bringup_lint.graph.nodes.sources.sending import called
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import NodeClass
from bringup_lint.named_tuple import NamedTuple

_SINGLE = "rclpy.executors.SingleThreadedExecutor"
_MULTI = "rclpy.executors.MultiThreadedExecutor"
_OWN_SIGNALS = (
    "rclpy.signals.install_signal_handlers",
    "rclpy.signals.uninstall_signal_handlers",
    "rclpy.install_signal_handlers",
    "rclpy.uninstall_signal_handlers",
    "signal.set_wakeup_fd",
    "signal.sigwait",
    "signal.pthread_sigmask",
)


_RAW = ("tty.setraw", "curses.raw")
_KEYS = (
    "termios",
    "tty",
    "curses",
    "getch",
    "getkey",
    "readchar",
    "sshkeyboard",
    "msvcrt",
    "pynput",
    "evdev.events",
    "evdev.KeyEvent",
)
UNKNOWN = ("foxy", "galactic")
"""Distributions whose rclpy handles signals in another way (before rclpy 3, Humble)."""


class Spin(NamedTuple):
    """A call that runs callbacks until the node ends. ``executor``: ``single``, ``multi`` or None when not known."""

    call: ast.Call
    executor: str | None
    loop: bool
    """A loop around ``spin_once``, which returns to the interpreter."""


class Handler(NamedTuple):
    """``signal.signal(...)``. ``first``: it surely is before ``rclpy.init``; None: the order is not known."""

    call: ast.Call
    signals: frozenset[str]
    handler: ast.expr
    python: bool
    """A function of Python, not ``SIG_IGN`` or ``SIG_DFL``."""


class Ending:
    """One file."""

    def __init__(self, syntax: Syntax, distribution: str | None = None) -> None:
        self.syntax = syntax
        self.file = syntax.file
        self.distribution = distribution

    @cached_property
    def inits(self) -> list[ast.Call]:
        return self.syntax.named.get("rclpy.init", [])

    @cached_property
    def signals(self) -> str | None:
        """What handles SIGINT and SIGTERM: ``rclpy`` (the default), ``none`` (not rclpy); None: not known."""
        options = {self._option(call) for call in self.inits}
        if self.distribution in UNKNOWN:
            return None
        if len(options) != 1 or not self.syntax.named.keys().isdisjoint(_OWN_SIGNALS):
            return None
        return options.pop()

    def _option(self, call: ast.Call) -> str | None:
        names = {each.arg: each.value for each in call.keywords}
        if None in names or "context" in names or call.args:
            return None
        if "signal_handler_options" not in names:
            return "rclpy"
        chosen = self.file.named(names["signal_handler_options"], self.syntax.function(call)) or ""
        return {"NO": "none", "ALL": "rclpy"}.get(chosen.rpartition("SignalHandlerOptions.")[2])

    @cached_property
    def is_raw_terminal(self) -> bool:
        """Whether Ctrl-C reaches the program as a character, and not as a signal."""
        return not self.syntax.named.keys().isdisjoint(_RAW)

    @cached_property
    def reads_keys(self) -> bool:
        """Whether a person runs it and presses keys, at a terminal or on a keypad."""
        return self.is_raw_terminal or any((name or "").startswith(_KEYS) for name in self.file.imports.values())

    @cached_property
    def drives_simulator(self) -> bool:
        """Whether it imports a module for that."""
        return any(map(is_simulator, filter(None, self.file.imports.values())))

    @cached_property
    def handlers(self) -> list[Handler]:
        found = []
        for call in self.syntax.calls:
            if self.syntax.qualified(call) == "signal.signal" and len(call.args) == 2:
                name = self.file.qualified(call.args[0]) or ""
                handler = self.file.qualified(call.args[1]) or ""
                python = not handler.startswith(("signal.SIG_", "signal.Handlers."))
                short = name.rpartition(".")[2]
                signals = frozenset({short} if short.startswith("SIG") else ("SIGINT", "SIGTERM"))
                found.append(Handler(call, signals, call.args[1], python))
        return found

    @cached_property
    def spins(self) -> list[Spin]:
        """The direct calls that spin, and the loops around ``spin_once``."""
        found = []
        for call in self.syntax.calls:
            spin = self._spin(call)
            if spin is not None and not self._in_thread(call):
                found.append(spin)
        return found

    def _spin(self, call: ast.Call) -> Spin | None:
        name = self.syntax.qualified(call)
        if name == "rclpy.spin":
            given = next((each.value for each in call.keywords if each.arg == "executor"), None)
            given = given or (call.args[1] if len(call.args) > 1 else None)
            return Spin(call, "single" if given is None else self._executor(given, call), False)
        if name == "rclpy.spin_once":
            return Spin(call, "single", True) if self._looped(call) and len(call.args) < 2 else None
        function = call.func
        if not isinstance(function, ast.Attribute) or function.attr not in ("spin", "spin_once"):
            return None
        executor = self._executor(function.value, call)
        if executor is None or (function.attr == "spin_once" and not self._looped(call)):
            return None
        return Spin(call, executor, function.attr == "spin_once")

    def _executor(self, node: ast.expr, call: ast.Call) -> str | None:
        name = self.file.named(node, self.syntax.function(call))
        return {_SINGLE: "single", _MULTI: "multi"}.get(name or "")

    def _looped(self, call: ast.Call) -> bool:
        return any(isinstance(outer, ast.While) for outer, _ in self.syntax.within(call))

    def spins_in(self, nodes: list[ast.stmt]) -> Iterator[Spin]:
        """The spins that statements run: their own, and those of the functions of the file that they call."""
        by_call = {spin.call: spin for spin in self.spins}
        for call in own_calls(nodes):
            if call in by_call:
                yield by_call[call]
                continue
            for function, _ in called(self.syntax, call, None):
                yield from (by_call[inner] for inner in own_calls(body_of(function)) if inner in by_call)

    @cached_property
    def tries(self) -> list[tuple[ast.Try, list[Spin]]]:
        """The ``try`` statements around a spin."""
        found = []
        for node in self.file.nodes:
            if not isinstance(node, ast.Try) or self._in_thread(node):
                continue
            if spins := list(self.spins_in(node.body)):
                found.append((node, spins))
        return found

    def _in_thread(self, node: ast.AST) -> bool:
        """Whether code runs in a thread of its own: what a signal raises is not raised there."""
        for outer, _ in self.syntax.above(node):
            if isinstance(outer, ast.ClassDef):
                return any((self.file.qualified(base) or "").endswith("Thread") for base in outer.bases)
            if isinstance(outer, (ast.FunctionDef, ast.AsyncFunctionDef)) and outer.name in self._targets:
                return True
        return False

    @cached_property
    def _targets(self) -> frozenset[str]:
        """The functions and methods that are handed to threads and processes."""
        given = [each.value for call in self.syntax.calls for each in call.keywords if each.arg == "target"]
        names = [node.attr if isinstance(node, ast.Attribute) else getattr(node, "id", "") for node in given]
        return frozenset(names)

    def caught(self, handler: ast.ExceptHandler) -> frozenset[str]:
        """The names of the exceptions that a handler takes; ``BaseException`` when it takes all. Empty: not known."""
        if handler.type is None:
            return frozenset({"BaseException"})
        types = handler.type.elts if isinstance(handler.type, ast.Tuple) else [handler.type]
        names = [self.file.qualified(each) or (each.id if isinstance(each, ast.Name) else "") for each in types]
        return frozenset() if "" in names else frozenset(name.rpartition(".")[2] for name in names)

    def guarded(self, node: ast.AST, until: ast.AST) -> bool:
        """Whether a condition, a ``with`` or an inner ``try`` is between a node and an outer one."""
        for outer, name in self.syntax.within(node):
            if outer is until:
                return False
            if isinstance(outer, (ast.If, ast.With, ast.While, ast.IfExp, ast.BoolOp)):
                return True
            if isinstance(outer, ast.Try) and name == "body" and outer.handlers:
                return True
        return False


def statements_of(ending: Ending, node: ast.expr, cls: NodeClass | None) -> list[ast.AST]:
    """The statements of a function that is handed over by name, as a method or as a lambda."""
    if isinstance(node, ast.Lambda):
        return [node.body]
    if isinstance(node, ast.Name) and node.id in ending.file.functions:
        return body_of(ending.file.functions[node.id].node)
    if isinstance(node, ast.Attribute):
        owners = [cls] if cls is not None else [each for each in ending.file.classes if each.is_node]
        found = next((method for each in owners if (method := each.method(node.attr))), None)
        return body_of(found.node) if found is not None else []
    return []
