"""What the code of a launch file computes is what Python computes, or is not known: never something else."""

from __future__ import annotations

import pathlib
import textwrap
from typing import Any

import pytest

from bringup_lint.model.launch import Node
from bringup_lint.model.launch import walk_actions
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.parsers.launch_python import parse
from bringup_lint.source import Source

FRAME = """\
import os
from pathlib import Path
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
{body}
    return LaunchDescription([Node(package='p', executable='e', name='n', parameters=[{{'out': out}}])])
"""

NOT_KNOWN = object()


def read(program: str) -> Any:
    """The value of ``out`` as a launch file that is only read gives it."""
    body = textwrap.indent(textwrap.dedent(program), "    ")
    file = parse(Source("robot.launch.py", FRAME.format(body=body)))
    (node,) = (action for action in walk_actions(file.actions) if isinstance(action, Node))
    (given,) = node.parameters
    assert isinstance(given, DictValue)
    return NOT_KNOWN if node.conditions else plain(given.get("out"))


def plain(value: Any) -> Any:
    if isinstance(value, Literal):
        return str(value.value) if isinstance(value.value, str) else value.value
    if isinstance(value, ListValue) and not value.open:
        items = [plain(item) for item in value.items]
        return NOT_KNOWN if NOT_KNOWN in items else items
    if isinstance(value, DictValue) and not value.open:
        pairs = {plain(key): plain(item) for key, item in value.items}
        return NOT_KNOWN if NOT_KNOWN in [*pairs, *pairs.values()] else pairs
    return NOT_KNOWN


def run(program: str) -> Any:
    """The value of ``out`` as Python gives it."""
    names: dict[str, Any] = {}
    body = textwrap.indent(textwrap.dedent(program), "    ")
    exec(f"import os\nfrom pathlib import Path\ndef f():\n{body}\n    return out\nresult = f()\n", names)
    return listed(names["result"])


def listed(value: Any) -> Any:
    if isinstance(value, (list, tuple)):
        return [listed(item) for item in value]
    if isinstance(value, dict):
        return {key: listed(item) for key, item in value.items()}
    return str(value) if isinstance(value, pathlib.PurePath) else value


