"""Over a folder of real configuration: nothing fails inside, whatever is done to the files."""

from __future__ import annotations

import json
import random
import shutil
from pathlib import Path

import pytest

from tests.lint import lint

pytestmark = pytest.mark.corpus

MUTANTS = 2000


def repositories(corpus: Path) -> list[Path]:
    return sorted(path for path in corpus.iterdir() if path.is_dir())


def test_no_internal_error(corpus: Path) -> None:
    for repository in repositories(corpus):
        run = lint("--min-severity", "info", "--output-format", "json", ".", cwd=repository)
        assert run.code in (0, 1), (repository.name, run.stdout[:2000], run.stderr)


def test_mutated_files_never_fail_inside(corpus: Path, tmp_path: Path) -> None:
    """Thousands of damaged files: bytes flipped, lines doubled, cut and swapped."""
    rng = random.Random(20)
    files = [path for path in sorted(corpus.rglob("*")) if path.is_file() and path.stat().st_size < 40_000]
    for number in range(MUTANTS // 50):
        folder = tmp_path / str(number)
        for path in rng.sample(files, 50):
            target = folder / path.relative_to(corpus)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(mutated(path.read_bytes(), rng))
        run = lint("--min-severity", "info", "--output-format", "json", ".", cwd=folder)
        failed = [item for item in json.loads(run.stdout)["findings"] if item["rule"] == "lint/internal-error"]
        assert run.code in (0, 1), failed
        shutil.rmtree(folder)


def mutated(data: bytes, rng: random.Random) -> bytes:
    lines = data.splitlines(keepends=True)
    for _ in range(rng.randint(1, 6)):
        if not lines:
            break
        at = rng.randrange(len(lines))
        kind = rng.randrange(6)
        if kind == 0:
            del lines[at]
        elif kind == 1:
            lines.insert(at, lines[at])
        elif kind == 2:
            lines[at] = lines[at][: rng.randrange(len(lines[at]) + 1)]
        elif kind == 3:
            lines[at] = lines[at].swapcase()
        elif kind == 4:
            here = bytearray(lines[at])
            here[rng.randrange(len(here))] = rng.randrange(1, 256)
            lines[at] = bytes(here)
        else:
            other = rng.randrange(len(lines))
            lines[at], lines[other] = lines[other], lines[at]
    return b"".join(lines)
