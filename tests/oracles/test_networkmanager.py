"""Profiles against NetworkManager itself: what `nmcli --offline connection modify` keeps of every key with many values.

Without nmcli the recorded answers of NetworkManager 1.42 (`networkmanager/answers.tsv`) stand for it.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest

from bringup_lint.facts import table
from bringup_lint.model.schema import Code
from bringup_lint.parsers.networkmanager import parse
from bringup_lint.source import Source

RECORDED = Path(__file__).parent / "networkmanager" / "answers.tsv"
VALUES = {
    "bool": ("true", "false", "1", "0", "yes", "no", "on", "maybe"),
    "int": ("5", "abc", "1x"),
    "address4": ("10.0.0.1/24", "10.0.0.300/24", "fe80::1/64", "10.0.0.1/33"),
    "address6": ("fd00::1/64", "10.0.0.1/24"),
    "addresses4": ("10.0.0.1;10.0.0.2;", "10.0.0.1,10.0.0.2", "robot"),
    "addresses6": ("fd00::1;", "10.0.0.1;"),
}
"""Right and wrong ones of each type; of an enum its words, and one that is none."""
TYPES = {"connection": "ethernet", "ipv4": "ethernet", "ipv6": "ethernet", "ethernet": "ethernet", "wifi": "wifi"}
"""The sections that are tried, with a type of connection that has them."""
MISTYPED = ("connection/autoconect", "ipv4/never-defualt", "wifi/bogus")


def trials() -> list[tuple[str, str]]:
    found = []
    for row in table("network/networkmanager"):
        section = row["path"].partition("/")[0]
        values = (*row["allowed"].split("|"), "bogus") if row["type"] == "enum" else VALUES.get(row["type"], ())
        if section in TYPES:
            found += [(row["path"], value) for value in values]
    return [*found, *((path, "true") for path in MISTYPED)]


def profile(path: str, value: str) -> str:
    section, _, key = path.partition("/")
    kind = TYPES[section]
    sections = {"connection": ["id=x", f"type={kind}"], kind: ["ssid=x"] if kind == "wifi" else []}
    sections.setdefault(section, []).append(f"{key}={value}")
    if section in ("ipv4", "ipv6") and key != "method":
        sections[section].append("method=auto")
    return "".join(f"[{name}]\n" + "".join(f"{line}\n" for line in lines) for name, lines in sections.items())


def real(path: str, value: str) -> str:
    """`refused`, or what nmcli writes instead of the profile, without its UUID."""
    command = ["nmcli", "--offline", "connection", "modify", "connection.zone", "home"]
    run = subprocess.run(
        command, input=profile(path, value), capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}
    )
    lines = [line for line in run.stdout.splitlines() if not line.startswith("uuid=")]
    return "refused" if run.returncode else " ".join(lines)


@cache
def answers() -> dict[tuple[str, str], str]:
    if shutil.which("nmcli"):
        empty = {section: real(f"{section}/nothing-of-this-name", "1") for section in TYPES}
        return {each: answer(*each, real(*each), empty) for each in trials()}
    rows = (line.split("\t") for line in RECORDED.read_text("utf-8").splitlines() if not line.startswith("#"))
    return {(path, value): said for path, value, said in rows}


def answer(path: str, value: str, said: str, empty: dict[str, str]) -> str:
    """`refused`, `dropped` when it makes no difference, else `kept`."""
    if said == "refused":
        return said
    return "dropped" if said == empty[path.partition("/")[0]] else "kept"


def ours(path: str, value: str) -> str:
    codes = {problem.code for problem in parse(Source("x.nmconnection", profile(path, value))).problems}
    if Code.ENUM in codes:
        return "refused"
    return "dropped" if codes else "kept"


DIFFERENCES = {
    ("ipv4/address", "10.0.0.1/33"): "a wrong prefix length counts as 24",
    ("ipv4/addresses", "10.0.0.1/33"): "a wrong prefix length counts as 24",
    ("ipv4/method", "manual"): "needs an address",
    ("ipv6/method", "manual"): "needs an address",
    ("wifi/mode", "mesh"): "needs a channel",
    ("ethernet/speed", "5"): "needs a duplex mode",
}


def agrees(path: str, value: str, said: str) -> bool:
    """Default values make no difference to nmcli; ranges of numbers are not judged."""
    own = ours(path, value)
    if own == "kept" and value == "5":
        return True
    default = value in ("true", "false", "1", "0", "auto")
    return own == said or (path, value) in DIFFERENCES or (said == "dropped" and default)


def test_values_are_judged_as_networkmanager_does() -> None:
    differing = [(*each, said, ours(*each)) for each, said in answers().items() if not agrees(*each, said)]
    assert not differing


@pytest.mark.skipif(not shutil.which("nmcli"), reason="nmcli is not installed")
def test_the_recorded_answers_are_those_of_nmcli(update_expected: bool) -> None:
    now = answers()
    if update_expected:
        RECORDED.parent.mkdir(exist_ok=True)
        head = "# Key, value, and what nmcli of NetworkManager 1.42 makes of a profile with them.\n"
        lines = (f"{path}\t{value}\t{said}\n" for (path, value), said in now.items())
        RECORDED.write_text(head + "".join(lines), "utf-8")
    version = subprocess.run(["nmcli", "--version"], capture_output=True, text=True).stdout
    if "1.42" in version:
        rows = (line.split("\t") for line in RECORDED.read_text("utf-8").splitlines() if not line.startswith("#"))
        assert now == {(path, value): said for path, value, said in rows}
