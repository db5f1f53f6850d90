"""Every value grammar against the real systemd: bred values, accepted or refused line by line."""

from __future__ import annotations

import random
import re
import subprocess
from collections import defaultdict
from pathlib import Path
from typing import NamedTuple

import pytest

from bringup_lint.facts.systemd import directives
from bringup_lint.parsers.systemd_values import nowhere
from bringup_lint.parsers.systemd_values import parse_timespan
from bringup_lint.parsers.systemd_values.calendar import is_calendar
from bringup_lint.parsers.systemd_values.grammars import check
from bringup_lint.toml import read_toml
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
"""Types whose wrong values can stop the whole file, or that may stand only once in it."""
HEAD = {
    "Unit": "[Unit]\n",
    "Service": "[Service]\nType=oneshot\nExecStart=/bin/true\n",
    "Socket": "[Socket]\nListenStream=/run/x\n",
    "Timer": "[Timer]\nOnBootSec=1\n",
}
SECTIONS = ("Unit", "Service", "Socket", "Timer", "Path", "Mount", "Automount", "Swap")
AVOIDED = {"OnFailureIsolate", "PermissionsStartOnly", "Delegate"}

pytestmark = pytest.mark.skipif(systemd_version() < 250, reason="needs systemd-analyze 250 or newer")


class Trial(NamedTuple):
    kind: str
    value: str
    file: str
    line: int


def bred(kind: str) -> list[str]:
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
        for found in directives.sections()[section].values():
            old = (section, found.key, "") in directives.legacy() or found.key in AVOIDED
            if found.type == kind and found.since <= systemd_version() and not old:
                return found
    return None


def suffix(section: str) -> str:
    return "service" if section == "Unit" else section.lower()


def written(folder: Path) -> tuple[list[Path], list[Trial]]:
    trials: list[Trial] = []
    shared: dict[str, list[tuple[str, str]]] = defaultdict(list)
    files: list[Path] = []
    for number, kind in enumerate(SEEDS):
        key = key_for(kind)
        if key is None:
            continue
        for index, value in enumerate(bred(kind)):
            if kind in SINGLE:
                name = f"t{number}n{index}.{suffix(key.section)}"
                folder.joinpath(name).write_text(f"{HEAD[key.section]}{key.key}={value}\n", "utf-8")
                files.append(folder / name)
                trials.append(Trial(kind, value, name, HEAD[key.section].count("\n") + 1))
            else:
                shared[key.section].append((f"{key.key}={value}\n", kind))
    for section, lines in shared.items():
        name = f"all-{section.lower()}.{suffix(section)}"
        folder.joinpath(name).write_text(f"[{section}]\n" + "".join(text for text, _ in lines), "utf-8")
        files.append(folder / name)
        trials += [Trial(kind, text.partition("=")[2][:-1], name, at) for at, (text, kind) in enumerate(lines, 2)]
    return files, trials


def excused(trial: Trial) -> bool:
    return any(row["type"] in (trial.kind, "*") and re.search(row["value"], trial.value) for row in DIFFERENCES)


def test_systemd_refuses_what_the_grammars_refuse(tmp_path):
    files, trials = written(tmp_path)
    said = verify(files, recursive="one")
    wrong: list[str] = []
    unexplained = 0
    for trial in trials:
        real = [
            text for text in said.lines.get((str(tmp_path / trial.file), trial.line), ()) if "please use" not in text
        ]
        problems = [p for p in check(trial.kind, nowhere(trial.value), systemd_version()) if p.code != "odd-name"]
        same = bool(real) == bool(problems)
        if same and trial.kind in SINGLE and problems:
            same = said.fatal(trial.file) == any(problem.effect == "unit" for problem in problems)
        if not same:
            explained = excused(trial)
            unexplained += not explained
            word = "reasoned" if explained else "WRONG"
            ours = [problem.code for problem in problems]
            wrong.append(f"{word} {trial.kind}: {trial.value!r} real={real} ours={ours}")
    print(f"{len(trials)} values, {len(wrong)} differences, {unexplained} of them without a reason")
    assert len(trials) > 3000
    assert not unexplained, "\n".join(line for line in wrong if line.startswith("WRONG"))
    assert len(wrong) < len(trials) / 100, "\n".join(wrong)


@pytest.mark.parametrize(("tool", "kind"), [("timespan", "timespan"), ("calendar", "calendar")])
def test_time_spans_and_calendar_events(tool, kind):
    wrong = []
    for value in bred(kind):
        done = subprocess.run(["systemd-analyze", tool, "--", value], capture_output=True, env={"TZ": "UTC"})
        ours = is_calendar(value) if tool == "calendar" else parse_timespan(value) is not None
        if (done.returncode == 0) != ours and not excused(Trial(kind, value, "", 0)):
            wrong.append(value)
    assert not wrong
