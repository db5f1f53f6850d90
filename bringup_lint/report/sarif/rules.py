"""Rules as SARIF descriptors, and the CWE taxonomy that they refer to."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from bringup_lint.finding import Confidence
from bringup_lint.finding import Severity
from bringup_lint.report.docs import finds
from bringup_lint.report.docs import markdown
from bringup_lint.report.docs import plain
from bringup_lint.report.model import Report
from bringup_lint.report.model import RuleDoc

DEFINITION = "https://cwe.mitre.org/data/definitions/{}.html"
LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}
_PROBLEMS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "recommendation"}
SECURITY_SEVERITIES = {Severity.ERROR: "8.0", Severity.WARNING: "5.5", Severity.INFO: "2.0"}
"""Of rules that are tagged ``security``: high, medium and low to GitHub and Azure DevOps, by the scale of CVSS."""
_PRECISION = {Confidence.HIGH: "high", Confidence.MEDIUM: "medium"}


def documented(report: Report) -> list[RuleDoc]:
    """The rules that results and notifications name, by id; a run of all rules would carry a megabyte of text."""
    named = {finding.rule: finding.severity for finding in report.findings}
    rules = [report.rules.get(rule_id) or _undocumented(rule_id, severity) for rule_id, severity in named.items()]
    told = {told.rule for told in report.notifications} - set(named)
    return sorted([*rules, *(report.rules[rule_id] for rule_id in told & set(report.rules))], key=lambda rule: rule.id)


def _undocumented(rule_id: str, severity: Severity) -> RuleDoc:
    return RuleDoc(rule_id, rule_id.rpartition("/")[2].replace("-", " ").capitalize(), severity)


def descriptor(rule: RuleDoc, taxonomy: dict[str, Any] | None) -> dict[str, Any]:
    """A SARIF ``reportingDescriptor``."""
    cwes = [tag for tag in rule.tags if tag.startswith("CWE-")]
    tags = _tags(rule)
    made: dict[str, Any] = {
        "id": rule.id,
        "name": "".join(word.capitalize() for word in rule.id.replace("/", "-").split("-")),
        "shortDescription": {"text": _sentence(rule.title)},
        "fullDescription": {"text": _sentence(finds(rule))},
        "help": {"text": plain(rule), "markdown": markdown(rule)},
        "defaultConfiguration": {"level": LEVELS[rule.severity]},
        "properties": {
            "tags": [rule.id.partition("/")[0], *tags],
            "precision": _PRECISION[rule.confidence],
            "problem.severity": _PROBLEMS[rule.severity],
        },
    }
    if "security" in tags:
        made["properties"]["security-severity"] = SECURITY_SEVERITIES[rule.severity]
    if rule.uri:
        made["helpUri"] = rule.uri
    if rule.aliases:
        made["deprecatedIds"] = list(rule.aliases)
    if taxonomy and cwes:
        made["relationships"] = [_relationship(taxonomy, cwe) for cwe in cwes]
    return made


def cwe_taxonomy(rules: Iterable[RuleDoc]) -> dict[str, Any] | None:
    """The part of the Common Weakness Enumeration that the rules refer to; None when they refer to none."""
    cwes = sorted({tag for rule in rules for tag in rule.tags if tag.startswith("CWE-")}, key=_number)
    if not cwes:
        return None
    return {
        "name": "CWE",
        "fullName": "Common Weakness Enumeration",
        "organization": "MITRE",
        "informationUri": "https://cwe.mitre.org/",
        "shortDescription": {"text": "The MITRE Common Weakness Enumeration."},
        "isComprehensive": False,
        "taxa": [{"id": cwe, "helpUri": DEFINITION.format(_number(cwe))} for cwe in cwes],
    }


def _relationship(taxonomy: dict[str, Any], cwe: str) -> dict[str, Any]:
    index = next(number for number, taxon in enumerate(taxonomy["taxa"]) if taxon["id"] == cwe)
    component = {"name": taxonomy["name"], "index": 0}
    return {"target": {"id": cwe, "index": index, "toolComponent": component}, "kinds": ["relevant"]}


def _tags(rule: RuleDoc) -> list[str]:
    """The tags, those of CWE in the form that code scanning services know."""
    cwes = [f"external/cwe/{tag.lower()}" for tag in rule.tags if tag.startswith("CWE-")]
    others = [tag for tag in rule.tags if not tag.startswith("CWE-")]
    return [*others, *(["security"] if cwes and "security" not in others else []), *cwes]


def _number(cwe: str) -> int:
    number = cwe.removeprefix("CWE-")
    return int(number) if number.isdecimal() else 0


def _sentence(text: str) -> str:
    return text if text.endswith((".", "!", "?")) else text + "."
