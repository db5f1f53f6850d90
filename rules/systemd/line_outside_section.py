"""An assignment above the first section header: systemd ignores it.

## What it finds
A line above the first section header of a unit file: a warning for a setting and for a header that has lost a bracket,
and an info for any other text, such as the name of the unit, which systemd ignores as well.

## Why it matters on a robot
The setting has no effect, and only a message in the journal says so.

## Bad
```ini
After=network-online.target

[Unit]
Description=Drivers
```

## Good
```ini
[Unit]
Description=Drivers
After=network-online.target
```

## When to ignore it
Never: systemd ignores the line.

## References
- systemd.syntax(7)
- journal: "Assignment outside of section. Ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import UnitFile

HEADER = regex(r"[({<]?(?P<name>Unit|Install|Service|Timer|Socket|Path|Mount|Automount|Swap|Slice|Scope)[\])}>]?[ \t]*")
"""The header of a section without its first bracket."""


@rule("warning", symptoms=["Assignment outside of section"])
def line_outside_section(robot: Robot) -> Iterator[Finding]:
    headers: dict[UnitFile, tuple[str, int]] = {}
    for file, problem in robot.units.problems("line-outside-section"):
        if file.source.template:
            continue
        line = str(problem.where)
        header = HEADER.fullmatch(line)
        if header is not None:
            headers[file] = header["name"], problem.where.line
        is_setting = "=" in line
        yield finding(
            problem.where,
            "Text before the first [Section]: systemd ignores this line",
            advice=_advice(is_setting, headers.get(file)),
            severity=None if is_setting or header is not None else "info",
        )


def _advice(is_setting: bool, header: tuple[str, int] | None) -> str:
    if header is not None:
        return f"write [{header[0]}] in line {header[1]}"
    return "move it below the header of its section" if is_setting else "remove it, or begin it with #"
