import ast

import pytest

from bringup_lint.parsers.newer_python import as_older
from bringup_lint.parsers.python_syntax import syntax_tree
from bringup_lint.source import Source

WRITTEN = {
    "f'a/{os.getenv('ROBOT')}.yaml'": "f'a/{os.getenv(\"ROBOT\")}.yaml'",
    'f"{d["k"]:>{w["n"]}} {{z}}"': "f\"{d['k']:>{w['n']}} {{z}}\"",
    "f'{', '.join(names)}'": "f'{\", \".join(names)}'",
    "f'{'\\n'.join(lines)}'": "f'{\"/n\".join(lines)}'",
    "rf'{f'{a}'}'": "rf'{f\"{a}\"}'",
    'f"""{d["k"]} "q" """': 'f"""{d["k"]} "q" """',
    "f'{a!r}' + 'b'  # it's": "f'{a!r}' + 'b'  # it's",
    "'{' + f'\\'{b}'": "'{' + f'\\'{b}'",
    "f'{(lambda: {1})()}'": "f'{(lambda: {1})()}'",
    "f'{a:#x} {', '.join(names)}'": "f'{a:#x} {\", \".join(names)}'",
    'f"{a:\'>{w}} {d["k"]}"': "f\"{a:'>{w}} {d['k']}\"",
}
BROKEN = ["f'{", "f'{'", "f'{\n'", "f'a\n{b}'", "f'{'a", "f'" + "{f'" * 20, "'\\", "f'{###", "f'{a:{#"]


@pytest.mark.parametrize(("new", "old"), WRITTEN.items())
def test_quotes(new: str, old: str) -> None:
    assert as_older(new) == old
    ast.parse(old)


@pytest.mark.parametrize("text", BROKEN)
def test_what_is_broken_keeps_its_length(text: str) -> None:
    assert len(as_older(text)) == len(text)


def test_quotes_of_a_comment_are_none() -> None:
    text = "f'''{a  # it's b\n} {d['k']}''' + f'{d['k']}'"
    assert as_older(text) == text[:-6] + '"k"' + text[-3:]


def test_a_file_of_a_newer_python_is_read() -> None:
    tree, _ = syntax_tree(Source("node.py", "x = f'a/{get('b')}'\ny = 1\n"))
    assert tree is not None
    assert len(tree.body) == 2


def test_other_mistakes_stay_mistakes() -> None:
    tree, problems = syntax_tree(Source("node.py", "x = f'a' b\n"))
    assert tree is None
    assert [each.code for each in problems] == ["syntax"]
