"""The findings as articles, grouped by severity; the script regroups and filters them."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.finding import Applicability
from bringup_lint.finding import Finding
from bringup_lint.finding import Related
from bringup_lint.finding import Severity
from bringup_lint.finding.place import is_whole_file
from bringup_lint.finding.place import place_of
from bringup_lint.report.frame import Mark
from bringup_lint.report.frame import frames
from bringup_lint.report.html.code import figure
from bringup_lint.report.html.markup import code
from bringup_lint.report.html.markup import icon
from bringup_lint.report.html.markup import lines
from bringup_lint.report.html.markup import text
from bringup_lint.report.html.prose import prose
from bringup_lint.report.model import Report
from bringup_lint.report.order import LONG
from bringup_lint.report.order import by_cause

TITLES = {Severity.ERROR: "Errors", Severity.WARNING: "Warnings", Severity.INFO: "Info"}
SNIPPET = 120
"""The line of a chain's step is cut after this many characters."""


def articles(report: Report) -> str:
    """A section for each severity, worst first; in a long report what starts at boot first, and each rule together."""
    shown = list(report.shown)
    if not shown:
        return _nothing(report)
    number = {id(finding): index for index, finding in enumerate(shown)}
    sections = []
    for severity, title in TITLES.items():
        found = [finding for finding in shown if finding.severity is severity]
        if len(shown) > LONG:
            found = [finding for group in by_cause(found, report.at_boot) for finding in group]
        held = [_article(number[id(finding)], finding, report) for finding in found]
        if held:
            heading = f'<h2>{title} <span class="count">{len(held)}</span></h2>'
            sections.append(f'<section class="group">{heading}{"".join(held)}</section>')
    return "\n".join((*sections, *_documentation(report)))


def _documentation(report: Report) -> Iterator[str]:
    """What the rules of the findings say, once each; the script shows it below a finding."""
    for rule in sorted({finding.rule for finding in report.shown}):
        if rule in report.rules:
            yield f'<template data-rule="{text(rule)}">{prose(report.rules[rule])}</template>'


def _nothing(report: Report) -> str:
    if not report.files:
        return (
            '<div class="empty"><h2>Nothing to check</h2>'
            "<p>No file of a known kind was found: no unit, launch file, udev rule, network or DDS configuration.</p>"
            "</div>"
        )
    files = "1 file was" if report.files == 1 else f"{report.files} files were"
    return (
        f'<div class="empty"><svg class="icon good" aria-hidden="true"><use href="#icon-good"/></svg>'
        f"<h2>Clear for bring-up</h2><p>{files} checked, nothing to report.</p></div>"
    )


def _article(number: int, finding: Finding, report: Report) -> str:
    severity = str(finding.severity)
    family = finding.rule.partition("/")[0]
    body = "".join(_body(finding))
    about = {"finding": number, "severity": severity, "family": family, "rule": finding.rule, "file": finding.span.path}
    held = "".join(f' data-{key}="{text(value)}"' for key, value in about.items())
    return (
        f'<article class="finding {severity}" id="finding-{number}"{held} tabindex="-1">'
        f'<header><span class="severity {severity}">{icon(severity)}{severity}</span>{_rule(finding.rule, report)}'
        '<button type="button" class="explain" aria-expanded="false" hidden>Why</button>'
        '<button type="button" class="locate" hidden>Show in the picture</button></header>'
        f"<h3>{text(' '.join(finding.message.split()))}</h3>{body}</article>\n"
    )


def _rule(rule: str, report: Report) -> str:
    doc = report.rules.get(rule)
    if doc is None or not doc.uri.startswith("https://"):
        return f'<span class="rule">{text(rule)}</span>'
    attributes = f'href="{text(doc.uri)}" rel="noreferrer" target="_blank" title="{text(doc.title)}"'
    return f'<a class="rule" {attributes}>{text(rule)}</a>'


def _body(finding: Finding) -> Iterator[str]:
    own = Mark(finding.span, str(finding.severity))
    for frame in frames([own, *(Mark(span, "mark", message) for span, message in finding.related)]):
        yield figure(frame)
    if finding.chain:
        yield f'<ol class="chain">{"".join(map(_step, finding.chain))}</ol>'
    if finding.advice:
        yield f'<p class="advice"><b>Instead</b><span>{lines(finding.advice)}</span></p>'
    if finding.fix:
        option = "--fix" if finding.fix.applicability is Applicability.SAFE else "--fix --unsafe-fixes"
        yield f'<p class="fix"><b>Fix</b><span>{text(finding.fix.title)} <code>{option}</code></span></p>'


def _step(step: Related) -> str:
    place, line = text(step.span.path), ""
    if not is_whole_file(step.span):
        at = place_of(step.span)
        place += f":{at.line}:{at.column}"
        snippet = step.span.source.line_text(at.line).strip()
        line = f"<code>{code(snippet[:SNIPPET])}{'…' if len(snippet) > SNIPPET else ''}</code>"
    return f'<li><span>{text(step.message)}</span><span class="place">{place}</span>{line}</li>'
