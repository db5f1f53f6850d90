"""A link disappears at the next change event.

## What it finds
A rule that makes a link and fires for `ACTION=="add"` but not for `change`.

## Why it matters on a robot
Links are made anew at every event. `udevadm trigger`, which every installer runs, sends `change`: the rule
does not fire, udev removes the link, and the running driver cannot reopen its device.

## Bad
```udev
ACTION=="add", SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## Good
```udev
ACTION!="remove", SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
```

## References
- udev(7), ACTION
- udevadm(8), trigger: the default action is change
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", fix="safe")
def action_add_only_symlink(robot: Robot):
    for line in robot.udev.judged:
        if "add" not in line.actions or "change" in line.actions:
            continue
        for link in line.links:
            if not robot.udev.survives_change(link):
                yield _finding(line, link)


def _finding(line, link):
    *others, action = line.on("ACTION")
    own = not action.inherited
    change = fix("fire at every event but the last", (action.token.span, 'ACTION!="remove"'))
    return finding(
        action.token.span if own else link.name,
        f"The next change event (udevadm trigger) removes {link.path}",
        advice='write ACTION!="remove"',
        related=[note(link.name, "the link") if own else note(action.token.span, "the jump over this rule")],
        fix=change if own and not others else None,
    )
