"""A rule's documentation as Markdown and as plain text."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.report.docs import finds
from bringup_lint.report.docs import markdown
from bringup_lint.report.docs import plain
from bringup_lint.report.docs import sections
from tests.report.sample import NETWORK_TARGET
from tests.report.sample import ROOT_USER

EXPECTED = Path(__file__).parent / "expected"
PAGES = {
    "explain.md": markdown(NETWORK_TARGET),
    "explain.txt": plain(NETWORK_TARGET),
    "explain_narrow.txt": plain(NETWORK_TARGET, 44),
    "explain_colour.txt": plain(NETWORK_TARGET, colour=True),
}


@pytest.mark.parametrize("name", PAGES)
def test_page(name: str, update_expected: bool) -> None:
    if update_expected:
        (EXPECTED / name).write_text(PAGES[name], "utf-8")
    assert PAGES[name] == (EXPECTED / name).read_text("utf-8")


def test_what_a_rule_finds_is_one_line_of_prose() -> None:
    assert finds(ROOT_USER) == "A unit without `User=` that starts nodes."
    assert "multicast group (https://www.rfc-editor.org/rfc/rfc1112)" in finds(NETWORK_TARGET)
    assert "\n" not in finds(NETWORK_TARGET)


def test_comments_in_code_are_no_headings() -> None:
    docstring = "Title.\n\n## Bad\n```sh\n## not a heading\n```\n\n## Good\nfine\n"
    assert sections(docstring) == {"Bad": "```sh\n## not a heading\n```", "Good": "fine"}


def test_indented_docstring_is_read_like_any_other() -> None:
    assert sections("Title.\n\n    ## Bad\n    worse\n") == {"Bad": "worse"}
