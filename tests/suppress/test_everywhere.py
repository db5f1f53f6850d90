"""Every finding of every bad fixture can be silenced, and the file stays what it was."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path

import pytest

from bringup_lint.discover.kinds import HEAD_SIZE
from bringup_lint.discover.kinds import kind_of
from bringup_lint.discover.reading import decode
from bringup_lint.fix import rewritten
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.suppress.placing import comments
from tests.lint import lint
from tests.rules.test_fixtures import arguments
from tests.rules.test_fixtures import case_id
from tests.rules.test_fixtures import cases
from tests.rules.test_fixtures import command
from tests.rules.test_fixtures import set_modes
from tests.sample import sampled
from tests.suppress.placing import Found
from tests.suppress.placing import copied
from tests.suppress.placing import found
from tests.suppress.placing import problems

WHY = "accepted on this robot"
COMPLAINTS = ("lint/unused-ignore", "lint/ignore-without-reason")
CASES = [
    (rule_id, case) for rule_id, case in cases("bad") if rule_id not in COMPLAINTS and not rule_id.startswith("fleet/")
]
"""Findings of a fleet are of several robots: ``tests/fleet/test_silence.py`` silences them."""


def source_of(folder: Path, name: str) -> Source | None:
    """The file, when it is one that its format lets a comment into."""
    path = folder / name
    if not path.is_file() or path.is_symlink():
        return None
    text, complaint = decode(path.read_bytes())
    return None if complaint else Source(name, text, kind_of(name, lambda: text[:HEAD_SIZE]))


def texts(folder: Path, findings: list[Found]) -> dict[str, Source]:
    """The files that findings are in, as they are now."""
    names = {path for each in findings for path, _ in ((each.path, each.line), *each.copies)}
    return {name: source for name in names if (source := source_of(folder, name)) is not None}


def places(source: Source, lines: dict[int, set[str]]) -> list[tuple[Span, str]]:
    starts = {line: source.line_starts[line - 1] for line in lines if line}
    spans = {line: source.span(starts[line], starts[line] + 1) if line else source.whole for line in lines}
    return [(spans[line], rule) for line, rules in lines.items() for rule in rules]


def write_comments(folder: Path, findings: list[Found]) -> dict[str, set[str]]:
    """Silence the findings in their files; returns the rules to be silenced by the configuration, by path."""
    wanted: dict[str, dict[int, set[str]]] = defaultdict(lambda: defaultdict(set))
    for each in findings:
        for path, line in ((each.path, each.line), *each.copies):
            wanted[path][line].add(each.rule)
    left: dict[str, set[str]] = {}
    for name, lines in wanted.items():
        source = source_of(folder, name)
        edits = [] if source is None else comments(source, places(source, lines), WHY)
        if source is None or not edits:
            left[name] = set().union(*lines.values())
            continue
        (folder / name).write_bytes(rewritten(source.text, edits).encode())
    return left


def write_configuration(folder: Path, left: dict[str, set[str]]) -> None:
    lines = [f'"/{name}" = {sorted(rules)}' for name, rules in left.items()]
    (folder / "bringup-lint.toml").write_text("\n".join(["[per-file-ignores]", *lines, ""]))


@pytest.mark.parametrize(("rule_id", "case"), sampled(CASES, 12, pytest.mark.campaign), ids=case_id)
def test_finding_can_be_silenced(rule_id: str, case: Path, tmp_path: Path) -> None:
    set_modes(case)
    folder = copied(case, tmp_path / "tree")
    family = rule_id.partition("/")[0]
    check = (*command(rule_id), "--select", ",".join({family, "lint"}), *arguments(folder))
    before = found(folder, *check)
    files = texts(folder, before)
    if family == "live":
        write_configuration(folder, write_comments(folder, [each for each in before if each.rule == rule_id]))
    else:
        run = lint("--add-ignores", WHY, *check, "--min-severity", "info", "--ignore", ",".join(COMPLAINTS), cwd=folder)
        assert (run.code, run.stdout) == (0, "")
    for name, source in texts(folder, before).items():
        assert list(problems(source, source.text)) <= list(problems(files[name], files[name].text))
    after = found(folder, *check)
    assert [each for each in after if each.rule == rule_id and not each.suppressed] == []
    assert any(each.suppressed for each in after)
    known = {(each.rule, path) for each in before for path, _ in ((each.path, each.line), *each.copies)}
    assert [each for each in after if (each.rule, each.path) not in known and not each.suppressed] == []
