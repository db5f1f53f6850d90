"""The floor: reads every file that a checker of the tree has to read, and parses it with the cheapest parser at hand
that keeps lines. ``python benchmarks/floor.py FOLDER...``"""

from __future__ import annotations

import ast
import os
import sys
from collections.abc import Callable
from collections.abc import Iterator
from xml.parsers import expat

import yaml

LIMIT = 8 << 20
SKIPPED = {".git", "__pycache__", "node_modules"}


def files(folders: list[str]) -> Iterator[str]:
    for folder in folders:
        for here, below, names in os.walk(folder):
            below[:] = [name for name in below if name not in SKIPPED]
            yield from (os.path.join(here, name) for name in names)


def read_yaml(data: bytes) -> None:
    for _ in yaml.compose_all(data, Loader=yaml.CSafeLoader):
        pass


def read_xml(data: bytes) -> None:
    expat.ParserCreate().Parse(data, True)


def read_lines(data: bytes) -> None:
    for line in data.decode("utf-8", "replace").splitlines():
        line.partition("=")


PARSERS: dict[str, Callable[[bytes], object]] = {
    ".yaml": read_yaml,
    ".yml": read_yaml,
    ".xml": read_xml,
    ".launch": read_xml,
    ".py": ast.parse,
}


def main(folders: list[str]) -> None:
    for path in files(folders):
        try:
            with open(path, "rb") as file:
                data = file.read(LIMIT)
            PARSERS.get(os.path.splitext(path)[1], read_lines)(data)
        except (OSError, SyntaxError, ValueError, RecursionError, yaml.YAMLError, expat.ExpatError):
            continue


if __name__ == "__main__":
    main(sys.argv[1:])
