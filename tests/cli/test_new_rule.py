"""The command that writes the files of a new rule."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.cli.commands import new_rule
from bringup_lint.registry import load
from tests.conftest import PROJECT
from tests.lint import Run
from tests.lint import lint


@pytest.fixture
def checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout with one family and one rule."""
    for path in ("rules/systemd/family.toml", "rules/systemd/root_user.py"):
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes((PROJECT / path).read_bytes())
    unit = tmp_path / "fixtures/systemd/root_user/good/robot.service"
    unit.parent.mkdir(parents=True)
    unit.write_text("[Service]\nUser=robot\nExecStart=/bin/true\n")
    monkeypatch.setattr(new_rule, "builtin_folder", lambda: str(tmp_path / "rules"))
    return tmp_path


def run(checkout: Path, rule_id: str) -> Run:
    return lint("new-rule", rule_id, cwd=checkout)


def test_rule_and_fixtures_are_written(checkout: Path) -> None:
    (checkout / "rules/__pycache__").mkdir()
    written = run(checkout, "systemd/no-tabs")
    assert (written.code, "-k no_tabs --update-expected" in written.stderr) == (0, True)
    rule = load(checkout / "rules/systemd/no_tabs.py", "systemd/no-tabs")
    assert rule.check.__name__ == "no_tabs"
    assert 'of_kind("systemd-dropin", "systemd-unit")' in (checkout / "rules/systemd/no_tabs.py").read_text()
    for case in ("bad", "good"):
        assert "User=robot" in (checkout / f"fixtures/systemd/no_tabs/{case}/robot.service").read_text()


def test_nothing_is_overwritten(checkout: Path) -> None:
    before = (checkout / "rules/systemd/root_user.py").read_bytes()
    again = run(checkout, "systemd/root-user")
    assert (again.code, again.stderr.endswith("root_user.py exists already\n")) == (2, True)
    assert (checkout / "rules/systemd/root_user.py").read_bytes() == before


def test_fixtures_of_a_rule_are_not_overwritten(checkout: Path) -> None:
    (checkout / "fixtures/systemd/no_tabs/bad").mkdir(parents=True)
    assert run(checkout, "systemd/no-tabs").code == 2
    assert not (checkout / "rules/systemd/no_tabs.py").exists()


@pytest.mark.parametrize(
    ("rule_id", "said"),
    [
        ("no-tabs", "'no-tabs' is not a rule id"),
        ("systemd/../x", "is not a rule id"),
        ("systemd/No_Tabs", "is not a rule id"),
        ("grub/no-tabs", "there is no family 'grub'; the families are systemd\n"),
    ],
)
def test_wrong_ids_are_explained(checkout: Path, rule_id: str, said: str) -> None:
    (checkout / "rules/__pycache__").mkdir()
    refused = run(checkout, rule_id)
    assert refused.code == 2
    assert said in refused.stderr


def test_an_installed_package_is_no_checkout(checkout: Path) -> None:
    (checkout / "fixtures").rename(checkout / "elsewhere")
    assert "works in a checkout of bringup-lint that is installed with" in run(checkout, "systemd/no-tabs").stderr
