"""The end of a text report, the table of its rules, and the order of a long one."""

from __future__ import annotations

import re
from dataclasses import replace

from bringup_lint.finding import Applicability
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Severity
from bringup_lint.report import Part
from bringup_lint.report import Report
from bringup_lint.report import render
from bringup_lint.report.order import by_cause
from bringup_lint.report.paint import painter
from bringup_lint.report.summary import by_rule
from bringup_lint.source import Source

UNIT = Source("etc/systemd/system/a.service", "[Service]\nUser=root\n" * 20, "systemd-unit")
RULES = Source("etc/udev/rules.d/a.rules", "A\n" * 20, "udev-rules")
PLAIN = painter(False)
KINDS = {"systemd-unit": 2, "udev-rules": 1}


def finding(rule: str, severity: Severity, source: Source = UNIT, line: int = 0, fix: str = "") -> Finding:
    span = source.span(source.line_starts[line], source.line_starts[line] + 1)
    written = Fix("write it", (Edit(span, "x"),), Applicability(fix)) if fix else None
    return Finding(f"{rule} in line {line}", span, rule, severity, advice="write something else", fix=written)


MANY = [
    *(finding("udev/b", Severity.ERROR, RULES, line) for line in range(12)),
    *(finding("systemd/z", Severity.WARNING, UNIT, line, "safe") for line in range(9)),
    finding("systemd/a", Severity.ERROR, UNIT, 3, "unsafe"),
    finding("systemd/a", Severity.WARNING, UNIT, 1, "safe"),
]


def test_table_begins_with_the_worst() -> None:
    assert list(by_rule(MANY, PLAIN)) == [
        "findings  severity  fixable           rule",
        "      12  error                       udev/b",
        "       2  error     1 safe, 1 unsafe  systemd/a",
        "       9  warning   9 safe            systemd/z",
        "",
    ]


def test_table_has_the_colours_of_the_severities() -> None:
    head, first, *_ = by_rule(MANY, painter(True))
    assert head.startswith("\x1b[2mfindings") and head.endswith("rule\x1b[0m")
    assert "\x1b[1;91merror   \x1b[0m" in first


def test_table_counts_what_it_leaves_out() -> None:
    assert list(by_rule(MANY, PLAIN, 1))[2:] == ["      11                     of 2 more rules", ""]
    assert list(by_rule(MANY, PLAIN, 2))[3:] == ["       9                              of 1 more rule", ""]


def test_a_report_of_few_findings_has_no_table() -> None:
    report = Report(tuple(MANY[:3]), kinds=KINDS)
    assert "fixable" not in render("text", report)
    assert render("text", report).endswith("\n\n3 errors in 1 of 3 files\n")


def test_a_long_report_ends_with_its_rules_and_what_can_be_fixed() -> None:
    text = render("text", Report(tuple(MANY), kinds=KINDS))
    assert text.endswith(
        "systemd/z\n\n13 errors, 10 warnings in 2 of 3 files\n"
        "10 fixable with --fix · 1 more fixable with --fix --unsafe-fixes\n"
    )


def test_parts_of_a_report() -> None:
    report = Report(tuple(MANY[:2]), kinds=KINDS)
    statistics = render("text", replace(report, part=Part.STATISTICS))
    assert statistics.startswith("findings  severity  fixable  rule\n       2  error              udev/b\n\n2 errors")
    findings = render("text", replace(report, part=Part.FINDINGS))
    assert render("text", report).startswith(findings)
    assert findings.endswith("explain udev/b\n")
    assert render("text", Report(part=Part.FINDINGS)) == ""


def test_errors_on_what_starts_at_boot_come_first() -> None:
    groups = [group[0].rule for group in by_cause(MANY, frozenset({UNIT.name}))]
    assert groups == ["systemd/a", "udev/b", "systemd/z"]
    assert [group[0].rule for group in by_cause(MANY, frozenset())] == ["udev/b", "systemd/a", "systemd/z"]


def test_a_group_begins_with_its_worst() -> None:
    (group,) = by_cause(MANY[-1:] + MANY[-2:-1], frozenset())
    assert [found.severity for found in group] == [Severity.ERROR, Severity.WARNING]


def test_a_long_report_says_once_what_is_the_same() -> None:
    text = render("text", Report(tuple(MANY), kinds=KINDS))
    assert text.count("explain udev/b") == 1
    assert text.count("help: write something else") == 3
    assert text.count("error[udev/b]: udev/b in line") == 12
    assert text.index("[udev/b]") < text.index("[systemd/a]") < text.index("[systemd/z]")


def test_a_long_page_begins_with_what_starts_at_boot_in_each_severity() -> None:
    early = [finding("can/e", Severity.ERROR, RULES, line) for line in range(3)]
    findings = (*early, *MANY[:9], *MANY[12:])
    page = render("html", Report(findings=findings, kinds=KINDS, at_boot=frozenset({UNIT.name})))
    assert re.findall(r'data-severity="(\w+)" data-family="\w+" data-rule="([\w/]+)"', page) == [
        ("error", "systemd/a"),
        *[("error", "udev/b")] * 9,
        *[("error", "can/e")] * 3,
        *[("warning", "systemd/z")] * 9,
        ("warning", "systemd/a"),
    ]
    assert re.findall(r'id="finding-(\d+)"', page)[:2] == ["21", "3"]
