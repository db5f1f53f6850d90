"""The systemd rules against ``systemd-analyze verify``: they report what it reports, and nothing else."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterable
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from bringup_lint.parsers.unit import parse
from bringup_lint.source import Source
from bringup_lint.templates import template_language
from bringup_lint.toml import read_toml
from tests.lint import lint
from tests.oracles import unit_mutations
from tests.oracles.test_systemd_values import SEEDS
from tests.oracles.verify import Messages
from tests.oracles.verify import systemd_version
from tests.oracles.verify import verify

DIFFERENCES = read_toml((Path(__file__).parent / "differences" / "systemd_verify.toml").read_text("utf-8"))
MUTANTS = 700
LINE_RULES = """unknown-section wrong-section-for-type unknown-key key-in-wrong-section install-unknown-key legacy-key
key-too-new invalid-value trailing-comment line-outside-section missing-equals bad-unit-name-in-dep unescaped-percent
unknown-escape unbalanced-quotes exec-not-absolute var-in-nonexec-key documentation-url""".split()
"""Rules about one line; their findings are compared by file and line."""
UNIT_RULES = {
    "exec-missing": r"has no ExecStart=",
    "exec-multiple": r"more than one ExecStart=",
    "oneshot-restart": r"Restart= set to either always or on-success",
    "dbus-no-busname": r"no D-Bus service name has been specified",
    "timer-no-trigger": r"lacks value setting",
    "socket-no-listen": r"has no Listen setting",
    "path-no-path": r"lacks path setting",
    "mount-name-mismatch": r"doesn't match unit name",
    "mount-no-what": r"What= setting is missing",
    "exec-bare-ros2": r"Command ros2 is not executable",
    "ordering-cycle": r"Found ordering cycle",
}
"""Rules about a whole unit, and the message that says the same; compared by unit."""
QUIET = re.compile(r"please use|is obsolete|deprecated|please update|has been removed|Special user|unset environment")
"""Messages about obsolete settings: legacy-key has a longer memory than one release, so they are compared one way."""

pytestmark = pytest.mark.skipif(systemd_version() < 250, reason="needs systemd-analyze 250 or newer")


class Point(NamedTuple):
    where: str
    what: str


class Tally(NamedTuple):
    compared: int
    reported: int
    """By either side."""
    wrong: list[str]
    unexplained: list[str]


def ours(folder: Path) -> list[dict]:
    (folder / "bringup-lint.toml").write_text(f"target-systemd = {systemd_version()}\n", "utf-8")
    run = lint("--select", "systemd", "--min-severity", "info", "--output-format", "json", ".", cwd=folder)
    assert run.code in (0, 1), run.stderr
    return json.loads(run.stdout)["findings"]


def last_lines(path: Path) -> dict[int, int]:
    """Every line of a continued assignment to its last one, which is where systemd reports."""
    model = parse(Source(path.name, path.read_text("utf-8")))
    found = {}
    for assignment in model.assignments:
        last = assignment.span.end_position.line
        found.update(dict.fromkeys(range(assignment.span.line, last + 1), last))
    return found


def our_lines(folder: Path, findings: Iterable[dict]) -> dict[Point, str]:
    ends: dict[str, dict[int, int]] = {}
    found = {}
    for finding in findings:
        rule = finding["rule"].partition("/")[2]
        path = finding["location"]["path"]
        if rule in LINE_RULES:
            ends.setdefault(path, last_lines(folder / path))
            line = finding["location"]["start"]["line"]
            found[Point(path, str(ends[path].get(line, line)))] = f"{rule}: {finding['message']}"
    return found


def their_lines(folder: Path, said: Messages) -> dict[Point, str]:
    found = {}
    for (path, line), texts in said.lines.items():
        loud = [text for text in texts if not QUIET.search(text)]
        if path.startswith(f"{folder}/") and loud:
            found[Point(path.removeprefix(f"{folder}/"), str(line))] = loud[0]
    return found


def fatal_lines(said: Messages, theirs: dict[Point, str]) -> dict[str, int]:
    """Files that systemd stopped reading, and the last line it spoke about."""
    stopped: dict[str, int] = {}
    for point in theirs:
        texts = " ".join(said.units.get(point.where.rpartition("/")[2], ()))
        if "fatal error" in texts or "failed to load properly" in texts:
            stopped[point.where] = max(stopped.get(point.where, 0), int(point.what))
    return stopped


def excused(text: str) -> bool:
    return any(re.search(row["message"], text) for row in DIFFERENCES["difference"])


def tally(found: dict[Point, str], real: dict[Point, str], everything: int) -> Tally:
    wrong = [f"only ours: {point.where}:{point.what} {text}" for point, text in found.items() if point not in real]
    wrong += [f"only systemd: {point.where}:{point.what} {text}" for point, text in real.items() if point not in found]
    return Tally(everything, len({*found, *real}), wrong, [line for line in wrong if not excused(line)])


def judge(result: Tally) -> None:
    print(
        f"{result.compared} compared, {result.reported} reported, {len(result.wrong)} differences,"
        f" {len(result.unexplained)} without a reason"
    )
    assert not result.unexplained, "\n".join(result.unexplained)
    assert len(result.wrong) <= result.compared / 100, "\n".join(result.wrong)


def compared_lines(folder: Path, files: list[Path], said: Messages, findings: list[dict]) -> Tally:
    real = their_lines(folder, said)
    stopped = fatal_lines(said, real)
    found = {
        point: text
        for point, text in our_lines(folder, findings).items()
        if int(point.what) <= stopped.get(point.where, 10**9)
    }
    return tally(found, real, sum(path.read_text("utf-8").count("\n") for path in files))


def values(kind: str) -> list[str]:
    return [value.strip() for value in SEEDS.get(kind, ()) if not value.endswith("\\")]


def test_mutated_lines(tmp_path):
    files = unit_mutations.write(tmp_path, [*unit_mutations.mutants(MUTANTS, values)])
    (tmp_path / "stub.service").write_text("[Service]\nExecStart=/bin/true\n", "utf-8")
    assert len(files) >= 500
    judge(compared_lines(tmp_path, files, verify(files, recursive="one"), ours(tmp_path)))


def units_of(said: Messages) -> Iterator[tuple[str, str, str]]:
    for unit, texts in said.units.items():
        for text in texts:
            for rule, pattern in UNIT_RULES.items():
                if re.search(pattern, text):
                    yield unit, rule, text


def test_units_that_are_refused(tmp_path):
    refused = [unit_mutations.Mutant(*item) for item in unit_mutations.REFUSALS.items()]
    files = unit_mutations.write(tmp_path, refused)
    (tmp_path / "stub.service").write_text("[Service]\nExecStart=/bin/true\n", "utf-8")
    real = {Point(unit, rule): text for unit, rule, text in units_of(verify(files)) if rule != "ordering-cycle"}
    found = {
        Point(Path(finding["location"]["path"]).name, rule): finding["message"]
        for finding in ours(tmp_path)
        if (rule := finding["rule"].partition("/")[2]) in UNIT_RULES and rule != "ordering-cycle"
    }
    judge(tally(found, real, len(files) * len(UNIT_RULES)))


def test_ordering_cycles(tmp_path):
    wrong = []
    rings = list(unit_mutations.cycles())
    for ring in rings:
        unit_mutations.write(tmp_path, ring)
    found = {
        Path(place["path"]).name
        for finding in ours(tmp_path)
        if finding["rule"] == "systemd/ordering-cycle"
        for place in [finding["location"], *(step["location"] for step in finding["chain"])]
    }
    for ring in rings:
        said = verify([tmp_path / ring[0].name], recursive="one")
        real = any(rule == "ordering-cycle" for _, rule, _ in units_of(said))
        if real != (ring[0].name in found):
            wrong.append(f"{ring[0].name}: systemd {real}, ours {not real}")
    assert not wrong, "\n".join(wrong)


def test_dropins_below_a_root(tmp_path):
    vendor = Path("/usr/lib/systemd/system")
    if not vendor.joinpath("sysinit.target").exists():
        pytest.skip("needs the distribution's units")
    shutil.copytree(vendor, tmp_path / "usr/lib/systemd/system", symlinks=True)
    for name, text in unit_mutations.ROOT.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
    for name in ("true", "false", "echo"):
        program = tmp_path / "bin" / name
        program.parent.mkdir(exist_ok=True)
        program.write_text("#!/bin/sh\n")
        program.chmod(0o755)
    names = [Path(f"{name}.service") for name in unit_mutations.ROOT_UNITS]
    said = verify(names, f"--root={tmp_path}", recursive="one")
    real = {point: text for point, text in their_lines(tmp_path, said).items() if point.where in unit_mutations.ROOT}
    own = tmp_path / "own"
    for name in unit_mutations.ROOT:
        copy = own / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(tmp_path / name, copy)
    findings = ours(own)
    judge(tally(our_lines(own, findings), real, len(unit_mutations.ROOT) * 3))
    refused = {(unit, rule) for unit, rule, _ in units_of(said)}
    found = {
        (_unit_of(finding["location"]["path"]), rule)
        for finding in findings
        if (rule := finding["rule"].partition("/")[2]) in UNIT_RULES
    }
    assert found == refused


def _unit_of(path: str) -> str:
    *_, folder, name = path.split("/")
    return folder.removesuffix(".d") if folder.endswith(".d") else name


@pytest.mark.corpus
def test_units_of_the_corpus(corpus, tmp_path):
    files = []
    for number, path in enumerate(sorted(corpus.rglob("*"))):
        kind = path.suffix[1:]
        if kind not in ("service", "timer", "socket", "path", "target", "mount") or not path.is_file():
            continue
        text = path.read_text("utf-8", "replace")
        if template_language(path.name, text) or not re.search(r"^\[[A-Z]\w+\]\s*$", text, re.M):
            continue
        name = path.name if kind == "mount" else f"c{number}-{path.name}"
        (tmp_path / name).write_text(text, "utf-8")
        files.append(tmp_path / name)
    assert files
    judge(compared_lines(tmp_path, files, verify(files, recursive="one"), ours(tmp_path)))
