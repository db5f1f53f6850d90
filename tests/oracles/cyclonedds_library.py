"""Asks the real Cyclone DDS: a child process creates a domain for each configuration, until it aborts."""

from __future__ import annotations

import importlib.metadata
import importlib.util
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

FEATURES = frozenset({"network_partitions", "shm", "topic_discovery"})
"""What the wheel was built with."""
VERSION = "11"
MARK = "@@"
_CHILD = """
import json, os, sys
from cyclonedds.domain import Domain
for number, configuration in json.load(open(sys.argv[1])):
    os.write(2, f"\\n@@ {number}\\n".encode())
    try:
        domain = Domain(int(sys.argv[2]), configuration)
    except Exception:
        os.write(2, b"\\n@@ refused\\n")
    else:
        del domain
        os.write(2, b"\\n@@ accepted\\n")
"""


def is_installed() -> bool:
    return importlib.util.find_spec("cyclonedds") is not None


def tool() -> str:
    """Such as ``cyclonedds 11.0.1``; without the number where it is not installed."""
    return f"cyclonedds {importlib.metadata.version('cyclonedds')}" if is_installed() else "cyclonedds"


class Verdict(NamedTuple):
    accepted: bool
    message: str


def ask(configurations: list[str], folder: Path, domain: int = 0) -> list[Verdict]:
    """The library's verdict on values of ``CYCLONEDDS_URI``, in order, for a participant of a domain. A crash is a
    refusal."""
    verdicts: dict[int, Verdict] = {}
    pending = list(enumerate(configurations))
    batch = folder / "batch.json"
    while pending:
        batch.write_text(json.dumps(pending), "utf-8")
        run = subprocess.run(
            [sys.executable, "-c", _CHILD, str(batch), str(domain)],
            capture_output=True,
            timeout=300,
            check=False,
            cwd=folder,
        )
        verdicts |= _read(run.stderr.decode("utf-8", "replace"))
        rest = [each for each in pending if each[0] not in verdicts]
        assert len(rest) < len(pending), run.stderr[-2000:]
        pending = rest
    return [verdicts[number] for number in range(len(configurations))]


def _read(output: str) -> dict[int, Verdict]:
    found: dict[int, Verdict] = {}
    for part in re.split(rf"^{MARK} (?=\d)", output, flags=re.M)[1:]:
        number, _, rest = part.partition("\n")
        message, _, verdict = rest.partition(f"\n{MARK} ")
        words = re.sub(r"\d{8,}\.\d+ \[\d*\] +[\w.+-]+: ", "", message)
        lines = [line.strip() for line in words.splitlines() if line.strip()]
        found[int(number)] = Verdict(verdict.startswith("accepted"), "; ".join(lines) or verdict.strip() or "crash")
    return found
