"""Asks the real Fast DDS of the ROS wheels: its profile manager for thousands of files, a node for a few.

``eprosima::fastrtps::xmlparser::XMLProfileManager::loadXMLString`` is what loading a file comes to; it returns 0 when
the file is dropped, 1 when all is well, 2 when some profiles are refused.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import sysconfig
from pathlib import Path
from typing import NamedTuple

VERSION = "2.14"
MARK = "@@"
_PREFIX = "_ZN8eprosima8fastrtps9xmlparser17XMLProfileManager"
_CHILD = f"""
import ctypes, json, os, sys
library = ctypes.CDLL(sys.argv[2])
load = library.{_PREFIX}13loadXMLStringEPKcm
load.argtypes, load.restype = [ctypes.c_char_p, ctypes.c_size_t], ctypes.c_int
wipe = library.{_PREFIX}14DeleteInstanceEv
flush = library._ZN8eprosima7fastdds3dds3Log5FlushEv
for number, text in json.load(open(sys.argv[1])):
    os.write(1, f"\\n{MARK} {{number}}\\n".encode())
    data = text.encode()
    verdict = load(data, len(data))
    flush()
    wipe()
    os.write(1, f"\\n{MARK} is {{verdict}}\\n".encode())
"""
_NODE = """
import rclpy
rclpy.init()
node = rclpy.create_node("probe")
node.create_publisher(__import__("rcl_interfaces.msg").msg.Log, "/probe", 1)
print("started")
"""
DROPPED, LOADED, PARTLY = 0, 1, 2


class Verdict(NamedTuple):
    result: int
    """DROPPED, LOADED or PARTLY; -1 for a crash."""
    message: str


def library() -> Path | None:
    """The library of the wheel; None when it is not installed, or of another series."""
    found = Path(sysconfig.get_path("data"), "lib", f"libfastrtps.so.{VERSION}")
    return found if found.exists() else None


def tool() -> str:
    """Such as ``fastdds 2.14``; without the number where it is not installed."""
    return f"fastdds {VERSION}" if library() else "fastdds"


def ask(texts: list[str], folder: Path) -> list[Verdict]:
    """The library's verdict on files, in order."""
    verdicts: dict[int, Verdict] = {}
    pending = list(enumerate(texts))
    batch = folder / "batch.json"
    while pending:
        batch.write_text(json.dumps(pending), "utf-8")
        command = [sys.executable, "-c", _CHILD, str(batch), str(library())]
        run = subprocess.run(
            command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300, check=False, cwd=folder
        )
        verdicts |= _read(run.stdout.decode("utf-8", "replace"))
        rest = [each for each in pending if each[0] not in verdicts]
        assert len(rest) < len(pending), run.stdout[-2000:]
        pending = rest
    return [verdicts[number] for number in range(len(texts))]


def start_node(file: Path) -> tuple[int, str]:
    """Exit status and output of a node that loads a profiles file."""
    environment = os.environ | {"FASTRTPS_DEFAULT_PROFILES_FILE": str(file), "ROS_DOMAIN_ID": "97"}
    command = [sys.executable, "-c", _NODE]
    run = subprocess.run(command, capture_output=True, timeout=60, check=False, env=environment, cwd=file.parent)
    return run.returncode, _plain((run.stdout + run.stderr).decode("utf-8", "replace"))


def _plain(text: str) -> str:
    return re.sub(r"\x1b\[[0-9;]*m", "", text)


def _read(output: str) -> dict[int, Verdict]:
    found: dict[int, Verdict] = {}
    for part in re.split(rf"^{MARK} (?=\d)", _plain(output), flags=re.M)[1:]:
        number, _, rest = part.partition("\n")
        message, _, verdict = rest.partition(f"\n{MARK} is ")
        words = re.sub(r"^[\d: .-]+\[\w+ Error\] ", "", message.strip(), flags=re.M)
        result = verdict.strip()
        found[int(number)] = Verdict(int(result) if result else -1, words.replace("\n", "; "))
    return found
