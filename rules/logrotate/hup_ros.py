"""A postrotate script sends SIGHUP to ROS: the robot's software exits at every rotation.

## What it finds
A script of a stanza that sends SIGHUP to a unit that runs ROS, or to ROS processes directly. It is a warning if the
stanza rotates logs of ROS and `systemctl` signals a unit that is neither in the tree nor one of the distribution.

## Why it matters on a robot
Neither ros2 launch nor the nodes handle SIGHUP: it kills them. systemd counts this as a clean exit, so that
Restart=on-failure does not restart the robot. This happens every night at the same time.

## Bad
```
/var/log/ros2/*.log {
    postrotate
        systemctl kill --signal=HUP robot.service
    endscript
}
```

## Good
```
/var/log/ros2/*.log {
    copytruncate
}
```

## When to ignore it
When every process that receives the signal installs its own handler for SIGHUP.

## References
- systemd.service(5), "SuccessExitStatus="
- <https://github.com/ros2/launch/issues/712>
"""

import re
from collections.abc import Iterator
from collections.abc import Set

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.logrotate import Script
from bringup_lint.api.logrotate import Stanza
from bringup_lint.api.shell import Command

HUP = regex(r"(?:-|--signal[= ]|-s ?)(?:SIG)?HUP\b|(?<=\s)-1\b", re.I)
ROS = regex(r"\bros2\b|/opt/ros/|_node\b|\bros2?_")
KILLERS = frozenset({"kill", "killall", "pkill", "systemctl"})


@rule("error", fix="unsafe", symptoms=["Main process exited, code=killed, status=1/HUP"])
def hup_ros(robot: Robot) -> Iterator[Finding]:
    for stanza in robot.logs.stanzas:
        for script in stanza.scripts:
            for command in robot.logs.commands(script):
                text = " ".join(command.words)
                if command.name not in KILLERS or not HUP.search(text):
                    continue
                unit = next((u for u in robot.units.ros if u.name in named(command)), None)
                certain = unit is not None or ROS.search(text) is not None
                if not certain and not (robot.logs.is_of_ros(stanza) and unknown(robot, command)):
                    continue
                back = unit is not None and robot.units.restart(unit).restart in ("always", "on-success")
                what = f"{unit.name} runs ROS" if unit else "This signals ROS"
                yield finding(
                    command.words[0],
                    f"{what}, which does not handle SIGHUP: the rotation kills it"
                    + ("" if back else ", and systemd counts that as a clean exit"),
                    advice="use copytruncate and delete the script",
                    related=[note(unit.where, f"{unit.name} is defined here")] if unit else (),
                    severity=None if certain else "warning",
                    fix=change(stanza, script) if len(robot.logs.commands(script)) == 1 else None,
                )


def named(command: Command) -> Set[str]:
    words = {str(word) for word in command.words[1:]}
    return words | {f"{word}.service" for word in words} if command.name == "systemctl" else frozenset()


def unknown(robot: Robot, command: Command) -> bool:
    """Whether systemctl signals a unit that is neither in the tree nor one of the distribution, such as rsyslog."""
    units = [word for word in named(command) if word.endswith(".service")]
    known = any(robot.units.candidates(name) or robot.units.is_distribution_unit(name) for name in units)
    return bool(units) and command.name == "systemctl" and not known


def change(stanza: Stanza, script: Script) -> Fix:
    text = "" if stanza.own("copytruncate") else "copytruncate"
    return fix("replace the script with copytruncate", (script.span, text))
