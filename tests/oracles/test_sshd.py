"""sshd's own verdict on bred configurations: the same complaints at the same lines; and its effective values."""

from __future__ import annotations

import os
import random
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from bringup_lint.graph.host.sshd import effective
from bringup_lint.parsers.sshd import keywords
from bringup_lint.parsers.sshd import parse
from bringup_lint.source import Source
from bringup_lint.toml import read_toml

FOLDER = Path(__file__).parent
SEEDS = {path.name: path.read_text("utf-8") for path in sorted((FOLDER / "sshd").glob("*.conf"))}
WORDS = (FOLDER / "sshd/words.txt").read_text("utf-8").splitlines()
DIFFERENCES = read_toml((FOLDER / "differences" / "sshd.toml").read_text("utf-8"))["difference"]
SSHD = shutil.which("sshd", path=f"{os.environ.get('PATH', '')}:/usr/sbin:/sbin")
MUTANTS = 260
"""For each seed."""
CODES = (
    ("unknown-option", r"Bad configuration option"),
    ("not-in-match", r"not allowed within a Match"),
    ("no-argument", r"no argument after keyword"),
    ("invalid-quotes", r"invalid quotes"),
    ("extra-arguments", r"extra arguments at end of line"),
    ("bad-match", r"Bad Match condition"),
    ("duplicate-subsystem", r"already defined"),
    ("deprecated", r"Deprecated option"),
    ("unsupported", r"Unsupported option"),
)
STOPS = ("bad-value", "not-in-match", "bad-match", "duplicate-subsystem")
"""What sshd stops at; the others it counts and goes on."""

pytestmark = pytest.mark.skipif(SSHD is None, reason="needs sshd")


def real(text: str, file: Path) -> tuple[list[tuple[str, int]], str]:
    """The complaints of ``sshd -t`` with their lines, up to the first that it stops at, and all that it prints."""
    file.write_bytes(text.encode("utf-8"))
    run = subprocess.run([SSHD, "-t", "-f", str(file)], capture_output=True, check=False)
    printed = run.stderr.decode("utf-8", "replace")
    found = []
    for line, message in re.findall(rf"^{re.escape(str(file))}:? line (\d+): (.*)$", printed, re.M):
        code = next((code for code, pattern in CODES if re.search(pattern, message)), "bad-value")
        if code != "unsupported" and not (code == "not-in-match" and ("unknown-option", int(line)) in found):
            found.append((code, int(line)))
    return found, printed


def ours(text: str) -> list[tuple[str, int]]:
    file = parse(Source("sshd_config", text))
    in_match = {option.keyword.line for option in file.options if option.match and not option.match.always}
    found = []
    for problem in file.problems:
        found.append((problem.code, problem.where.line))
        if problem.code in STOPS or (problem.code == "unknown-option" and problem.where.line in in_match):
            break
    return found


def mutants(seed: str) -> list[str]:
    """Broken and harmless variants of a seed, the same in every run."""
    chance = random.Random(seed)
    lines = SEEDS[seed].splitlines()
    found: dict[str, None] = {}
    while len(found) < MUTANTS:
        changed = list(lines)
        for _ in range(chance.choice((1, 1, 2))):
            changed = mutate(changed, chance)
        found["\n".join(changed) + "\n"] = None
    return list(found)


