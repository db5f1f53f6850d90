"""How many small mistakes the tests notice: each mutant of a fixed sample is judged by the tests that run its line.

    pip install -e '.[test]'
    python benchmarks/mutants.py [all]

Judges the mutants of ``mutants.tsv`` that have no verdict yet, or all of them, and writes what it saw. A mutant that no
test can notice keeps its reason: set ``equivalent`` and why in the record. ``benchmarks/mutant_sample.py`` draws a new
sample.

A rule is judged by its fixtures. Which tests run a line of the parsers and of the graph is measured once: of all
fixtures, and of the tests in the folders of the same names. Who survives these meets all tests and fixtures of the
parser's or the layer's name, with the recorded answers of real tools. The tests of a mutant run in a process of their
own, in which the changed text is loaded in place of the file, and end at the first failure. Nothing is written to the
source.
"""

from __future__ import annotations

import ast
import importlib
import os
import random
import resource
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from functools import cache
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import CodeType

import pytest
from mutant_sample import AREAS
from mutant_sample import PROJECT
from mutant_sample import Mutant
from mutant_sample import read
from mutant_sample import write

FIXTURES = "tests/rules/test_fixtures.py"
ADVICE = "tests/rules/test_advice.py"
BESIDE = "tests/rules/test_beside.py"
TESTS = ("tests/parsers", "tests/graph", FIXTURES)
MOST_FIXTURES = 120
"""Fixtures that judge one mutant; of more that run its line, so many are drawn."""
SECONDS = 60
"""Of the processor's time; who takes more is killed, as a test that never ends would be noticed."""
PRELOADED = ("hypothesis", "pytest_lsp", "xdist", "pytest_cov", "yaml", "click", "lxml.etree", "jsonschema", "libcst")
QUIET = ("-x", "-q", "--no-header", "--tb=no", "-p", "no:cacheprovider", "-p", "no:xdist", "-p", "no:randomly")


def main(everything: bool) -> None:
    os.chdir(PROJECT)
    os.nice(15)
    sys.path.insert(0, str(PROJECT))
    mutants, head = read()
    reached = reach(measured(Path(tempfile.gettempdir()) / "bringup-lint-reach"))
    for module in PRELOADED:
        with suppress(ImportError):
            importlib.import_module(module)
    for number, mutant in enumerate(mutants):
        if mutant.verdict == "equivalent" or (mutant.verdict and not everything):
            continue
        mutants[number] = judged(mutant, reached)
        print(*mutants[number], sep="\t", flush=True)
        write(mutants, head)
    for area, folder in AREAS.items():
        counts = Counter(mutant.verdict for mutant in mutants if mutant.path.startswith(folder))
        print(area, *(f"{verdict} {count}" for verdict, count in sorted(counts.items())))


def measured(data: Path) -> Path:
    """The file in which coverage.py noted which test ran which line. A folder that has it need not measure again."""
    if not data.exists():
        sources = [f"--cov={AREAS[area]}" for area in ("graph", "parsers")]
        command = [
            sys.executable,
            "-m",
            "pytest",
            "-q",
            "-n",
            "2",
            *TESTS,
            *sources,
            "--cov-report=",
            "--cov-context=test",
        ]
        subprocess.run(command, env=os.environ | {"COVERAGE_FILE": str(data)}, check=False)
    return data


def reach(data: Path) -> dict[str, dict[int, set[str]]]:
    """Path -> line -> the tests that run it."""
    from coverage import CoverageData

    found = CoverageData(str(data))
    found.read()
    return {
        str(Path(path).relative_to(PROJECT)): {
            line: {context.rpartition("|")[0] for context in contexts if context}
            for line, contexts in found.contexts_by_lineno(path).items()
        }
        for path in found.measured_files()
    }


def judged(mutant: Mutant, reached: dict[str, dict[int, set[str]]]) -> Mutant:
    """The mutant with its verdict, and with the line where it is now."""
    mutant = mutant._replace(line=place(mutant))
    lines = reached.get(mutant.path, {})
    if is_rule(mutant.path):
        tests = fixtures_of(mutant.path)
    else:
        tests = lines.get(statement(mutant.path, mutant.line)) or set().union(*lines.values())
    failed = failing(mutant, chosen(tests)) if tests else "survived"
    for others in named_after(mutant.path):
        failed = failing(mutant, others) if failed == "survived" else failed
    verdict, why = ("survived", "") if failed == "survived" else ("killed", failed)
    return mutant._replace(verdict=verdict, why=why)


