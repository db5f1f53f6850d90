"""Every finding of every bad fixture can be silenced, and the file stays what it was."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path

import pytest

from bringup_lint.discover.kinds import HEAD_SIZE
from bringup_lint.discover.kinds import kind_of
from bringup_lint.discover.reading import decode
from bringup_lint.source import Source
from tests.rules.test_fixtures import arguments
from tests.rules.test_fixtures import case_id
from tests.rules.test_fixtures import cases
from tests.rules.test_fixtures import command
from tests.rules.test_fixtures import set_modes
from tests.suppress.placing import Found
from tests.suppress.placing import copied
from tests.suppress.placing import found
from tests.suppress.placing import problems
from tests.suppress.placing import with_comments

COMPLAINTS = ("lint/unused-ignore", "lint/ignore-without-reason")
CASES = [
    (rule_id, case) for rule_id, case in cases("bad") if rule_id not in COMPLAINTS and not rule_id.startswith("fleet/")
]
"""Findings of a fleet are of several robots: ``[[accept]]`` in ``fleet.toml`` silences them."""
EVERY = 12
"""Of so many fixtures, one is tried in a quick run; all of them in a whole one."""


def source_of(folder: Path, name: str) -> Source | None:
    """The file, when it is one that its format lets a comment into."""
    path = folder / name
    if not path.is_file() or path.is_symlink():
        return None
    text, complaint = decode(path.read_bytes())
    return None if complaint else Source(name, text, kind_of(name, lambda: text[:HEAD_SIZE]))


def write_comments(folder: Path, findings: list[Found]) -> dict[str, set[str]]:
    """Silence the findings in their files; returns the rules to be silenced by the configuration, by path."""
    wanted: dict[str, dict[int, set[str]]] = defaultdict(lambda: defaultdict(set))
    for each in findings:
        for path, line in ((each.path, each.line), *each.copies):
            wanted[path][line].add(each.rule)
    left: dict[str, set[str]] = {}
    for name, lines in wanted.items():
        source = source_of(folder, name)
        text = None if source is None else with_comments(source, lines)
        if source is None or text is None:
            left[name] = set().union(*lines.values())
            continue
        (folder / name).write_bytes(text.encode())
        assert list(problems(source, text)) <= list(problems(source, source.text))
    return left


def write_configuration(folder: Path, left: dict[str, set[str]]) -> None:
    lines = [f'"/{name}" = {sorted(rules)}' for name, rules in left.items()]
    (folder / "bringup-lint.toml").write_text("\n".join(["[per-file-ignores]", *lines, ""]))


def tried() -> list[object]:
    marks = [() if number % EVERY == 0 else (pytest.mark.slow,) for number in range(len(CASES))]
    return [pytest.param(*case, marks=mark) for case, mark in zip(CASES, marks)]


@pytest.mark.parametrize(("rule_id", "case"), tried(), ids=case_id)
def test_finding_can_be_silenced(rule_id: str, case: Path, tmp_path: Path) -> None:
    set_modes(case)
    folder = copied(case, tmp_path / "tree")
    family = rule_id.partition("/")[0]
    check = (*command(rule_id), "--select", ",".join({family, "lint"}), *arguments(folder))
    before = found(folder, *check)
    left = write_comments(folder, [each for each in before if each.rule == rule_id])
    if left:
        write_configuration(folder, left)
    after = found(folder, *check)
    assert [each for each in after if each.rule == rule_id and not each.suppressed] == []
    assert any(each.suppressed for each in after)
    known = {(each.rule, path) for each in before for path, _ in ((each.path, each.line), *each.copies)}
    assert [each for each in after if (each.rule, each.path) not in known and not each.suppressed] == []
