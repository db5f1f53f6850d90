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
from collections.abc import Iterator

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


@rule("error", silent="the shell replaces the variable with nothing, and writes the file")
def heredoc_expanded(robot: Robot) -> Iterator[Finding]:
    for source, written in robot.scripts.written("<<"):
        for name in dict.fromkeys(UNKNOWN.findall(str(written.text or ""))):
            place = _place(source, written, name) if _is_own(source, written, name) else None
            if place is not None:
                yield finding(
                    place,
                    f"The script replaces ${name} with nothing while it writes {written.path}",
                    advice="quote the end word of the here-document (<<'EOF'), or write a backslash before the dollar",
                    severity=None if name in OF_SYSTEMD else "warning",
                    confidence=None if written.certain else "medium",
                )


def _is_own(source: Source, written: Written, name: str) -> bool:
    """Whether a variable belongs to the file that is written: systemd sets it, or only this file does."""
    text = str(written.text)
    start, end = _extent(written)
    around = source.text[:start] + source.text[end:]
    word = re.escape(name)
    if name in OF_SYSTEMD:
        return "[Service]" in text and not re.search(rf"\b{word}=", around)
    if name in OF_LOGIN or SOURCES.search(around) or re.search(rf"\b{word}=[^\n]*\{{\{{ {word} \}}\}}", text):
        return False
    sets = re.compile(rf"^[ \t]*(?:export |local |readonly )?{word}=", re.M)
    known = re.compile(rf"\b{word}(?:\+?=|:?[=?])|\b(?:for|read|getopts|declare|mapfile|printf -v)\b[^\n]*\b{word}\b")
    return sets.search(text) is not None and known.search(around) is None


def _extent(written: Written) -> tuple[int, int]:
    """Where the text of a written file is in its script."""
    places = written.text.places if written.text is not None else []
    return min((start for start, _ in places), default=0), max((end for _, end in places), default=0)


def _place(source: Source, written: Written, name: str) -> Located | None:
    """Where the here-document names a variable."""
    start, end = _extent(written)
    word = re.escape(name)
    found = re.compile(rf"(?<!\\)\$(?:{word}\b|\{{{word}\}})").search(source.text, start, end)
    return source.located(*found.span()) if found is not None else None
