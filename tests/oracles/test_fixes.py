"""The real tools find nothing in a fixed file that they did not find before."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.lint import lint
from tests.oracles.judges import has_stopped
from tests.oracles.judges import is_installed
from tests.oracles.judges import judges_of
from tests.rules.test_fixes import FIXES
from tests.rules.test_fixes import source
from tests.rules.test_fixes import texts
from tests.rules.test_fixtures import arguments
from tests.rules.test_fixtures import case_id


@pytest.mark.parametrize(("rule_id", "case"), FIXES, ids=case_id)
def test_fixed_file(rule_id: str, case: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(case, tmp_path / "tree", symlinks=True)
    old = texts(folder)
    lint("--fix", "--unsafe-fixes", "--min-severity", "info", "--select", rule_id, *arguments(folder), cwd=folder)
    changed = {name: data for name, data in texts(folder).items() if data != old.get(name)}
    for name, data in changed.items():
        for tool, judge in judges_of(source(name, data).kind):
            if not is_installed(tool):
                continue
            after = judge(folder / name)
            (folder / name).write_bytes(old[name])
            before = judge(folder / name)
            (folder / name).write_bytes(data)
            if not has_stopped(tool, before):
                assert not after - before
