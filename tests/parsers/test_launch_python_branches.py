"""What a launch file does for each value of an argument is what Python does, or is not known: never something else."""

from __future__ import annotations

import textwrap
from typing import Any

import pytest

from bringup_lint.model.launch import DeclareArgument
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import Opaque
from bringup_lint.model.launch import walk_actions
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Value
from bringup_lint.parsers.launch_python import parse
from bringup_lint.source import Source

FRAME = """\
import os
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def setup(context):
    mode = LaunchConfiguration('mode').perform(context)
    nodes = []
{body}
    return [*nodes, Node(package='p', executable='e', name='last', parameters=[{{'out': out}}])]

def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('mode'), OpaqueFunction(function=setup)])
"""
MODES = ("a", "b", "")
ABSENT = object()


class NotKnown(Exception):
    """The reader of launch files leaves it open."""


class Reading:
    """A launch file for one value of its argument."""

    def __init__(self, file: LaunchFile, mode: str) -> None:
        actions = [action for action in walk_actions(file.actions) if not isinstance(action, DeclareArgument)]
        self.nodes = [action for action in actions if isinstance(action, Node)]
        self.known = all(isinstance(action, (Node, Opaque)) for action in actions)
        self.mode = mode

    def happening(self) -> list[Node]:
        if not self.known:
            raise NotKnown
        return [node for node in self.nodes if self.hold(node.conditions)]

    def hold(self, guards: tuple[Condition, ...]) -> bool:
        return all(bool(self.value(guard.predicate)) is guard.wanted for guard in guards)

    def value(self, value: Value | None) -> Any:
        if isinstance(value, Literal):
            return str(value.value) if isinstance(value.value, str) else value.value
        if isinstance(value, Argument) and value.performed:
            return self.mode
        if isinstance(value, Concat):
            return "".join(map(self.value, value.parts))
        if isinstance(value, PathJoin):
            return "/".join(map(self.value, value.parts))
        if isinstance(value, Choice):
            held = [option for guards, option in value.options if self.hold(guards)]
            return self.value(held[-1]) if held else ABSENT
        if isinstance(value, ListValue) and not value.open:
            return [item for item in map(self.value, value.items) if item is not ABSENT]
        if isinstance(value, DictValue) and not value.open:
            pairs = [(self.value(key), self.value(item)) for key, item in value.items]
            return {key: item for key, item in pairs if item is not ABSENT}
        if isinstance(value, Operation) and value.name in OPERATIONS:
            return OPERATIONS[value.name](*map(self.value, value.operands))
        raise NotKnown


OPERATIONS: dict[str, Any] = {
    "==": lambda a, b: a == b,
    "!=": lambda a, b: a != b,
    "not": lambda a: not a,
    "and": lambda *all_of: all(all_of),
    "or": lambda *any_of: any(any_of),
    "lower": str.lower,
    "upper": str.upper,
    "strip": str.strip,
    "title": str.title,
    "capitalize": str.capitalize,
}


def body(program: str) -> str:
    return textwrap.indent(textwrap.dedent(program), "    ")


def read(program: str, mode: str) -> tuple[list[str], Any] | None:
    """The names of the nodes that start, and ``out``; None where that is not known, and where the file raises."""
    reading = Reading(parse(Source("robot.launch.py", FRAME.format(body=body(program)))), mode)
    try:
        nodes = reading.happening()
        if not nodes:
            return None
        (given,) = nodes[-1].parameters
        assert isinstance(given, DictValue)
        return [reading.value(node.name) for node in nodes[:-1]], reading.value(given.get("out"))
    except NotKnown:
        return None


def run(program: str, mode: str) -> tuple[list[str], Any]:
    names: dict[str, Any] = {"Node": lambda name, **_: name}
    text = f"import os\ndef f(mode):\n    nodes = []\n    out = ''\n{body(program)}\n    return nodes, out\n"
    exec(text, names)
    nodes, out = names["f"](mode)
    return nodes, out


def node(name: str) -> str:
    return f"Node(package='p', executable='e', name='{name}')"


