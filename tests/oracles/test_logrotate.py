"""logrotate's own complaints about bred configurations: the same ones, in the same order."""

from __future__ import annotations

import os
import random
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from bringup_lint.parsers.logrotate import directives
from bringup_lint.parsers.logrotate import parse
from bringup_lint.source import Source
from bringup_lint.toml import read_toml

FOLDER = Path(__file__).parent
SEEDS = {path.name: path.read_text("utf-8") for path in sorted((FOLDER / "logrotate").glob("*.conf"))}
WORDS = (FOLDER / "logrotate/words.txt").read_text("utf-8").splitlines()
DIFFERENCES = read_toml((FOLDER / "differences" / "logrotate.toml").read_text("utf-8"))["difference"]
CORPUS = os.environ.get("BRINGUP_LINT_CORPUS", "")
MUTANTS = 300
"""For each seed."""

CODES = (
    ("unknown-directive", r"unknown option"),
    ("not-separated", r"not properly separated"),
    ("argument-expected", r"argument expected after"),
    ("bad-number", r"bad (rotation count|start count|minimum age|maximum age|shred cycles)"),
    ("unknown-unit", r"unknown unit"),
    ("bad-size", r"bad size"),
    ("bad-weekday", r"bad weekly"),
    ("extra-arguments", r"extra arguments for"),
    ("su-incomplete", r"no (user|group) for su"),
    ("bad-address", r"bad mail address"),
    ("bad-path", r"bad \S+ path"),
    ("bad-options", r"invalid compression options"),
    ("global-only", r"may not appear inside"),
    ("unexpected-path", r"unexpected log filename"),
    ("missing-open-brace", r"missing previous '\{'|missing '\{' after"),
    ("bad-quotes", r"error parsing filename|\{ expected after"),
    ("duplicate-path", r"duplicate log entry"),
    ("unexpected-brace", r"unexpected \}$"),
    ("text-after-brace", r"unexpected text after \}"),
    ("bad-line-start", r"lines must begin with"),
    ("missing-endscript", r"without endscript"),
    ("unknown-name", r"unknown (user|group)"),
)

pytestmark = [
    pytest.mark.skipif(shutil.which("logrotate") is None, reason="needs logrotate"),
    pytest.mark.skipif(os.geteuid() != 0, reason="logrotate ignores files of others than root"),
]


def real(text: str, file: Path) -> tuple[list[str], list[str]]:
    """The codes of what ``logrotate -d`` complains about, and the lines as it prints them."""
    file.write_bytes(text.encode("utf-8"))
    file.chmod(0o644)
    run = subprocess.run(["logrotate", "-d", "-s", "/dev/null", str(file)], capture_output=True, check=False)
    printed = run.stderr.decode("utf-8", "replace").splitlines()
    said = [line for line in printed if line.startswith(f"error: {file}:")]
    return [next((code for code, pattern in CODES if re.search(pattern, line)), line) for line in said], said


def ours(text: str) -> list[str]:
    return [problem.code for problem in parse(Source("robot", text)).problems if problem.code != "unclosed"]


def mutants(seed: str) -> list[str]:
    """Broken and harmless variants of a seed, the same in every run."""
    chance = random.Random(seed)
    lines = SEEDS[seed].splitlines()
    found: dict[str, None] = {}
    while len(found) < MUTANTS:
        changed = list(lines)
        for _ in range(chance.choice((1, 1, 2, 3))):
            changed = mutate(changed, chance)
        found["\n".join(changed) + "\n"] = None
    return list(found)


def mutate(lines: list[str], chance: random.Random) -> list[str]:
    at = chance.randrange(len(lines))
    line = lines[at]
    words = line.split()
    act = chance.choice(
        ("drop", "twice", "swap", "cut", "typo", "value", "value", "directive", "insert", "indent", "brace")
    )
    if act == "drop":
        return lines[:at] + lines[at + 1 :]
    if act == "twice":
        return lines[: at + 1] + lines[at:]
    if act == "insert":
        return [*lines[:at], f"    {chance.choice(list(directives()))} {chance.choice(WORDS)}", *lines[at:]]
    if act == "swap":
        other = chance.randrange(len(lines))
        lines[at], lines[other] = lines[other], line
    elif act == "cut":
        lines[at] = line[: chance.randrange(len(line) + 1)]
    elif act == "indent":
        lines[at] = line.lstrip() if line.startswith(" ") else f"  {line}"
    elif act == "typo" and line:
        i = chance.randrange(len(line))
        lines[at] = line[:i] + chance.choice("aesx-_4 {}#=\"'\\\r") + line[i + chance.randrange(2) :]
    elif act == "value" and words:
        lines[at] = f"    {words[0]} {chance.choice(WORDS)}"
    elif act == "directive" and words:
        lines[at] = " ".join(["   ", chance.choice(list(directives())), *words[1:]])
    elif act == "brace":
        lines[at] = line.replace("{", "").replace("}", "") if {"{", "}"} & set(line) else line + chance.choice("{}")
    return lines


def reason(text: str, said: list[str]) -> str:
    """Why a difference is meant, by the table of differences."""
    for row in DIFFERENCES:
        if ("says" in row and any(re.search(row["says"], line) for line in said)) or (
            "text" in row and re.search(row["text"], text, re.M)
        ):
            return row["reason"]
    return ""


def test_bred_configurations(tmp_path: Path) -> None:
    trials = [text for seed in SEEDS for text in (SEEDS[seed], *mutants(seed))]
    assert len(trials) >= 400
    complained = 0
    unexplained = []
    for text in trials:
        codes, said = real(text, tmp_path / "robot")
        complained += bool(codes)
        if codes != ours(text) and not reason(text, said):
            unexplained.append((codes, ours(text), said, text))
    assert 0.3 < complained / len(trials) < 0.9
    for codes, mine, said, text in unexplained:
        print("=" * 20, codes, mine, *said, text, sep="\n")
    assert len(unexplained) <= len(trials) // 100


@pytest.mark.corpus
@pytest.mark.skipif(not CORPUS, reason="BRINGUP_LINT_CORPUS names no folder")
def test_files_of_the_corpus(tmp_path: Path) -> None:
    files = [path for path in sorted(Path(CORPUS).rglob("logrotate.d/*")) if path.is_file()]
    assert files
    for path in (*files, *Path("/etc/logrotate.d").glob("*")):
        text = path.read_text("utf-8")
        assert real(text, tmp_path / "robot")[0] == ours(text), path
