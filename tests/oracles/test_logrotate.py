"""logrotate's own complaints about broken configurations: the same ones, in the same order."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path
from random import Random

import pytest

from bringup_lint.parsers.logrotate import directives
from bringup_lint.parsers.logrotate import parse
from bringup_lint.source import Source
from bringup_lint.toml import read_toml
from tests.oracles import line_mutations as lines
from tests.oracles.answers import Oracle

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


def tool() -> str:
    """Such as ``logrotate 3.21.0``; logrotate ignores the files of others than root."""
    if shutil.which("logrotate") is None or os.geteuid() != 0:
        return "logrotate"
    run = subprocess.run(["logrotate", "--version"], capture_output=True, text=True, check=False)
    return " ".join((run.stdout + run.stderr).split()[:2])


def real(text: str, file: Path) -> tuple[list[str], str]:
    """The codes of what ``logrotate -d`` complains about, and the lines as it prints them."""
    file.write_bytes(text.encode("utf-8"))
    file.chmod(0o644)
    run = subprocess.run(["logrotate", "-d", "-s", "/dev/null", str(file)], capture_output=True, check=False)
    printed = run.stderr.decode("utf-8", "replace").replace(str(file), file.name).splitlines()
    said = [line for line in printed if line.startswith(f"error: {file.name}:")]
    codes = [next((code for code, pattern in CODES if re.search(pattern, line)), line) for line in said]
    return codes, "\n".join(said)


def ours(text: str) -> list[str]:
    return [problem.code for problem in parse(Source("robot", text)).problems if problem.code != "unclosed"]


def another_brace(line: str, chance: Random) -> str:
    return line.replace("{", "").replace("}", "") if {"{", "}"} & set(line) else line + chance.choice("{}")


ACTS = (
    lines.drop,
    lines.twice,
    lines.swap,
    lines.on_line(lines.cut),
    lines.on_line(lines.typo("aesx-_4 {}#=\"'\\\r")),
    lines.on_line(lines.another_word(WORDS, "    ")),
    lines.on_line(lines.another_word(WORDS, "    ")),
    lines.on_line(lines.another_directive(list(directives()), "    ")),
    lines.on_line(another_brace),
    lines.on_line(lambda line, chance: line.lstrip() if line.startswith(" ") else f"  {line}"),
    lines.before_line(lambda chance: f"    {chance.choice(list(directives()))} {chance.choice(WORDS)}"),
)


def test_broken_configurations(answers: Oracle, tmp_path: Path) -> None:
    trials = lines.trials(SEEDS, ACTS, MUTANTS, (1, 1, 2, 3))
    said = answers.of(
        "logrotate/configurations", tool(), trials, lambda texts: [real(text, tmp_path / "robot") for text in texts]
    )
    lines.judge(said.pairs, ours, DIFFERENCES)


@pytest.mark.corpus
@pytest.mark.skipif(tool() == "logrotate", reason="needs logrotate, and root")
@pytest.mark.skipif(not CORPUS, reason="BRINGUP_LINT_CORPUS names no folder")
def test_files_of_the_corpus(tmp_path: Path) -> None:
    files = [path for path in sorted(Path(CORPUS).rglob("logrotate.d/*")) if path.is_file()]
    assert files
    for path in (*files, *Path("/etc/logrotate.d").glob("*")):
        text = path.read_text("utf-8")
        assert real(text, tmp_path / "robot")[0] == ours(text), path
