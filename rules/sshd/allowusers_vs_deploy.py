"""A script logs in as a user, or on a port, that sshd rejects.

## What it finds
A script in the tree runs `ssh user@host`, scp or rsync in one of these ways:

- with a user that AllowUsers does not list;
- on port 22, while sshd listens only on other ports.

## Why it matters on a robot
After the configuration is rolled out, the deployment that rolled it out no longer reaches the robot.

## Bad
```
# sshd_config
AllowUsers robot-admin
# deploy.sh
ssh robot@10.0.0.7
```

## Good
```
# sshd_config
AllowUsers robot-admin
# deploy.sh
ssh robot-admin@10.0.0.7
```

## When to ignore it
When the script connects to another machine than this robot, such as a build server.

## References
- sshd_config(5), "AllowUsers", "Port"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", symptoms=["not allowed because not listed in AllowUsers"])
def allowusers_vs_deploy(robot: Robot) -> Iterator[Finding]:
    if len(robot.sshd) != 1 or not robot.sshd[0].files:
        return
    (sshd,) = robot.sshd
    allowed = [word for option in sshd.all("AllowUsers") if option.everywhere for word in option.arguments]
    ports = [option.value for option in sshd.all("Port")]
    for user, word, port in robot.ssh_logins:
        names = {str(name).partition("@")[0] for name in allowed}
        if allowed and user not in names and not any({"*", "?", "!"} & set(name) for name in names):
            yield finding(
                word,
                f"The script logs in as {user}, but sshd rejects that user",
                advice=f"log in as {' or '.join(sorted(names))}, or add {user} to AllowUsers",
                related=[note(allowed[0], "only these may log in")],
            )
        elif ports and sshd.is_whole and port == "22" and "22" not in ports:
            yield finding(
                word,
                f"The script connects to port 22, but sshd listens on {', '.join(ports)}",
                advice=f"use ssh -p {ports[0]}",
                related=[note(ports[0], "sshd listens here")],
            )
