"""A link, tag or property disappears at the next change event.

## What it finds
A rule that fires for `ACTION=="add"` but not for `change`, and does one of these:
- It makes a link. This is info where no other file of the tree names the link.
- It gives the tag `systemd` to a device that 99-systemd.rules does not tag.
- It sets a property that a daemon reads at every event (`ID_MM_DEVICE_IGNORE`, `ID_MM_PORT_IGNORE`,
  `NM_UNMANAGED`).

What one `GOTO` skips is one finding.

Owner, group and mode survive a change event. A tag that only accompanies `SYSTEMD_WANTS` has served its
purpose and is not reported.

## Why it matters on a robot
udev computes links, tags and properties again at every event. `udevadm trigger`, which every package
installation runs, sends `change`: the rule does not fire and the link is gone. The running driver cannot
reopen its device, or systemd stops the units that are bound to the device.

## Bad
```udev
ACTION=="add", SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## Good
```udev
ACTION!="remove", SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## When to ignore it
If the link or tag is needed only once, at the moment when the device is plugged in, and nothing uses it
later.

## References
- udev(7), ACTION
- udevadm(8), trigger: the default action is change
- systemd.device(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.udev import Condition
from bringup_lint.api.udev import Token
from bringup_lint.api.udev import UdevRule

_MOST_SHOWN = 20
_READ_AT_EVERY_EVENT = ("ID_MM_DEVICE_IGNORE", "ID_MM_PORT_IGNORE", "NM_UNMANAGED")


@rule("warning", fix="unsafe", silent="udev removes the link at the change event as the rules say")
def action_add_only_symlink(robot: Robot) -> Iterator[Finding]:
    jumped: dict[Token, list[Lost]] = {}
    for lost in _all_lost(robot):
        if lost.action.inherited:
            jumped.setdefault(lost.action.token, []).append(lost)
        else:
            yield _finding(lost)
    for first, *others in jumped.values():
        yield _skipped(first, others)


class Lost(NamedTuple):
    """What a change event removes."""

    line: UdevRule
    where: Located | Span
    what: str
    name: str
    severity: str | None = None

    @property
    def action(self) -> Condition:
        return self.line.on("ACTION")[-1]


def _all_lost(robot: Robot) -> Iterator[Lost]:
    for line in robot.udev.matching:
        if "add" not in line.actions or "change" in line.actions:
            continue
        for link in line.links:
            if not robot.udev.survives_change(link):
                used = robot.devices.names(link.path)
                yield Lost(line, link.name, f"removes {link.path}", "the link", None if used else "info")
        for token in line.line.assignments("TAG"):
            if token.value == "systemd" and _is_for_device_unit(line, robot.target.systemd):
                yield Lost(line, token.span, "makes systemd stop what is bound to the device", "the tag")
        for token in line.line.assignments("ENV"):
            if token.attribute in _READ_AT_EVERY_EVENT and token.value:
                yield Lost(line, token.span, f"removes {token.attribute}", "the property")


def _is_for_device_unit(line: UdevRule, systemd: int) -> bool:
    """Whether the tag is there for others to depend on the device, and not only to start something once."""
    starts = any(token.attribute == "SYSTEMD_WANTS" for token in line.line.assignments("ENV"))
    return not starts and line.is_tagged_by_systemd(systemd) is False


def _finding(lost: Lost) -> Finding:
    change = fix("fire at every event except remove", (lost.action.token.span, 'ACTION!="remove"'))
    return finding(
        lost.action.token.span,
        f"The next change event (udevadm trigger) {lost.what}",
        advice='write ACTION!="remove"',
        related=[note(lost.where, lost.name)],
        severity=lost.severity,
        fix=change if len(lost.line.on("ACTION")) == 1 else None,
    )


def _skipped(first: Lost, others: list[Lost]) -> Finding:
    more = f", and {_count(len(others))} theirs" if others else ""
    return finding(
        first.where,
        f"The next change event (udevadm trigger) {first.what}{more}",
        advice='write ACTION!="remove"',
        related=[
            note(first.action.token.span, "this jump skips the rule"),
            *(note(lost.where, f"{lost.name} that is lost too") for lost in others[:_MOST_SHOWN]),
        ],
        severity="info" if all(lost.severity for lost in (first, *others)) else None,
    )


def _count(lines: int) -> str:
    return "one more line that this jump skips loses" if lines == 1 else f"{lines} more lines that this jump skips lose"
