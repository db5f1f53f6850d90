"""Real configuration, judged by hand: what was marked as wrong is found, clean files stay quiet."""

from __future__ import annotations

import csv
import json
from collections import Counter
from functools import cache
from pathlib import Path
from typing import Any
from typing import NamedTuple

import pytest

from bringup_lint.toml import read_toml
from tests.conftest import PROJECT
from tests.lint import lint

pytestmark = pytest.mark.corpus

EXCEPTIONS = read_toml((PROJECT / "tests/rules/labels_exceptions.toml").read_text("utf-8"))["exception"]
"""Labels that bringup-lint does not follow, each with its reason."""


class Found(NamedTuple):
    path: str
    line: int
    rule: str
    severity: str
    places: frozenset[tuple[str, int]]
    """Where it is, and the related places: one cause is one finding."""


@cache
def findings(folder: Path) -> list[Found]:
    run = lint("--min-severity", "info", "--output-format", "json", ".", cwd=folder)
    assert run.code in (0, 1), run.stderr
    return [_found(item) for item in json.loads(run.stdout)["findings"]]


def _found(item: dict[str, Any]) -> Found:
    places = [item["location"], *(each["location"] for each in item["related"])]
    lines = [(place["path"], place["start"]["line"]) for place in places]
    return Found(*lines[0], item["rule"], item["severity"], frozenset(lines))


def labels(corpus: Path, kind: str) -> list[dict[str, str]]:
    """The labels of a kind, on files that are there."""
    with (corpus / "labels.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return [row for row in rows if row["kind"] == kind and (corpus / row["repo"] / row["file"]).is_file()]


def is_exception(row: dict[str, str]) -> bool:
    return any(all(row[key] == str(each[key]) for key in ("repo", "file", "line")) for each in EXCEPTIONS)


def at(corpus: Path, row: dict[str, str]) -> list[Found]:
    """What is found at the line of a label, or names it as a place of the same cause."""
    here = (row["file"], int(row["line"]))
    return [found for found in findings(corpus / row["repo"]) if here in found.places]


def test_every_labelled_defect_is_found(corpus: Path) -> None:
    wanted = [row for row in labels(corpus, "true anti-pattern") if not is_exception(row)]
    assert len(wanted) > 45
    assert [row for row in wanted if not at(corpus, row)] == []


def test_clean_files_are_quiet(corpus: Path) -> None:
    clean = [row for row in labels(corpus, "clean") if not is_exception(row)]
    noise = [
        found
        for row in clean
        for found in findings(corpus / row["repo"])
        if found.path == row["file"] and found.severity != "info"
    ]
    assert len(clean) > 40
    assert noise == []


def test_exceptions_are_still_needed(corpus: Path) -> None:
    defects = [row for row in labels(corpus, "true anti-pattern") if is_exception(row)]
    assert len(defects) == len(EXCEPTIONS)
    assert [row for row in defects if at(corpus, row)] == []


def test_the_rules_of_systemd_are_quiet(corpus: Path) -> None:
    found = findings(corpus / "systemd__systemd-stable")
    assert [each for each in found if each.path.startswith("rules.d/") and each.severity != "info"] == []


def test_counts_for_each_family(corpus: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Prints how much of what was labelled is found, by the family of the rules that find it."""
    wanted = labels(corpus, "true anti-pattern")
    families = ({found.rule.partition("/")[0] for found in at(corpus, row)} for row in wanted)
    by_family = Counter(family for each in families for family in each)
    found = sum(bool(at(corpus, row)) for row in wanted)
    with capsys.disabled():
        each = ", ".join(f"{family} {count}" for family, count in sorted(by_family.items()))
        print(f"\nlabelled defects: {found} of {len(wanted)} found; by family: {each}")
    assert found + len(EXCEPTIONS) >= len(wanted)
