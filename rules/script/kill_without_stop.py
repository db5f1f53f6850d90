"""A script kills the nodes of the robot with SIGKILL.

## What it finds
`pkill -9`, `killall -9` or `kill -9 $(...)` whose pattern means ROS: `ros2`, `/opt/ros`, `launch.py`, or a package or
program of the tree. Also `ps ... | grep ros | ...` that ends in `xargs kill -9`, or in a variable that `kill -9` gets.
It is an info where the script launches ROS afterwards: it clears away what an earlier run left
behind. Silent if the script sends another signal to anything first or stops it otherwise
(`systemctl stop`, Ctrl+C in tmux), for simulators, RViz and the daemon of
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
from itertools import islice
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
NOT_ROBOT = regex(r"micro[_-]ros|gz|gazebo|ign|rviz|rqt|sim|daemon|webots|foxglove|plotjuggler|test", re.I)

LISTED = regex(
    r"^[ \t]*(?:sudo[ \t]+)?(?:(?P<name>\w+)=[\"']?(?:\$\(|`)[ \t]*)?ps[ \t][^\n|#]{0,60}\|"
    r"(?P<found>[^\n]{0,300}?\bgrep[ \t](?:-[A-Za-uw-z]+[ \t]+)*(?P<pattern>(?!-)\"[^\"\n]*\"|'[^'\n]*'|[\w./\[\]-]+))"
    r"(?P<rest>[^\n]*)",
    re.M,
    hints="ps ",
)
"""A list of processes, from which a pattern picks some."""
MOST = 20
"""Such lists that are looked at in one script."""
PIPED = regex(r"\bxargs\b[^\n|;&]{0,60}\bkill[ \t]+(?:-9|-KILL|-SIGKILL|-s[ \t]*(?:9|KILL|SIGKILL))\b")
ASKED = regex(
    r"\bsend-keys\b[^\n]{0,200}\bC-c\b|\bsystemctl\b[^\n]{0,200}[ \t]stop\b|\blifecycle[ \t]+set\b|\btopic[ \t]+pub\b"
    r"|\bdocker\b[^\n]{0,200}\b(?:stop|down|pkill|kill)\b|\btimeout[ \t]+-"
)
"""What stops nodes or the robot before in another way."""
GENTLE = regex(
    r"\bkill(?:all)?[ \t]+(?!-9|-KILL|-SIGKILL|-s[ \t]*(?:9|KILL|SIGKILL))|\bpkill[ \t]+(?!-9|-KILL|-SIGKILL)"
)


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
    for source in robot.of_kind("shell-script"):
        if source.judged and source not in asked and source.matches(LISTED):
            hard.setdefault(source, []).extend(_listed(source))
    for first, *others in filter(None, hard.values()):
        asked_before = ASKED.search(first.span.source.said)
        if asked_before is not None and asked_before.start() < first.span.start:
            continue
        yield finding(
            first,
            "SIGKILL ends the nodes before they can stop anything: what moves at that moment keeps its last command",
            advice="send SIGINT first, wait for the end, and kill only what is left",
            related=[note(other, "and these") for other in others],
            severity="info" if STARTS.search(first.span.source.text, first.span.end) else None,
            confidence="medium",
        )


def _listed(source: Source) -> Iterator[Located]:
    """The patterns by which a script picks processes of ROS from a list, and kills them."""
    gentle = GENTLE.search(source.text)
    for match in islice(LISTED.finditer(source.text), MOST):
        name, rest = match["name"], match["rest"]
        pattern = match["pattern"].strip("\"'").replace("[", "").replace("]", "")
        if not ROS.search(pattern) or NOT_ROBOT.search(f"{match['found']} {pattern}"):
            continue
        if gentle is not None and gentle.start() < match.start():
            continue
        killed = re.compile(rf"\bkill[ \t]+(?:-9|-KILL|-SIGKILL)[ \t]+[\"']?\$\{{?{re.escape(name or '')}\b")
        if PIPED.search(rest) or (name is not None and killed.search(source.text, match.end())):
            yield source.located(*match.span("pattern"))


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
