"""Netplan's own verdict on bred configurations: accepted or refused, and at which line."""

from __future__ import annotations

import os
import random
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

from bringup_lint.graph.netplan.netplan import merge
from bringup_lint.model.netplan import NetplanFile
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.parsers.netplan import parse
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.toml import read_toml

FOLDER = Path(__file__).parent
SEEDS = {path.name: path.read_text("utf-8") for path in sorted((FOLDER / "netplan").glob("*.yaml"))}
DIFFERENCES = read_toml((FOLDER / "differences" / "netplan.toml").read_text("utf-8"))["difference"]
MUTANTS = 130
"""For each seed."""
CORPUS = os.environ.get("BRINGUP_LINT_CORPUS", "")
WORDS = (FOLDER / "netplan/values.txt").read_text("utf-8").splitlines()
KEYS = (FOLDER / "netplan/keys.txt").read_text("utf-8").splitlines()
PLACE = re.compile(r"/(?P<file>[^/:\s]+):(?P<line>\d+):(?P<column>\d+): (?P<message>.*)")


@cache
def generator() -> tuple[str | None, tuple[int, ...]]:
    """The path of netplan's generator, and its version."""
    paths = ("/usr/libexec/netplan/generate", "/usr/lib/netplan/generate", "/lib/netplan/generate")
    found = next((path for path in paths if Path(path).exists()), None)
    if found is None or shutil.which("dpkg-query") is None:
        return None, ()
    query = ["dpkg-query", "-W", "-f", "${Version}", "netplan.io"]
    version = subprocess.run(query, capture_output=True, text=True, check=False).stdout
    return found, tuple(int(number) for number in re.findall(r"\d+", version.partition("-")[0]))


pytestmark = pytest.mark.skipif(generator()[0] is None, reason="needs netplan")


class Verdict(NamedTuple):
    accepted: bool
    line: int = 0
    column: int = 0
    message: str = ""


