"""Fast DDS of the ROS wheels loads and drops what bringup-lint says it does: every element, slips in files,
the corpus, a node."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from bringup_lint.discover.kinds import kind_of
from bringup_lint.facts import table
from bringup_lint.model.schema import Item
from bringup_lint.parsers.fastdds import parse
from bringup_lint.parsers.fastdds_schema import schema
from bringup_lint.source import Source
from bringup_lint.toml import read_toml
from tests.oracles.answers import Oracle
from tests.oracles.fastdds_library import DROPPED
from tests.oracles.fastdds_library import LOADED
from tests.oracles.fastdds_library import PARTLY
from tests.oracles.fastdds_library import VERSION
from tests.oracles.fastdds_library import Verdict
from tests.oracles.fastdds_library import ask
from tests.oracles.fastdds_library import library
from tests.oracles.fastdds_library import start_node
from tests.oracles.fastdds_library import tool
from tests.oracles.xml_mutations import mutants

needs_library = pytest.mark.skipif(library() is None, reason="needs pip install 'ros-jazzy-rclpy[fastrtps]'")

FOLDER = Path(__file__).parent
DIFFERENCES = read_toml((FOLDER / "differences" / "fastdds.toml").read_text("utf-8"))["difference"]
SEED = (FOLDER / "dds/fastdds.xml").read_text("utf-8")
MUTANTS = 900
AGREEMENT = 0.95
"""Without what the table of differences explains."""
VALUES = [
    "true",
    "True",
    "false",
    "1",
    "0",
    "2",
    "-1",
    "yes",
    " true ",
    "4MB",
    "+5",
    "5 ",
    "0x10",
    "1.5",
    "70000",
    "300",
    "-40000",
    "5000000000",
    "abc",
    "RELIABLE",
    "reliable",
    "BEST_EFFORT",
    "DURATION_INFINITY",
    "10.0.0.300",
    "localhost",
    "127.0.0.1:80",
    "0a.0b",
    "zz",
    "239.255.0.1",
    "::1",
    "UDPv4",
    "udpv4",
    "CLIENT",
    "DYNAMIC",
    "${UNSET_HERE}",
]
STAND_INS = {
    "{LocatorList}": ("profiles/participant/rtps/builtin/initialPeersList", "<locator/>"),
    "{ExternalLocatorList}": (
        "profiles/participant/rtps/default_external_unicast_locators",
        "<udpv4><address>1.2.3.4</address><port>7</port></udpv4>",
    ),
    "{Duration}": ("profiles/participant/rtps/builtin/discovery_config/leaseDuration", "<sec>1</sec>"),
    "{ThreadSettings}": ("profiles/participant/rtps/timed_events_thread", ""),
    "{AllocationConfig}": ("profiles/participant/rtps/allocation/total_readers", ""),
    "{PropertyPolicy}": ("profiles/participant/rtps/propertiesPolicy", ""),
}
"""Where a shared structure is tried, and its shortest content."""


def verdict_of(text: str) -> int:
    profiles = parse(Source("a.xml", text), VERSION)
    codes = {remark.code for remark in profiles.remarks}
    if profiles.dropped:
        return DROPPED
    if not codes & {"profile-name", "profile-duplicate"}:
        return LOADED
    return PARTLY if profiles.transports or any(profile.name for profile in profiles.profiles) else DROPPED


def compare(pairs: list[tuple[str, list]]) -> None:
    """They agree, but for what is in the table of differences."""
    wrong = []
    differing = dropped = 0
    for text, answer in pairs:
        verdict = Verdict(*answer)
        dropped += verdict.result == DROPPED
        ours = verdict_of(text)
        if (ours == DROPPED) != (verdict.result == DROPPED):
            differing += 1
            if ours == DROPPED or not any(re.search(each["message"], verdict.message) for each in DIFFERENCES):
                wrong.append((text, verdict, ours))
    print(f"{len(pairs)} files, {dropped} dropped, {differing} differ, {len(wrong)} without a reason")
    for text, verdict, ours in wrong[:10]:
        print(f"--- ours {ours} / {verdict}\n{text[:500]}")
    assert not wrong
    assert differing <= len(pairs) * (1 - AGREEMENT)


def needed(item: Item, skip: str = "") -> str:
    """The attributes and elements without which an item is refused."""
    shape = schema(VERSION).inside(item)
    children = [child for name, child in shape.children.items() if child.required and name == child.name != skip]
    return "".join(element(child) for child in children)


def element(item: Item, content: str | None = None, extra: str = "") -> str:
    """An item with its content, the shortest that is taken when none is given."""
    attributes = "".join(f' {each.name}="{ATTRIBUTES.get(each.name, "x")}"' for each in item.attributes.values())
    if item.attributes and not any(each.required for each in item.attributes.values()):
        attributes = ""
    if item.name == "reception_thread":
        attributes = ' port="7"'
    if content is None:
        content = STAND_INS[item.type][1] if item.type in STAND_INS else needed(item) or CONTENT.get(item.type, "")
        content = SPECIAL.get(item.name, item.words[0] if item.words and item.type == "enum" else content)
    return f"<{item.name}{attributes}{extra}>{content}</{item.name}>"


ATTRIBUTES = {"prefix": "44.53.00.5f.45.50.52.4f.53.49.4d.41", "is_default_profile": "false"}
CONTENT = {
    **dict.fromkeys(("number", "natural", "positive", "uint8", "uint16", "int16", "atleast-1", "duration"), "5"),
    "bool": "true",
    "text": "x",
    "any": "x",
    "octets": "0a",
    "octets?": "0a",
    "guid": "44.53.00.5f.45.50.52.4f.53.49.4d.41",
    "address4": "127.0.0.1",
    "address6": "::1",
    "flags": "NO_FILTER",
}
SPECIAL = {"type": "UDPv4", "intraprocess_delivery": "OFF"}
TRANSPORT = (
    "<transport_descriptors><transport_descriptor><transport_id>x</transport_id><type>UDPv4</type>"
    "</transport_descriptor></transport_descriptors>"
)


def document(path: str, inner: str) -> str:
    """A file with an element inside the element at ``path``."""
    items = schema(VERSION).items
    root = path.partition("/")[0]
    if root in STAND_INS:
        path = STAND_INS[root][0] + path[len(root) :]
        return document_below(path, inner, root, STAND_INS[root][0])
    while path:
        item = items[path]
        name = inner.partition(">")[0].partition(" ")[0].strip("<")
        inner = element(item, needed(item, skip=name) + inner)
        path = path.rpartition("/")[0]
    return inner.replace("<profiles>", f"<profiles>{TRANSPORT}", 1) if "<userTransports>" in inner else inner


def document_below(path: str, inner: str, root: str, base: str) -> str:
    """The same inside a shared structure, whose items are under its own name."""
    items = schema(VERSION).items
    while path != base:
        item = items[root + path[len(base) :]]
        name = inner.partition(">")[0].partition(" ")[0].strip("<")
        inner = element(item, needed(item, skip=name) + inner)
        path = path.rpartition("/")[0]
    if root == "{ExternalLocatorList}" and "<address>" not in inner:
        inner = inner.replace("<port>", "<address>1.2.3.4</address><port>", 1)
    head = items[base]
    return document(base.rpartition("/")[0], f"<{head.name}>{inner}</{head.name}>")


def test_every_element(answers: Oracle, tmp_path: Path) -> None:
    texts = []
    for path, item in schema(VERSION).items.items():
        parent = path.rpartition("/")[0]
        if "@" in path or not parent or path.startswith("log"):
            # a log consumer would swallow the messages of the files after it
            continue
        leaf = item.type not in ("group", *STAND_INS)
        contents = [*VALUES, "", None] if leaf else ["", "text", needed(item) + "<bogus/>", None]
        texts += [document(parent, element(item, content)) for content in contents]
        texts.append(document(parent, element(item) + element(item)))
        texts.append(document(parent, element(item, extra=' bogus="1"')))
    assert len(texts) > 5000
    compare(answers.of("fastdds/elements", tool(), texts, lambda texts: ask(texts, tmp_path)).pairs)


def test_elements_of_other_versions_are_dropped(answers: Oracle, tmp_path: Path) -> None:
    known = schema(VERSION).items
    rows = [row for row in table("dds/fastdds") if row[VERSION] == "no" and "@" not in row["path"]]
    parents = [(row["path"].rpartition("/")[0], row["path"].rpartition("/")[2]) for row in rows]
    texts = [document(parent, f"<{name}/>") for parent, name in parents if parent in known]
    assert len(texts) > 10
    compare(answers.of("fastdds/versions", tool(), texts, lambda texts: ask(texts, tmp_path)).pairs)


def test_slips(answers: Oracle, tmp_path: Path) -> None:
    texts = [SEED, *mutants(SEED, VALUES, MUTANTS, seed=5)]
    compare(answers.of("fastdds/slips", tool(), texts, lambda texts: ask(texts, tmp_path)).pairs)


@pytest.mark.corpus
@needs_library
def test_corpus(corpus: Path, tmp_path: Path) -> None:
    texts = []
    for path in sorted(corpus.rglob("*.xml")):
        text = path.read_bytes().decode("utf-8", "replace")
        if kind_of(str(path), lambda text=text: text[:8192]) == "fastdds":
            texts.append(text)
    assert texts
    compare(list(zip(texts, ask(texts, tmp_path), strict=True)))


@needs_library
@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("", "", ""),
        ("<useBuiltinTransports>false", "<useBuiltinTransports>False", "getXMLBool XML_ERROR!"),
        ("<kind>RELIABLE", "<kind>reliable", "bad content"),
        (
            "<transport_id>lan</transport_id>\n          <transport_id>mem",
            "<transport_id>lam",
            "Transport Node not found",
        ),
        ("</dds>", "", "Error opening|Error parsing"),
        ("<name>robot</name>", "<name><!-- me -->robot</name>", "XML_ERROR!"),
    ],
)
def test_a_node_says_so_and_starts_all_the_same(old: str, new: str, message: str, tmp_path: Path) -> None:
    file = tmp_path / "fastdds.xml"
    file.write_text(SEED.replace(old, new, 1), "utf-8")
    code, output = start_node(file)
    assert code == 0 and "started" in output
    assert bool(re.search(message, output)) if message else "XMLPARSER Error" not in output
    assert parse(Source("a.xml", file.read_text("utf-8")), VERSION).dropped == bool(message)


@needs_library
def test_no_transport_stops_the_node(tmp_path: Path) -> None:
    file = tmp_path / "fastdds.xml"
    file.write_text(
        '<profiles><participant profile_name="a" is_default_profile="true"><rtps>'
        "<useBuiltinTransports>false</useBuiltinTransports></rtps></participant></profiles>"
    )
    code, _ = start_node(file)
    assert code != 0
