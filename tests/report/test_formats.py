"""The formats, to the letter: ``--update-expected`` rewrites the files in ``expected/``."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.report import FORMATS
from bringup_lint.report import render
from tests.report.sample import PASSWORD
from tests.report.sample import clean
from tests.report.sample import sample

EXPECTED = Path(__file__).parent / "expected"
CASES = {
    "text.txt": ("text", sample()),
    "text_narrow.txt": ("text", sample(width=50)),
    "text_colour.txt": ("text", sample(colour=True)),
    "text_clean.txt": ("text", clean()),
    "text_nothing.txt": ("text", clean(kinds={})),
    "concise.txt": ("concise", sample()),
    "concise_clean.txt": ("concise", clean()),
    "report.json": ("json", sample()),
    "clean.json": ("json", clean()),
    "report.sarif": ("sarif", sample()),
    "clean.sarif": ("sarif", clean()),
    "github.txt": ("github", sample()),
    "gitlab.json": ("gitlab", sample()),
    "junit.xml": ("junit", sample()),
    "junit_clean.xml": ("junit", clean()),
    "markdown.md": ("markdown", sample()),
    "markdown_clean.md": ("markdown", clean()),
    "rdjson.json": ("rdjson", sample()),
}


@pytest.mark.parametrize("name", CASES)
def test_format(name: str, update_expected: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)
    text = render(*CASES[name])
    if update_expected:
        (EXPECTED / name).write_text(text, "utf-8")
    assert text == (EXPECTED / name).read_text("utf-8")


@pytest.mark.parametrize("name", CASES)
def test_no_secret_is_shown(name: str) -> None:
    assert PASSWORD not in render(*CASES[name])


@pytest.mark.parametrize("output_format", FORMATS)
def test_output_can_be_written_anywhere(output_format: str) -> None:
    text = render(output_format, sample())
    assert "\x1b" not in text
    assert text.encode("utf-8").decode() == text


@pytest.mark.parametrize("width", [60, 80, 100])
def test_text_keeps_to_the_width(width: int) -> None:
    lines = render("text", sample(width=width)).splitlines()
    assert [line for line in lines if len(line) > width and "explain" not in line] == []
