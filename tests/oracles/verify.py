"""Runs the real ``systemd-analyze verify`` over many unit files at once, and sorts its messages by line."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections import defaultdict
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import NamedTuple

_LINE = re.compile(r"(?P<path>/[^:]+):(?P<line>[0-9]+): (?P<text>.*)")
_UNIT = re.compile(r"(?:Unit )?(?P<unit>[A-Za-z0-9:_.\\@-]+\.[a-z]+)(?::| (?=has|failed)) ?(?P<text>.*)")
_CHUNK = 250


class Messages(NamedTuple):
    lines: dict[tuple[str, int], list[str]]
    """(path, line) to what is said about it."""
    units: dict[str, list[str]]
    """Unit name to what is said about it as a whole."""

    def about(self, path: Path, line: int) -> list[str]:
        """What is said about a line, without the folder of the file."""
        return [text.replace(f"{path.parent}/", "") for text in self.lines.get((str(path), line), ())]

    def of(self, path: Path) -> tuple[dict[str, list[str]], list[str]]:
        """What is said about the lines of a file, and about its unit as a whole, without the folder of the file.

        Which of several missing units makes a start fail differs from run to run: that is left out.
        """
        lines = {str(line): self.about(path, line) for name, line in self.lines if name == str(path)}
        said = (text for text in self.units.get(path.name, ()) if not text.startswith("Failed to create "))
        return lines, [text.replace(f"{path.parent}/", "") for text in said]

    def fatal(self, unit: str) -> bool:
        said = " ".join(self.units.get(unit, ()))
        return any(words in said for words in ("fatal error", "bad unit file setting", "failed to load properly"))


@cache
def systemd_version() -> int:
    """The release of the installed tool, 0 when there is none."""
    tool = shutil.which("systemd-analyze")
    if not tool:
        return 0
    said = subprocess.run([tool, "--version"], capture_output=True, text=True).stdout
    return int(said.split()[1])


def systemd() -> str:
    """Such as ``systemd 252``; without the number where there is none that the tests can ask."""
    return f"systemd {systemd_version()}" if systemd_version() >= 250 else "systemd"


def verify(units: Iterable[Path], *options: str, recursive: str = "no") -> Messages:
    paths = [str(path) for path in units]
    lines: dict[tuple[str, int], list[str]] = defaultdict(list)
    whole: dict[str, list[str]] = defaultdict(list)
    for start in range(0, len(paths), _CHUNK):
        command = ["systemd-analyze", "verify", "--man=no", f"--recursive-errors={recursive}", *options]
        done = subprocess.run(
            [*command, *paths[start : start + _CHUNK]],
            capture_output=True,
            text=True,
            errors="replace",
            env={"LANG": "C.UTF-8", "PATH": "/usr/bin:/bin", "SYSTEMD_LOG_LEVEL": "info", "TZ": "UTC"},
        )
        for said in done.stderr.splitlines():
            if found := _LINE.match(said):
                lines[found["path"], int(found["line"])].append(found["text"])
            elif found := _UNIT.match(said):
                whole[found["unit"]].append(found["text"])
    return Messages(dict(lines), dict(whole))


def put_together(folder: Path, answers: Iterable[tuple[str, tuple[dict[str, list[str]], list[str]]]]) -> Messages:
    """The messages about files, by their names, that ``Messages.of`` took apart."""
    lines = {}
    whole = {}
    for name, (about_lines, about_unit) in answers:
        lines.update({(str(folder / name), int(line)): texts for line, texts in about_lines.items()})
        whole[name] = about_unit
    return Messages(lines, whole)
