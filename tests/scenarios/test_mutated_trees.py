"""Broken trees: whatever happens to the text of any file, the run ends, no rule or parser fails inside, and every
finding has its place in the text."""

from __future__ import annotations

import random
import shutil
from pathlib import Path

import pytest

from bringup_lint.config import Config
from bringup_lint.discover.walk import discover
from bringup_lint.engine import run
from bringup_lint.registry import Registry
from bringup_lint.robot import Robot
from tests.conftest import PROJECT

pytestmark = pytest.mark.slow

FIXTURES = PROJECT / "fixtures"
SCRAPS = [
    *"\0\v\f\x1c\x85\u2003\u2028\ufeff\r\t\"'\\`$%{}[]()<>&|;:=#*~!@,^é😀",
    *"${ $( %{ <!-- ]]> <![CDATA[ &amp; 0x 1e999 -1 r' f\"{ lambda: ... null *a <<EOF ((((( [[[[[ {{{{{".split(),
    *["\r\n", "\n\n", "\\\n", '"""', "- ", "---\n", "? ", "&a ", "$$", "//", " " * 80, "é" * 50],
]


def mutated(text: str, chance: random.Random) -> str:
    for _ in range(chance.randint(1, 6)):
        at = chance.randint(0, len(text))
        kind = chance.random()
        if kind < 0.5:
            text = text[:at] + chance.choice(SCRAPS) + text[at:]
        elif kind < 0.65:
            text = text[:at] + text[at + chance.randint(1, 20) :]
        elif kind < 0.75:
            text = text[:at]
        else:
            start = chance.randint(0, len(text))
            text = text[:at] + text[start : start + chance.randint(1, 200)] + text[at:]
    return text


@pytest.mark.parametrize("family", sorted(folder.name for folder in FIXTURES.iterdir()))
def test_no_mutation_makes_anything_fail(family: str, tmp_path: Path) -> None:
    chance = random.Random(family)
    registry = Registry.of()
    trees = [*FIXTURES.glob(f"{family}/*/bad*"), *FIXTURES.glob(f"{family}/*/tree")]
    for number, tree in enumerate(chance.sample(trees, min(len(trees), 8))):
        copy = tmp_path / str(number)
        shutil.copytree(tree, copy, symlinks=True)
        files = [path for path in copy.rglob("*") if path.is_file() and path.name != "bringup-lint.toml"]
        for path in chance.sample(sorted(files), min(len(files), 12)):
            text = path.read_bytes().decode("utf-8", "replace")
            path.write_bytes(mutated(text, chance).encode("utf-8"))
        outcome = run(Robot(discover((str(copy),))), registry, Config(min_severity="info"))
        assert outcome.failures == (), copy
        for found in outcome.findings:
            assert 0 <= found.span.start <= found.span.end <= len(found.source.text)
