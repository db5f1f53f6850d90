"""What is right does not end a rule: what is wrong in a bad fixture is found too when the good ones are read first.

``beside.toml`` names the rules that judge a robot as a whole, for which a good robot beside the bad one makes it good.
"""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from bringup_lint.toml import read_toml
from tests.lint import lint
from tests.rules.test_fixtures import BY_ENGINE
from tests.rules.test_fixtures import RULE_IDS
from tests.rules.test_fixtures import arguments
from tests.rules.test_fixtures import cases_of
from tests.rules.test_fixtures import command
from tests.rules.test_fixtures import folder_of

TABLE = Path(__file__).with_name("beside.toml")
WHOLE = frozenset(read_toml(TABLE.read_text("utf-8"))["whole"])


def is_tried(rule_id: str) -> bool:
    """A fixture without arguments of its own can be a folder of a larger tree."""
    bad = folder_of(rule_id) / "bad"
    return not command(rule_id) and rule_id not in BY_ENGINE and bad.is_dir() and arguments(bad) == ["."]


TRIED = [rule_id for rule_id in RULE_IDS if is_tried(rule_id)]


def places(text: str, folder: str) -> Iterator[str]:
    """Path, line and column of what the concise output says of files in a folder."""
    for match in re.finditer(rf"^{folder}(.*?:\d+:\d+): ", text, re.M):
        yield match[1]


def lost(rule_id: str, folder: Path) -> list[str]:
    """The places of a bad fixture at which nothing is found when the good ones are beside it."""
    good = [case for case in cases_of(rule_id, "good") if arguments(case) == ["."]]
    for number, case in enumerate(good):
        shutil.copytree(case, folder / f"a{number}", symlinks=True)
    shutil.copytree(folder_of(rule_id) / "bad", folder / "b", symlinks=True)
    run = lint("--select", rule_id, "--output-format", "concise", ".", cwd=folder)
    expected = (folder_of(rule_id) / "expected.txt").read_text("utf-8")
    return sorted(set(places(expected, "")) - set(places(run.stdout, "b/")))


@pytest.mark.slow
@pytest.mark.parametrize("rule_id", [rule_id for rule_id in TRIED if rule_id not in WHOLE])
def test_bad_is_found_beside_good(rule_id: str, tmp_path: Path) -> None:
    assert lost(rule_id, tmp_path) == []


@pytest.mark.slow
@pytest.mark.parametrize("rule_id", sorted(WHOLE))
def test_exceptions_are_needed(rule_id: str, tmp_path: Path) -> None:
    assert rule_id in TRIED
    assert lost(rule_id, tmp_path) != []