X, Y = node("x"), node("y")
PROGRAMS = [
    # values
    "out = 'x' + mode",
    "out = mode + '_x'",
    "out = f'{mode}_x'",
    "out = '%s.yaml' % mode",
    "out = '{}.yaml'.format(mode)",
    "out = os.path.join('x', mode + '.yaml')",
    "out = '_'.join(['x', mode])",
    "out = {'a': 1, 'b': 2, '': 3}[mode]",
    "out = mode.upper()",
    "out = mode.strip().lower() + 'x'",
    "out = [mode, 'x']",
    "out = {'k': mode}",
    "out = str(mode)",
    # conditions
    "out = 1 if mode == 'a' else 2",
    "out = 1 if mode != 'a' else 2",
    "out = 1 if mode else 2",
    "out = 1 if not mode else 2",
    "out = 1 if mode in ('a', 'b') else 2",
    "out = 1 if mode not in ['a'] else 2",
    "out = 1 if mode == 'a' or mode == 'b' else 2",
    "out = 1 if mode and mode != 'b' else 2",
    "out = 1 if mode.upper() == 'A' else 2",
    "out = 1 if mode in {'a': 1} else 2",
    "out = mode or 'fallback'",
    "out = mode and 'chosen'",
    "on = mode == 'a'\nout = 1 if on else 2",
    "on = not (mode == 'a')\nout = 1 if on else 2",
    # branches
    "if mode == 'a':\n    out = 1\nelse:\n    out = 2",
    "out = 0\nif mode == 'a':\n    out = 1",
    "if mode == 'a':\n    out = 1\nelif mode == 'b':\n    out = 2\nelse:\n    out = 3",
    "out = 'n'\nif mode == 'a':\n    out += '_a'",
    "out = 'n'\nif mode == 'a':\n    out += '_a'\nif mode:\n    out += '_m'",
    "out = []\nif mode == 'a':\n    out.append(1)\nout.append(2)",
    "out = [0]\nif mode == 'a':\n    out += [1, 2]",
    "out = [0]\nif mode == 'a':\n    out = out + [1]",
    "out = [1, 2]\nif mode == 'a':\n    out.remove(1)",
    "out = [1, 2]\nif mode == 'a':\n    out.pop()",
    "out = [1, 2]\nif mode == 'a':\n    out.insert(0, 0)",
    "out = [1, 2]\nif mode == 'a':\n    out.reverse()",
    "out = [1, 2]\nif mode == 'a':\n    out[0] = 5",
    "out = [1, 2]\nif mode == 'a':\n    out.clear()",
    "out = {}\nif mode == 'a':\n    out['k'] = 1",
    "out = {'k': 0}\nif mode == 'a':\n    out['k'] = 1",
    "out = {'k': 0}\nif mode == 'a':\n    out.update({'k': 1, 'm': 2})",
    "out = {'k': 0}\nif mode == 'a':\n    del out['k']",
    "out = {'k': 0}\nif mode == 'a':\n    out.pop('k')",
    "box = {}\nif mode == 'a':\n    box['k'] = 1\nout = box.get('k', 0)",
    "box = {}\nif mode == 'a':\n    box['k'] = 1\nout = 'k' in box",
    "box = {}\nif mode == 'a':\n    box.setdefault('k', 1)\nout = box.get('k', 0)",
    "box = []\nif mode == 'a':\n    box.append(1)\nout = 1 if box else 2",
    "box = []\nif mode == 'a':\n    box.append(1)\nout = len(box)",
    "box = []\nif mode == 'a':\n    box.append(1)\nout = 1 in box",
    "box = ['x']\nif mode == 'a':\n    box.append('y')\nout = '_'.join(box)",
    "box = ['x']\nif mode == 'a':\n    box.append('y')\nout = box[-1]",
    "box = ['x']\nif mode == 'a':\n    box.append('y')\nout = [n + '1' for n in box]",
    "name = 'p' if mode == 'a' else 'q'\nout = name + '_x'",
    "name = 'p' if mode == 'a' else 'q'\nout = name.upper()",
    "name = 'p' if mode == 'a' else 'q'\nout = f'{name}_x'",
    "name = 'p' if mode == 'a' else 'q'\nout = os.path.join('d', name, 'f')",
    "name = 'p' if mode == 'a' else 'q'\nout = {'p': 1, 'q': 2}[name]",
    "name = 'p' if mode == 'a' else 'q'\nout = 1 if name == 'p' else 2",
    "name = None\nif mode == 'a':\n    name = 'p'\nout = 1 if name is None else 2",
    "name = None\nif mode == 'a':\n    name = 'p'\nout = name or 'q'",
    "both = ['p'] if mode == 'a' else ['q', 'r']\nout = [n for n in both]",
    "both = ['p'] if mode == 'a' else ['q', 'r']\nout = both + ['s']",
    "both = {'k': 1} if mode == 'a' else {'k': 2}\nout = both['k']",
    # functions and loops
    "def pick():\n    if mode == 'a':\n        return 1\n    return 2\nout = pick()",
    "def pick(m):\n    if m == 'a':\n        return 1\n    elif m == 'b':\n        return 2\nout = pick(mode)",
    "out = 0\nfor m in ['a', 'b']:\n    if m == mode:\n        out = m",
    "out = []\nfor m in ['a', 'b', 'c']:\n    if m == mode:\n        break\n    out.append(m)",
    "out = []\nfor m in ['a', 'b', 'c']:\n    if m == mode:\n        continue\n    out.append(m)",
    "for m in ['a', 'b']:\n    if m == mode:\n        out = 'found'\n        break\nelse:\n    out = 'none'",
    "out = 0\nwhile mode == 'a' and out < 1:\n    out = 1",
    "try:\n    out = {'a': 1}[mode]\nexcept KeyError:\n    out = 2",
    "match mode:\n    case 'a':\n        out = 1\n    case _:\n        out = 2",
    "out = [m for m in ['a', 'b'] if m == mode]",
    "out = any([mode == 'a', mode == 'b'])",
    # nodes
    f"out = 0\nif mode == 'a':\n    nodes.append({X})",
    f"out = 0\nif mode == 'a':\n    nodes.append({X})\nelse:\n    nodes.append({Y})",
    f"out = 0\nif mode:\n    nodes.append({X})\n    if mode == 'a':\n        nodes += [{Y}]",
    f"out = 0\nnodes = [{X}] if mode == 'a' else [{Y}]",
    f"out = 0\nnodes += [{X}] * (1 if mode == 'a' else 0)",
    f"out = 0\ndef more():\n    if mode != 'a':\n        return []\n    return [{X}]\nnodes += more()",
    "def pick():\n    for m in 'ab':\n        if m == mode:\n            return m\n    return 'none'\nout = pick()",
    "out = 0\nfor m in ['a', 'b']:\n    if m == mode:\n        out = m\n        continue\n    last = m",
    "out = []\nfor m in ['a', 'b', 'c']:\n    if m == mode:\n        break\n    else:\n        continue\nout = m",
    f"out = 0\nfor m in ['a', 'b']:\n    if m != mode:\n        continue\n    nodes.append({X})",
    f"out = 0\nfor m in ['a', 'b']:\n    if m == mode:\n        break\n    nodes.append({X})",
    f"out = 0\nfound = {{'a': {X}, 'b': {Y}}}.get(mode)\nif found is not None:\n    nodes.append(found)",
    f"out = 0\ndef add(n):\n    if mode == n:\n        nodes.append({X})\nadd('a')\nadd('b')",
    f"out = 0\nnodes.extend([{X}, {Y}])\nif mode == 'a':\n    nodes.pop()",
    f"out = 0\nnodes.extend([{X}, {Y}])\nif mode == 'a':\n    nodes = nodes[:1]",
    f"out = 0\nnodes.extend([{X}, {Y}])\nif mode == 'a':\n    nodes.clear()",
    f"out = 0\nnodes.extend([{X}, {Y}])\nif mode == 'a':\n    del nodes[0]",
    f"out = 0\nif mode not in ('a', 'b'):\n    raise RuntimeError(mode)\nnodes.append({X})",
]
FOLLOWED = 0.7
"""The least share of the programs that are known for each value of the argument."""


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("program", PROGRAMS)
def test_a_branch_is_that_of_python_or_not_known(program: str, mode: str) -> None:
    found = read(program, mode)
    if found is None:
        return
    try:
        expected = run(program, mode)
    except (KeyError, RuntimeError):
        return
    assert found == expected


def test_most_branches_are_known() -> None:
    unknown = [program for program in PROGRAMS if any(read(program, mode) is None for mode in MODES)]
    assert len(unknown) <= len(PROGRAMS) * (1 - FOLLOWED), unknown
