"""An environment file contains a variable, command or ~ that is not expanded.

## What it finds
`$NAME`, `${NAME}`, `$(command)`, backquotes or a leading `~` in a value of a file that a unit reads with
EnvironmentFile=. Placeholders that a deployment fills in, passwords, CYCLONEDDS_URI, and values that a shell in the
unit expands again are not reported.

## Why it matters on a robot
Environment files are not shell scripts: systemd passes the text on literally. The configuration file is not found,
the log folder has a dollar sign in its name, PATH leads nowhere.

## Bad
```sh
CYCLONEDDS_HOME=$HOME/dds
PATH=/opt/robot/bin:$PATH
```

## Good
```sh
CYCLONEDDS_HOME=/home/robot/dds
PATH=/opt/robot/bin:/usr/local/bin:/usr/bin:/bin
```

## When to ignore it
When the program itself expands the value.

## References
- systemd.exec(5), "EnvironmentFile=": no variable expansion is performed
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.environment import UsedEnvFile

_SHELL = regex(r"\$(?:\{[A-Za-z_][^}]{0,400}\}|[A-Za-z_]\w*|\()|`[^`]+`")
_SECRET = regex(r"PASS|SECRET|TOKEN|KEY|PSK", re.I)
_EXPANDED_BY_READER = ("CYCLONEDDS_URI",)


@rule(
    "error",
    symptoms=[
        "No such file or directory: '$HOME/",
        "No such file or directory: '${HOME}/",
    ],
)
def expansion(robot: Robot) -> Iterator[Finding]:
    for file in robot.env_files:
        for entry in file.entries:
            if _SECRET.search(entry.name) or entry.name in _EXPANDED_BY_READER or _again(robot, file, entry.name):
                continue
            found = _SHELL.search(entry.value)
            word = entry.value.part(*found.span()) if found else None
            if word is None and (entry.value == "~" or entry.value.startswith("~/")):
                word = entry.value.part(0, 1)
            if word is not None:
                yield finding(
                    word,
                    f"Environment files are not shell scripts: {entry.name} gets '{word}' literally",
                    advice="write the value in full",
                    related=[note(file.readers[0].value, "the service reads it here")],
                )


def _again(robot: Robot, file: UsedEnvFile, name: Located) -> bool:
    """Whether a unit that reads the file hands the variable to a shell, which expands the text once more."""
    uses = f"${{{name}}}"
    return any(uses in line for reader in file.readers for key in _KEYS for line in reader.unit.values(key, "Service"))


_KEYS = ("ExecStartPre", "ExecStart", "ExecStartPost")
