"""The real tools find nothing in a fixed file that they did not find before."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.lint import lint
from tests.oracles.judges import is_installed
from tests.oracles.judges import judge_of
from tests.rules.test_fixes import FIXES
from tests.rules.test_fixes import source
from tests.rules.test_fixes import texts
from tests.rules.test_fixtures import arguments
from tests.rules.test_fixtures import case_id

READ_ON = {"systemd/unescaped-percent": "systemd comes to the next specifier of the line"}


@pytest.mark.parametrize(("rule_id", "case"), [each for each in FIXES if each[0] not in READ_ON], ids=case_id)
def test_fixed_file(rule_id: str, case: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(case, tmp_path / "tree", symlinks=True)
    old = texts(folder)
    lint("--fix", "--unsafe-fixes", "--select", rule_id, *arguments(folder), cwd=folder)
    changed = {name: data for name, data in texts(folder).items() if data != old.get(name)}
    for name, data in changed.items():
        found = judge_of(source(name, data).kind)
        if found is None or not is_installed(found[0]):
            continue
        after = found[1](folder / name)
        (folder / name).write_bytes(old[name])
        before = found[1](folder / name)
        (folder / name).write_bytes(data)
        assert not after - before
