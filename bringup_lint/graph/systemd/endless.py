"""Programs that never end by themselves: what a Type=oneshot service waits for forever."""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.shells import SHELL_SCRIPT
from bringup_lint.graph.systemd.process import Process
from bringup_lint.model.python import written
from bringup_lint.model.shell import Block
from bringup_lint.parsers.python_syntax import syntax_tree
from bringup_lint.parsers.shell import script_blocks
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.files import Files

_LASTING = ("launch", "run", "node")
_TASK = regex(
    r"(?:^|[/_.-])(?:calib\w*|check\w*|clear|configure|convert|dump|flash\w*|home|homing|init\w*|load|once|prepare|reset"
    r"|save|self_?test|setup|test|upload|wait\w*)(?=[_.-]|$)"
)
"""Words for what ends when it is done."""
_SERVER = regex(r"(?:_|^)(?:agent|bridge|broadcaster|controller|driver|manager|monitor|node|publisher|server|talker)$")
_ENDS = frozenset({"break", "exit", "return", "exec"})


def never_ends(process: Process, files: Files) -> Located | None:
    """The word of a command line that starts something endless: a program of ROS that is no task by its name, or a
    program of the tree with a loop without an end."""
    for step, ros in process.ros:
        if ros.kind in _LASTING and not step.command.background and step.script is None and step.depth <= 1:
            return ros.where if _lasts(ros, process) else None
    for word in process.argv[:2]:
        source = files.find(word, word.span.source) if word.startswith("/") and "$" not in word else None
        if source is not None and _loops_forever(source):
            return word
    return None


def _lasts(ros: Ros, process: Process) -> bool:
    """Whether a program of ROS goes on until it is stopped, as far as its name says."""
    if _TASK.search(ros.where):
        return False
    return ros.kind == "launch" or (process.replaces_shell and _SERVER.search(ros.where) is not None)


def _loops_forever(source: Source) -> bool:
    first = source.text.partition("\n")[0]
    if SHELL_SCRIPT.match(first):
        return any(_is_endless(block) for block in script_blocks(source))
    if source.name.endswith(".py") or (first.startswith("#!") and "python" in first):
        return _python_loops_forever(source)
    return False


def _is_endless(block: Block) -> bool:
    if block.kind != "loop" or len(block.condition) != 1 or block.condition[0].command is None:
        return False
    return block.condition[0].command.name in ("true", ":") and not any(map(_may_end, block.bodies[0]))


def _may_end(block: Block) -> bool:
    if block.command is not None:
        return block.command.name in _ENDS
    return any(_may_end(inner) for body in (block.condition, *block.bodies) for inner in body)


def _python_loops_forever(source: Source) -> bool:
    """Whether the module, or a function that it calls at its top level, has an endless loop."""
    tree, _ = syntax_tree(source)
    if tree is None:
        return False
    functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
    top = [inner for node in tree.body for inner in _top_level(node)]
    called = {
        node.value.func.id
        for node in top
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call) and isinstance(node.value.func, ast.Name)
    }
    bodies = [top, *(functions[name].body for name in called if name in functions)]
    return any(_is_endless_loop(node) for body in bodies for node in body)


def _top_level(node: ast.stmt) -> list[ast.stmt]:
    """A statement of a module, or those below ``if __name__ == "__main__"``."""
    return node.body if isinstance(node, ast.If) and "__name__" in written(node.test) else [node]


def _is_endless_loop(node: ast.stmt) -> bool:
    if not isinstance(node, ast.While) or not isinstance(node.test, ast.Constant) or not node.test.value:
        return False
    ends = (ast.Break, ast.Return, ast.Raise)
    exits = ("exit", "_exit", "quit", "abort")
    return not any(
        isinstance(inner, ends)
        or (isinstance(inner, ast.Attribute) and inner.attr in exits)
        or (isinstance(inner, ast.Name) and inner.id in exits)
        for inner in ast.walk(node)
    )
