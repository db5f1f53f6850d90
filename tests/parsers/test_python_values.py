"""The evaluator of Python launch files against Python itself: the same value, or none."""

from __future__ import annotations

import textwrap

import pytest

from bringup_lint.model.launch import Node
from bringup_lint.model.launch import walk_actions
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Value
from bringup_lint.parsers.launch_python import parse
from bringup_lint.source import Source

HEAD = """\
import os
from pathlib import Path
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
{body}
    return LaunchDescription([Node(package='p', executable='e', parameters=[{{'x': x}}])])
"""
UNKNOWN = object()


def evaluated(body: str) -> object:
    """What the linter says that ``x`` is after these statements; UNKNOWN where it says nothing."""
    file = parse(Source("robot.launch.py", HEAD.format(body=textwrap.indent(body, "    "))))
    (node,) = [action for action in walk_actions(file.actions) if isinstance(action, Node)]
    (parameters,) = node.parameters
    assert isinstance(parameters, DictValue)
    return plain(parameters.get("x"))


def plain(value: Value | None) -> object:
    if isinstance(value, Literal):
        return str(value.value) if isinstance(value.value, str) else value.value
    if isinstance(value, ListValue) and not value.open:
        items = [plain(item) for item in value.items]
        return UNKNOWN if UNKNOWN in items else items
    if isinstance(value, DictValue) and not value.open:
        return {plain(key): plain(item) for key, item in value.items}
    return UNKNOWN


def real(body: str) -> object:
    names: dict[str, object] = {}
    exec(body, names)
    return as_list(names["x"])


def as_list(value: object) -> object:
    if isinstance(value, (list, tuple)):
        return [as_list(item) for item in value]
    return {key: as_list(item) for key, item in value.items()} if isinstance(value, dict) else value


