"""Files of the host that several rules ask for."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from typing import TYPE_CHECKING

from bringup_lint.model.shell import Command
from bringup_lint.parsers.shell import commands
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

_SECTION = re.compile(
    r"^\[(?P<section>[^\]\n]+)\]"
    r"|^(?P<key>[A-Za-z][\w.-]*)[ \t]*=[ \t]*(?P<value>[^\n#;]*?)[ \t\r]*(?:[#;].*)?$",
    re.M,
)
_INSTALLERS = frozenset(("apt", "apt-get", "aptitude"))


@dataclass(eq=False)
class Jail:
    """A fail2ban jail file: the last value of a key wins."""

    source: Source
    values: dict[tuple[str, str], Located] = field(default_factory=dict)

    def get(self, section: str, key: str) -> Located | None:
        return self.values.get((section, key))


def parse_jail(source: Source) -> Jail:
    """Read the sections and keys; indented continuation lines are left out."""
    jail, section = Jail(source), ""
    for match in _SECTION.finditer(source.text):
        if match["section"] is not None:
            section = match["section"].strip()
        elif section:
            jail.values[section, match["key"].lower()] = source.located(*match.span("value"))
    return jail


def sshd_sources(robot: Robot) -> list[Source]:
    """The sshd configuration of the tree: the main file and its drop-ins."""
    known = [
        source for source in robot.sources if re.search(r"(?:^|/)ssh/sshd_config(?:\.d/[^/]+\.conf)?$", source.name)
    ]
    main = robot.tree.find("/etc/ssh/sshd_config")
    return known if main is None or main in known else [*known, main]


def installations(robot: Robot) -> Iterator[tuple[Source, Command]]:
    """The commands of scripts and Dockerfiles that install packages with apt."""
    scripts = [
        (source, source.located(0, len(source.text)))
        for source in robot.of_kind("shell-script")
        if "install" in source.text
    ]
    for file in robot.dockerfiles:
        for instruction in file.instructions:
            if instruction.name == "RUN":
                scripts += [(file.source, script) for script in instruction.scripts]
    for source, script in scripts:
        for command in commands(script):
            words = [word.rpartition("/")[2] for word in command.words]
            if "install" in words and _INSTALLERS & set(words):
                yield source, command
