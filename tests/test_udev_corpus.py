"""udev rules of real robots: what people marked as wrong is found, what they marked as clean stays quiet."""

from __future__ import annotations

import csv
import json
from functools import cache
from pathlib import Path

import pytest

from tests.lint import lint

pytestmark = pytest.mark.corpus


@cache
def findings(folder: Path) -> list[tuple[str, int, str]]:
    """File, line and rule of every error and warning about udev rules and device paths."""
    run = lint("--select", "udev,device", "--output-format", "json", ".", cwd=folder)
    assert run.code in (0, 1), run.stderr
    found = [(item["location"], item["rule"]) for item in json.loads(run.stdout)["findings"]]
    return [(place["path"], place["start"]["line"], rule) for place, rule in found]


def labels(corpus: Path) -> list[dict[str, str]]:
    """The labels on udev rules, and those on device paths in files that the device family reads."""
    with (corpus / "labels.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    devices = ("hardcoded /dev/", "hardcoded dev-", "SERIAL_PORT=/dev/")
    return [
        row
        for row in rows
        if row["file"].endswith(".rules")
        or (any(words in row["problem"] for words in devices) and not row["file"].endswith(".yaml"))
    ]


def test_every_labelled_defect_is_found(corpus: Path) -> None:
    wanted = [row for row in labels(corpus) if row["kind"] == "true anti-pattern"]
    assert len(wanted) > 15
    for row in wanted:
        found = findings(corpus / row["repo"])
        assert any((path, line) == (row["file"], int(row["line"])) for path, line, _ in found), row


def test_clean_files_are_quiet(corpus: Path) -> None:
    for row in labels(corpus):
        if row["kind"] == "clean":
            found = findings(corpus / row["repo"])
            assert not [item for item in found if item[0] == row["file"]], row


def test_the_rules_of_systemd_are_quiet(corpus: Path) -> None:
    assert findings(corpus / "systemd__systemd-stable") == []
