"""A kernel parameter is set for the running kernel only.

## What it finds
`sysctl -w` in a script with a buffer of the network stack or of IP fragments (`net.core.rmem_max`,
`net.ipv4.ipfrag_time`, ...), when no `sysctl.d` file of the tree sets the parameter and no unit, container or cron
job runs the script.

## Why it matters on a robot
The value is gone after the next boot. Large messages such as images and point clouds are then lost again, days after
somebody has tuned the robot and seen them arrive.

## Bad
```sh
sudo sysctl -w net.core.rmem_max=16777216
```

## Good
```sh
echo 'net.core.rmem_max=16777216' | sudo tee /etc/sysctl.d/60-dds.conf
sudo sysctl --system
```

## When to ignore it
When something that the tree does not hold runs the script at every boot.

## References
- sysctl(8)
- sysctl.d(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

TUNED = regex(r"(net\.core\.(?:[rw]mem_(?:max|default)|netdev_max_backlog)|net\.ipv4\.ipfrag_\w+)=")
DONE_HERE = regex(r"sysctl\.(?:conf|d)\b")


@rule("warning", tags=["CWE-1188"], symptoms=["failed to increase socket receive buffer size"])
def sysctl_lost_at_reboot(robot: Robot) -> Iterator[Finding]:
    by_script: dict[int, list[Run]] = {}
    for source, run in robot.scripts.run("sysctl"):
        if _key(run) and not DONE_HERE.search(source.said) and not robot.sysctl.mentions(_key(run)):
            by_script.setdefault(id(source), []).append(run)
    for first, *others in by_script.values():
        source = first.command.words[0].span.source
        if robot.scripts.starts_by_itself(source):
            continue
        yield finding(
            first.words[0],
            f"{_key(first)} is at its default again after the next boot: sysctl -w sets the running kernel only",
            advice="write it to a file in /etc/sysctl.d, and run sysctl --system",
            related=[note(run.words[0], f"{_key(run)} is lost too") for run in others],
        )


def _key(run: Run) -> str:
    """The tuned parameter that a command sets; empty for any other command."""
    return next((found[1] for word in run.arguments if (found := TUNED.match(word))), "")
