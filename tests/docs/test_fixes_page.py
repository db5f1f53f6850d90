"""``docs/fixes.md`` lists every rule with a fix; ``--update-expected`` rewrites it."""

from __future__ import annotations

import shutil
from collections import defaultdict
from pathlib import Path

import pytest

from bringup_lint.registry import Registry
from tests.conftest import PROJECT
from tests.lint import lint
from tests.oracles.judges import judges_of
from tests.rules.test_fixes import FIXES
from tests.rules.test_fixes import source
from tests.rules.test_fixes import texts
from tests.rules.test_fixtures import arguments

PAGE = PROJECT / "docs/fixes.md"
HEAD = """# Fixes

`--fix` applies the safe fixes, `--fix --unsafe-fixes` all of them. A safe fix changes nothing that works: afterwards
the robot does the same, or what it corrects keeps a program from starting at all and there is one way to write it. An
unsafe fix changes what the robot does: who may log in, what starts, stops, is ordered or is rotated, which value a node
gets, which nodes find each other, with which status it ends. It is also unsafe to bring a line into effect that its
reader ignores today, to guess a name, and to change a value of YAML that an alias repeats.

After a fix, a file that could be read before can still be read: where fixes would break it, such as two that give one
name to two keys, the one that breaks it is left out, and the others are applied.

For each fix, a test compares what the tool in the last column says of the file before and after the fix: it must not
find anything new; netplan and launch, which stop at the first mistake, must still accept what they accepted. Where the
column names none, the parser of bringup-lint alone judges the fixed file. What launch says is recorded, too. `udevadm
verify` is that of systemd 254 or newer, which reads the rules without a device.

| rule | fix | judged by |
|---|---|---|
"""


def judges(tmp_path: Path) -> dict[str, set[str]]:
    """Rule -> the tools that read the files that its fixes change, over all of its fixtures."""
    tools: dict[str, set[str]] = defaultdict(set)
    for number, (rule_id, case) in enumerate(FIXES):
        folder = shutil.copytree(case, tmp_path / str(number), symlinks=True)
        old = texts(folder)
        lint("--fix", "--unsafe-fixes", "--min-severity", "info", "--select", rule_id, *arguments(folder), cwd=folder)
        for name, data in texts(folder).items():
            if data != old.get(name):
                tools[rule_id] |= {tool for tool, _ in judges_of(source(name, data).kind)}
    return tools


@pytest.mark.slow
def test_the_page_is_current(tmp_path: Path, update_expected: bool) -> None:
    tools = judges(tmp_path)
    registry = Registry.of()
    rows = [
        f"| [{rule_id}](../{path.relative_to(PROJECT)}) | {fix} | {', '.join(sorted(tools[rule_id]))} |\n"
        for rule_id, path in sorted(registry.paths.items())
        if (fix := registry[rule_id].meta.fix) != "none"
    ]
    if update_expected:
        PAGE.write_text(HEAD + "".join(rows), "utf-8")
    assert PAGE.read_text("utf-8") == HEAD + "".join(rows)


def test_the_page_says_what_the_rules_say() -> None:
    page = PAGE.read_text("utf-8")
    registry = Registry.of()
    for rule_id in registry.paths:
        fix = registry[rule_id].meta.fix
        assert (f"[{rule_id}](" in page) == (fix != "none")
        assert fix == "none" or f".py) | {fix} |" in page.partition(f"[{rule_id}](")[2].partition("\n")[0]
