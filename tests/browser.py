"""A real, headless Chromium for pages that are opened from disk.

Needs the library ``playwright`` and a Chromium to drive, from apt or by ``playwright install chromium``; what asks for
it is skipped where one of them is missing or the browser does not start.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
WIDE = {"width": 1400, "height": 900}
PHONE = {"width": 390, "height": 844}
HUGE = {"width": 2560, "height": 1440}


@pytest.fixture(scope="module")
def browser() -> Iterator:
    playwright = pytest.importorskip("playwright.sync_api")
    with playwright.sync_playwright() as driver:
        try:
            browser = driver.chromium.launch(
                executable_path=CHROMIUM, args=["--no-sandbox", "--disable-dev-shm-usage"], timeout=30_000
            )
        except playwright.Error as error:
            pytest.skip(f"chromium does not start: {str(error).splitlines()[0]}")
        yield browser
        browser.close()


class Tabs:
    """Tabs of a browser, each used by one test after the other: a new one takes longer than most tests."""

    def __init__(self, browser) -> None:
        self.browser = browser
        self.free: dict[str, list] = {}
        """Options of their contexts -> the tabs that no test uses."""
        self.complaints: list[str] = []
        """What was complained of or asked of the network since the test began."""
        self.file = ""

    def open(self, file: Path, viewport: dict[str, int], options: dict[str, object]):
        self.file = file.as_uri()
        free = self.free.setdefault(repr(options), [])
        tab = free.pop() if free else self._new(options)
        tab.set_viewport_size(viewport)
        tab.mouse.move(0, 0)
        tab.goto(self.file)
        return tab

    def _new(self, options: dict[str, object]):
        tab = self.browser.new_context(**options).new_page()
        tab.set_default_timeout(10_000)
        tab.on("console", lambda message: self.complaints.append(message.text))
        tab.on("pageerror", lambda error: self.complaints.append(str(error)))
        tab.on("request", self._asked)
        tab.on("dialog", lambda dialog: self.complaints.append(dialog.message))
        return tab

    def _asked(self, request) -> None:
        if request.url != self.file:
            self.complaints.append(request.url)


@pytest.fixture(scope="module")
def tabs(browser) -> Tabs:
    return Tabs(browser)


@pytest.fixture
def opened(tabs: Tabs, tmp_path: Path) -> Iterator:
    """A function that opens a page; at the end, nothing was complained of and nothing was asked of the network."""
    tabs.complaints.clear()
    used = []

    def open_(text: str, viewport: dict[str, int] = WIDE, **options: object):
        file = tmp_path / "page.html"
        file.write_text(text, "utf-8")
        used.append((repr(options), tabs.open(file, viewport, options)))
        return used[-1][1]

    yield open_
    for options, tab in used:
        tab.emulate_media(media="null")
        tabs.free[options].append(tab)
    assert [complaint for complaint in tabs.complaints if complaint != "data:,"] == []