def fixtures_of(path: str) -> set[str]:
    """The tests that judge a rule."""
    rule_id = path.removeprefix("rules/").removesuffix(".py").replace("_", "-")
    folder = PROJECT / "fixtures" / path.removeprefix("rules/").removesuffix(".py")
    names = sorted(os.listdir(folder))
    kinds = [(name, name.partition("_")[0]) for name in names if "." not in name]
    tests = {f"{FIXTURES}::test_{kind}_fixture[{rule_id}-{name}]" for name, kind in kinds if kind in ("bad", "good")}
    alone = rule_id.startswith(("fleet/", "live/")) or "arguments.txt" in os.listdir(folder / "bad")
    if not alone and f'"{rule_id}"' not in whole():
        tests.add(f"{BESIDE}::test_bad_is_found_beside_good[{rule_id}]")
    return tests | {ADVICE}


def named_after(path: str) -> Iterator[list[str]]:
    """The quick tests whose files have the name of the parser or the layer, and the fixtures of that name."""
    if is_rule(path):
        return
    _, area, name, *_ = path.removesuffix(".py").split("/")
    word = name.partition("_")[0]
    files = [*Path("tests", area).rglob(f"test_*{word}*.py"), *Path("tests/oracles").glob(f"test_*{word}*.py")]
    folder = Path("tests", area, name)
    places = sorted({*files, *(folder.rglob("test_*.py") if folder.is_dir() else ())})
    if places:
        yield ["-m", "not slow", *map(str, places)]
    yield [FIXTURES, "-k", word]


@cache
def whole() -> str:
    """The text of the list of rules that are not judged beside good fixtures."""
    return (PROJECT / "tests/rules/beside.toml").read_text("utf-8")


def is_rule(path: str) -> bool:
    return path.startswith(AREAS["rules"] + "/")


def chosen(tests: set[str]) -> list[str]:
    """The tests of the code, then fixtures."""
    fixtures = sorted(test for test in tests if test.startswith(FIXTURES))
    own = sorted(tests - set(fixtures))
    return own + random.Random(len(fixtures)).sample(fixtures, min(len(fixtures), MOST_FIXTURES))


def statement(path: str, line: int) -> int:
    """Where the statement begins that a line belongs to: coverage counts by that."""
    nodes = [node for node in ast.walk(syntax(path)) if isinstance(node, ast.stmt) and node.lineno <= line]
    around = [node for node in nodes if (node.end_lineno or node.lineno) >= line]
    return max(around, key=lambda node: node.lineno).lineno if around else line


@cache
def syntax(path: str) -> ast.Module:
    return ast.parse((PROJECT / path).read_text("utf-8"))


def failing(mutant: Mutant, tests: list[str]) -> str:
    """The test that notices a mutant; ``survived`` where none does."""
    with tempfile.TemporaryFile("w+") as output:
        child = os.fork()
        if child == 0:
            os.dup2(output.fileno(), 1)
            os.dup2(output.fileno(), 2)
            resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
            load_instead(mutant)
            os._exit(pytest.main([*QUIET, *tests]))
        _, status = os.waitpid(child, 0)
        output.seek(0)
        lines = output.read().splitlines()
    if os.WIFSIGNALED(status):
        return "takes too long"
    if os.WEXITSTATUS(status) == pytest.ExitCode.USAGE_ERROR:
        raise ValueError("\n".join(lines))
    if os.WEXITSTATUS(status) in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED):
        return "survived"
    return next(_named(lines), "nothing can be collected")


def _named(lines: list[str]) -> Iterator[str]:
    for line in lines:
        if line.startswith(("FAILED ", "ERROR ")):
            yield line.partition(" ")[2].partition(" - ")[0]


def load_instead(mutant: Mutant) -> None:
    """From now on, this process loads the changed text where the file is asked for."""
    text = changed(mutant)
    original = SourceFileLoader.get_code

    def get_code(loader: SourceFileLoader, fullname: str) -> CodeType | None:
        if Path(loader.path).resolve() == PROJECT / mutant.path:
            return compile(text, loader.path, "exec", dont_inherit=True)
        return original(loader, fullname)

    SourceFileLoader.get_code = get_code  # type: ignore[assignment,method-assign]


def changed(mutant: Mutant) -> str:
    """The text of a file with a mutant's line."""
    lines = (PROJECT / mutant.path).read_text("utf-8").split("\n")
    at = place(mutant) - 1
    indent = lines[at][: len(lines[at]) - len(lines[at].lstrip())]
    return "\n".join([*lines[:at], indent + mutant.became, *lines[at + 1 :]])


def place(mutant: Mutant) -> int:
    """The line of a mutant, which is looked for near where it was."""
    lines = (PROJECT / mutant.path).read_text("utf-8").split("\n")
    places = [number for number, line in enumerate(lines, 1) if line.strip() == mutant.was]
    if not places:
        raise ValueError(f"{mutant.path} has no line {mutant.was!r} anymore: take the mutant out of the record")
    return min(places, key=lambda number: abs(number - mutant.line))


if __name__ == "__main__":
    main("all" in sys.argv[1:])