EXPRESSIONS = """
'front' + '_' + 'lidar'
'%s_%s' % ('front', 'lidar')
'lidar%d' % 3
'%s' % 'lidar'
'{}_{}'.format('front', 2)
'{1}_{0}'.format('front', 'lidar')
'{side}_lidar'.format(side='front')
f'{1 + 1}_{"front"}'
'Front'.lower() + 'lidar'.upper() + 'arm'.capitalize() + 'left arm'.title() + ' x '.strip()
'a/b/c'.split('/')
'a b  c'.split()
'a/b/c'.rsplit('/')
'xxarmxx'.strip('x')
'xxarm'.lstrip('x')
'armxx'.rstrip('x')
'left_arm'.replace('left', 'right')
'left_arm'.startswith('left')
'left_arm'.endswith('left')
'_'.join(['left', 'arm'])
''.join([])
'-'.join(['a', str(1), 'c'])
'left_arm'[0]
'left_arm'[-3:]
'left_arm'[::2]
[1, 2, 3][1]
[1, 2, 3][-1]
[1, 2, 3][:2]
[1, 2, 3][::-1]
(1, 2)[True]
{'a': 1, 'b': 2}['b']
1 + 2 * 3 - 4
7 // 2
7 % 4
7 / 2
-3
+3
not 0
not ''
not [1]
1 < 2
2 <= 1
2 > 1
1 >= 1
1 == 1.0
'a' != 'b'
1 == 'a'
'a' in 'abc'
'a' not in 'abc'
'a' in ['a', 'b']
'c' in ['a', 'b']
'c' not in ['a', 'b']
'a' in {'a': 1}
'b' not in {'a': 1}
None is None
1 is not None
1 < 2 < 3
1 < 3 < 2
True is True
False is not True
1 if 2 > 1 else 3
1 if [] else 3
'' or 'b'
'a' and 'b'
0 or 5
str(5)
str(True)
int('5') + 1
float('2.5')
bool('')
bool([0])
bool({})
len([1, 2, 3])
len('four')
list(range(3))
list(range(1, 8, 3))
list(range(5, 0, -2))
[i for i in range(6) if i % 2]
[(i, c) for i, c in enumerate(['a', 'b'])]
[(i, c) for i, c in enumerate(['a', 'b'], 1)]
[a + b for a, b in zip(['a', 'b'], ['c', 'd'])]
list(reversed([1, 2, 3]))
sorted([3, 1, 2])
sorted(['b', 'a'])
[n.upper() for n in ('a', 'b')]
list(map(str, [1, 2]))
dict(a=1, b=2)
dict([('a', 1), ('b', 2)])
dict({'a': 1}, b=2)
{'a': 1} | {'b': 2}
{**{'a': 1}, 'b': 2}
{k: v for k, v in {'a': 1}.items()}
[*[1], 2]
[1] + [2, 3]
list({'a': 1, 'b': 2}.keys())
list({'a': 1, 'b': 2}.values())
{'a': 1}.get('a')
{'a': 1}.get('b', 5)
{'a': [1, 2]}['a'][0]
isinstance('a', str)
isinstance(1, str)
[[y for y in x] for x in [[1], [2, 3]]]
""".strip().splitlines()
BODIES = {
    "append": "x = []\nx.append(1)\nx.append(2)",
    "extend": "x = [1]\nx.extend([2, 3])",
    "insert": "x = [1, 3]\nx.insert(1, 2)",
    "remove": "x = ['a', 'b', 'c']\nx.remove('b')",
    "remove what is not known": "x = ['a', 'b']\nx.remove('a')\nx.append('c')",
    "reverse": "x = [1, 2, 3]\nx.reverse()",
    "pop": "y = [1, 2, 3]\nx = y.pop()",
    "pop the first": "y = [1, 2, 3]\nx = y.pop(0)",
    "copy of a list": "y = [1]\nx = y.copy()\ny.append(2)",
    "update": "x = {'a': 1}\nx.update({'b': 2})",
    "update by words": "x = {'a': 1}\nx.update(b=2)",
    "setdefault": "x = {'a': 1}\nx.setdefault('a', 2)\nx.setdefault('b', 3)",
    "pop of a dictionary": "y = {'a': 1}\nx = y.pop('a')",
    "copy of a dictionary": "y = {'a': 1}\nx = y.copy()\ny['b'] = 2",
    "item": "x = {}\nx['a'] = 1\nx['b'] = 2",
    "nested item": "x = {'a': {}}\nx['a']['b'] = 2",
    "added to": "x = 1\nx += 2",
    "text added to": "x = 'a'\nx += 'b'",
    "list added to": "x = [1]\nx += [2]",
    "unpacked": "a, b = 1, 2\nx = [b, a]",
    "unpacked with a rest": "a, *b = [1, 2, 3]\nx = b",
    "loop": "x = []\nfor i in range(3):\n    x.append(i * 2)",
    "loop with continue": "x = []\nfor i in range(4):\n    if i == 1:\n        continue\n    x.append(i)",
    "loop with break": "x = []\nfor i in range(4):\n    if i == 2:\n        break\n    x.append(i)",
    "function": "def double(n, by=2):\n    return n * by\nx = [double(2), double(2, by=3)]",
    "function with a rest": "def rest(*names):\n    return list(names)\nx = rest('a', 'b')",
    "function with words": "def words(**names):\n    return names\nx = words(a=1)",
    "lambda": "double = lambda n: n * 2\nx = double(4)",
    "if": "x = 1\nif x > 0:\n    x = 'more'\nelse:\n    x = 'less'",
    "elif": "y = 2\nif y == 1:\n    x = 'one'\nelif y == 2:\n    x = 'two'\nelse:\n    x = 'many'",
    "deleted item": "x = {'a': 1, 'b': 2}\ndel x['a']",
    "deleted item of a list": "x = [1, 2]\ndel x[0]",
    "walrus": "if (y := 5) > 3:\n    x = y",
    "with an assertion": "x = 1\nassert x == 1",
    "try": "try:\n    x = 1\nexcept KeyError:\n    x = 2",
    "while": "x = 3\nwhile x > 0:\n    x -= 1",
}


@pytest.mark.parametrize("expression", EXPRESSIONS)
def test_known_values_are_those_of_python(expression: str) -> None:
    body = f"x = {expression}"
    assert evaluated(body) == real(body)


@pytest.mark.parametrize("name", BODIES)
def test_statements_change_values_as_in_python(name: str) -> None:
    found = evaluated(BODIES[name])
    assert found is UNKNOWN or found == real(BODIES[name])


SILENT = """
'%d' % 'a'
'%s %s' % ('a',)
'%5d' % 3
'{:>5}'.format('a')
'{!r}'.format('a')
'{x}'.format('a')
'{'.format('a')
'a'.encode()
'a' * 3
'a' < 1
1 / 0
10 ** 30
~1
(1 << 70) + 1
[1, 2][5]
'ab'[5]
[1, 2]['a']
{'a': 1}['b']
[1, 2][0:2:0]
int('a')
float('a')
int('1', 16)
len(5)
range(0, 5, 0)
[].index(1)
[1].count(1)
os.environ['HOME']
os.path.expanduser('~/x')
open('x').read()
eval('1')
unheard_of()
isinstance(1, int)
repr('a')
{'a': 1}.popitem()
[1] + unheard_of()
'_'.join(unheard_of())
sorted([1, 'a'])[0] + unheard_of()
zip(unheard_of())
enumerate(unheard_of())
1 is 1
'a' in unheard_of()
""".strip().splitlines()


@pytest.mark.parametrize("expression", SILENT)
def test_what_is_not_known_is_not_guessed(expression: str) -> None:
    assert evaluated(f"x = {expression}") is UNKNOWN
