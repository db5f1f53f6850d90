"""Every user can write to a device node.

## What it finds
`MODE` with write permission for others, such as `0666` or `0777`. Device nodes that are open by design (null,
fuse, kvm, graphics) are not reported, nor is a mode that a packaged file sets anew afterwards. All lines of one
file are one finding, which is info where they name debug probes, programmers, logic analyzers, cameras and game pads
only, each by its product: these drive nothing on the robot.

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
_USUAL_GROUPS = {"tty": "dialout", "video4linux": "video", "input": "input", "sound": "audio"}
"""The groups that 50-udev-default.rules gives to devices of a subsystem."""


@rule("warning", fix="unsafe", silent="udev sets the mode as it is told", tags=["CWE-732"])
def mode_world_writable(robot: Robot) -> Iterator[Finding]:
    files: dict[str, list[tuple[UdevRule, Token]]] = {}
    for line, token in robot.udev.open_to_all:
        files.setdefault(token.span.path, []).append((line, token))
    for found in files.values():
        ordered = sorted(found, key=lambda each: each[0].drives_nothing)
        yield _finding(ordered, "info" if ordered[0][0].drives_nothing else None)


def _finding(found: list[tuple[UdevRule, Token]], severity: str | None) -> Finding:
    (first, token), *others = found
    grouped = first.line.first("GROUP") is not None
    lacking = [line for line, _ in found if not has_users(line)]
    edits = [(one.value, "0660") for _, one in found]
    return finding(
        token.value,
        f"With mode {token.value} every user and service can write to the device"
        + ", so GROUP has no effect" * grouped
        + (f" ({len(found)} lines of this file)" if others else ""),
        advice=f"write 0660 and {_group_for(lacking)}" if lacking else "write 0660",
        related=[note(other.value, "this mode too") for _, other in others[:_MOST_SHOWN]],
        severity=severity,
        fix=None if lacking else fix("let only the owner and the group write", *edits),
    )


def has_users(rule: UdevRule) -> bool:
    """Whether users can open the device without a mode for all: those of a group, or who is logged in."""
    groups = [token.value for token in rule.line.assignments("GROUP")]
    tags = [token for token in rule.line.assignments("TAG") if token.value == "uaccess" and token.operator != "-="]
    return bool(tags) or bool(groups and groups[-1] not in ("root", "0", ""))


def _group_for(rules: list[UdevRule]) -> str:
    subsystems = frozenset().union(*(rule.subsystems for rule in rules))
    groups = {_USUAL_GROUPS.get(name, "") for name in subsystems}
    if len(groups) == 1 and "" not in groups:
        return f'add GROUP="{groups.pop()}"'
    return "name the group that needs the device with GROUP="
