"""What the guides warn of or ask for is found by a rule that is proved, or has a reason why files cannot show it."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from bringup_lint.registry import Registry
from tests.conftest import PROJECT
from tests.docs import guides

ENTRIES = {f"{guide}/{key}": entry for guide, entries in guides.answers().items() for key, entry in entries.items()}
RULES = frozenset(Registry.of().paths)
SHOWN = {
    line.partition("[")[2].partition("]")[0]
    for line in (PROJECT / "fixtures" / "robots" / "guide" / "expected.txt").read_text("utf-8").splitlines()
}
"""What the robot that follows the guides shows."""


@pytest.fixture(scope="module")
def texts() -> dict[str, str]:
    folder = os.environ.get("BRINGUP_LINT_GUIDES")
    if not folder:
        pytest.skip("BRINGUP_LINT_GUIDES names no folder")
    return guides.texts(Path(folder))


def is_shown(entry: dict[str, Any]) -> bool:
    """An item that the robot cannot have at the same time as its others names a fixture of its own."""
    rules = entry.get("rules", ())
    if "fixture" in entry:
        folders = [f"fixtures/{rule.replace('-', '_')}/" for rule in rules]
        return (PROJECT / entry["fixture"]).is_dir() and any(folder in entry["fixture"] for folder in folders)
    return not rules or bool(SHOWN.intersection(rules))


def test_rules_or_reason() -> None:
    known = {"fingerprint", "what", "rules", "limit", "reason", "fixture"}
    for name, entry in ENTRIES.items():
        assert set(entry) <= known, name
        assert ("rules" in entry) != ("reason" in entry), name
        assert entry["what"] and (entry.get("rules") or entry["reason"]), name


def test_rules_are_proved() -> None:
    rules = {rule for entry in ENTRIES.values() for rule in entry.get("rules", ())}
    assert rules - RULES == set()
    folders = [PROJECT / "fixtures" / rule.replace("-", "_") for rule in sorted(rules)]
    assert [folder.name for folder in folders if not any(folder.glob("bad*"))] == []


def test_robot_that_follows_the_guides_shows_every_item() -> None:
    assert [name for name, entry in ENTRIES.items() if not is_shown(entry)] == []


def test_page_is_drawn_from_the_entries(update_expected: bool) -> None:
    page = PROJECT / "docs" / "guides.md"
    if update_expected:
        page.write_text(guides.page(), "utf-8")
    assert page.read_text("utf-8") == guides.page()


@pytest.mark.parametrize("guide", guides.GUIDES)
def test_every_item_of_the_guide_has_an_entry(guide: str, texts: dict[str, str]) -> None:
    found = {key: fingerprint for key, fingerprint, _ in guides.items(texts[guide])}
    assert {key: entry["fingerprint"] for key, entry in guides.answers()[guide].items()} == found


def test_no_sentence_of_a_guide_is_copied(texts: dict[str, str]) -> None:
    plain = {guide: " ".join(text.lower().split()) for guide, text in texts.items()}
    told = [
        text for entry in ENTRIES.values() for text in (entry["what"], entry.get("limit", ""), entry.get("reason", ""))
    ]
    assert [text for text in told if len(text) > 25 and any(text.lower() in guide for guide in plain.values())] == []
