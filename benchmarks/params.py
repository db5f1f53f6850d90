"""How fast parameter files are read: ``python benchmarks/params.py FOLDER...``, folders with checkouts of ROS 2
packages.

Compared with PyYAML's C loader, which makes plain values without places: the aim is 3 times its time or less. Best of
several rounds in turn.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from pathlib import Path

import yaml

PROJECT = Path(__file__).parent.parent
sys.path.insert(0, str(PROJECT))

from bringup_lint.discover.kinds import HEAD_SIZE  # noqa: E402
from bringup_lint.discover.kinds import kind_of  # noqa: E402
from bringup_lint.parsers import params  # noqa: E402
from bringup_lint.source import Source  # noqa: E402

ROUNDS = 6


def texts(folders: list[str]) -> Iterator[str]:
    for folder in folders:
        for path in sorted(Path(folder).rglob("*.y*ml")):
            if path.is_file():
                text = path.read_text("utf-8", errors="replace")
                if kind_of(str(path), lambda text=text: text[:HEAD_SIZE]) == "params":
                    yield text


def ours(text: str) -> None:
    params.parse(Source("params.yaml", text))


def theirs(text: str) -> None:
    try:
        list(yaml.load_all(text, Loader=yaml.CSafeLoader))
    except yaml.YAMLError:
        return


def main(folders: list[str]) -> None:
    found = list(texts(folders))
    best = {ours: float("inf"), theirs: float("inf")}
    for _ in range(ROUNDS):
        for read in best:
            start = time.perf_counter()
            for text in found:
                read(text)
            best[read] = min(best[read], time.perf_counter() - start)
    size = sum(len(text.encode()) for text in found)
    speed = size / best[ours] / 1e6
    ratio = best[ours] / best[theirs]
    print(f"params: {len(found)} files, {size / 1e3:.0f} kB, {speed:.2f} MB/s, {ratio:.2f} x PyYAML (aim 3)")


if __name__ == "__main__":
    main(sys.argv[1:] or [str(PROJECT / "fixtures" / "params")])
