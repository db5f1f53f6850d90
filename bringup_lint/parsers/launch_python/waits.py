"""Calls in a launch file's own code that hold up the whole launch: programs that it runs to the end, and pauses.

launch evaluates launch files and calls the functions of ``OpaqueFunction`` in its one event loop: nothing is started,
watched or stopped meanwhile.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.model.launch import Wait
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.pattern import regex

MENTIONED = regex(r"\b(?:subprocess|os\.system|sleep)\b", hints="subprocess os.system sleep")
"""Without one of these words in its text, a file has no such call."""
_RUNNING = ("subprocess.run", "subprocess.check_call", "subprocess.check_output", "check_call", "check_output")
_SLEEPING = ("time.sleep", "sleep")
_PREFIXES = ("sudo", "env", "exec", "nice")
_LONG = frozenset(
    "docker podman openocd wget curl apt apt-get pip pip3 git ros2 avrdude esptool esptool.py rosdep nmcli ssh scp "
    "rsync colcon make cmake dfu-util st-flash systemctl bluetoothctl".split()
)
"""Programs that take their time, or fail when a network or a device is missing."""
_ENTRIES = ("generate_launch_description",)
_WITHOUT_END = float("inf")


def waits(tree: ast.Module, positions: Positions) -> Iterator[Wait]:
    """The calls that hold up the launch, in the order of the text."""
    functions = {each.name: each for each in ast.walk(tree) if isinstance(each, ast.FunctionDef)}
    bodies: list[ast.Module | ast.FunctionDef] = [tree]
    names = [*_ENTRIES, *_opaque(tree)]
    while names:
        function = functions.get(names.pop())
        if function is not None and function not in bodies:
            bodies.append(function)
            names += [name for call in _calls(function) if (name := _name(call.func)) in functions]
    names = [name for call in _calls(tree) if (name := _name(call.func)) in functions]
    bodies += [functions[name] for name in names if functions[name] not in bodies]
    loaded = (tree, *(functions.get(name) for name in _ENTRIES))
    for body in sorted(bodies, key=lambda each: getattr(each, "lineno", 0)):
        yield from (each._replace(is_before=body in loaded) for each in _of_body(body, positions))


def _opaque(tree: ast.Module) -> Iterator[str]:
    """The names of the functions that launch calls while it runs."""
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and _name(call.func).rpartition(".")[2] == "OpaqueFunction":
            given = [*call.args[:1], *(word.value for word in call.keywords if word.arg == "function")]
            yield from (each.id for each in given if isinstance(each, ast.Name))


def _calls(body: ast.Module | ast.FunctionDef) -> Iterator[ast.Call]:
    return (node for node, _, _ in _walk(body) if isinstance(node, ast.Call))


def _walk(body: ast.AST, times: float = 1, caught: bool = False) -> Iterator[tuple[ast.AST, float, bool]]:
    """The nodes of a body without the functions in it, with how often a loop runs them, and whether an exception of
    theirs is caught."""
    for child in ast.iter_child_nodes(body):
        if isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda)):
            continue
        if isinstance(child, ast.Try):
            for part in child.body:
                yield from _walk(ast.Module([part], []), times, caught or bool(child.handlers))
            for rest in (*child.handlers, *child.orelse, *child.finalbody):
                yield from _walk(ast.Module([rest], []), times, caught)  # type: ignore[list-item]
            continue
        yield child, times, caught
        yield from _walk(child, times * _rounds(child), caught)


def _rounds(loop: ast.AST) -> float:
    """How often the body of a loop runs at most; 1 for what is none, or where it is not known."""
    if isinstance(loop, ast.While):
        endless = isinstance(loop.test, ast.Constant) and bool(loop.test.value)
        return _WITHOUT_END if endless else 1
    if isinstance(loop, ast.For) and isinstance(loop.iter, ast.Call) and _name(loop.iter.func) == "range":
        last = loop.iter.args[-1] if len(loop.iter.args) == 1 else None
        return _number(last) or 1
    return 1


def _of_body(body: ast.Module | ast.FunctionDef, positions: Positions) -> Iterator[Wait]:
    lists = _assigned(body)
    for node, times, caught in _walk(body):
        if not isinstance(node, ast.Call):
            continue
        name = _name(node.func)
        if name in _SLEEPING and node.args:
            seconds = _number(node.args[0])
            if seconds:
                yield Wait(name, positions.span(node), seconds * times)
        elif name in _RUNNING and node.args and not any(word.arg == "timeout" for word in node.keywords):
            program = _program(node.args[0], lists)
            if program in _LONG and not caught and _raises(name, node):
                yield Wait(program, positions.span(node))


def _assigned(body: ast.Module | ast.FunctionDef) -> dict[str, ast.expr]:
    """Variable -> the list or text that it was given first."""
    found: dict[str, ast.expr] = {}
    for node, _, _ in _walk(body):
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            found.setdefault(node.targets[0].id, node.value)
    return found


def _program(given: ast.expr, lists: dict[str, ast.expr]) -> str:
    if isinstance(given, ast.Name):
        given = lists.get(given.id, given)
    words: list[str] = []
    if isinstance(given, ast.Constant) and isinstance(given.value, str):
        words = given.value.split()
    elif isinstance(given, ast.List):
        words = [each.value for each in given.elts if isinstance(each, ast.Constant) and isinstance(each.value, str)]
    program = next((word for word in words if word not in _PREFIXES and "=" not in word), "")
    return program.rpartition("/")[2]


def _raises(name: str, call: ast.Call) -> bool:
    checks = (word.value for word in call.keywords if word.arg == "check")
    return not name.endswith("run") or any(isinstance(each, ast.Constant) and each.value is True for each in checks)


def _number(node: ast.expr | None) -> float | None:
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)) and not isinstance(node.value, bool):
        return float(node.value)
    return None


def _name(node: ast.expr) -> str:
    """A dotted name; empty for anything else."""
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute):
        owner = _name(node.value)
        return f"{owner}.{node.attr}" if owner else ""
    return ""
