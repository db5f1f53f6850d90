"""What systemd says of its units: ``systemctl show``, which asks and changes nothing."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Iterable
from collections.abc import Iterator

RUNNING = "/run/systemd/system"
"""There where systemd runs, by sd_booted(3)."""
PROPERTIES = {
    "Id": "unit",
    "LoadState": "load",
    "ActiveState": "active",
    "Result": "result",
    "NeedDaemonReload": "reload",
    "FragmentPath": "fragment",
}
"""The properties that are asked for, and what they are called in a saved graph; systemd.directives(7), systemctl(1)."""
PATIENCE = 10.0
"""Seconds."""
MOST = 500
"""Units that are asked for."""


def units(names: Iterable[str]) -> list[dict[str, str]]:
    """The units of these names that systemd knows, of templates the loaded instances; none where it does not run or
    does not answer."""
    asked = sorted({_asked(name) for name in names})[:MOST]
    systemctl = shutil.which("systemctl")
    if not asked or systemctl is None or not os.path.isdir(RUNNING):
        return []
    command = [systemctl, "show", "--no-pager", f"--property={','.join(PROPERTIES)}", "--", *asked]
    try:
        run = subprocess.run(
            command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", timeout=PATIENCE
        )
    except (OSError, subprocess.TimeoutExpired):
        return []
    return [unit for unit in _read(run.stdout) if unit.get("load") not in (None, "not-found")]


def _asked(name: str) -> str:
    """A template has no properties, and systemctl refuses its name; a pattern finds its instances."""
    return name.replace("@.", "@*.")


def _read(text: str) -> Iterator[dict[str, str]]:
    """The blocks of the answer, one for each unit; what is empty or ``no`` is left out."""
    for block in text.split("\n\n"):
        pairs = (line.partition("=") for line in block.splitlines())
        known = {PROPERTIES[key]: value for key, _, value in pairs if key in PROPERTIES and value not in ("", "no")}
        if "unit" in known:
            yield known
