"""Cyclone DDS from PyPI accepts and rejects what bringup-lint says it does: every setting, slips in whole
files, the corpus."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from bringup_lint.discover.kinds import kind_of
from bringup_lint.facts import table
from bringup_lint.graph.dds.cyclonedds_discovery import PEER
from bringup_lint.graph.dds.cyclonedds_discovery import bad_addresses
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.parsers.cyclonedds import parse
from bringup_lint.parsers.cyclonedds_uri import split_uri
from bringup_lint.source import Source
from bringup_lint.toml import read_toml
from tests.oracles.answers import Oracle
from tests.oracles.cyclonedds_library import FEATURES
from tests.oracles.cyclonedds_library import VERSION
from tests.oracles.cyclonedds_library import Verdict
from tests.oracles.cyclonedds_library import ask
from tests.oracles.cyclonedds_library import is_installed
from tests.oracles.cyclonedds_library import tool
from tests.oracles.xml_mutations import mutants

FOLDER = Path(__file__).parent
DIFFERENCES = read_toml((FOLDER / "differences" / "cyclonedds.toml").read_text("utf-8"))["difference"]
MUTANTS = 400
"""For each seed."""
AGREEMENT = 0.97
"""Without what the table of differences explains."""
VALUES = [
    "true",
    "False",
    " TRUE",
    "no",
    "0",
    "1",
    "-1",
    "42",
    "65535",
    "65536",
    "2147483648",
    "4294967296",
    "1.5",
    "1e3",
    "0x10",
    "+7",
    "",
    "default",
    "auto",
    "none",
    "any",
    "10kB",
    "10 MB",
    "100KB",
    "3GB",
    "10ms",
    "5 s",
    "5sec",
    "2hr",
    "inf",
    "-5ms",
    "20us",
    "1day",
    "spdp",
    "spdp,asm",
    "asm,-spdp",
    "lax",
    "finest",
    "trace",
    "udp",
    "all",
    "always",
    "realtime",
    "8Mb/s",
    "x",
    "info",
    "config,data",
    "recv",
    "1,2",
    "1.5 kB",
    "5 ",
    "${UNSET}",
    "${UNSET:-true}",
    "${UNSET",
    "$UNSET",
]
NEEDED = {"Peer": ' Address="localhost"', "Thread": ' Name="recv"', "NetworkInterface": ' name="lo"'}
FILES_ARE_WRITTEN = ("OutputFile", "PacketCaptureFile")


def refusals(text: str, inline: bool) -> list[str]:
    """Why bringup-lint says that no participant can be created."""
    source = Source("a.xml", text)
    if inline:
        parts = list(split_uri(source.located(0, len(text))))
        codes = ["no-file" for part in parts if not part.inline]
        regions = [(part.text.span.start, part.text.span.end) for part in parts if part.inline]
        return codes + [code for region in regions for code in refusals_of(source, inline=True, region=region)]
    return refusals_of(source)


def refusals_of(source: Source, **options: object) -> list[str]:
    configuration = parse(source, VERSION, environment={}, features=FEATURES, **options)
    used = [domain for domain in configuration.domains if is_domain_0(domain)]
    remarks = [*configuration.remarks, *(remark for domain in used for remark in domain.remarks)]
    codes = [remark.code for remark in remarks if remark.fatal]
    peers = [setting for domain in used for setting in domain.all(PEER)]
    return codes + ["peer" for peer in peers if any(bad_addresses(peer))]


def is_domain_0(domain: Domain) -> bool:
    """Whether the library reads the block: it skips those of other domains."""
    text = (domain.id or "any").strip().removeprefix("+")
    return not (text.isdigit() and 0 < int(text) < (1 << 32) - 1)


def explained(verdict: Verdict) -> bool:
    return any(re.search(each["message"], verdict.message) for each in DIFFERENCES if "message" in each)


def compare(pairs: list[tuple[str, list]], inline: bool) -> None:
    """They agree, but for what is in the table of differences."""
    verdicts = [Verdict(*verdict) for _, verdict in pairs]
    judged = ((text, verdict, refusals(text, inline)) for (text, _), verdict in zip(pairs, verdicts))
    differing = [each for each in judged if each[1].accepted == bool(each[2])]
    wrong = [each for each in differing if not (explained(each[1]) and not each[2])]
    refused = sum(not verdict.accepted for verdict in verdicts)
    print(f"{len(pairs)} configurations, {refused} refused, {len(differing)} differ")
    for text, verdict, codes in wrong[:10]:
        print(f"--- {codes} / {verdict}\n{text[:600]}")
    assert not [each for each in wrong if each[2]], "refused by us alone"
    assert not wrong
    assert len(differing) <= max(len(pairs) * (1 - AGREEMENT), 2)


def setting(path: str, value: str) -> str:
    """The shortest configuration that sets one item."""
    path, _, attribute = path.partition("@")
    names = path.split("/")
    text = "" if attribute else value
    for number, name in enumerate(reversed(names)):
        needed = NEEDED.get(name, "")
        if attribute and number == 0:
            if attribute.lower() in needed.lower():
                needed = ""
            needed += f' {attribute}="{value}"'
        text = f"<{name}{needed}>{text}</{name}>"
    return text


def test_every_setting(answers: Oracle, tmp_path: Path) -> None:
    texts = [
        setting(row["path"], value)
        for row in table("dds/cyclonedds")
        if row["type"] != "ignored" and not row["path"].endswith(FILES_ARE_WRITTEN)
        for value in (VALUES if row["type"] not in ("group", "moved", "string") else ["x", "", "1"])
    ]
    compare(answers.of("cyclonedds/settings", tool(), texts, lambda texts: ask(texts, tmp_path)).pairs, inline=True)


@pytest.mark.parametrize("name", ["cyclonedds.xml", "cyclonedds_old.xml"])
def test_slips_in_files(name: str, answers: Oracle, tmp_path: Path) -> None:
    seed = (FOLDER / "dds" / name).read_text("utf-8")
    texts = [seed, *mutants(seed, VALUES, MUTANTS, seed=7)]
    record = f"cyclonedds/{name.removesuffix('.xml')}"
    compare(answers.of(record, tool(), texts, lambda texts: ask_files(texts, tmp_path)).pairs, inline=False)


def test_slips_inline(answers: Oracle, tmp_path: Path) -> None:
    seed = (FOLDER / "dds/cyclonedds.xml").read_text("utf-8").partition("-->\n")[2]
    texts = [text for text in mutants(seed, VALUES, MUTANTS, seed=8) if text.startswith("<") and "</>" not in text]
    compare(answers.of("cyclonedds/inline", tool(), texts, lambda texts: ask(texts, tmp_path)).pairs, inline=True)


@pytest.mark.corpus
@pytest.mark.skipif(not is_installed(), reason="needs pip install cyclonedds")
def test_corpus(corpus: Path, tmp_path: Path) -> None:
    texts = []
    for path in sorted(corpus.rglob("*.xml")):
        text = path.read_bytes().decode("utf-8", "replace")
        if kind_of(str(path), lambda text=text: text[:8192]) == "cyclonedds":
            texts.append(text)
    assert texts
    compare(list(zip(texts, ask_files(texts, tmp_path), strict=True)), inline=False)


def ask_files(texts: list[str], folder: Path) -> list[Verdict]:
    paths = [folder / f"{number}.xml" for number in range(len(texts))]
    for path, text in zip(paths, texts, strict=True):
        path.write_text(text, "utf-8")
    verdicts = ask([f"file://{path}" for path in paths], folder)
    return [
        Verdict(verdict.accepted, verdict.message.replace(str(path), "FILE"))
        for path, verdict in zip(paths, verdicts, strict=True)
    ]
