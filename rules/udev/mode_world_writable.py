"""Every user can write to a device node.

## What it finds
`MODE` with write permission for others, such as `0666` or `0777`. Device nodes that are open by design (null,
fuse, kvm, graphics) are not reported, nor is a mode that a packaged file sets anew afterwards. All lines of one
file are one finding.

## Why it matters on a robot
Any process of any user, including a compromised web service, can drive the motor controller. `GROUP=` on the
same line does not restrict that.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", MODE="0666", GROUP="dialout"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", MODE="0660", GROUP="dialout"
```

## When to ignore it
If every process on the computer may use the device, for example a game pad of a demonstration robot with a
single user and no network services.

## References
- udev(7), MODE
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.udev import Token
from bringup_lint.api.udev import UdevRule

_MOST_SHOWN = 20


@rule("warning", fix="unsafe", silent="udev sets the mode as it is told", tags=["CWE-732"])
def mode_world_writable(robot: Robot) -> Iterator[Finding]:
    files: dict[str, list[tuple[UdevRule, Token]]] = {}
    for line, token in robot.udev.open_to_all:
        files.setdefault(token.span.path, []).append((line, token))
    for found in files.values():
        yield _finding(found)


def _finding(found: list[tuple[UdevRule, Token]]) -> Finding:
    (first, token), *others = found
    grouped = first.line.first("GROUP") is not None
    all_grouped = all(line.line.first("GROUP") for line, _ in found)
    return finding(
        token.value,
        f"With mode {token.value} every user and service can write to the device"
        + ", so GROUP has no effect" * grouped
        + (f" ({len(found)} lines of this file)" if others else ""),
        advice="write 0660" if all_grouped else "write 0660 and name the group that needs the device with GROUP=",
        related=[note(other.value, "this mode too") for _, other in others[:_MOST_SHOWN]],
        fix=fix("let only the owner and the group write", *((one.value, "0660") for _, one in found), safe=all_grouped),
    )