def real(text: str, folder: Path) -> Verdict:
    """What ``netplan generate`` says to a configuration of this one file."""
    shutil.rmtree(folder, ignore_errors=True)
    file = folder / "etc/netplan/10.yaml"
    file.parent.mkdir(parents=True)
    file.write_bytes(text.encode("utf-8"))
    file.chmod(0o600)
    command = [generator()[0], "--root-dir", str(folder)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    place = PLACE.search(run.stderr)
    if run.returncode == 0:
        return Verdict(True)
    if place is None:
        return Verdict(False, message=run.stderr.strip())
    return Verdict(False, int(place["line"]), int(place["column"]), place["message"])


def ours(text: str) -> tuple[list[Problem], NetplanFile]:
    """The problems of the same file for the installed netplan, in the order in which they were met."""
    file = parse(Source("etc/netplan/10.yaml", text, kind="netplan"))
    plan = merge([file], whole=True)
    release = generator()[1]
    newer = [problem for problem in file.newer if _number(problem.detail) > release]
    return [*file.problems, *newer, *plan.problems], file


def _number(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split("."))


def mutants(seed: str) -> list[str]:
    """Broken and harmless variants of a seed, the same in every run."""
    chance = random.Random(seed)
    lines = SEEDS[seed].splitlines()
    found = {}
    while len(found) < MUTANTS:
        changed = list(lines)
        for _ in range(chance.choice((1, 1, 1, 2))):
            changed = mutate(changed, chance)
        found["\n".join(changed) + "\n"] = None
    return list(found)


def mutate(lines: list[str], chance: random.Random) -> list[str]:
    at = chance.randrange(2, len(lines))
    line = lines[at]
    key = re.search(r"[\w-]+(?=:( |$))", line)
    value = re.search(r"(?<=: )[^{\[#]+$|(?<=- )[^{\[:#]+$", line)
    act = chance.choice(
        ("drop", "twice", "indent", "tab", "typo", "key", "value", "value", "value", "colon", "swap", "cut")
    )
    if act == "drop":
        return lines[:at] + lines[at + 1 :]
    if act == "twice":
        return lines[: at + 1] + lines[at:]
    if act == "swap":
        other = chance.randrange(2, len(lines))
        lines[at], lines[other] = lines[other], line
    elif act == "indent":
        lines[at] = "  " + line if chance.random() < 0.5 else line[2:] if line.startswith("  ") else line
    elif act == "tab":
        lines[at] = line.replace("  ", "\t", 1)
    elif act == "colon":
        lines[at] = line.replace(":", "", 1)
    elif act == "cut":
        lines[at] = line[: chance.randrange(len(line) + 1)]
    elif act == "typo" and key:
        i = chance.randrange(key.start(), key.end())
        lines[at] = line[:i] + chance.choice("aeix-_4") + line[i + chance.randrange(2) :]
    elif act == "key" and key:
        lines[at] = line[: key.start()] + chance.choice(KEYS) + line[key.end() :]
    elif act == "value" and value:
        lines[at] = line[: value.start()] + chance.choice(WORDS)
    return lines


def same_place(verdict: Verdict, problems: list[Problem], file: NetplanFile) -> bool:
    """Whether a problem stands on the line that netplan names, or inside the entry that begins there."""
    if not verdict.line or any(problem.where.line == verdict.line for problem in problems):
        return True
    start = file.source.line_starts[min(verdict.line, len(file.source.line_starts)) - 1] + verdict.column - 1
    spots = [problem.where if isinstance(problem.where, Span) else problem.where.span for problem in problems]
    entries = [(node.span, node.span) for node in file.yaml.nodes if node.span.start == start]
    for node in file.yaml.nodes:
        if isinstance(node, Mapping):
            entries += [(key.span, value.span) for key, value in node.pairs if value.span.start == start]
    return any(first.start <= spot.start <= last.end for first, last in entries for spot in spots)


def reason(text: str, verdict: Verdict, problems: list[Problem]) -> str:
    """Why a difference is meant, by the table of differences."""
    for row in DIFFERENCES:
        said = verdict.message if not verdict.accepted else ""
        if ("netplan" in row and re.search(row["netplan"], said)) or (
            "ours" in row and any(re.search(row["ours"], f"{p.code} {p.detail}") for p in problems)
        ):
            return row["reason"]
    return ""


def test_bred_configurations(tmp_path: Path) -> None:
    trials = [(seed, text) for seed in SEEDS for text in (SEEDS[seed], *mutants(seed))]
    assert len(trials) >= 400
    refused = 0
    unexplained = []
    for seed, text in trials:
        verdict = real(text, tmp_path / "root")
        problems, file = ours(text)
        refused += not verdict.accepted
        agrees = verdict.accepted != bool(problems) and (verdict.accepted or same_place(verdict, problems, file))
        if not agrees and not reason(text, verdict, problems):
            unexplained.append((seed, verdict, problems, text))
    assert 0.3 < refused / len(trials) < 0.9
    for seed, verdict, problems, text in unexplained:
        print("=" * 20, seed, verdict, [(p.code, p.where.line, p.detail) for p in problems], text, sep="\n")
    assert len(unexplained) <= len(trials) // 100


@pytest.mark.corpus
@pytest.mark.skipif(not CORPUS, reason="BRINGUP_LINT_CORPUS names no folder")
def test_files_of_the_corpus(tmp_path: Path) -> None:
    files = [path for path in sorted(Path(CORPUS).rglob("*.yaml")) if "netplan" in str(path)]
    different = []
    for path in files:
        text = path.read_text("utf-8")
        verdict = real(text, tmp_path / "root")
        problems, file = ours(text)
        agrees = verdict.accepted != bool(problems) and (verdict.accepted or same_place(verdict, problems, file))
        if not agrees and not reason(text, verdict, problems):
            different.append((path.name, verdict))
    assert len(files) >= 40
    assert different == []
