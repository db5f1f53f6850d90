"""Runs a real ``udevadm`` of systemd 254 or newer: the installed one, or one unpacked in a folder."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections import defaultdict
from collections.abc import Iterable
from functools import cache
from pathlib import Path

FOLDER = os.environ.get("BRINGUP_LINT_UDEV", "")
"""Where ``fetch_udev.sh`` unpacked its packages."""

_LINE = re.compile(r"(?P<path>/[^:\n]+):(?P<line>[0-9]+) (?P<text>.*)")
_CHUNK = 200


@cache
def udevadm() -> tuple[str, ...] | None:
    """The command, or None when there is none that can verify."""
    for command in filter(None, (_unpacked(), _installed())):
        run = subprocess.run([*command, "--version"], capture_output=True, text=True, check=False)
        if run.returncode == 0 and int(run.stdout.split()[0]) >= 254:
            return command
    return None


def tool() -> str:
    """Such as ``udevadm 257``; without the number where there is none that can verify."""
    command = udevadm()
    if command is None:
        return "udevadm"
    return f"udevadm {subprocess.run([*command, '--version'], capture_output=True, text=True).stdout.split()[0]}"


def _unpacked() -> tuple[str, ...] | None:
    root = Path(FOLDER)
    if not FOLDER or not (root / "usr/bin/udevadm").is_file():
        return None
    loader = next(root.glob("usr/lib*/ld-linux*.so.*"), None) or next(root.glob("usr/lib/*/ld-linux*.so.*"))
    libraries = [str(path.parent) for path in root.glob("usr/lib/*/libc.so.6")]
    path = ":".join((*libraries, *(f"{folder}/systemd" for folder in libraries)))
    return (str(loader), "--library-path", path, str(root / "usr/bin/udevadm"))


def _installed() -> tuple[str, ...] | None:
    found = shutil.which("udevadm")
    return (found,) if found else None


def verify(paths: Iterable[Path]) -> dict[tuple[str, int], list[str]]:
    """What ``udevadm verify`` says: (file name, last physical line of the rule) to its messages."""
    said: dict[tuple[str, int], list[str]] = defaultdict(list)
    names = [str(path) for path in paths]
    for start in range(0, len(names), _CHUNK):
        command = [*(udevadm() or ()), "verify", "--resolve-names=never", "--no-summary"]
        run = subprocess.run(
            [*command, *names[start : start + _CHUNK]],
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
        )
        for found in _LINE.finditer(run.stderr):
            said[found["path"], int(found["line"])].append(found["text"])
    return said
