"""The site builds without a broken link, with a page for each rule at the address that reports name."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler
from http.server import ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from urllib.parse import urlparse

import pytest

from bringup_lint.registry import Registry
from bringup_lint.registry import doc_of
from tests.conftest import PROJECT

pytest.importorskip("mkdocs")
pytest.importorskip("material")
pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(folder)]
    run = subprocess.run(command, cwd=PROJECT, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    return folder


def test_every_rule_has_its_page(site: Path) -> None:
    registry = Registry.of()
    base = "/bringup-lint/"
    addresses = [urlparse(doc_of(rule).uri).path.removeprefix(base) for rule in registry.all()]
    assert addresses and [each for each in addresses if not (site / each / "index.html").is_file()] == []


def test_a_page_says_what_explain_says(site: Path) -> None:
    page = (site / "rules/systemd/network-target/index.html").read_text("utf-8")
    for expected in ("What it finds", "When to ignore it", "does not match an available interface", "guides/"):
        assert expected in page


def test_the_indexes_lead_to_the_rules(site: Path) -> None:
    lines = (site / "rules/log-lines/index.html").read_text("utf-8")
    assert "Start request repeated too quickly" in lines and "../systemd/restart-unlimited/" in lines
    files = (site / "rules/files/index.html").read_text("utf-8")
    assert "systemd-unit" in files and "../systemd/" in files


def test_every_key_of_the_configuration_is_described(site: Path) -> None:
    page = (site / "configuration/index.html").read_text("utf-8")
    for key in ("select", "per-file-ignores", "deploy", "purpose"):
        assert f'id="{key}"' in page


def test_links_to_rules_lead_to_their_pages(site: Path) -> None:
    page = (site / "guides/index.html").read_text("utf-8")
    assert "../rules/env/bashrc-only/" in page and "rules/env/bashrc_only.py" not in page


@pytest.fixture(scope="module")
def address(site: Path) -> Iterator[str]:
    """Of the site as a server gives it away: the search needs one."""
    handler = partial(Quiet, directory=str(site))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *arguments: object) -> None:
        pass


def test_the_filter_says_how_many_rows_it_shows(browser, address: str) -> None:
    tab = browser.new_page()
    tab.goto(f"{address}/rules/log-lines/")
    tab.fill(".filter", "start request repeated")
    shown = tab.locator("tbody tr:visible").count()
    assert shown and tab.inner_text(".filtered").startswith(f"{shown} of ")
    tab.fill(".filter", "")
    assert tab.inner_text(".filtered") == ""
    tab.close()


def test_a_line_that_is_pasted_is_searched(browser, address: str) -> None:
    """Pasted with the mouse: no key is pressed."""
    tab = browser.new_page()
    tab.goto(address)
    tab.click(".md-search__input")
    tab.fill(".md-search__input", "netplan")
    tab.wait_for_selector("text=matching documents", timeout=20_000)
    tab.fill(".md-search__input", "zzzzqq")
    tab.wait_for_selector("text=No matching documents", timeout=20_000)
    tab.close()
