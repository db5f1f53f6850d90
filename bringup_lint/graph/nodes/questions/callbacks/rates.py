"""Rates that sleep where nothing spins the node."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_THREADS = regex(
    r"spin_once|spin_some|[Tt]hread|concurrent\.futures|multiprocessing|MultiThreadedExecutor|EventsExecutor|asyncio",
    hints="spin_once spin_some hread concurrent.futures multiprocessing MultiThreadedExecutor EventsExecutor asyncio",
)


class EndlessRate(NamedTuple):
    rate: ast.Call
    sleep: ast.Call


def endless_rates(syntax: Syntax) -> Iterator[EndlessRate]:
    """The sleeps on rates of a file that runs in one thread; the first of each rate."""
    if syntax.file.source.matches(_THREADS) or not _makes_node(syntax):
        return
    rates = [call for call in syntax.calls if _is_method(call, "create_rate")]
    first = _first_sleeps(syntax) if rates else {}
    for rate in rates:
        sleep = first.get(_kept(syntax, rate))
        if sleep is not None and not _is_in_callback(syntax, sleep):
            yield EndlessRate(rate, sleep)


def _first_sleeps(syntax: Syntax) -> dict[str | None, ast.Call]:
    """Variable or attribute -> the first call of its method ``sleep``."""
    found: dict[str | None, ast.Call] = {}
    for call in syntax.calls:
        if isinstance(call.func, ast.Attribute) and call.func.attr == "sleep":
            found.setdefault(written(call.func.value), call)
    return found


def _makes_node(syntax: Syntax) -> bool:
    """Whether the file is the program: it initialises rclpy itself, so that nobody else spins its nodes."""
    return "rclpy.init" in syntax.named


def _is_method(call: ast.Call, name: str) -> bool:
    return isinstance(call.func, ast.Attribute) and call.func.attr == name


def _is_in_callback(syntax: Syntax, call: ast.Call) -> bool:
    """Whether a spin may run the method that sleeps: it then blocks the executor, and is no matter of the rate."""
    function = syntax.function(call)
    method = any(isinstance(outer, ast.ClassDef) for outer, _ in syntax.above(call))
    spins = "rclpy.spin" in syntax.named
    return method and spins and function is not None and function.name != "__init__"


def _kept(syntax: Syntax, call: ast.Call) -> str | None:
    """The variable or attribute that a rate is assigned to."""
    outer = next((each for each, _ in syntax.above(call)), None)
    if isinstance(outer, ast.Assign) and len(outer.targets) == 1:
        return written(outer.targets[0])
    return None
