"""A script kills the nodes of the robot with SIGKILL.

## What it finds
`pkill -9`, `killall -9` or `kill -9 $(...)` whose pattern means ROS: `ros2`, `/opt/ros`, `launch.py`, or a package or
program of the tree. It is an info where the script launches ROS afterwards: it clears away what an earlier run left
behind. Silent if the script sends another signal to anything first, for simulators, RViz and the daemon of
the command line, and for scripts of simulations and tests.

## Why it matters on a robot
SIGKILL ends a process at once: no driver sends a last stop, no bag is closed, no lifecycle node deactivates its
hardware. A motor controller without a time-out keeps the last command, and the robot drives on while nobody can
command it.

## Bad
```sh
pkill -9 -f 'ros2 launch'
```

## Good
```sh
pkill -INT -f '/bin/ros2 launch'
sleep 10
pkill -9 -f '/bin/ros2 launch'
```

## When to ignore it
When every actuator stops by itself without commands, and nothing is recorded.

## References
- signal(7): SIGKILL cannot be caught
- https://docs.ros.org/en/jazzy/Tutorials/Intermediate/Launch/Launch-system.html
"""

import re
from collections.abc import Iterator
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

KILLERS = ("pkill", "killall", "kill")
KILL = regex(r"-(?:9|KILL|SIGKILL)|--signal=(?:9|KILL|SIGKILL)")
VALUES = ("9", "KILL", "SIGKILL")
ROS = regex(r"\bros2?\b(?![-_]daemon)|/opt/ros|\blaunch\.py\b|\blaunch\b|\bros/[a-z]+\b")
STARTS = regex(r"\bros2[ \t]+launch\b", hints="launch")
NOT_ROBOT = regex(r"gz|gazebo|ign|rviz|rqt|sim|daemon|webots|foxglove|plotjuggler|test", re.I)


@rule("warning", symptoms=["Killed", "exit code -9"])
def kill_without_stop(robot: Robot) -> Iterator[Finding]:
    hard: dict[Source, list[Located]] = {}
    asked: set[Source] = set()
    for source, run in robot.scripts.run(*KILLERS):
        if not _is_hard(run):
            asked.add(source)
        elif source not in asked:
            pattern = _pattern(robot, run)
            if pattern is not None:
                hard.setdefault(source, []).append(pattern)
    for first, *others in hard.values():
        yield finding(
            first,
            "SIGKILL ends the nodes before they can stop anything: what moves at that moment keeps its last command",
            advice="send SIGINT first, wait for the end, and kill only what is left",
            related=[note(other, "and these") for other in others],
            severity="info" if STARTS.search(first.span.source.text, first.span.end) else None,
            confidence="medium",
        )


def _is_hard(run: Run) -> bool:
    words = run.arguments
    if any(map(KILL.fullmatch, words)):
        return True
    return any(word in ("-s", "--signal") and after in VALUES for word, after in pairwise(words))


def _pattern(robot: Robot, run: Run) -> Located | None:
    """The word that says what is killed, when that is something of ROS on the robot."""
    for word in run.words[1:]:
        text = str(word) if word.startswith(("$(", "`")) else run.text(word)
        if word.startswith("-") or NOT_ROBOT.search(text):
            continue
        if run.name == "kill" and not text.startswith(("$(", "`")):
            continue
        if ROS.search(text) or (run.name != "kill" and _is_own(robot, text)):
            return word
    return None


def _is_own(robot: Robot, name: str) -> bool:
    """Whether a package of the workspace has the name."""
    return bool(re.fullmatch(r"\w{4,}", name)) and name in robot.launch.workspace.packages