PROGRAMS = [
    # numbers
    "out = 7 // 2 + 7 % 4 * 2 - 1",
    "out = 1 / 4",
    "out = -3 + (+2)",
    "out = not 0",
    "out = 2 < 3 and 3 >= 3",
    "out = 'a' < 'b'",
    "out = 5 != 5.0",
    # text
    "out = 'a' + 'b'",
    "out = 'robot_%s' % 'a'",
    "out = '%s/%s' % ('a', 'b')",
    "out = 'n%d' % 3",
    "out = '{}_{}'.format('a', 1)",
    "name = 'base'\nout = f'{name}_link{1 + 1}'",
    "out = ' Base '.strip().lower()",
    "out = 'base link'.title()",
    "out = 'a,b'.split(',')",
    "out = '/'.join(['a', 'b'])",
    "out = 'front_left'.replace('front', 'rear')",
    "out = 'lidar'.upper().capitalize()",
    "out = 'abc'[1]",
    "out = 'abc'[-2:]",
    "out = 'b' in 'abc'",
    "out = 'x' not in 'abc'",
    "out = str(5) + str(1.5)",
    "out = 'true' == 'True'.lower()",
    "out = os.path.join('a', 'b', 'c.yaml')",
    # lists
    "out = [1, 2] + [3]",
    "out = [1, 2, 3][1:]",
    "out = [1, 2, 3][-1]",
    "out = (1, 2)[0]",
    "out = [x * 2 for x in [1, 2, 3]]",
    "out = [x for x in (1, 2, 3) if x != 2]",
    "out = [a + b for a in 'xy' for b in ['1']] if False else ['z']",
    "out = []\nfor x in range(3):\n    out.append(x)",
    "out = []\nout.extend([1, 2])\nout.insert(0, 0)",
    "out = [1, 2, 3]\nout.remove(2)",
    "out = [1, 2, 3]\nout.pop()",
    "out = [1, 2, 3]\nout.pop(0)",
    "out = [1, 2, 3]\nout.reverse()",
    "first = [1]\nout = first.copy()\nfirst.append(2)",
    "out = [1]\nother = out\nother += [2]",
    "out = [1, 2]\nout[0] = 5",
    "out = [1, 2]\nout[-1] = 5",
    "out = [*[1, 2], 3]",
    "out = [n for i, n in enumerate(['a', 'b'])]",
    "out = [a + b for a, b in zip(['a', 'b'], ['c', 'd'])]",
    "out = len([1, 2])",
    "out = 2 in [1, 2]",
    "out = 3 not in (1, 2)",
    "out = [1, 2]\nout += (3,)",
    "out = []\nout += {'a': 1}",
    "out = []\nfor key in {'a': 1, 'b': 2}:\n    out.append(key)",
    # dictionaries
    "out = {'a': 1, **{'b': 2}}",
    "out = {'a': 1} | {'b': 2}",
    "out = {'a': 1}\nout['b'] = 2",
    "out = {'a': 1}\nout.update({'a': 2})",
    "out = {'a': 1, 'b': 2}\ndel out['a']",
    "out = {'a': 1}['a']",
    "out = {'a': 1}.get('a')",
    "out = {'a': 1}.get('b', 5)",
    "out = 'a' in {'a': 1}",
    "out = [f'{k}{v}' for k, v in {'a': 1}.items()]",
    "out = list({'a': 1}.keys())",
    "out = list({'a': 1}.values())",
    "out = {k: v for k, v in [('a', 1)]}",
    "out = dict(a=1, b='x')",
    "out = {'a': 1}\nout.setdefault('b', 2)",
    "out = {'a': 1}\nout.pop('a')",
    # conditions
    "out = 1 if [] else 2",
    "out = 1 if {} else 2",
    "out = 1 if {'a': 1} else 2",
    "out = 1 if [0] else 2",
    "out = '' or 'fallback'",
    "out = 'a' and 'b'",
    "x = None\nout = 1 if x is None else 2",
    "x = True\nout = 1 if x is not False else 2",
    "if 'a' == 'b':\n    out = 1\nelif 1 < 2:\n    out = 2\nelse:\n    out = 3",
    "out = 1 < 2 < 3",
    # statements
    "a = b = 3\nout = a + b",
    "a, (b, c) = 1, (2, 3)\nout = [a, b, c]",
    "out: int = 4",
    "out = 1\nout += 2",
    "out = 'a'\nout += 'b'",
    "box = {'n': 1}\nbox['n'] += 1\nout = box['n']",
    "def twice(x, *, by=2):\n    return x * by\nout = twice(4)",
    "def named(a, b='c', *rest, **more):\n    return a + b\nout = named(b='x', a='y')",
    "count = 0\ndef add():\n    nonlocal count\n    count = count + 1\nadd()\nout = count",
    "out = (lambda x: x + 1)(1)",
    "def parts():\n    yield 'a'\n    yield 'b'\nout = list(parts())",
    "for out in [1, 2, 3]:\n    if out == 2:\n        break",
    "out = 0\nfor x in [1, 2, 3]:\n    if x == 2:\n        continue\n    out += x",
    "for x in [1]:\n    out = x\nelse:\n    out = 'else'",
    "for x in [1, 2]:\n    out = x\n    break\nelse:\n    out = 'else'",
    "out = [[x, y] for x in [1, 2] for y in [3]]",
    "def early(x):\n    if x > 1:\n        return 'big'\n    return 'small'\nout = [early(1), early(2)]",
    "def inner():\n    for x in [1, 2, 3]:\n        if x == 2:\n            return x\nout = inner()",
    "out = sorted(['b', 'a'])",
    "out = sorted([1, 2], reverse=True)",
    "out = [2, 1]\nout.sort()",
    "out = [str(x) for x in reversed([1, 2])]",
    "out = bool('')",
    "out = int('5') + 1",
    "out = float('1.5')",
    "out = max(1, 2)",
    "out = any([0, 1])",
    "out = 'a.b'.startswith('a')",
    "out = 'config.yaml'.endswith('.yaml')",
    "import os as system\nout = system.path.join('a', 'b')",
    "out = 'a' + os.sep + 'b'",
    "try:\n    out = 1\nfinally:\n    pass",
    "pass\nassert True\n'text'\nout = 1",
    "a = 1\ndel a\nout = 2",
    "out = list(map(lambda x: x + 1, [1, 2]))",
    "out = list(filter(None, [0, 1]))",
    "out = [x for x in [3, 1, 2]][::-1]",
    "out = ''.join(reversed('abc'))",
    "out = 'a-b'.partition('-')[0]",
    "out = 10 ** 3",
    "out = 7 & 3",
    "out = round(1.26, 1)",
    "out = 'ab' * 2",
    "out = [0.0] * 3",
    "first, *rest = [1, 2, 3]\nout = rest",
    "a = [1, 2, 3]\na[0:2] = [9]\nout = a",
    "out = []\nn = 0\nwhile n < 2:\n    out.append(n)\n    n += 1",
    "class Options:\n    rate = 5\nout = Options.rate",
    "try:\n    out = int('x')\nexcept ValueError:\n    out = 0",
    "with open(os.devnull) as file:\n    out = 1",
    "out = os.environ.get('BRINGUP_LINT_UNSET', 'fallback')",
    "command = 'a'\nmatch command:\n    case 'a':\n        out = 1\n    case name:\n        out = name",
    "out = f'{3.14159:.2f}'",
    "out = '{:03d}'.format(7)",
    "out = '%05.1f' % 2.25",
    "out = 1 if 'x' is None else 2",
    "out = {1: 'a'}[True]",
    "out = [1, 2, 3].index(2)",
    "out = {'a': {'b': [1, 2]}}",
    "x = [1, 2]\ndel x[0]\nout = x",
    "x = 5\ndef change():\n    global x\n    x = 6\nout = x",
]

FOLLOWED = 0.8
"""The least share of the programs whose value is known."""


@pytest.mark.parametrize("program", PROGRAMS)
def test_a_value_is_that_of_python_or_not_known(program: str) -> None:
    found = read(program)
    assert found is NOT_KNOWN or (found, type(found)) == (run(program), type(run(program)))


def test_most_values_are_known() -> None:
    unknown = [program for program in PROGRAMS if read(program) is NOT_KNOWN]
    assert len(unknown) <= len(PROGRAMS) * (1 - FOLLOWED), unknown
