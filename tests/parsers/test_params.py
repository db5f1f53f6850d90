"""The reader of parameter files: rcl's table, recovery, and values that know their place."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.discover.kinds import kind_of
from bringup_lint.model.params import matches
from bringup_lint.parsers.param_scalar import scalar
from bringup_lint.parsers.params import parse
from bringup_lint.source import Located
from bringup_lint.source import Source

PIECES = [
    "n:", "/**:", "  ros__parameters:", "    a: 1", "    b: [1, 2.0]", "    c: {}", "    d: {e: {f: 1}}",
    "  g: 2", "*x", "&x ", "<<: *x",
    "\n", "\n", "\n", "---\n", "\t", "- ", "{", "}", "[", "]", '"', "'", "#", "|\n", "? ", ": ", "é", "\0", "\ufeff",
]  # fmt: skip


def read(text: str):
    return parse(Source("config/robot.yaml", text))


@given(st.lists(st.sampled_from(PIECES), max_size=25).map("".join))
def test_nothing_raises_and_everything_lies_inside_the_text(text: str) -> None:
    file = read(text)
    spans = [each.span for block in file.blocks for each in (block, *block.parameters)]
    spans += [each.where.span if isinstance(each.where, Located) else each.where for each in file.problems]
    assert all(0 <= span.start <= span.end <= len(text) for span in spans)


def test_a_broken_entry_costs_only_itself() -> None:
    file = read("n:\n  ros__parameters:\n    a:\n    b: [1, x]\n    c: 3\n  d: 4\nm:\n  ros__parameters: {e: 5}\n")
    assert [problem.code for problem in file.problems] == ["no-value", "mixed-list", "value-before-parameters"]
    assert [(each.block.name, each.name) for each in file.parameters if each.value.data is not None] == [
        ("n", "c"),
        ("m", "e"),
    ]


def test_values_know_their_place() -> None:
    parameter = read("n:\n  ros__parameters:\n    g: {p: 'x y'}\n").parameters[0]
    assert (parameter.name, str(parameter.key), parameter.text) == ("g.p", "p", "'x y'")
    assert (parameter.key.line, parameter.span.column) == (3, 12)


@pytest.mark.parametrize(
    ("text", "style", "expected"),
    [
        ("010", "", ("integer", 8)),
        ("08", "", ("double", 8.0)),
        ("y", "", ("bool", True)),
        ("1e3", "", ("double", 1000.0)),
        ("1_000", "", ("string", "1_000")),
        ("null", "", ("string", "null")),
        ("5", "|", ("integer", 5)),
        ("5", "'", ("string", "5")),
        ("9223372036854775808", "", ("double", 9223372036854775808.0)),
    ],
)
def test_types_of_scalars(text: str, style: str, expected: tuple) -> None:
    assert scalar(text, style) == expected


def test_the_first_type_wins_over_the_last_value() -> None:
    file = read("n:\n  ros__parameters:\n    a: x\n    a: 1\n    a: 2.5\n")
    assert file.of_node("/n")["a"] == ("integer", 1)


def test_a_dotted_prefix_loses_one_part_too_few() -> None:
    names = [each.name for each in read("n:\n  ros__parameters:\n    x: {p.q: {r: 1}, s: 2}\n").parameters]
    assert names == ["x.p.q.r", "x.p.s"]


@pytest.mark.parametrize(
    ("key", "fqn", "expected"),
    [
        ("n", "/n", True),
        ("n", "/x/n", False),
        ("/*", "/n", True),
        ("*", "/x/n", False),
        ("/**/n", "/n", True),
        ("/**/n", "/x/y/n", True),
        ("/*/n", "/n", False),
        ("/**", "/x/n", True),
    ],
)
def test_node_keys(key: str, fqn: str, expected: bool) -> None:
    assert matches(key, fqn) is expected


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("config/a.yaml", "n:\n  ros__parameters:\n    a: 1\n", True),
        ("config/a.yml", "{n: {ros__parameters: {a: 1}}}\n", True),
        ("config/a.yaml", "n:\n  ros_parameters:\n    a: 1\n", True),
        ("config/a.yaml", "n:\n  parameters:\n    a: 1\n", False),
        ("config/a.yaml", "note: sets ros__parameters: of n\n", False),
        (".github/workflows/ci.yaml", "run: |\n  n:\n    ros__parameters:\n", False),
        ("docker-compose.yaml", "x:\n  ros__parameters:\n", False),
        ("config/a.txt", "n:\n  ros__parameters:\n    a: 1\n", False),
    ],
)
def test_only_parameter_files_are_claimed(path: str, text: str, expected: bool) -> None:
    assert (kind_of(path, lambda: text) == "params") is expected
