"""Netplan's own verdict on broken configurations: accepted or refused, and at which line."""

from __future__ import annotations

import os
import random
import re
import shutil
import subprocess
from collections.abc import Callable
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
from tests.oracles import line_mutations as lines
from tests.oracles.answers import Oracle

FOLDER = Path(__file__).parent
SEEDS = {path.name: path.read_text("utf-8") for path in sorted((FOLDER / "netplan").glob("*.yaml"))}
DIFFERENCES = read_toml((FOLDER / "differences" / "netplan.toml").read_text("utf-8"))["difference"]
MUTANTS = 130
"""For each seed."""
CORPUS = os.environ.get("BRINGUP_LINT_CORPUS", "")
WORDS = (FOLDER / "netplan/values.txt").read_text("utf-8").splitlines()
KEYS = (FOLDER / "netplan/keys.txt").read_text("utf-8").splitlines()
WARNING = re.compile(r"^\*\* \(generate:\d+\): WARNING .*$", re.M)
PLACE = re.compile(r"/(?P<file>[^/:\s]+):(?P<line>\d+):(?P<column>\d+): (?P<message>.*)")


GENERATORS = ("/usr/libexec/netplan/generate", "/usr/lib/netplan/generate", "/lib/netplan/generate")


@cache
def tool() -> str:
    """Such as ``netplan 0.106``; without the number where it is not installed."""
    if generator() is None or shutil.which("dpkg-query") is None:
        return "netplan"
    query = ["dpkg-query", "-W", "-f", "${Version}", "netplan.io"]
    version = subprocess.run(query, capture_output=True, text=True, check=False).stdout
    return f"netplan {version.partition('-')[0]}"


def generator() -> str | None:
    return next((path for path in GENERATORS if Path(path).exists()), None)


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
    command = [str(generator()), "--root-dir", str(folder)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    place = PLACE.search(run.stderr)
    if run.returncode == 0:
        return Verdict(True)
    if place is None:
        return Verdict(False, message=WARNING.sub("", run.stderr).strip())
    return Verdict(False, int(place["line"]), int(place["column"]), place["message"])


def verdicts(texts: list[str], folder: Path) -> list[Verdict]:
    return [real(text, folder) for text in texts]


def ours(text: str, version: str) -> tuple[list[Problem], NetplanFile]:
    """The problems of the same file for this version of netplan, in the order in which they were met."""
    file = parse(Source("etc/netplan/10.yaml", text, kind="netplan"))
    plan = merge([file], whole=True)
    newer = [problem for problem in file.newer if _number(problem.detail) > _number(version)]
    return [*file.problems, *newer, *plan.problems], file


def _number(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in re.findall(r"\d+", version))


def in_key(change: Callable[[str, random.Random], str]) -> lines.Act:
    """An act on the key of the line, where it has one."""
    return lines.on_line(lambda line, chance: KEY.sub(lambda found: change(found[0], chance), line, count=1))


def indent(line: str, chance: random.Random) -> str:
    return "  " + line if chance.random() < 0.5 else line.removeprefix("  ")


KEY = re.compile(r"[\w-]+(?=:( |$))")
VALUE = re.compile(r"(?<=: )[^{\[#]+$|(?<=- )[^{\[:#]+$")
another_value = lines.on_line(lambda line, chance: VALUE.sub(lambda found: chance.choice(WORDS), line, count=1))
ACTS = (
    lines.drop,
    lines.twice,
    lines.swap,
    lines.on_line(lines.cut),
    lines.on_line(indent),
    lines.on_line(lambda line, chance: line.replace("  ", "\t", 1)),
    lines.on_line(lambda line, chance: line.replace(":", "", 1)),
    in_key(lines.typo("aeix-_4")),
    in_key(lambda key, chance: chance.choice(KEYS)),
    another_value,
    another_value,
    another_value,
)


def same_place(verdict: Verdict, problems: list[Problem], file: NetplanFile) -> bool:
    """Whether a problem is on the line that netplan names, or inside the entry that begins there."""
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


def agrees(text: str, verdict: Verdict, version: str) -> bool:
    problems, file = ours(text, version)
    same = verdict.accepted != bool(problems) and (verdict.accepted or same_place(verdict, problems, file))
    return same or bool(reason(text, verdict, problems))


def test_broken_configurations(answers: Oracle, tmp_path: Path) -> None:
    trials = lines.trials(SEEDS, ACTS, MUTANTS, (1, 1, 1, 2), first=2)
    said = answers.of("netplan/configurations", tool(), trials, lambda texts: verdicts(texts, tmp_path / "root"))
    assert len(said.pairs) >= 400
    pairs = [(text, Verdict(*verdict)) for text, verdict in said.pairs]
    assert 0.3 < sum(not verdict.accepted for _, verdict in pairs) / len(pairs) < 0.9
    unexplained = [(text, verdict) for text, verdict in pairs if not agrees(text, verdict, said.version)]
    for text, verdict in unexplained:
        problems, _ = ours(text, said.version)
        print("=" * 20, verdict, [(p.code, p.where.line, p.detail) for p in problems], text, sep="\n")
    assert len(unexplained) <= len(pairs) // 100


@pytest.mark.corpus
@pytest.mark.skipif(tool() == "netplan", reason="needs netplan")
@pytest.mark.skipif(not CORPUS, reason="BRINGUP_LINT_CORPUS names no folder")
def test_files_of_the_corpus(tmp_path: Path) -> None:
    files = [path for path in sorted(Path(CORPUS).rglob("*.yaml")) if "netplan" in str(path)]
    texts = [path.read_text("utf-8") for path in files]
    version = tool().partition(" ")[2]
    wrong = [text for text in texts if not agrees(text, real(text, tmp_path / "root"), version)]
    assert len(files) >= 40
    assert wrong == []
