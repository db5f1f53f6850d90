"""What rules need to find anything: a rule is never left out that would find something."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from functools import reduce
from pathlib import Path
from typing import Any

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.registry import Registry
from bringup_lint.registry import load
from bringup_lint.robot import HOLDING_SYNTAX
from bringup_lint.robot import OF_SYNTAX
from bringup_lint.robot import Robot
from bringup_lint.rule_index.body import needs_of
from bringup_lint.rule_index.met import KINDS
from bringup_lint.rule_index.met import is_met
from bringup_lint.rule_index.needs import NEVER
from bringup_lint.rule_index.needs import NOTHING
from bringup_lint.rule_index.needs import Atom
from bringup_lint.rule_index.needs import Needs
from tests.conftest import PROJECT

RULE = '@rule("warning")\ndef example(robot):\n'
UNITS = "for unit in robot.units.judged:\n    "
JUDGED: Atom = ("some", ("units", "judged"))


def needs(body: str, more: str = "") -> Needs:
    indented = "".join(f"    {line}\n" for line in body.splitlines())
    return needs_of(f"{RULE}{indented}\n{more}")


def all_of(*atoms: Atom) -> Needs:
    return frozenset([frozenset(atoms)])


def any_of(*atoms: Atom) -> Needs:
    return frozenset(frozenset([atom]) for atom in atoms)


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("yield 1", NOTHING),
        ("return ()", NEVER),
        ("for unit in robot.units.judged:\n    yield unit", all_of(JUDGED)),
        ("yield from robot.sshd", all_of(("some", ("sshd",)))),
        ("units = robot.units\nfor unit in units.judged:\n    yield unit", all_of(JUDGED)),
        ("for each in robot.ros.of('A', 'B'):\n    yield each", all_of(("some", ("ros", ("of", "A", "B"))))),
        ("for each in robot.dds.of(NAME):\n    yield each", NOTHING),
        ("if not robot.of_kind('compose'):\n    return\nyield 1", all_of(("true", (("of_kind", "compose"),)))),
        (f"{UNITS}if unit.get('User'):\n        yield unit", all_of(JUDGED, ("key", "User"))),
        (
            "for unit in robot.units.judged:\n    user = unit.get('User')\n    if user is None:\n        continue\n"
            "    yield unit",
            all_of(JUDGED, ("key", "User")),
        ),
        ("for unit in robot.units.judged:\n    if not unit.get('User'):\n        yield unit", all_of(JUDGED)),
        (
            "for unit in robot.units.judged:\n    if unit.type != 'timer' or unit.fragment is None:\n"
            "        continue\n    yield unit",
            all_of(JUDGED, ("type", "timer")),
        ),
        (
            "for unit in robot.units.judged:\n    found = unit.get('User') if unit.has('A') else None\n"
            "    if found is None:\n        continue\n    yield unit",
            all_of(JUDGED, ("key", "A"), ("key", "User")),
        ),
        ("for unit in robot.units.running('bag'):\n    yield unit", all_of(("some", ("units", ("running", "bag"))))),
        (
            f"{UNITS}for key in ('A', 'B'):\n        for word in unit.words(key):\n            yield word",
            frozenset([frozenset([JUDGED, ("key", "A")]), frozenset([JUDGED, ("key", "B")])]),
        ),
        (f"{UNITS}for key in (NAME, 'B'):\n        yield from unit.words(key)", all_of(JUDGED)),
        (f"{UNITS}for key in 'A', 'B':\n        key = 'C'\n        yield from unit.words(key)", all_of(JUDGED)),
        ("for each in robot.ros.of(*NAMES):\n    yield each", all_of(("some", ("ros", "settings")))),
        (
            f"{UNITS}if robot.devices.meant_by(unit.name) is not None:\n        yield unit",
            all_of(JUDGED, ("true", (("of_kind", "udev-rules"),))),
        ),
        ("yield from (*robot.jails, *robot.sshd)", any_of(("some", ("jails",)), ("some", ("sshd",)))),
        ("for each in [robot]:\n    yield each", NOTHING),
        (
            f"{UNITS}first = next((each for each in unit.words('A') if each), None)\n    if first is None:\n"
            "        continue\n    yield first",
            all_of(JUDGED, ("key", "A")),
        ),
        (f"{UNITS}first = next(iter(unit.words('A')), 1)\n    if first is not None:\n        yield 1", all_of(JUDGED)),
        (
            "chosen = [unit for unit in robot.units.judged if unit.has('A')]\nfor unit in chosen:\n"
            "    if unit.has('B'):\n        yield unit",
            all_of(JUDGED, ("key", "A"), ("key", "B")),
        ),
        (
            "chosen = [unit for unit in robot.units.judged]\nchosen.append(1)\nfor unit in chosen:\n"
            "    if unit.has('B'):\n        yield unit",
            NOTHING,
        ),
        (
            f"{UNITS}one, other = unit.get('A'), unit.get('B')\n    if not one or not other:\n        continue\n"
            "    yield one",
            all_of(JUDGED, ("key", "A"), ("key", "B")),
        ),
        ("found = {each: 1 for each in robot.sshd}\nif 'x' in found:\n    yield 1", all_of(("some", ("sshd",)))),
        ("found = {each: 1 for each in robot.sshd}\nif 'x' not in found:\n    yield 1", NOTHING),
        ("found = [*robot.sshd]\nif found:\n    yield found[0]", all_of(("some", ("sshd",)))),
        (f"{UNITS}if memory(unit, 'A') is not None:\n        yield unit", all_of(JUDGED, ("key", "A"))),
        (f"{UNITS}yield from paths(other, 'A')", all_of(JUDGED)),
        (
            "for runner in robot.runners.all:\n    unit = runner.unit\n    if unit is None or not unit.has('A'):\n"
            "        continue\n    yield unit",
            all_of(("some", ("runners", "all")), ("key", "A")),
        ),
        (
            "for process in robot.ros.processes:\n    if process.environment.text('A') == '1':\n        yield 1",
            all_of(("some", ("ros", "processes")), ("true", (("may_hold", "A"),))),
        ),
        (
            "for process in robot.ros.processes:\n    environment = process.environment\n"
            "    for name in ('A', 'B'):\n        found = environment.get(name)\n"
            "        if found is not None:\n            yield found",
            all_of(("some", ("ros", "processes")), ("true", (("may_hold", "A", "B"),))),
        ),
        (
            "for process in robot.ros.processes:\n    if process.environment.text('A') not in (None, '1'):\n"
            "        continue\n    yield 1",
            all_of(("some", ("ros", "processes"))),
        ),
        ("if not robot.mentions(OTHER):\n    return\nyield 1", NOTHING),
        ("for unit in robot.units.judged:\n    pass\nelse:\n    yield 1", NOTHING),
        ("if [unit for unit in robot.units.judged if unit.has('A')]:\n    yield 1", all_of(JUDGED, ("key", "A"))),
        ("found = {}\n" + UNITS + "found.setdefault(1, unit)\nyield from found.values()", all_of(JUDGED)),
        ("found = []\nfill(found)\nfor each in found:\n    yield each", NOTHING),
        ("found = []\nother = found\nother.append(1)\nfor each in found:\n    yield each", NOTHING),
        ("found = list(robot.sshd)\nfound.append(1)\nfor each in found:\n    yield each", NOTHING),
        ("found = robot.sshd\nfound = [1]\nfor each in found:\n    yield each", NOTHING),
        ("for each in robot.sshd or [1]:\n    yield each", NOTHING),
        ("try:\n    first = robot.sshd[0]\nexcept IndexError:\n    yield 1", NOTHING),
        ("while robot.sshd:\n    yield 1", NOTHING),
    ],
)  # fmt: skip
def test_needs(body: str, expected: Needs) -> None:
    assert needs(body) == expected


def test_words_that_the_file_names() -> None:
    rule = needs(f"{UNITS}for key in KEYS:\n        yield from unit.words(key)", "KEYS = ('A',)\n")
    assert rule == all_of(JUDGED, ("key", "A"))


@pytest.mark.parametrize(
    ("pattern", "expected"),
    [
        ("regex(r'a|b', hints='a b')", all_of(("true", (("may_hold", "a", "b"),)))),
        ("regex(r'a', re.M, 'a')", all_of(("true", (("may_hold", "a"),)))),
        ("regex(r'a', re.M | re.I, 'a')", NOTHING),
        ("regex(r'a')", NOTHING),
        ("regex(r'a', hints=NAMES)", NOTHING),
    ],
)
def test_words_of_a_pattern(pattern: str, expected: Needs) -> None:
    assert needs("if not robot.mentions(SAID):\n    return\nyield 1", f"SAID = {pattern}\n") == expected


def test_words_that_a_call_is_given() -> None:
    body = "for each in robot.of_kind(*NAMES):\n    yield each"
    assert needs(body, "NAMES = ('a', 'b')\n") == all_of(("some", (("of_kind", "a", "b"),)))
    assert needs(f"NAMES = named()\n{body}", "NAMES = ('a', 'b')\n") == NOTHING


def test_own_functions_are_followed() -> None:
    body = "for each in _named(robot.units):\n    yield each"
    function = (
        "def _named(units):\n    for unit in units.judged:\n        if unit.has('User'):\n            yield unit\n"
    )
    assert needs(body, function) == all_of(JUDGED, ("key", "User"))


def test_what_an_own_function_gives_besides_none() -> None:
    body = "for unit in robot.units.judged:\n    found = _set(unit)\n    if found is not None:\n        yield found"
    function = "def _set(unit):\n    if unit.flag('A'):\n        return 'A', 1\n    return None\n"
    assert needs(body, function) == all_of(JUDGED, ("key", "A"))
    assert needs(body, function.replace("None", "1")) == all_of(JUDGED)


def test_a_list_that_another_function_returns_may_be_filled() -> None:
    body = "found = _all(robot)\nfound.append(1)\nfor each in found:\n    yield each"
    assert needs(body, "def _all(robot):\n    return robot.sshd\n") == NOTHING


@cache
def needs_of_file(path: Path) -> Needs:
    return needs_of(path.read_text("utf-8"))


def silent(robot: Robot) -> Iterator[tuple[str, Path]]:
    """The rules whose needs a robot does not meet."""
    registry = Registry.of()
    paths = registry.paths
    for rule_id in registry.ids_for(robot):
        path = paths[rule_id]
        if not is_met(needs_of_file(path), robot):
            yield rule_id, path


def check(top: Path, root: bool) -> None:
    robot = Robot(discover(["/"], root=str(top)) if root else discover([str(top)]))
    for rule_id, path in silent(robot):
        assert list(load(path, rule_id).check(robot)) == [], rule_id


@pytest.mark.slow
@pytest.mark.parametrize("root", [False, True])
@pytest.mark.parametrize("top", sorted((PROJECT / "fixtures/robots").glob("*/tree")), ids=lambda top: top.parent.name)
def test_no_rule_that_is_left_out_finds_anything(top: Path, root: bool) -> None:
    check(top, root)


@pytest.mark.parametrize("path", KINDS, ids=".".join)
def test_a_list_is_empty_without_the_kinds_of_its_files(path: tuple[str, ...]) -> None:
    for top in sorted((PROJECT / "fixtures/robots").glob("*/tree")):
        tree = discover([str(top)])
        robot = Robot(tree.without({source.name for source in tree.sources if source.kind in KINDS[path]}))
        found: Any = reduce(getattr, path, robot)
        assert list(found("docker") if callable(found) else found) == []


def test_what_is_named_apart_from_robot_is_asked_of_it() -> None:
    named = {*OF_SYNTAX, *HOLDING_SYNTAX, *(path[0] for path in KINDS)}
    assert {name for name in named if not hasattr(Robot, name)} == set()


@pytest.mark.campaign
@pytest.mark.parametrize("family", sorted((PROJECT / "rules").glob("[a-z]*")), ids=lambda family: family.name)
def test_no_rule_that_is_left_out_finds_anything_in_fixtures(family: Path) -> None:
    for top in sorted((PROJECT / "fixtures" / family.name).glob("*/*/")):
        check(top, root=(top / "etc").is_dir())


def test_no_rule_finds_anything_in_an_empty_tree(tmp_path: Path) -> None:
    robot = Robot(discover([str(tmp_path)]))
    paths = {
        rule_id: path for rule_id, path in Registry.of().paths.items() if not rule_id.startswith(("fleet/", "live/"))
    }
    assert [rule_id for rule_id, path in paths.items() if list(load(path, rule_id).check(robot))] == []
