"""A user may run everything as root without a password, or everybody something.

## What it finds
In a sudoers file, or in what a script writes to one:

- A line `USER ALL=(ALL) NOPASSWD: ALL`.
- A line `ALL ALL=(ALL) NOPASSWD: COMMAND`: every user and service of the robot may run the command as root.

## Why it matters on a robot
Whatever runs as this user is root: a node with a hole, a web interface, a USB stick that types. File permissions,
`User=` of the units and the sandbox of systemd then protect nothing.

## Bad
```sh
echo 'rover ALL=(ALL) NOPASSWD:ALL' | sudo tee /etc/sudoers.d/rover
```

## Good
```sh
echo 'rover ALL=(root) NOPASSWD: /usr/bin/systemctl restart rover.service' | sudo tee /etc/sudoers.d/rover
```

## When to ignore it
When the user exists on development machines only.

## References
- sudoers(5), "NOPASSWD and PASSWD"
- CWE-250: Execution with Unnecessary Privileges
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

RULE = regex(
    r"^[ \t]*(?P<who>[%+\w.{}-]+(?: +[%+\w.{}-]+)*?)[ \t]+\S+[ \t]*=[ \t]*(?:\((?:ALL|root)[^)\n]*\)[ \t]*)?"
    r"(?P<what>NOPASSWD:[ \t]*ALL)[ \t]*$",
    re.M,
)
EVERYBODY = regex(
    r"^[ \t]*ALL[ \t]+\S+[ \t]*=[ \t]*(?:\((?:ALL|root)[^)\n]*\)[ \t]*)?NOPASSWD:[ \t]*(?P<command>/[^\s,]+)", re.M
)


@rule("warning", tags=["CWE-250", "CWE-269"])
def sudo_nopasswd_all(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("sudoers"):
        if not source.judged:
            continue
        for match in RULE.finditer(source.text):
            who = "a user" if "{" in match["who"] else match["who"]
            yield finding(
                source.located(*match.span("what")),
                f"Every program that runs as {who} can become root without a password",
                advice="name the commands that are needed, with their full paths and arguments",
            )
        for match in EVERYBODY.finditer(source.text):
            yield finding(
                source.located(*match.span("command")),
                f"Every user and service can run {match['command']} as root without a password",
                advice="name the user that needs it in place of the first ALL",
            )
