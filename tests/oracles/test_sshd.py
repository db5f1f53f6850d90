"""sshd's own verdict on broken configurations: the same complaints at the same lines; and its effective values."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from random import Random

from bringup_lint.graph.host.sshd import effective
from bringup_lint.parsers.sshd import keywords
from bringup_lint.parsers.sshd import parse
from bringup_lint.source import Source
from bringup_lint.toml import read_toml
from tests.oracles import line_mutations as lines
from tests.oracles.answers import Oracle
from tests.oracles.sshd_server import sshd
from tests.oracles.sshd_server import sshd_folder
from tests.oracles.sshd_server import version

FOLDER = Path(__file__).parent
SEEDS = {path.name: path.read_text("utf-8") for path in sorted((FOLDER / "sshd").glob("*.conf"))}
WORDS = (FOLDER / "sshd/words.txt").read_text("utf-8").splitlines()
DIFFERENCES = read_toml((FOLDER / "differences" / "sshd.toml").read_text("utf-8"))["difference"]
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


def real(printed: str) -> tuple[list[tuple[str, int]], str]:
    """The complaints of ``sshd -t`` with their lines, up to the first that it stops at, and all that it prints."""
    found = []
    for line, message in re.findall(r"^config:? line (\d+): (.*)$", printed, re.M):
        code = next((code for code, pattern in CODES if re.search(pattern, message)), "bad-value")
        if code != "unsupported" and not (code == "not-in-match" and ("unknown-option", int(line)) in found):
            found.append((code, int(line)))
    return found, printed


def complaints(texts: list[str]) -> list[tuple[list[tuple[str, int]], str]]:
    with sshd_folder() as folder:
        return [real(sshd(folder, text, "-t").stderr.replace(f"{folder}/", "")) for text in texts]


def ours(text: str) -> list[list[str | int]]:
    file = parse(Source("sshd_config", text))
    in_match = {option.keyword.line for option in file.options if option.match and not option.match.always}
    found = []
    for problem in file.problems:
        found.append([problem.code, problem.where.line])
        if problem.code in STOPS or (problem.code == "unknown-option" and problem.where.line in in_match):
            break
    return found


def equals_sign(line: str, chance: Random) -> str:
    first, *rest = line.split() or [""]
    return f"{first}{chance.choice(('=', ' = ', '= '))}{' '.join(rest)}" if first else line


def new_line(chance: Random) -> str:
    keyword = chance.choice([known.name for known in keywords().values() if known.type != "match"])
    return f"{keyword} {chance.choice(WORDS)}"


ACTS = (
    lines.drop,
    lines.twice,
    lines.swap,
    lines.on_line(lines.cut),
    lines.on_line(lines.typo("aesx-_4 #=\"'\\")),
    lines.on_line(lines.another_word(WORDS)),
    lines.on_line(lines.another_word(WORDS)),
    lines.on_line(lines.another_directive(list(keywords()))),
    lines.on_line(equals_sign),
    lines.on_line(lambda line, chance: line.upper() if chance.random() < 0.5 else line.lower()),
    lines.before_line(new_line),
)


def test_broken_configurations(answers: Oracle) -> None:
    trials = lines.trials(SEEDS, ACTS, MUTANTS, (1, 1, 2))
    lines.judge(answers.of("sshd/configurations", version(), trials, complaints).pairs, ours, DIFFERENCES)


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
    "Port",
)
ALIKE = {"without-password": "prohibit-password", "all": "yes"}
INCLUDED = "PasswordAuthentication yes\nMatch User x\nMaxAuthTries 1\n"
INCLUDE = "Include first.conf\n"


def dumped(texts: list[str]) -> list[dict[str, str] | None]:
    """The effective values that ``sshd -T`` prints for each; None for a configuration that it refuses."""
    with sshd_folder() as folder:
        (folder / "first.conf").write_text(INCLUDED)
        (folder / "first.conf").chmod(0o644)
        return [_values(sshd(folder, text.replace(INCLUDE, f"Include {folder}/first.conf\n"), "-T")) for text in texts]


def _values(run: subprocess.CompletedProcess[str]) -> dict[str, str] | None:
    if run.returncode:
        return None
    pairs = (line.partition(" ") for line in run.stdout.splitlines())
    return {name: value for name, _, value in pairs if name in {known.lower() for known in CHECKED}}


def included(pattern: str) -> list[Source]:
    return [Source("first.conf", INCLUDED)] if "first" in pattern else []


def test_effective_values(answers: Oracle) -> None:
    trials = [
        f"{INCLUDE}{text}" if number % 3 == 0 else text
        for number, text in enumerate(lines.trials(SEEDS, ACTS, 60, (1, 1, 2)))
    ]
    checked = 0
    for text, theirs in answers.of("sshd/values", version(), trials, dumped).pairs:
        mine = effective(
            [Source("config", text)], lambda pattern: [Source("first", INCLUDED)] if "first" in pattern else []
        )
        for name in CHECKED if theirs else ():
            value = mine.get(name)
            if value is not None:
                got, want = theirs[name.lower()], str(value.value).lower()
                assert ALIKE.get(got, got) == ALIKE.get(want, want), (name, text)
                checked += 1
    assert checked > 100
