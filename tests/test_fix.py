"""What becomes of fixes after which a file could not be read."""

from __future__ import annotations

import pytest

from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.fix import NOT_VALID
from bringup_lint.fix import planned
from bringup_lint.source import Source


def finding(source: Source, *edits: tuple[str, str]) -> Finding:
    """One whose fix writes other words."""
    places = [(source.text.index(old), old, new) for old, new in edits]
    made = tuple(Edit(source.span(at, at + len(old)), new) for at, old, new in places)
    return Finding("wrong", source.whole, "test/test", fix=Fix("write it", made))


@pytest.mark.parametrize(
    ("name", "text", "old", "new"),
    [
        ("a.launch.py", "Node(name='a', node_name='b')\n", "node_name", "name"),
        ("a.py", "if a:\n    b()\n", "    b", "b"),
        ("a.launch.xml", '<launch><node name="a" type="b"/></launch>', "type", "name"),
        ("a.yaml", "a: 1\nb: 2\n", "b", "a"),
        ("a.yaml", "a: |\n  b\n", "  b", "  b\nc"),
        ("a.json", '{"a": 1}', "1", ""),
        ("a.toml", "a = 1\nb = 2\n", "b", "a"),
    ],
)
def test_a_file_that_could_not_be_read_afterwards_is_left_alone(name: str, text: str, old: str, new: str) -> None:
    source, other = Source(name, text), Source("robot.service", "[Unit]\n")
    good = finding(other, ("Unit", "Service"))
    plan = planned([finding(source, (old, new)), good])
    assert [why for _, why in plan.left] == [NOT_VALID]
    assert list(plan.changes) == ["robot.service"]


def test_a_fix_of_two_files_is_not_made_by_half() -> None:
    source, other = Source("a.json", "{}"), Source("robot.service", "[Unit]\n")
    edits = (Edit(source.span(0, 1), ""), Edit(other.span(1, 5), "Service"))
    both = Finding("wrong", source.whole, "test/test", fix=Fix("write it", edits))
    assert not planned([both]).changes


def test_a_file_that_could_not_be_read_before_is_fixed() -> None:
    source = Source("a.yaml", "a: [1\nb: yes\n")
    assert planned([finding(source, ("yes", "true"))]).changes
