"""A variable of a written file is replaced while the file is written.

## What it finds
A here-document whose end word is not quoted, and that writes a file with a variable of this file's own: `$MAINPID` in
a unit, which systemd sets, or a variable that the written script assigns itself and the writing script does not.

## Why it matters on a robot
The shell that writes the file puts the value in, which it does not have: `kill -HUP $MAINPID` becomes `kill -HUP`, and
`cd "$WS"` becomes `cd ""`. The unit or script on the robot is not the one that is in the repository.

## Bad
```sh
cat <<EOF | sudo tee /etc/systemd/system/rover.service
ExecReload=/bin/kill -HUP $MAINPID
EOF
```

## Good
```sh
cat <<'EOF' | sudo tee /etc/systemd/system/rover.service
ExecReload=/bin/kill -HUP $MAINPID
EOF
```

## When to ignore it
When whoever runs the script gives it the variable.

## References
- bash(1), "Here Documents"
- systemd.exec(5), $MAINPID
"""

import re
from collections.abc import Iterable
from collections.abc import Iterator
from itertools import chain

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Written

UNKNOWN = regex(r"\{\{ (?P<name>[A-Za-z_]\w*) \}\}")
OF_SYSTEMD = ("MAINPID", "SERVICE_RESULT", "EXIT_CODE", "EXIT_STATUS")
OF_LOGIN = ("HOME", "USER", "LOGNAME", "PATH", "PWD", "HOSTNAME", "SUDO_USER", "ROS_DISTRO", "DISPLAY")
SOURCES = regex(r"^[ \t]*(?:source|\.)[ \t]", re.M)
"""Another file may set the variable of the script that writes."""
GIVEN = regex(r"\b([A-Za-z_]\w*)=")
KNOWN = regex(r"\b([A-Za-z_]\w*)(?:\+?=|:?[=?])")
READS = regex(r"\b(?:for|read|getopts|declare|mapfile|printf -v)\b([^\n]*)")
WORD = regex(r"\w+")
SETS = regex(r"^[ \t]*(?:export |local |readonly )?([A-Za-z_]\w*)=", re.M)
USE = regex(r"(?<!\\)\$(?:(?P<plain>[A-Za-z_]\w*)|\{(?P<braced>[A-Za-z_]\w*)\})")


@rule("error", silent="the shell replaces the variable with nothing, and writes the file")
def heredoc_expanded(robot: Robot) -> Iterator[Finding]:
    read: dict[Source, Places] = {}
    for source, written in robot.scripts.written("<<"):
        names = dict.fromkeys(UNKNOWN.findall(str(written.text or "")))
        if not names:
            continue
        if source not in read:
            read[source] = Places(source)
        uses = _uses(source, *_extent(written))
        for name in _own(read[source], written, names):
            place = uses.get(name)
            if place is not None:
                yield finding(
                    place,
                    f"The script replaces ${name} with nothing while it writes {written.path}",
                    advice="quote the end word of the here-document (<<'EOF'), or write a backslash before the dollar",
                    severity=None if name in OF_SYSTEMD else "warning",
                    confidence=None if written.certain else "medium",
                )


class Places:
    """Where a script has to do with variables: the first and the last place of each, so that it is read once."""

    def __init__(self, source: Source) -> None:
        text = source.text
        self.sources = _ends((match.start(), "") for match in SOURCES.finditer(text))
        self.given = _ends((match.start(), match[1]) for match in GIVEN.finditer(text))
        read = ((match.start(), word) for match in READS.finditer(text) for word in WORD.findall(match[1]))
        self.known = _ends(chain(((match.start(), match[1]) for match in KNOWN.finditer(text)), read))


def _ends(found: Iterable[tuple[int, str]]) -> dict[str, tuple[int, int]]:
    ends: dict[str, tuple[int, int]] = {}
    for at, name in found:
        first, last = ends.get(name, (at, at))
        ends[name] = (min(first, at), max(last, at))
    return ends


def _is_outside(ends: dict[str, tuple[int, int]], name: str, start: int, end: int) -> bool:
    first, last = ends.get(name, (start, start))
    return first < start or last >= end


def _own(places: Places, written: Written, names: Iterable[str]) -> Iterator[str]:
    """The variables that belong to the file that is written: systemd sets them, or only this file does."""
    text = str(written.text)
    extent = _extent(written)
    sets, passed = set(SETS.findall(text)), _passed(text)
    sources = _is_outside(places.sources, "", *extent)
    for name in names:
        if name in OF_SYSTEMD:
            if "[Service]" in text and not _is_outside(places.given, name, *extent):
                yield name
        elif name in sets and not (sources or name in OF_LOGIN or name in passed):
            if not _is_outside(places.known, name, *extent):
                yield name


def _passed(text: str) -> set[str]:
    """The variables that a line of the file sets to what the script has for them."""
    found: set[str] = set()
    for line in text.split("\n"):
        given = _ends((match.start(), match[1]) for match in GIVEN.finditer(line))
        used = ((match.start(), match["name"]) for match in UNKNOWN.finditer(line))
        found.update(name for at, name in used if name in given and given[name][0] < at)
    return found


def _extent(written: Written) -> tuple[int, int]:
    """Where the text of a written file is in its script."""
    places = written.text.places if written.text is not None else []
    return min((start for start, _ in places), default=0), max((end for _, end in places), default=0)


def _uses(source: Source, start: int, end: int) -> dict[str, Located]:
    """Variable -> where the here-document names it first."""
    found: dict[str, Located] = {}
    for each in USE.finditer(source.text, start, end):
        found.setdefault(each["plain"] or each["braced"], source.located(*each.span()))
    return found
