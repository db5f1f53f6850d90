"""Keys that edits add to YAML mappings."""

from __future__ import annotations

import pytest

from bringup_lint.finding import Edit
from bringup_lint.fix import rewritten
from bringup_lint.graph.yaml_edits import last_key
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.source import Source


@pytest.mark.parametrize(
    ("text", "after"),
    [
        ("a:\n  b: 1  # one\n\nc: 2\n", "a:\n  b: 1  # one\n  new: 0\n\nc: 2\n"),
        ("a:\n  b: 1", "a:\n  b: 1\n  new: 0"),
        ("a:\r\n  b: 1\r\nc: 2\r\n", "a:\r\n  b: 1\r\n  new: 0\r\nc: 2\r\n"),
        ("a:\n  b:\n    - 1\n    - 2\nc: 2\n", "a:\n  b:\n    - 1\n    - 2\n  new: 0\nc: 2\n"),
        ("a:\n  b: |\n    1\n\nc: 2\n", "a:\n  b: |\n    1\n  new: 0\n\nc: 2\n"),
        ("a: {b: 1}\n", "a: {new: 0, b: 1}\n"),
        ("x: &x 1\na:\n  b: *x\n", "x: &x 1\na:\n  new: 0\n  b: *x\n"),
        ("a:\n  b: 1\n  # c: 2\n", "a:\n  new: 0\n  b: 1\n  # c: 2\n"),
    ],
)
def test_last_key(text: str, after: str) -> None:
    root = parse(Source("a.yaml", text)).documents[0].root
    assert isinstance(root, Mapping)
    mapping = root.mapping("a")
    assert mapping is not None
    assert rewritten(text, [Edit(*last_key(mapping, "new: 0"))]) == after
