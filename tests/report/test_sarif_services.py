"""What code scanning services read of SARIF beyond the standard."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.finding import Suppression
from bringup_lint.report import Report
from bringup_lint.report import render
from bringup_lint.report.sarif.line_hash import line_hash
from bringup_lint.report.sarif.run import MOST
from bringup_lint.source import Source
from tests.lint import lint
from tests.report.sample import sample

HASHES = {
    "Hello World\n": ["1b80bc49a5e600dd:1", "c129715d7a2bc9a3:1"],
    "x": ["638816509450efbf:1"],
    "\n": ["3c5bef55b72b93c9:1", "c129715d7a2bc9a3:1"],
    "é😀 z\n" * 40: ["d798c710b8171068:1", "d798c710b8171068:2"],
    "[Unit]\nAfter=network.target\n" * 60: ["80953b81c973c55a:1", "210137f5a86165e2:1", "80953b81c973c55a:2"],
    "a\n\n\n b\tc\r\nd\re\r \nf": [
        *("331149ca17bc067e:1", "fdaf1e459cdae2f:1", "5284cffafb999a61:1", "f511e9405e12bd9b:1"),
        *("d205a5179fdac394:1", "8998c0a51cabb2d6:1", "b9cf1fc32cf7373:1", "b58ed36d58db1d35:1"),
    ],
}
"""What the code of upload-sarif prints for these files, run once with node."""


@pytest.mark.parametrize("text", HASHES, ids=[str(number) for number in range(len(HASHES))])
def test_lines_hash_as_upload_sarif_hashes_them(text: str) -> None:
    source = Source("a", text)
    assert [line_hash(source, line) for line in range(1, len(HASHES[text]) + 1)] == HASHES[text]


@pytest.mark.parametrize(
    "source",
    [Source("a", "x", masked=True), Source("<graph>", "x", virtual=True), Source("a", ""), Source("a", "\ufffd")],
)
def test_what_is_not_in_the_file_is_not_hashed(source: Source) -> None:
    assert line_hash(source, 1) is None


def test_rules_of_security_have_a_score() -> None:
    (run,) = json.loads(render("sarif", sample()))["runs"]
    rules = {rule["id"]: rule["properties"] for rule in run["tool"]["driver"]["rules"]}
    assert rules["systemd/root-user"]["security-severity"] == "8.0"
    assert [name for name, each in rules.items() if ("security" in each["tags"]) != ("security-severity" in each)] == []


def test_a_run_holds_no_more_than_services_show() -> None:
    """The worst are kept, in their order, and the report says that others are not."""
    source = Source("a.service", "\n" * (MOST + 10), "systemd-unit")
    found = [Finding(f"m {at}", source.span(at, at + 1), "systemd/x", Severity.WARNING) for at in range(MOST + 8)]
    found.append(Finding("m", source.span(MOST + 8, MOST + 9), "systemd/x", Severity.ERROR))
    found.insert(0, Finding("s", source.whole, "systemd/x", suppression=Suppression(source.whole, "known")))
    (run,) = json.loads(render("sarif", Report(tuple(found))))["runs"]
    assert len(run["results"]) == MOST
    assert run["results"][-1]["level"] == "error"
    assert run["results"][0]["message"]["text"] == "M 0."
    (told,) = run["invocations"][0]["toolExecutionNotifications"]
    assert told["level"] == "warning" and "10 results are left out" in told["message"]["text"]


@pytest.mark.parametrize(("options", "code"), [((), 1), (("--exit-zero",), 0)])
def test_the_exit_code_is_that_of_the_process(tmp_path: Path, options: tuple[str, ...], code: int) -> None:
    (tmp_path / "a.service").write_text("[Service]\nExecStart=relative\nUser\n")
    run = lint("--isolated", *options, "--output-format", "sarif", ".", cwd=tmp_path)
    assert run.code == code
    assert json.loads(run.stdout)["runs"][0]["invocations"][0]["exitCode"] == code
