"""What the formats for CI services promise to the programs that read them."""

from __future__ import annotations

import io
import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any
from typing import NamedTuple

import jsonschema
import pytest

from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.finding import Severity
from bringup_lint.report import Notification
from bringup_lint.report import Report
from bringup_lint.report import render
from bringup_lint.report.columns import printable
from bringup_lint.report.markdown import NODES
from bringup_lint.report.markdown import ROWS
from bringup_lint.source import Source
from tests.report.sample import FINDINGS
from tests.report.sample import clean
from tests.report.sample import sample

HOSTILE = "::error::a,b=c%0A\r\n##[add-mask]x|`y`<img src=x>](http://evil)@root #1 ![i](j)"
ODD = Source(HOSTILE, "one\nÄ two\n", "systemd-unit")
HOSTILE_REPORT = Report(
    (Finding(HOSTILE, ODD.span(4, 9), "systemd/root-user", related=(Related(ODD.whole, HOSTILE),), advice=HOSTILE),),
    notifications=(Notification("error", HOSTILE),),
    root="/robot",
)
REPORTS = {"sample": sample(), "clean": clean(), "bare": Report(), "hostile": HOSTILE_REPORT}

# What GitLab demands of an issue, and what reviewdog's rdf.Diagnostic says of one.
POSITIVE = {"type": "integer", "minimum": 1}
LINES = {"required": ["begin"], "properties": {"begin": POSITIVE, "end": POSITIVE}}
ISSUES = {
    "type": "array",
    "items": {
        "required": ["description", "check_name", "fingerprint", "severity", "location"],
        "properties": {
            "description": {"type": "string", "minLength": 1},
            "check_name": {"type": "string"},
            "fingerprint": {"type": "string", "pattern": "^[0-9a-f]{32}$"},
            "severity": {"enum": ["info", "minor", "major", "critical", "blocker"]},
            "location": {
                "required": ["path", "lines"],
                "properties": {
                    "path": {"type": "string"},
                    "lines": {"required": ["begin"], "properties": {"begin": POSITIVE}},
                },
            },
        },
    },
}
POSITION = {"required": ["line"], "properties": {"line": POSITIVE, "column": POSITIVE}, "additionalProperties": False}
RANGE = {"required": ["start"], "properties": {"start": POSITION, "end": POSITION}, "additionalProperties": False}
LOCATION = {
    "required": ["path"],
    "properties": {"path": {"type": "string"}, "range": RANGE},
    "additionalProperties": False,
}
DIAGNOSTICS = {
    "required": ["source", "diagnostics"],
    "properties": {
        "diagnostics": {
            "items": {
                "required": ["message", "location"],
                "properties": {
                    "message": {"type": "string"},
                    "location": LOCATION,
                    "severity": {"enum": ["ERROR", "WARNING", "INFO"]},
                    "code": {"required": ["value"]},
                    "suggestions": {"items": {"required": ["range", "text"], "properties": {"range": RANGE}}},
                    "related_locations": {"items": {"required": ["location"], "properties": {"location": LOCATION}}},
                },
                "additionalProperties": False,
            }
        }
    },
}


@pytest.mark.parametrize("name", REPORTS)
def test_gitlab_takes_every_issue(name: str) -> None:
    issues = json.loads(render("gitlab", REPORTS[name]))
    jsonschema.validate(issues, ISSUES)
    assert len({issue["fingerprint"] for issue in issues}) == len(issues) == len(list(REPORTS[name].shown))


@pytest.mark.parametrize("name", REPORTS)
def test_reviewdog_takes_every_diagnostic(name: str) -> None:
    report = json.loads(render("rdjson", REPORTS[name]))
    jsonschema.validate(report, DIAGNOSTICS)
    jsonschema.validate(report, reviewdogs_schema())


def reviewdogs_schema() -> dict[str, Any]:
    """The published schema, which may not be extended."""
    return strict(json.loads(Path(__file__).with_name("rdjson.schema.json").read_text("utf-8")))


def strict(schema: Any) -> Any:
    """A schema whose objects have no members but those that it names."""
    if isinstance(schema, list):
        return [strict(each) for each in schema]
    if not isinstance(schema, dict):
        return schema
    inner = {key: strict(value) for key, value in schema.items()}
    if "$ref" in inner or "properties" in inner:
        inner.pop("additionalProperties", None)
    return {**inner, "additionalProperties": False} if isinstance(inner.get("properties"), dict) else inner


def test_reviewdog_counts_bytes() -> None:
    (diagnostic,) = json.loads(render("rdjson", HOSTILE_REPORT))["diagnostics"]
    assert diagnostic["location"]["range"] == {"start": {"line": 2, "column": 1}, "end": {"line": 2, "column": 7}}


