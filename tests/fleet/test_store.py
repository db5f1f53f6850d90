"""The store of summaries: what goes in comes out, in an order, and memory does not grow with the robots."""

from __future__ import annotations

import tracemalloc
from collections.abc import Iterable
from collections.abc import Iterator

import pytest

from bringup_lint.config import ConfigError
from bringup_lint.fleet import store as stores
from bringup_lint.fleet.fleet import Fleet
from bringup_lint.fleet.gather import stored
from bringup_lint.fleet.members import Member
from bringup_lint.fleet.store import BY_VALUE
from bringup_lint.fleet.summary import Fact
from bringup_lint.fleet.summary import Mark
from bringup_lint.fleet.summary import Own
from bringup_lint.fleet.summary import Summary


def fleet(*summaries: Summary) -> Fleet:
    names = sorted(summary.name for summary in summaries)
    return Fleet(stored((Member(name, ("/",)) for name in names), summaries))


def test_names_of_files_need_not_be_utf_8() -> None:
    fact = Fact("unit", "a\udcff.service", "there", "etc/\udcff/a.service", 3)
    own = Own("systemd/root-user", "warning", "\udcff", "\udcff", 1, 1, "0" * 32)
    mark = Mark("tls-key", "/etc/\udcff.key", "0" * 32, "\udcff", 1)
    made = fleet(Summary("b", "robot", own=(own,), facts=(fact,), marks=(mark,)), Summary("a", "robot", marks=(mark,)))
    assert [(stated.robot.name, stated.fact) for stated in made.stated("unit")] == [("b", fact)]
    assert [[(each.robot.name, each.mark) for each in group] for group in made.shared("tls-key")] == [
        [("a", mark), ("b", mark)]
    ]
    assert [(robot.name, robot.own) for robot in made.store] == [("a", ()), ("b", (own,))]


def test_what_robots_say_comes_in_the_order_of_their_names() -> None:
    summaries = [
        Summary(name, "robot", facts=(Fact("node", "", f"n{name}", "", 1), Fact("node", "", "x", "", 2)))
        for name in "cab"
    ]
    made = fleet(*summaries)
    assert [each.fact.value for each in made.stated("node")] == ["na", "x", "nb", "x", "nc", "x"]
    assert [[each.robot.name for each in group] for group in made.alike("node", BY_VALUE)] == [["a", "b", "c"]]
    assert [made.robots[1].one("node"), [fact.value for fact in made.robots[1].of("node")]] == [None, ["nb", "x"]]


def test_a_robot_that_says_several_things_is_not_among_those_that_say_the_usual() -> None:
    said = {"a": "x", "b": "x", "c": "x", "d": "xy"}
    summaries = [
        Summary(name, "robot", facts=tuple(Fact("setting", "k", value, "", at) for at, value in enumerate(values)))
        for name, values in said.items()
    ]
    made = fleet(*summaries)
    [(key, majority)] = made.majorities("setting", made.roles.values(), mixed=True)
    assert (key, [each.robot.name for each in majority.usual]) == ("k", ["a", "b", "c"])
    assert {value: [each.robot.name for each in group] for value, group in majority.others.items()} == {"y": ["d"]}


def many(robots: int) -> Iterator[Summary]:
    for number in range(robots):
        path = f"robots/rover-{number:05}/etc/systemd/system/rover.service"
        facts = tuple(Fact("setting", f"rover.service Key{at}", f"{at % 7}", path, at) for at in range(300))
        own = tuple(Own("systemd/root-user", "warning", "ROS runs as root", path, at, 1, "0" * 32) for at in range(20))
        yield Summary(f"rover-{number:05}", "rover", facts=facts, own=own)


def peak(summaries: Iterable[Summary], robots: int) -> int:
    """Bytes of Python's own memory at most, while summaries are gathered and judged."""
    members = [Member(f"rover-{number:05}", ("/",)) for number in range(robots)]
    tracemalloc.start()
    try:
        made = Fleet(stored(members, summaries))
        assert list(made.majorities("setting", made.roles.values())) == []
        assert sum(len(robot.own) for robot in made.store) == 20 * robots
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


@pytest.mark.slow
def test_memory_does_not_grow_with_what_robots_say() -> None:
    few, more = peak(many(20), 20), peak(many(220), 220)
    assert more - few < 200 * 2048


def test_a_full_folder_for_temporary_files_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = stores.opened

    def small() -> stores.Store:
        store = whole()
        store.database.execute("PRAGMA max_page_count = 20")
        return store

    monkeypatch.setattr("bringup_lint.fleet.gather.opened", small)
    with pytest.raises(ConfigError, match="do not fit into the folder for temporary files: database or disk is full"):
        stored([Member(f"rover-{number:05}", ("/",)) for number in range(20)], many(20))
