"""A file is not UTF-8 text.

## What it finds
A configuration file with bytes that are not UTF-8, in UTF-16, or with NUL bytes.

## Why it matters on a robot
systemd drops lines that are not UTF-8, and XML and YAML readers reject the whole file. Nothing reports it when the
file is edited: editors on other systems save UTF-16 or Latin-1 without asking.

## Bad
```
Description=Antrieb für Räder        (saved as Latin-1)
```

## Good
```
Description=Antrieb für Räder        (saved as UTF-8)
```

## When to ignore it
When the program that reads the file expects this encoding.

## References
- systemd.syntax(7): "Files are expected to be encoded in UTF-8"
- YAML 1.2.2, section 5.2; XML 1.0, section 4.3.3
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["invalid UTF-8", "is not UTF-8 clean"])
def encoding(robot: Robot) -> Iterator[Finding]:
    for problem in robot.problems:
        if problem.code == "encoding":
            yield finding(problem.where, f"The file {problem.detail}", advice="save it as UTF-8 without NUL bytes")
