"""The first line of a script ends in a carriage return.

## What it finds
A shell script whose first line, `#!/bin/bash`, ends in CR LF. Info where the script is not executable, while others
of the repository are, and nothing names it, by itself or with a pattern (`scripts/*.sh`). A bare name that several
scripts have is one of those in the folder.

## Why it matters on a robot
The kernel takes the carriage return as part of the interpreter's name and looks for `/bin/bash\\r`. A unit that
starts the script fails with status 203/EXEC, a shell says `bad interpreter`. An editor or git on Windows adds the
characters, and most editors do not show them.

## Bad
```sh
#!/bin/bash<CR>
```

## Good
```sh
#!/bin/bash
```

## When to ignore it
When every caller names the interpreter itself (`bash start.sh`) and the commands tolerate the carriage returns.

## References
- execve(2), "Interpreter scripts"
- systemd.exec(5), "Process Exit Codes": 203/EXEC
- gitattributes(5), "eol"
"""

import posixpath
import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import rule

ABSOLUTE = r"(?:/[\w.-]{1,60}){1,9}"
UNKNOWN = r"(?:^|[\s\"'=])|\$[\w{}]{1,60}[\"']?/"
"""What precedes a pattern for files of a folder that is not named."""


@rule(
    "error",
    symptoms=[
        "/usr/bin/env: '*\\r': No such file or directory",
        "203/EXEC",
        "Failed to execute *.sh: No such file or directory",
        "exec /*.sh: no such file or directory",
        "bad interpreter: No such file or directory",
        "/bin/bash^M",
        "cannot execute: required file not found",
    ],
)
def crlf_shebang(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        first = source.text.partition("\n")[0]
        if not source.judged or not first.startswith("#!") or not first.endswith("\r"):
            continue
        line = source.located(0, len(first) - 1)
        yield finding(
            line,
            f"The kernel looks for {line[2:].split()[0]!r} with a carriage return at its end: the script does not start"
            if line[2:].strip()
            else "The first line names no interpreter",
            advice="save the file with LF line ends, and put '*.sh text eol=lf' in .gitattributes",
            severity="info" if _is_idle(robot, source) else None,
        )


def _is_idle(robot: Robot, source: Source) -> bool:
    """Whether a script cannot be run by its path, as it is not executable where others are, and nothing else names or
    takes it."""
    if not robot.tree.keeps_modes or robot.tree.is_executable(source.name):
        return False
    folder, name = posixpath.split(source.name)
    is_alone = not any(each is not source and each.basename == name for each in robot.of_kind("shell-script"))
    place = re.escape(posixpath.basename(folder))
    path = re.compile(rf"\b{place}/{re.escape(name)}|(?:^|[\s\"'=:]){ABSOLUTE}/{re.escape(name)}\b", re.M)
    all_of_folder = re.compile(rf"(?:{UNKNOWN}|\b{place}[\"']?/)\*\.(?:sh|bash)\b|\b{place}[\"']?/\*(?![\w*/.])", re.M)
    for each in robot.sources:
        if each is source:
            continue
        is_beside = posixpath.dirname(each.name) == folder
        if name in each.text and (is_alone or is_beside or path.search(each.text)):
            return False
        if "*" in each.text and all_of_folder.search(each.text):
            return False
    return True
