"""The page: everything of a report is in it, nothing of a tree gets out of its place, and nothing is loaded."""

from __future__ import annotations

import json
import re
from base64 import b64encode
from hashlib import sha256
from html import unescape
from html.parser import HTMLParser
from pathlib import Path

import pytest

from bringup_lint.finding import Finding
from bringup_lint.finding import Related
from bringup_lint.finding import Severity
from bringup_lint.report import Report
from bringup_lint.report.html import page
from bringup_lint.report.html.document import document
from bringup_lint.report.html.findings import articles
from bringup_lint.report.html.outline import outline
from bringup_lint.source import Source
from tests.report.html_picture import HOSTILE
from tests.report.html_picture import crowd
from tests.report.html_picture import hostile
from tests.report.html_picture import mower
from tests.report.sample import clean
from tests.report.sample import sample

EXPECTED = Path(__file__).parent / "expected"
VOID = {"meta", "link", "input", "br", "use", "path", "circle"}
PIECES = {
    "html_articles.html": lambda: articles(sample()),
    "html_outline.html": lambda: outline(document(mower(), None)) + "\n",
}


class Elements(HTMLParser):
    """Every start tag with its attributes; complains about what is closed wrongly."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.open: list[str] = []
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def data_of(text: str) -> dict:
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.DOTALL)[1])


def hostile_report() -> Report:
    source = Source(f"etc/{HOSTILE}", f"[Unit]\n{HOSTILE}\tAfter=x\n")
    place = Related(source.span(7, 12), HOSTILE)
    found = Finding(
        HOSTILE, source.span(7, 9), f"a/{HOSTILE}", Severity.ERROR, advice=HOSTILE, related=(place,), chain=(place,)
    )
    return Report((found,), root=f"/srv/{HOSTILE.replace('/', '')}")


PAGES = {
    "report": lambda: page(mower(), sample()),
    "clean": lambda: page(mower(), clean()),
    "findings": lambda: page({}, sample()),
    "picture": lambda: page(mower()),
    "nothing": lambda: page({}),
    "hostile": lambda: page(hostile(), hostile_report()),
    "hostile_picture": lambda: page(hostile()),
}


@pytest.mark.parametrize("name", PIECES)
def test_pieces(name: str, update_expected: bool) -> None:
    text = PIECES[name]()
    if update_expected:
        (EXPECTED / name).write_text(text, "utf-8")
    assert text == (EXPECTED / name).read_text("utf-8")


@pytest.mark.parametrize("name", PAGES)
def test_elements_are_closed_and_nothing_is_loaded(name: str) -> None:
    text = PAGES[name]()
    assert text.encode("utf-8").decode() == text
    for tag, attributes in Elements(text).found:
        assert not any(key.startswith("on") or key == "style" for key in attributes)
        assert tag not in ("img", "iframe", "object", "embed", "base")
        for key in ("src", "href", "action"):
            target = attributes.get(key) or "#"
            assert target.startswith("#") or (tag == "a" and target.startswith("https://")) or target == "data:,"


@pytest.mark.parametrize("name", PAGES)
def test_policy_allows_this_style_and_this_script_only(name: str) -> None:
    text = PAGES[name]()
    policy = next(attributes["content"] for tag, attributes in Elements(text).found if "http-equiv" in attributes)
    held = [re.search(f"<{tag}>(.*?)</{tag}>", text, re.DOTALL)[1] for tag in ("style", "script")]
    style, script = (f"'sha256-{b64encode(sha256(part.encode()).digest()).decode()}'" for part in held)
    assert policy == (
        f"default-src 'none'; img-src data:; style-src {style}; script-src {script}; "
        "base-uri 'none'; form-action 'none'"
    )


@pytest.mark.parametrize("name", ["hostile", "hostile_picture"])
def test_names_of_the_tree_stay_text(name: str) -> None:
    text = PAGES[name]()
    scripts = [attributes for tag, attributes in Elements(text).found if tag == "script"]
    assert scripts == [{"type": "application/json", "id": "data"}, {}]
    assert not {"\u2028", "\u202e", "\x1b"} & set(text)
    assert "<script>alert" not in text
    shown = data_of(text)["nodes"][0]["label"]
    assert shown == "</script><script>alert('1')</script>\"&]]>--!>\ufffd\ufffd␛[31m\ufffd${x}0"
    assert shown in unescape(text)


def test_findings_of_the_picture_are_those_of_the_report() -> None:
    text = page(mower(), sample())
    data = data_of(text)
    unit = next(node for node in data["nodes"] if node["label"] == "mower.service")
    rules = [data["findings"][index]["rule"] for index in unit["findings"]]
    assert rules == ["systemd/network-target", "systemd/root-user"]
    for index, told in enumerate(data["findings"]):
        held = re.search(rf'id="finding-{index}".*?</article>', text, re.DOTALL)[0]
        assert told["rule"] in held


def test_the_edge_to_a_node_that_is_not_drawn_is_left_out() -> None:
    picture = mower()
    picture["edges"].append({**picture["edges"][0], "target": "unit:gone.service"})
    assert len(document(picture, None)["edges"]) == len(mower()["edges"])


def test_the_same_picture_gives_the_same_page() -> None:
    assert page(crowd(60)) == page(crowd(60))


def test_what_is_empty_says_so() -> None:
    assert "Clear for bring-up" in articles(clean())
    assert "Nothing to check" in articles(clean(kinds={}))
    assert "No picture" in page({})


def test_a_page_of_many_nodes_stays_small() -> None:
    assert len(page(crowd(400))) < 400_000