def mutate(lines: list[str], chance: random.Random) -> list[str]:
    at = chance.randrange(len(lines))
    line = lines[at]
    words = line.split()
    act = chance.choice(
        ("drop", "twice", "swap", "cut", "typo", "value", "value", "keyword", "insert", "equals", "case")
    )
    if act == "drop":
        return lines[:at] + lines[at + 1 :]
    if act == "twice":
        return lines[: at + 1] + lines[at:]
    if act == "insert":
        keyword = chance.choice([known.name for known in keywords().values() if known.kind != "match"])
        return [*lines[:at], f"{keyword} {chance.choice(WORDS)}", *lines[at:]]
    if act == "swap":
        other = chance.randrange(len(lines))
        lines[at], lines[other] = lines[other], line
    elif act == "cut":
        lines[at] = line[: chance.randrange(len(line) + 1)]
    elif act == "typo" and line:
        i = chance.randrange(len(line))
        lines[at] = line[:i] + chance.choice("aesx-_4 #=\"'\\") + line[i + chance.randrange(2) :]
    elif act == "value" and words:
        lines[at] = f"{words[0]} {chance.choice(WORDS)}"
    elif act == "keyword" and words:
        lines[at] = " ".join([chance.choice(list(keywords())), *words[1:]])
    elif act == "equals" and words:
        lines[at] = f"{words[0]}{chance.choice(('=', ' = ', '= '))}{' '.join(words[1:])}"
    elif act == "case":
        lines[at] = line.upper() if chance.random() < 0.5 else line.lower()
    return lines


def reason(text: str, printed: str) -> str:
    """Why a difference is meant, by the table of differences."""
    for row in DIFFERENCES:
        if ("says" in row and re.search(row["says"], printed)) or ("text" in row and re.search(row["text"], text)):
            return row["reason"]
    return ""


def test_bred_configurations(tmp_path: Path) -> None:
    trials = [text for seed in SEEDS for text in (SEEDS[seed], *mutants(seed))]
    assert len(trials) >= 400
    complained = 0
    unexplained = []
    for text in trials:
        theirs, printed = real(text, tmp_path / "robot_config")
        complained += bool(theirs)
        if theirs != ours(text) and not reason(text, printed):
            unexplained.append((theirs, ours(text), printed, text))
    assert 0.3 < complained / len(trials) < 0.9
    for theirs, mine, printed, text in unexplained:
        print("=" * 20, theirs, mine, printed, text, sep="\n")
    assert len(unexplained) <= len(trials) // 100


def dumped(file: Path, *more: str) -> dict[str, str] | None:
    """The effective values that ``sshd -T`` prints; None when it cannot run here."""
    run = subprocess.run([SSHD, "-T", "-f", str(file), *more], capture_output=True, text=True, check=False)
    if run.returncode:
        return None
    return {line.partition(" ")[0]: line.partition(" ")[2] for line in run.stdout.splitlines()}


CHECKED = (
    "PasswordAuthentication",
    "KbdInteractiveAuthentication",
    "PermitRootLogin",
    "PermitEmptyPasswords",
    "UsePAM",
    "X11Forwarding",
    "AllowTcpForwarding",
    "PermitTunnel",
    "MaxAuthTries",
    "ClientAliveInterval",
    "Port",
)


def test_effective_values(tmp_path: Path) -> None:
    (tmp_path / "first.conf").write_text("PasswordAuthentication yes\nMatch User x\nMaxAuthTries 1\n")
    file = tmp_path / "config"
    file.write_text("Port 22\n")
    if dumped(file) is None:
        pytest.skip("sshd -T needs host keys and /run/sshd")
    checked = 0
    for seed in SEEDS:
        for number, text in enumerate((SEEDS[seed], *mutants(seed)[:60])):
            text = f"Include {tmp_path}/first.conf\n{text}" if number % 3 == 0 else text
            file.write_text(text)
            theirs = dumped(file)
            if theirs is None:
                continue
            source = Source("config", text)
            mine = effective(
                [source],
                lambda pattern: [Source("first", (tmp_path / "first.conf").read_text())] if "first" in pattern else [],
            )
            for name in CHECKED:
                value = mine.get(name)
                if value is not None and name not in ("ClientAliveInterval",):
                    alike = {"without-password": "prohibit-password", "all": "yes"}
                    got, want = theirs[name.lower()], str(value.value).lower()
                    assert alike.get(got, got) == alike.get(want, want), (name, text)
                    checked += 1
    assert checked > 100
