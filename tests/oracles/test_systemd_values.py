"""Every value grammar against the real systemd: good and broken values, accepted or refused line by line."""

from __future__ import annotations

import random
import re
import subprocess
from pathlib import Path
from typing import NamedTuple

import pytest

from bringup_lint.facts.systemd import directives
from bringup_lint.parsers.systemd_values import nowhere
from bringup_lint.parsers.systemd_values import parse_timespan
from bringup_lint.parsers.systemd_values.calendar import is_calendar
from bringup_lint.parsers.systemd_values.grammars import check
from bringup_lint.toml import read_toml
from tests.oracles.answers import Oracle
from tests.oracles.verify import systemd
from tests.oracles.verify import systemd_version
from tests.oracles.verify import verify

FOLDER = Path(__file__).parent
SEEDS: dict[str, list[str]] = read_toml((FOLDER / "systemd_values.toml").read_text("utf-8"))
DIFFERENCES = read_toml((FOLDER / "differences" / "systemd_values.toml").read_text("utf-8"))["difference"]
ALPHABET = "aZ019 .:-+/%,;#~=\"'\\@_!"
MUTANTS = 50
SINGLE = {
    "command",
    "user",
    "users",
    "working-directory",
    "path-fatal",
    "label",
    "trigger-unit",
    "slice",
    "service-unit",
    "pid-file",
}
"""Types whose wrong values can stop the whole file, or that may be only once in it."""
HEAD = {
    "Unit": "[Unit]\n",
    "Service": "[Service]\nType=oneshot\nExecStart=/bin/true\n",
    "Socket": "[Socket]\nListenStream=/run/x\n",
    "Timer": "[Timer]\nOnBootSec=1\n",
}
SECTIONS = ("Unit", "Service", "Socket", "Timer", "Path", "Mount", "Automount", "Swap")
AVOIDED = {"OnFailureIsolate", "PermissionsStartOnly", "Delegate"}


class Trial(NamedTuple):
    kind: str
    section: str
    key: str
    value: str


class Said(NamedTuple):
    about_line: list[str]
    fatal: bool
    """The unit is not loaded."""


def values(kind: str) -> list[str]:
    """The seeds of a type and mutants of them, the same in every run."""
    chance = random.Random(kind)
    found = {seed.strip(): None for seed in SEEDS[kind] if not seed.endswith("\\")}
    seeds = SEEDS[kind]
    for _ in range(MUTANTS):
        value = chance.choice(seeds)
        for _ in range(chance.choice((1, 1, 2))):
            at = chance.randrange(len(value) + 1)
            act = chance.randrange(4)
            letter = chance.choice(ALPHABET + "".join(seeds))
            if act == 0:
                value = value[:at] + letter + value[at:]
            elif act == 1:
                value = value[:at] + value[at + 1 :]
            elif act == 2:
                value = value[:at] + letter + value[at + 1 :]
            else:
                other = chance.choice(seeds)
                value = value[:at] + other[chance.randrange(len(other) + 1) :]
        value = value.strip()
        if value and not value.endswith("\\"):
            found[value] = None
    return list(found)


def key_for(kind: str) -> directives.Directive | None:
    """A key of this type that the installed systemd knows and that is not obsolete."""
    for section in SECTIONS:
        for found in directives.of_section(section):
            old = (section, found.key, "") in directives.legacy() or found.key in AVOIDED
            if found.type == kind and found.since <= systemd_version() and not old:
                return found
    return None


def suffix(section: str) -> str:
    return "service" if section == "Unit" else section.lower()


def trials() -> list[Trial]:
    keys = ((kind, key_for(kind)) for kind in SEEDS)
    return [Trial(kind, key.section, key.key, value) for kind, key in keys if key for value in values(kind)]


def ask(trials: list[Trial], folder: Path) -> list[Said]:
    """Values that can stop a unit are in a file of their own, the others of a section share one."""
    asked = [Trial(*each) for each in trials]
    texts: dict[str, str] = {}
    places = []
    for number, trial in enumerate(asked):
        alone = trial.kind in SINGLE
        name = f"{f't{number}' if alone else f'all-{trial.section.lower()}'}.{suffix(trial.section)}"
        text = texts.setdefault(name, HEAD[trial.section] if alone else f"[{trial.section}]\n")
        places.append((name, text.count("\n") + 1))
        texts[name] = f"{text}{trial.key}={trial.value}\n"
    for name, text in texts.items():
        (folder / name).write_text(text, "utf-8")
    said = verify([folder / name for name in texts], recursive="one")
    return [
        Said(said.about(folder / name, line), trial.kind in SINGLE and said.fatal(name))
        for trial, (name, line) in zip(asked, places, strict=True)
    ]


def differs(trial: Trial, said: Said, version: int) -> str:
    """What we say otherwise than systemd; empty where we agree."""
    real = [text for text in said.about_line if "please use" not in text]
    problems = [p for p in check(trial.kind, nowhere(trial.value), version) if p.code != "odd-name"]
    same = bool(real) == bool(problems)
    if same and trial.kind in SINGLE and problems:
        same = said.fatal == any(problem.effect == "unit" for problem in problems)
    return "" if same else f"{trial.kind}: {trial.value!r} real={real} ours={[problem.code for problem in problems]}"


def excused(kind: str, value: str) -> bool:
    return any(row["type"] in (kind, "*") and re.search(row["value"], value) for row in DIFFERENCES)


def test_systemd_refuses_what_the_grammars_refuse(answers: Oracle, tmp_path: Path) -> None:
    given = answers.of("systemd/values", systemd(), trials(), lambda each: ask(each, tmp_path))
    assert len(given.pairs) > 3000
    pairs = [(Trial(*trial), Said(*said)) for trial, said in given.pairs]
    differences = [(trial, differs(trial, said, int(given.version))) for trial, said in pairs]
    wrong = [(trial, text) for trial, text in differences if text]
    assert not [text for trial, text in wrong if not excused(trial.kind, trial.value)]
    assert len(wrong) < len(pairs) / 100, wrong


def accepted(tool: str, values: list[str]) -> list[bool]:
    commands = (["systemd-analyze", tool, "--", value] for value in values)
    return [subprocess.run(each, capture_output=True, env={"TZ": "UTC"}).returncode == 0 for each in commands]


@pytest.mark.parametrize("kind", ["timespan", "calendar"])
def test_time_spans_and_calendar_events(kind: str, answers: Oracle) -> None:
    reads = {"timespan": lambda text: parse_timespan(text) is not None, "calendar": is_calendar}[kind]
    given = answers.of(f"systemd/{kind}", systemd(), values(kind), lambda texts: accepted(kind, texts))
    assert not [value for value, real in given.pairs if real != reads(value) and not excused(kind, value)]
