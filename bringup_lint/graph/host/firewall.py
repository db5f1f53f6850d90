"""Firewalls and tunnels of a tree, and the DDS domain that their ports must fit."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.firewall import Firewall
from bringup_lint.parsers.arithmetic import evaluate
from bringup_lint.parsers.firewall import parse
from bringup_lint.parsers.shell import commands
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

_TOOLS = re.compile(r"\b(?:ufw|ip6?tables)\b")
_DOMAIN = re.compile(r"^[^#\n]*?\bROS_DOMAIN_ID[\"']?[ \t]*[=:][ \t]*[\"']?(\d{1,3})\b", re.M)
_FORWARD = re.compile(r"(?:[^:]*:)?(?P<port>[^:]+):(?P<host>[^:]+):(?P<remote>[^:]+)\Z")
Forward = tuple[Source, int, Located]


def load_firewalls(robot: Robot) -> list[Firewall]:
    """The judged rule files, and the scripts that call a firewall tool."""
    scripts = [source for source in robot.of_kind("shell-script") if _TOOLS.search(source.text)]
    return robot.parsed(parse, [*robot.of_kind("iptables-rules", "nftables"), *scripts])


def dds_domain(robot: Robot) -> tuple[int, Located] | None:
    """The domain of the robot's units when they agree on one; where they set none, the one that all files agree on."""
    found = _domain_of_units(robot)
    if found:
        return next(iter(found.items())) if len(found) == 1 else None
    for source in robot.sources:
        if not source.judged:
            continue
        for match in _DOMAIN.finditer(source.text):
            found.setdefault(int(match[1]), source.located(match.start(1), match.end(1)))
    return next(iter(found.items())) if len(found) == 1 else None


def _domain_of_units(robot: Robot) -> dict[int, Located]:
    found: dict[int, Located] = {}
    for process in robot.ros.processes:
        variable = process.environment.get("ROS_DOMAIN_ID") if process.unit else None
        if variable is not None and variable.text is not None and re.fullmatch(r"\d{1,3}", variable.text):
            found.setdefault(int(variable.text), variable.value)
    return found


def ssh_forwards(robot: Robot) -> Iterator[Forward]:
    """The ports at the far end of ``ssh -L`` and ``-R`` in scripts, each with the word that says so."""
    for source in robot.of_kind("shell-script"):
        if "ssh" not in source.text:
            continue
        variables: dict[str, str] = {}
        for command in commands(source.located(0, len(source.text))):
            for assignment in command.assignments:
                name, _, value = assignment.partition("=")
                number = evaluate(value, variables)
                variables[name] = str(number) if number is not None else value
            if command.name in ("ssh", "autossh"):
                yield from _forwards(source, command.words, variables)


def _forwards(source: Source, words: tuple[Located, ...], variables: dict[str, str]) -> Iterator[Forward]:
    for at, word in enumerate(words):
        text = words[at + 1] if word in ("-L", "-R") and at + 1 < len(words) else None
        if word[:2] in ("-L", "-R") and len(word) > 2:
            text = word.part(2, len(word))
        match = _FORWARD.match(text) if text is not None else None
        port = evaluate(match["remote"], variables) if match else None
        if port is not None:
            yield source, port, text
