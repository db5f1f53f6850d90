"""Has the running graph looked at, by processes with a time limit."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterable
from collections.abc import Mapping
from itertools import chain
from itertools import repeat
from math import ceil
from typing import Any

from bringup_lint.extras import installed_by
from bringup_lint.live import observe
from bringup_lint.pattern import regex

SLACK = 12.0
"""Seconds that a process gets beyond its wait: loading the middleware, asking for states, leaving."""
AT_MOST = 4
"""Other domains that are looked at."""
AGAIN = 2.0
"""How many times as long the second look takes, before anything is called missing."""

NOTHING: Mapping[str, list[str]] = {}
_FRILLS = regex(r"^\[\w+\] \[[\d.]+\] \[[\w.]+\]: |^\w+Error: |(?<![.,])[.,]* at /\S+:\d+$")
"""Log prefixes, exception names, and the place in the library's sources."""
_OTHER_RMW = regex(r"Expected RMW implementation identifier of '(\w+)' but instead found '(\w+)'")
"""What rcl says where the one that was asked for is not installed and one other is;
rmw_implementation_identifier_check.c."""


class LiveError(Exception):
    """The graph cannot be looked at; the text is one clear line."""


class _NoRclpy(LiveError):
    pass


def look(
    domains: Iterable[int],
    wait: float,
    *,
    enclave: str | None,
    rmw: str | None,
    parameters: Mapping[str, list[str]] = NOTHING,
) -> list[dict[str, Any]]:
    """What can be seen on some domains, all looked at side by side; on the first one also ``parameters``, names by
    node. Raises LiveError."""
    environment = dict(os.environ)
    if rmw:
        environment["RMW_IMPLEMENTATION"] = rmw
    task = {"wait": wait, "enclave": enclave, "limit": ceil(wait + observe.LONGER + SLACK) + 1}
    asked = chain([parameters], repeat(NOTHING))
    tasks = [json.dumps({**task, "domain": each, "parameters": names}) for each, names in zip(domains, asked)]
    pythons = _pythons()
    for python in pythons[:-1]:
        try:
            return _together(python, tasks, wait, environment)
        except _NoRclpy:
            continue
    return _together(pythons[-1], tasks, wait, environment)


def merged(first: dict[str, Any], second: dict[str, Any]) -> dict[str, Any]:
    """Two looks at one domain: the second, with the nodes that only the first has seen."""
    names = {name for name, _ in second["nodes"]}
    nodes = [[name, enclave] for name, enclave in first["nodes"] if name not in names]
    ends = [each for each in first["endpoints"] if each["node"] not in names]
    return {
        **second,
        "nodes": sorted([*second["nodes"], *nodes]),
        "endpoints": [*second["endpoints"], *ends],
        "states": {**first["states"], **second["states"], **_told(first), **_told(second)},
        "parameters": second.get("parameters") or first.get("parameters", []),
    }


def _told(seen: dict[str, Any]) -> dict[str, str]:
    return {name: state for name, state in seen["states"].items() if state != observe.NO_ANSWER}


def _pythons() -> list[str]:
    """This Python, and that of a sourced ROS where this program is installed apart from it."""
    other = shutil.which("python3")
    return [sys.executable, *([other] if other and other != sys.executable else [])]


def _together(python: str, tasks: list[str], wait: float, environment: dict[str, str]) -> list[dict[str, Any]]:
    started = [_start(python, task, environment) for task in tasks]
    try:
        return [_answer(process, wait + observe.LONGER + SLACK) for process in started]
    finally:
        for process in started:
            if process.poll() is None:
                process.kill()
                process.wait()


def _start(python: str, task: str, environment: dict[str, str]) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [python, observe.__file__, task],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        errors="replace",
        env=environment,
    )


def _answer(process: subprocess.Popen[str], limit: float) -> dict[str, Any]:
    try:
        output, errors = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        raise LiveError(f"the middleware did not answer within {limit:g} s") from None
    for line in output.splitlines():
        if line.startswith(observe.MARK):
            return json.loads(line[len(observe.MARK) :])
    reason = _reason(f"{errors}\n{output}")
    if process.returncode == observe.NO_RCLPY:
        distro = os.environ.get("ROS_DISTRO", "jazzy")
        how = f"{installed_by('live')}, or: source /opt/ros/{distro}/setup.bash"
        raise _NoRclpy(f"the running graph cannot be looked at without rclpy ({reason}); {how}")
    if process.returncode < 0:
        raise LiveError(f"the middleware crashed with signal {-process.returncode}: {reason}")
    raise LiveError(f"the ROS graph cannot be joined: {reason}")


def _reason(output: str) -> str:
    """The line of an output that tells most, the first that speaks of an error, else the last; without its frills."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    telling = [line for line in lines if "error" in line.lower() and not line.startswith("Traceback")]
    line = next(iter([*telling, *lines[-1:]]), "no message")
    if "error not set" in line and os.environ.get("ROS_SECURITY_ENABLE") == "true":
        return "ROS_SECURITY_ENABLE is true, and ROS_SECURITY_KEYSTORE is not set"
    if other := _OTHER_RMW.search(line):
        return f"{other[1]} is not installed; RMW_IMPLEMENTATION={other[2]} looks with the one that is"
    return _FRILLS.sub("", line)[:300]