@pytest.mark.parametrize(
    ("said", "shown"),
    [
        ("add <id>142</id>, and sign it", "add `<id>142</id>`, and sign it"),
        ("source /opt/ros/<distro>/setup.bash first", "source `/opt/ros/<distro>/setup.bash` first"),
        ('write <NetworkInterface name="eth0"/>.', 'write `<NetworkInterface name="eth0"/>`.'),
        ("list /var/log/*.log, not **: 1 < 2", "list `/var/log/*.log`, not `**`: 1 < 2"),
        ("no __init__.py of @robot, but a@b and robot_a", "no `__init__.py` of `@robot`, but a@b and robot_a"),
        ("a `b` c", "a 'b' c"),
        ("see ![i](j) and #1", "see `![i](j)` and #1"),
        ("::error::one", "∷error::one"),
        ("wait_\x1b[1m", "wait_␛[1m"),
    ],
)
def test_a_review_shows_each_word_of_a_message(said: str, shown: str) -> None:
    related = Related(ODD.whole, said)
    report = Report((replace(FINDINGS[0], message=said, advice=f"add:\n{said}", related=(related,)),))
    (diagnostic,) = json.loads(render("rdjson", report))["diagnostics"]
    told = diagnostic["message"].splitlines()
    assert (told[0], told[-1], diagnostic["related_locations"][0]["message"]) == (shown, shown, shown)


def test_what_reviewdog_writes_to_a_log_is_no_command() -> None:
    (diagnostic,) = json.loads(render("rdjson", HOSTILE_REPORT))["diagnostics"]
    for line in diagnostic["message"].splitlines():
        assert parsed(line) is None, line
        assert "##[" not in line


def test_a_suggestion_holds_all_edits() -> None:
    """Each suggestion is accepted by itself, so one is made of all edits."""
    (first, *_) = json.loads(render("rdjson", sample()))["diagnostics"]
    (suggestion,) = first["suggestions"]
    assert suggestion["text"] == "Wants=network-online.target\nAfter=network-online.target"
    assert suggestion["range"] == {"start": {"line": 3, "column": 1}, "end": {"line": 3, "column": 21}}


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
@pytest.mark.parametrize(
    ("start", "end", "text"),
    [
        ("", "", "d\n"),
        ("c\n", "", ""),
        ("c\n", "", "d\n"),
        ("b\nc\n", "", "d\n"),
        ("b\nc\n", "c\n", ""),
        ("b\nc\n", "c\n", "d\n"),
        ("b\nc\n", "b\nc\n", "d\n"),
        ("b\nc\n", "\nc\n", "d"),
    ],
)
def test_a_suggestion_needs_no_line_after_the_last(start: str, end: str, text: str, ending: str) -> None:
    """Reviewdog puts the text between what is before and after it on its first and last line."""
    source = Source("a.service", "a\nb\nc\n".replace("\n", ending))
    first, last = (len(source.text) - len(tail.replace("\n", ending)) for tail in (start, end))
    edit = Edit(source.span(first, last), text.replace("\n", ending))
    report = Report((replace(FINDINGS[0], span=source.span(0, 1), fix=Fix("edit", (edit,))),))
    (diagnostic,) = json.loads(render("rdjson", report))["diagnostics"]
    (suggestion,) = diagnostic["suggestions"]
    lines = source.text.removesuffix(ending).split(ending)
    at, until = suggestion["range"]["start"], suggestion["range"]["end"]
    before, after = lines[at["line"] - 1][: at["column"] - 1], lines[until["line"] - 1][until["column"] - 1 :]
    made = [*lines[: at["line"] - 1], before + suggestion["text"] + after, *lines[until["line"] :]]
    assert ending.join((*made, "")) == source.text[:first] + edit.text + source.text[last:]


def test_edits_of_other_files_are_no_suggestion() -> None:
    other = Source("other.service", "a\n")
    finding = replace(FINDINGS[0], fix=Fix("both", (Edit(other.span(0, 1), "b"), *FINDINGS[0].fix.edits)))
    (diagnostic,) = json.loads(render("rdjson", Report((finding,))))["diagnostics"]
    assert "suggestions" not in diagnostic


class Command(NamedTuple):
    """What GitHub's runner takes from a line."""

    name: str
    properties: dict[str, str]
    data: str


def parsed(line: str) -> Command | None:
    """The rules of ``ActionCommand.TryParseV2`` in actions/runner."""
    line = line.lstrip()
    end = line.find("::", 2)
    if not line.startswith("::") or end < 0:
        return None
    name, _, rest = line[2:end].partition(" ")
    pairs = [pair.split("=", 1) for pair in rest.strip().split(",") if pair]
    properties = {key: unescaped(value, ("%3A", ":"), ("%2C", ",")) for key, value in pairs}
    return Command(name, properties, unescaped(line[end + 2 :]))


def unescaped(text: str, *more: tuple[str, str]) -> str:
    for escape, sign in (("%0D", "\r"), ("%0A", "\n"), *more, ("%25", "%")):
        text = text.replace(escape, sign)
    return text


