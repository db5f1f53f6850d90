"""Where Ansible finds the files of a repository that is a role or a play itself."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.lint import lint

CASES = Path(__file__).parents[3] / "fixtures/script/ansible_name_missing"


@pytest.mark.parametrize("case", ["good_role_at_root", "good_tasks_of_play"])
def test_files_at_the_top_of_a_tree_are_found(case: str, tmp_path: Path) -> None:
    """The fixtures lie in a larger tree: only a copy has nothing above."""
    tree = shutil.copytree(CASES / case, tmp_path / case)
    run = lint("--isolated", "--select", "script/ansible-name-missing", "--output-format", "concise", ".", cwd=tree)
    assert (run.code, run.stdout) == (0, "")


def test_a_file_that_is_nowhere_is_missed(tmp_path: Path) -> None:
    tree = shutil.copytree(CASES / "good_role_at_root", tmp_path / "role")
    (tree / "templates/etc/weir.j2").unlink()
    run = lint("--isolated", "--select", "script/ansible-name-missing", "--output-format", "concise", ".", cwd=tree)
    assert "Ansible finds no etc/weir.j2" in run.stdout
