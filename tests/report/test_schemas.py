"""What reports as data promise to their readers."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest

from bringup_lint.dataclass import replace
from bringup_lint.report import Report
from bringup_lint.report import render
from bringup_lint.report.model import Notification
from tests.conftest import PROJECT
from tests.report.sample import FINDINGS
from tests.report.sample import clean
from tests.report.sample import sample

SCHEMA = json.loads((PROJECT / "bringup_lint/report/json.schema.json").read_text("utf-8"))
REPORTS = {"sample": sample(), "clean": clean(), "bare": Report()}


@pytest.mark.parametrize("name", REPORTS)
def test_json_follows_its_schema(name: str) -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    jsonschema.validate(json.loads(render("json", REPORTS[name])), SCHEMA)


def test_json_offsets_and_lines_agree() -> None:
    report = sample()
    data = json.loads(render("json", report))
    texts = {finding.source.name: finding.source.text for finding in report.findings}
    for finding in data["findings"]:
        start, end = finding["location"]["start"], finding["location"]["end"]
        text = texts[finding["location"]["path"]]
        before = text[: start["offset"]].split("\n")
        assert (start["line"], start["column"]) == (len(before), len(before[-1]) + 1)
        assert start["offset"] <= end["offset"] <= len(text)


def test_sarif_refers_to_what_it_holds() -> None:
    (run,) = json.loads(render("sarif", sample()))["runs"]
    rules = run["tool"]["driver"]["rules"]
    assert [rule["id"] for rule in rules] == sorted({finding.rule for finding in FINDINGS})
    for result in run["results"]:
        assert rules[result["ruleIndex"]]["id"] == result["ruleId"]
    for location in _objects(run, "artifactLocation"):
        assert run["artifacts"][location["index"]]["location"] == location
    (taxon,) = run["taxonomies"][0]["taxa"]
    assert taxon["id"] == "CWE-250"


def test_sarif_documents_what_a_notification_names() -> None:
    told = Notification("error", "it failed inside", rule="systemd/network-target")
    (run,) = json.loads(render("sarif", replace(clean(), notifications=(told,))))["runs"]
    assert [rule["id"] for rule in run["tool"]["driver"]["rules"]] == ["systemd/network-target"]
    assert run["invocations"][0]["toolExecutionNotifications"][0]["associatedRule"]["index"] == 0


def test_sarif_says_who_is_outside_the_root() -> None:
    (run,) = json.loads(render("sarif", sample()))["runs"]
    outside = [at["location"]["uri"] for at in run["artifacts"] if "uriBaseId" not in at["location"]]
    assert outside == ["file:///srv/image/99-mower.rules"]
    assert {"uri": "etc/netplan/10%20mower.yaml", "uriBaseId": "%SRCROOT%", "index": 1} in [
        at["location"] for at in run["artifacts"]
    ]


def test_sarif_is_complete_without_findings(tmp_path: Path) -> None:
    (run,) = json.loads(render("sarif", clean()))["runs"]
    assert run["results"] == []
    assert run["tool"]["driver"]["rules"] == []
    assert run["invocations"][0]["executionSuccessful"] is True


def test_sarif_times_can_be_fixed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    (run,) = json.loads(render("sarif", sample()))["runs"]
    assert run["invocations"][0]["startTimeUtc"] == "2023-11-14T22:13:20.000Z"
    assert render("sarif", sample(started=1.0, ended=2.0)) == render("sarif", sample(started=5.0, ended=6.0))


def _objects(data: object, key: str) -> list[dict]:
    if isinstance(data, dict):
        own = [data[key]] if key in data else []
        return own + [found for value in data.values() for found in _objects(value, key)]
    return [found for item in data for found in _objects(item, key)] if isinstance(data, list) else []
