"""Two rules on one place: each such pair is reasoned in ``pairs.toml``, so that no two say the same or the opposite.

Every rule is run over every bad fixture. What two different rules mark as errors or warnings, from the same start to
the same end, is a pair. In the ledger of public robots, which holds no columns, two findings of one line are one.
"""

from __future__ import annotations

import csv
import json
from collections import defaultdict
from collections.abc import Iterator
from itertools import combinations
from pathlib import Path
from typing import NamedTuple

import pytest

from bringup_lint.toml import read_toml
from tests.conftest import PROJECT
from tests.lint import lint
from tests.rules.test_fixtures import FIXTURES
from tests.rules.test_fixtures import arguments
from tests.rules.test_fixtures import cases
from tests.rules.test_fixtures import set_modes

TABLE = Path(__file__).parent / "pairs.toml"
LEDGER = PROJECT / "benchmarks" / "ecosystem" / "ledger.tsv"
BAD = [case for rule, case in cases("bad") if not rule.startswith("live/")]


class Pair(NamedTuple):
    first: str
    second: str


def table(kind: str) -> dict[Pair, dict[str, str]]:
    """The reasoned pairs: ``pair`` of the fixtures, ``line`` of the ledger."""
    entries = read_toml(TABLE.read_text("utf-8"))[kind]
    return {Pair(*sorted(entry["rules"])): entry for entry in entries}


def pairs_of(case: Path) -> set[Pair]:
    """The pairs of rules that mark the same span of a file in a bad fixture."""
    set_modes(case)
    run = lint("--isolated", "--exit-zero", "--output-format", "json", *arguments(case), cwd=case)
    places = defaultdict(set)
    for found in json.loads(run.stdout)["findings"]:
        place = found["location"]
        if found["severity"] != "info":
            span = (place["path"], *place["start"].values(), *place["end"].values())
            places[span].add(found["rule"])
    return {pair for rules in places.values() for pair in couples(rules)}


def couples(rules: set[str]) -> Iterator[Pair]:
    return (Pair(*pair) for pair in combinations(sorted(rules), 2))


@pytest.mark.slow
@pytest.mark.parametrize("family", sorted({case.parts[-3] for case in BAD}))
def test_pairs_on_one_span_are_reasoned(family: str) -> None:
    known = table("pair")
    found = {pair: case for case in BAD if case.parts[-3] == family for pair in pairs_of(case)}
    new = {pair: str(case.relative_to(FIXTURES)) for pair, case in found.items() if pair not in known}
    assert new == {}, "merge the two rules, or say in pairs.toml why both are needed"


@pytest.mark.parametrize("pair", table("pair"), ids="+".join)
def test_reasoned_pairs_exist(pair: Pair) -> None:
    entry = table("pair")[pair]
    assert pair in pairs_of(FIXTURES / entry["fixture"])
    assert len(entry["reason"]) > 10


def test_pairs_on_one_line_of_a_robot_are_reasoned() -> None:
    lines = [line for line in LEDGER.read_text("utf-8").splitlines() if not line.startswith("#")]
    places = defaultdict(set)
    for row in csv.DictReader(lines, delimiter="\t", quoting=csv.QUOTE_NONE):
        places[row["repository"], row["path"], row["line"]].add(row["rule"])
    found = {pair: place for place, rules in places.items() for pair in couples(rules)}
    known = {*table("pair"), *table("line")}
    assert {pair: place for pair, place in found.items() if pair not in known} == {}
