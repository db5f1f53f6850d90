"""Coverage-guided inputs for one kind of file, or for all of them, through the whole pipeline (needs atheris, the extra
``fuzz``).

    python benchmarks/fuzz.py KIND|all [CORPUS] [-max_total_time=60 and other options of libFuzzer]

Each input is the text of one file; with ``all``, its first byte chooses the name. The fixtures are the seeds. An input
on which a parser, a layer, a rule or a report fails, or that takes too long, becomes a tree in ``fixtures/hostile``,
which the tests try from then on: make it smaller and give it a name before the repair.
"""

from __future__ import annotations

import hashlib
import importlib
import os
import pkgutil
import sys
import tempfile
import time
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(PROJECT))

import atheris  # noqa: E402

with atheris.instrument_imports(include=["bringup_lint"]):
    import bringup_lint
    from bringup_lint.budget import OutOfTime
    from bringup_lint.budget import limited
    from bringup_lint.config import Config
    from bringup_lint.discover.kinds import HEAD_SIZE
    from bringup_lint.discover.kinds import kind_of
    from bringup_lint.discover.walk import discover_text
    from bringup_lint.engine import run
    from bringup_lint.finish import Invocation
    from bringup_lint.finish import finish
    from bringup_lint.registry import Registry
    from bringup_lint.report import render
    from bringup_lint.robot import Robot

    for found in pkgutil.walk_packages(bringup_lint.__path__, "bringup_lint."):
        if found.name.startswith(("bringup_lint.parsers.", "bringup_lint.graph.", "bringup_lint.model.")):
            importlib.import_module(found.name)

LONGEST = 4096
"""Bytes of an input: what is wrong with a long one is mostly wrong with a short one, too."""
SEEDS = 8
"""Files of the fixtures for each kind."""
SLOWEST = 10
"""CPU seconds for one input."""
STUCK = 300
"""Seconds after which libFuzzer ends a run that even the limit of CPU time does not."""
HOSTILE = PROJECT / "fixtures/hostile"


def samples() -> dict[str, list[Path]]:
    """The files of the fixtures, by kind, in the order of their paths."""
    found: dict[str, list[Path]] = {}
    for path in sorted((PROJECT / "fixtures").rglob("*")):
        if path.is_file() and not path.is_symlink():
            text = path.read_bytes()[:HEAD_SIZE].decode("utf-8", "replace")
            kind = kind_of(_name(path), lambda text=text: text)  # type: ignore[misc]
            if kind:
                found.setdefault(kind, []).append(path)
    return found


def _name(path: Path) -> str:
    """The path of a file below its fixture."""
    above = 2 if HOSTILE in path.parents else 3
    return str(Path(*path.relative_to(PROJECT / "fixtures").parts[above:])) or path.name


def seeded(names: list[str], files: dict[str, list[Path]], folder: Path) -> Path:
    """Write the seeds of the kinds, behind the byte of their name when there are several."""
    folder.mkdir()
    for number, kind in enumerate(names):
        first = bytes([number]) if len(names) > 1 else b""
        hostile = [path for path in files[kind] if HOSTILE in path.parents]
        for at, path in enumerate([*files[kind][:SEEDS], *hostile]):
            (folder / f"{kind}-{at}").write_bytes(first + path.read_bytes()[:LONGEST])
    return folder


def judged(name: str, data: bytes, registry: Registry) -> list[str]:
    """What failed inside on a file of one name, or that it takes too long."""
    try:
        with limited(SLOWEST):
            return _judged(name, data, registry)
    except OutOfTime:
        return [f"takes more than {SLOWEST} s"]
    except Exception as error:
        return [f"escaped: {error!r}"]


def _judged(name: str, data: bytes, registry: Registry) -> list[str]:
    robot = Robot(discover_text(name, data))
    outcome = run(robot, registry, Config(min_severity="info"))
    report = finish(outcome, robot, Invocation(("bringup-lint",), os.getcwd(), time.time()))
    render("sarif", report)
    return list(outcome.failures)


def keep(name: str, data: bytes) -> Path:
    """Make a hostile fixture of an input; returns its folder."""
    folder = HOSTILE / f"found_{hashlib.sha256(name.encode() + data).hexdigest()[:12]}"
    place = folder / name
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_bytes(data)
    return folder


def main() -> None:
    asked, *options = sys.argv[1:] or ["all"]
    files = samples()
    names = sorted(files) if asked == "all" else [asked]
    if asked != "all" and asked not in files:
        sys.exit(f"no kind is called '{asked}': {', '.join(sorted(files))}")
    registry = Registry.of()
    paths = [_name(files[kind][0]) for kind in names]

    def test_one_input(data: bytes) -> None:
        name, text = (paths[0], data) if len(paths) == 1 else (paths[data[0] % len(paths)] if data else "", data[1:])
        failures = judged(name, text, registry) if name else []
        if failures:
            raise AssertionError("\n".join([*failures, f"kept as {keep(name, text)}"]))

    with tempfile.TemporaryDirectory() as folder:
        seeds = seeded(names, files, Path(folder, "seeds"))
        limits = [f"-max_len={LONGEST}", f"-timeout={STUCK}", f"-artifact_prefix={folder}/"]
        atheris.Setup([sys.argv[0], *limits, *options, str(seeds)], test_one_input)
        atheris.Fuzz()


if __name__ == "__main__":
    main()