def test_github_reads_what_was_said() -> None:
    told, failed = map(parsed, render("github", HOSTILE_REPORT).splitlines())
    shown = printable(HOSTILE.replace("\r\n", " "))
    assert told.name == "warning"
    assert told.properties["file"].replace("␍␊", " ") == shown
    assert (told.properties["line"], told.properties["col"], told.properties["endColumn"]) == ("2", "1", "6")
    assert told.data.split("\n") == [shown, f"{shown}:1: {shown}", f"help: {shown}"]
    assert (failed.name, failed.data) == ("error", shown)


@pytest.mark.parametrize("output_format", ["concise", "text", "gitlab", "junit", "markdown", "rdjson"])
def test_no_name_becomes_a_command(output_format: str) -> None:
    for line in render(output_format, HOSTILE_REPORT).splitlines():
        assert parsed(line) is None, line


def test_github_says_errors_first() -> None:
    names = [parsed(line).name for line in render("github", sample()).splitlines()]
    assert names == [*sorted(names[:-1], key=["error", "warning", "notice"].index), "error"]


@pytest.mark.parametrize("name", REPORTS)
def test_junit_counts_its_cases(name: str) -> None:
    etree = pytest.importorskip("lxml.etree")
    tree = etree.fromstring(render("junit", REPORTS[name]).encode())
    for suite in tree:
        assert [child.tag for child in suite if child.tag != "testcase"] == ["properties", "system-out", "system-err"]
        assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d", suite.get("timestamp"))
        for kind, count in (("failure", "failures"), ("error", "errors"), ("skipped", "skipped")):
            assert len(suite.findall(f"testcase/{kind}")) == int(suite.get(count))
        assert len(suite.findall("testcase")) == int(suite.get("tests")) > 0
        assert all(case.get("name") and case.get("classname") for case in suite.findall("testcase"))
    assert len(tree.findall("testsuite/testcase/failure")) == len(list(REPORTS[name].shown))


def test_junit_is_read_by_its_library() -> None:
    junitparser = pytest.importorskip("junitparser")
    suites = junitparser.JUnitXml.fromfile(io.BytesIO(render("junit", sample()).encode()))
    results = [result for suite in suites for case in suite for result in case.result]
    assert sum(isinstance(result, junitparser.Failure) for result in results) == len(list(sample().shown))


def rendered(text: str) -> str:
    markdown_it = pytest.importorskip("markdown_it")
    return markdown_it.MarkdownIt("gfm-like", {"linkify": False}).render(text)


def many(count: int) -> Report:
    source = Source("a.service", "\n" * count, "systemd-unit")
    found = (
        Finding(
            f"message {at}",
            source.span(at, at + 1),
            "systemd/x",
            Severity.ERROR if at == count - 1 else Severity.WARNING,
        )
        for at in range(count)
    )
    return Report(tuple(found), kinds={"systemd-unit": 1})


def test_markdown_is_one_table() -> None:
    page = rendered(render("markdown", sample()))
    assert page.count("<table>") == 1
    assert page.count("<tr>") == 1 + len(list(sample().shown))
    assert page.index("systemd/root-user") < page.index("systemd/network-target")


def test_markdown_shows_no_markup_of_the_tree() -> None:
    page = rendered(render("markdown", HOSTILE_REPORT))
    assert "<img" not in page and "<a " not in page
    assert page.count("<td>") == 4
    assert not re.search(r"[@#]\w", re.sub(r"&#\w+;|<h3>.*?</h3>", "", page))


def test_markdown_says_what_it_leaves_out() -> None:
    text = render("markdown", many(ROWS + 5))
    assert text.count("\n| ") == 1 + ROWS
    assert f"message {ROWS + 4} " in text
    assert f"{ROWS} of {ROWS + 5} findings are shown; 5 warnings left out." in text
    assert len(text) < 65536


def picture(count: int, marked: int = 0) -> dict[str, Any]:
    nodes = [
        {"id": f"unit:{at}", "kind": "unit", "layer": "boot", "label": f"u{at}", "path": "u", "line": 1, "findings": []}
        for at in range(count)
    ]
    for node in nodes[:marked]:
        node["findings"] = [0]
    findings = [{"rule": "systemd/x", "severity": "error", "message": "m"}] if marked else []
    return {"layers": [{"id": "boot", "title": "Boot"}], "focus": [], "nodes": nodes, "edges": [], "findings": findings}


@pytest.mark.parametrize(
    ("count", "marked", "drawn"), [(NODES, 0, NODES), (NODES + 1, 2, 2), (NODES + 1, NODES + 1, 0)]
)
def test_markdown_draws_a_small_picture(count: int, marked: int, drawn: int) -> None:
    text = render("markdown", sample(picture=picture(count, marked)))
    assert ("```mermaid\nflowchart LR" in text) == bool(drawn)
    assert len(re.findall(r"^    n\d+", text, re.M)) == drawn
