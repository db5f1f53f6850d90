"""What becomes of fixes after which a file could not be read."""

from __future__ import annotations

import pytest

from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.fix import MOST_HELD_BACK
from bringup_lint.fix import NOT_VALID
from bringup_lint.fix import planned
from bringup_lint.parsers.well_formed import is_well_formed
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


def keys(count: int) -> Source:
    return Source("a.yaml", "".join(f"key{number:02}: 1\n" for number in range(count)))


def test_only_the_fix_that_breaks_a_file_is_left_out() -> None:
    source = keys(5)
    wrong = finding(source, ("key02", "key04"))
    others = [finding(source, (name, f"new{name}")) for name in ("key00", "key01", "key03")]
    plan = planned([others[0], wrong, *others[1:]])
    assert plan.left == ((wrong, NOT_VALID),)
    assert [each for each, _ in plan.taken] == others
    assert plan.changes["a.yaml"].new_text() == "newkey00: 1\nnewkey01: 1\nkey02: 1\nnewkey03: 1\nkey04: 1\n"


def test_of_two_fixes_that_break_a_file_together_one_is_left_out() -> None:
    source = keys(3)
    one, other = (finding(source, (name, "key")) for name in ("key00", "key02"))
    plan = planned([one, other])
    assert [each for each, _ in plan.taken] == [one]
    assert plan.left == ((other, NOT_VALID),)


def test_a_fix_is_left_out_of_all_its_files() -> None:
    source, other = keys(2), Source("robot.service", "[Unit]\n")
    edits = (Edit(source.span(0, 5), "key01"), Edit(other.span(1, 5), "Service"))
    both = Finding("wrong", source.whole, "test/test", fix=Fix("write it", edits))
    plan = planned([finding(other, ("Unit", "Install")), both])
    assert list(plan.changes) == ["robot.service"]
    assert [why for _, why in plan.left] == ["another fix changes the same place"]
    plan = planned([both, finding(other, ("Unit", "Install"))])
    assert [why for _, why in plan.left] == [NOT_VALID]
    assert plan.changes["robot.service"].new_text() == "[Install]\n"


def test_a_file_that_many_fixes_break_is_left_alone() -> None:
    last = MOST_HELD_BACK + 2
    source = keys(last + 1)
    wrong = [finding(source, (f"key{number:02}", "key00")) for number in range(1, last)]
    good = finding(source, (f"key{last:02}", "key"))
    assert not planned([*wrong, good]).changes
    assert [each for each, _ in planned([*wrong[1:], good]).taken] == [good]


def test_a_file_is_read_a_bounded_number_of_times(monkeypatch: pytest.MonkeyPatch) -> None:
    source, read = keys(90), 0

    def counting(text: Source) -> bool:
        nonlocal read
        read += 1
        return is_well_formed(text)

    monkeypatch.setattr("bringup_lint.parsers.well_formed.is_well_formed", counting)
    planned(finding(source, (f"key{number:02}", "key00")) for number in range(1, 90))
    assert read <= (MOST_HELD_BACK + 1) * (len(source.text).bit_length() + 2)
