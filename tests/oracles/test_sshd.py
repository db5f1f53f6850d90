"""sshd's own verdict on bred configurations: the same complaints at the same lines; and its effective values."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from random import Random

import pytest

from bringup_lint.graph.host.sshd import effective
from bringup_lint.parsers.sshd import keywords
from bringup_lint.parsers.sshd import parse
from bringup_lint.source import Source
from bringup_lint.toml import read_toml
from tests.oracles import line_mutations as bred

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


def another_value(line: str, chance: Random) -> str:
    return f"{line.split()[0]} {chance.choice(WORDS)}" if line.split() else line


def another_keyword(line: str, chance: Random) -> str:
    return " ".join([chance.choice(list(keywords())), *line.split()[1:]]) if line.split() else line


def equals_sign(line: str, chance: Random) -> str:
    first, *rest = line.split() or [""]
    return f"{first}{chance.choice(('=', ' = ', '= '))}{' '.join(rest)}" if first else line


def new_line(chance: Random) -> str:
    keyword = chance.choice([known.name for known in keywords().values() if known.kind != "match"])
    return f"{keyword} {chance.choice(WORDS)}"


ACTS = (
    bred.drop,
    bred.twice,
    bred.swap,
    bred.on_line(bred.cut),
    bred.on_line(bred.typo("aesx-_4 #=\"'\\")),
    bred.on_line(another_value),
    bred.on_line(another_value),
    bred.on_line(another_keyword),
    bred.on_line(equals_sign),
    bred.on_line(lambda line, chance: line.upper() if chance.random() < 0.5 else line.lower()),
    bred.before_line(new_line),
)


def mutants(seed: str, count: int = MUTANTS) -> Iterator[str]:
    return bred.mutants(seed, SEEDS[seed], ACTS, count, (1, 1, 2))


def test_bred_configurations(tmp_path: Path) -> None:
    trials = [text for seed in SEEDS for text in (SEEDS[seed], *mutants(seed))]
    bred.hold_against(trials, lambda text: real(text, tmp_path / "robot_config"), ours, DIFFERENCES)


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
        for number, text in enumerate((SEEDS[seed], *mutants(seed, 60))):
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
