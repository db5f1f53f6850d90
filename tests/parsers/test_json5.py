"""JSON5 is told from what is none."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.parsers.json5 import fault
from bringup_lint.source import Source


@pytest.mark.parametrize(
    "text",
    [
        "{}",
        "[1, 2,]",
        "{a: 1, 'b': \"x\", $c: +.5, d: [Infinity, -NaN, 0xFf,], /* x */ e: null} // end",
        "{\n  mode: 'peer',\n  listen: { endpoints: { peer: ['tcp/[::]:0'] } },\n}\n",
        "'two\\\nlines'",
        "true",
        "\ufeff{ünï: 1e5}",
    ],
)
def test_good(text: str) -> None:
    assert fault(Source("x.json5", text)) is None


@pytest.mark.parametrize(
    ("text", "offset", "detail"),
    [
        ("", 0, "a value is expected"),
        ("{a: 1 b: 2}", 6, "'{' of line 1 wants ',' or '}'"),
        ("{a: tcp/1}", 4, "a value is expected"),
        ("{a 1}", 3, "':' is expected"),
        ("{1: 2}", 1, "a key is expected"),
        ("[1,,2]", 3, "a value is expected"),
        ("{a: 'x}", 4, "a value is expected"),
        ("{} {}", 3, "something follows the value"),
        ("{a: [1}", 6, "'[' of line 1 wants ',' or ']'"),
        ("{a: 01}", 4, "a value is expected"),
        ("/* {}", 0, "a value is expected"),
    ],
)
def test_bad(text: str, offset: int, detail: str) -> None:
    problem = fault(Source("x.json5", text))
    assert (problem.where.start, problem.detail) == (offset, detail)


SCALARS = st.none() | st.booleans() | st.floats() | st.text()


@given(st.recursive(SCALARS, lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner)))
def test_all_json_is_json5(value: object) -> None:
    assert fault(Source("x.json", json.dumps(value))) is None


@given(st.text(alphabet="{}[],:'\"ab1 \n/*\\", max_size=60))
def test_no_text_makes_it_fail(text: str) -> None:
    problem = fault(Source("x.json5", text))
    if problem is not None:
        assert 0 <= problem.where.start <= problem.where.end <= len(text)
    try:
        json.loads(text)
    except ValueError:
        return
    assert problem is None


def test_deep_and_long_texts_cost_no_stack() -> None:
    assert fault(Source("x.json5", "[" * 200_000 + "]" * 200_000)) is None
    assert fault(Source("x.json5", "{a:" * 100_000)) is not None
