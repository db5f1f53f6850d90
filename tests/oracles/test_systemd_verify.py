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
from tests.oracles.answers import Answers
from tests.oracles.answers import Oracle
from tests.oracles.test_systemd_values import SEEDS
from tests.oracles.verify import Messages
from tests.oracles.verify import put_together
from tests.oracles.verify import systemd
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


class Point(NamedTuple):
    where: str
    what: str


class Tally(NamedTuple):
    compared: int
    reported: int
    """By either side."""
    wrong: list[str]
    unexplained: list[str]


def ours(folder: Path, version: str) -> list[dict]:
    (folder / "bringup-lint.toml").write_text(f"target-systemd = {version}\n", "utf-8")
    run = lint("--select", "systemd", "--min-severity", "info", "--output-format", "json", ".", cwd=folder)
    assert run.code in (0, 1), run.stderr
    return [place for finding in json.loads(run.stdout)["findings"] for place in places(finding)]


def places(finding: dict) -> Iterator[dict]:
    """A finding, and the same at the other places of the file that it names."""
    yield finding
    for related in finding["related"]:
        if related["message"] == "the same here":
            yield {**finding, "location": related["location"]}


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


def written(folder: Path, mutants: Iterable[unit_mutations.Mutant]) -> list[Path]:
    """The files, and the unit that some of them start."""
    folder.mkdir(exist_ok=True)
    (folder / "stub.service").write_text("[Service]\nExecStart=/bin/true\n", "utf-8")
    return unit_mutations.write(folder, [unit_mutations.Mutant(*each) for each in mutants])


def asked(folder: Path, mutants: Iterable[unit_mutations.Mutant], recursive: str) -> list[tuple]:
    files = written(folder, mutants)
    said = verify(files, recursive=recursive)
    return [said.of(path) for path in files]


def messages(folder: Path, given: Answers) -> Messages:
    return put_together(folder, [(name, answer) for (name, _), answer in given.pairs])


def test_mutated_lines(answers: Oracle, tmp_path: Path) -> None:
    mutants = [*unit_mutations.mutants(MUTANTS, values)] if systemd_version() else []
    given = answers.of("systemd/lines", systemd(), mutants, lambda each: asked(tmp_path / "real", each, "one"))
    folder = tmp_path / "ours"
    files = written(folder, [mutant for mutant, _ in given.pairs])
    assert len(files) >= 500
    judge(compared_lines(folder, files, messages(folder, given), ours(folder, given.version)))


def units_of(said: Messages) -> Iterator[tuple[str, str, str]]:
    for unit, texts in said.units.items():
        for text in texts:
            for rule, pattern in UNIT_RULES.items():
                if re.search(pattern, text):
                    yield unit, rule, text


def test_units_that_are_refused(answers: Oracle, tmp_path: Path) -> None:
    refused = [*unit_mutations.REFUSALS.items()]
    given = answers.of("systemd/units", systemd(), refused, lambda each: asked(tmp_path / "real", each, "no"))
    folder = tmp_path / "ours"
    files = written(folder, [mutant for mutant, _ in given.pairs])
    said = units_of(messages(folder, given))
    real = {Point(unit, rule): text for unit, rule, text in said if rule != "ordering-cycle"}
    found = {
        Point(Path(finding["location"]["path"]).name, rule): finding["message"]
        for finding in ours(folder, given.version)
        if (rule := finding["rule"].partition("/")[2]) in UNIT_RULES and rule != "ordering-cycle"
    }
    judge(tally(found, real, len(files) * len(UNIT_RULES)))


def cycles_of(folder: Path, rings: list[list[unit_mutations.Mutant]]) -> list[bool]:
    """Whether systemd finds a cycle from the first unit of each ring."""
    firsts = [written(folder, ring)[0] for ring in rings]
    said = (verify([first], recursive="one") for first in firsts)
    return [any(rule == "ordering-cycle" for _, rule, _ in units_of(messages)) for messages in said]


def test_ordering_cycles(answers: Oracle, tmp_path: Path) -> None:
    rings = list(unit_mutations.cycles())
    given = answers.of("systemd/rings", systemd(), rings, lambda each: cycles_of(tmp_path / "real", each))
    folder = tmp_path / "ours"
    for ring, _ in given.pairs:
        written(folder, ring)
    found = {
        Path(place["path"]).name
        for finding in ours(folder, given.version)
        if finding["rule"] == "systemd/ordering-cycle"
        for place in [finding["location"], *(step["location"] for step in finding["chain"])]
    }
    assert {ring[0][0]: real for ring, real in given.pairs} == {
        ring[0][0]: ring[0][0] in found for ring, _ in given.pairs
    }


VENDOR = Path("/usr/lib/systemd/system")


def verified_root(folder: Path, files: dict[str, str]) -> tuple[list[tuple[str, int, list[str]]], dict[str, list[str]]]:
    """What is said about the lines of our files and about units below a root with the distribution's units."""
    shutil.copytree(VENDOR, folder / "usr/lib/systemd/system", symlinks=True)
    put(folder, files)
    for name in ("true", "false", "echo"):
        program = folder / "bin" / name
        program.parent.mkdir(exist_ok=True)
        program.write_text("#!/bin/sh\n")
        program.chmod(0o755)
    said = verify([Path(f"{name}.service") for name in unit_mutations.ROOT_UNITS], f"--root={folder}", recursive="one")
    ours = {str(folder / name): name for name in files}
    lines = [(ours[path], line, said.about(Path(path), line)) for path, line in said.lines if path in ours]
    units = {name: [text.replace(f"{folder}/", "") for text in texts] for name, texts in said.units.items()}
    return lines, units


def put(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")


def test_dropins_below_a_root(answers: Oracle, tmp_path: Path) -> None:
    tool = systemd() if VENDOR.joinpath("sysinit.target").exists() else "the distribution's units"
    roots = [unit_mutations.ROOT]
    given = answers.of(
        "systemd/root", tool, roots, lambda each: [verified_root(tmp_path / "real", files) for files in each]
    )
    ((files, (lines, units)),) = given.pairs
    folder = tmp_path / "ours"
    put(folder, files)
    said = Messages({(str(folder / name), line): texts for name, line, texts in lines}, units)
    findings = ours(folder, given.version)
    judge(tally(our_lines(folder, findings), their_lines(folder, said), len(files) * 3))
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
@pytest.mark.skipif(systemd_version() < 250, reason="needs systemd-analyze 250 or newer")
def test_units_of_the_corpus(corpus: Path, tmp_path: Path) -> None:
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
    judge(compared_lines(tmp_path, files, verify(files, recursive="one"), ours(tmp_path, str(systemd_version()))))
