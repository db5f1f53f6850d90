"""The reports of a fleet that programs and browsers read."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from bringup_lint.fleet.fleet import Difference
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.fleet import FleetPlace
from bringup_lint.fleet.render import rendered
from bringup_lint.fleet.summary import Own
from bringup_lint.fleet.summary import Summary
from bringup_lint.report.fleet import FleetReport
from bringup_lint.report.fleet import concise
from bringup_lint.report.fleet import render
from bringup_lint.report.fleet import sarif
from tests.conftest import PROJECT
from tests.lint import lint

DRIFT = PROJECT / "fixtures/fleet/drift/bad"


def report(robots: int, own: int = 0) -> FleetReport:
    finding = Own("systemd/root-user", "warning", "Runs as root", "a/rover.service", 3, 1, "0" * 32)
    summaries = tuple(Summary(f"rover-{number:04}", "rover", own=(finding,) * own) for number in range(robots))
    difference = Difference("key", "<usual>", ("rover-0000",), "<odd>", ("rover-0001",))
    place = FleetPlace("rover-0001", "b/60 dds.conf", 2)
    return FleetReport(summaries, (FleetFinding("Differs <b>", (place,), difference=difference, rule="fleet/drift"),))


def test_sarif_has_a_run_for_each_robot() -> None:
    run = lint("fleet", "--workers", "1", "--output-format", "sarif", ".", cwd=DRIFT)
    data = json.loads(run.stdout)
    ids = [each["automationDetails"]["id"] for each in data["runs"]]
    assert ids == [f"bringup-lint/fleet/{name}/" for name in ("alpha", "beta", "gamma")]
    fleet = [[each for each in run["results"] if each["ruleId"].startswith("fleet/")] for run in data["runs"]]
    assert [len(results) for results in fleet] == [0, 1, 3]


@pytest.mark.slow
def test_sarif_keeps_within_the_limits_of_its_readers() -> None:
    data = json.loads("".join(render("sarif", report(30, own=3000))))
    assert len(data["runs"]) == sarif.MOST_RUNS
    last = data["runs"][-1]
    assert len(last["results"]) == sarif.MOST_RESULTS
    assert "8000 results are left out" in last["invocations"][0]["toolExecutionNotifications"][0]["message"]["text"]


def test_sarif_locations_are_uris() -> None:
    data = json.loads("".join(render("sarif", report(2))))
    place = data["runs"][1]["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]
    assert place == {"uri": "b/60%20dds.conf"}


def test_the_page_shows_every_robot_and_both_sides() -> None:
    page = "".join(render("html", report(1000)))
    assert page.count("<th scope=row>") == 1000 + len(["rover"])
    assert "<pre class=usual>&lt;usual&gt;</pre>" in page
    assert "<pre class=odd>&lt;odd&gt;</pre>" in page
    assert "Differs &lt;b&gt;" in page
    assert "http" not in page.replace("http-equiv", "")


def test_the_page_is_written_to_a_file(tmp_path: Path) -> None:
    page = tmp_path / "fleet.html"
    run = lint("fleet", "--workers", "1", "--output-format", "html", "--output-file", page, ".", cwd=DRIFT)
    assert run.stdout == ""
    assert "net.core.rmem_max" in page.read_text("utf-8")


def test_what_cannot_be_rendered_costs_nothing_else() -> None:
    sound = report(2, own=1)
    broken = Own("systemd/root-user", "none of them", "Runs as root", "a/rover.service", 3, 1, "0" * 32)
    unlucky = dataclasses.replace(sound.robots[1], own=(broken,))
    found = rendered("sarif", dataclasses.replace(sound, robots=(sound.robots[0], unlucky)))
    failures = found.failures
    assert failures == ("rendering as sarif a finding of systemd/root-user failed: KeyError",)
    runs = json.loads("".join(found.pieces))["runs"]
    assert [[each["ruleId"] for each in run["results"]] for run in runs] == [["systemd/root-user"], ["fleet/drift"]]
    assert runs[0]["invocations"][0] == {
        "executionSuccessful": False,
        "toolExecutionNotifications": [{"level": "error", "message": {"text": failures[0]}}],
    }


def test_a_format_that_fails_as_a_whole_costs_no_other(monkeypatch: pytest.MonkeyPatch) -> None:
    own = concise.render

    def failing(report: FleetReport) -> Iterator[str]:
        yield from own(report)
        if report.findings and any(robot.own for robot in report.robots):
            raise KeyError("both")

    monkeypatch.setattr(concise, "render", failing)
    found = rendered("concise", report(2, own=1))
    assert "fleet/drift" in "".join(found.pieces)
    assert found.failures == ("rendering as concise failed: KeyError",)
    run = lint("fleet", "--workers", "1", "--output-format", "concise", ".", cwd=DRIFT)
    assert run.code == 3
    assert run.stderr == "bringup-lint: rendering as concise failed: KeyError\n"
