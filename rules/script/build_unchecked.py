"""A script goes on although the build before it failed.

## What it finds
`colcon build` whose result nobody looks at, before a `ros2 launch` or `ros2 run` of the same script, in a script
without `set -e`; and one before another build of other packages, in a script that does not end with the build, so that
its status says nothing of it. Silent if `&&` or `||` follows the build or the group that ends with it, if the build is
the condition of an `if`, if the script looks at `$?`, and if it ends by sourcing what was built, as scripts do that
people source.

## Why it matters on a robot
When a package does not compile, its last build is still in `install/`. The script sources it and starts it: the robot
drives with the old code, and the message of the compiler has long left the screen. Whoever tests a fix sees that it
changes nothing.

## Bad
```sh
#!/bin/bash
colcon build --symlink-install
source install/setup.bash
ros2 launch rover rover.launch.py
```

## Good
```sh
#!/bin/bash
colcon build --symlink-install || exit 1
source install/setup.bash
exec ros2 launch rover rover.launch.py
```

## When to ignore it
When the last build that succeeded is what is to be started.

## References
- bash(1), "Lists"
"""

import itertools
import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import STRICT
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import shell_blocks

LOOKS = regex(STRICT + r"|\btrap [^\n]{0,200}\bERR\b|\$\?|\bPIPESTATUS\b", re.M)
ASKED = ("&&", "||")
"""What ends a command whose status somebody looks at."""
OF_SH = regex(r"#![ \t]*\S*/(?:env[ \t]+)?(?:da)?sh\b")
"""A shell that may know no pipefail, and then ends."""
CONDITION = regex(r"\b(?:if|elif|while|until)\b[^;\n]{0,200}$|![ \t]*$")


@rule("warning", symptoms=["Failed   <<<"])
def build_unchecked(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or "colcon" not in source.text or LOOKS.search(source.text):
            continue
        runs = [did for did in robot.scripts.done(source) if isinstance(did, Run)]
        builds = [at for at, run in enumerate(runs) if _is_ignored(run)]
        if not builds:
            continue
        first, later = runs[builds[0]], runs[builds[0] + 1 :]
        ros = next((run for run in later if _starts_ros(run)), None)
        again = next((run for run in later if _builds_more(first, run)), None)
        if ros is not None:
            what, follows = "ROS starts with what the last build left in install/", note(ros.words[0], "ROS is started")
        elif again is not None and not _is_ignored(runs[-1]) and not _sets_up(runs[-1]):
            what, follows = "the script goes on, and ends as if it were built", note(again.words[0], "the next build")
        else:
            continue
        yield finding(
            first.words[0],
            f"A build that fails is ignored: {what}",
            advice=_advice(first),
            related=[
                *(
                    note(run.words[0], "a folder that is not there is ignored too")
                    for run in runs[: builds[0]]
                    if _moves(run)
                ),
                follows,
            ],
        )


def _advice(build: Run) -> str:
    """What ends the script with the build: in a pipe, the last command has the status, and exit leaves no more than the
    shell that it is in."""
    source = build.words[0].span.source
    around = _around(shell_blocks(source), build.words[0].span.start)
    is_piped = build.command.ends == "|"
    places = ["the pipe" if is_piped else "the build"]
    if build.shell:
        places.append(f"the text of {build.shell} -c")
    for block in around:
        if block.ends == "|":
            is_piped = True
            places.append("the pipe")
        elif block.kind == "group" and block.ends not in ASKED and _is_subshell(block):
            places.append("the subshell")
    after = " and after ".join(dict.fromkeys(places))
    if not is_piped:
        return f"write '|| exit 1' after {after}"
    bash = "run the script with bash, write" if OF_SH.match(source.text) else "write"
    return f"{bash} 'set -o pipefail' before the build, and '|| exit 1' after {after}"


def _around(blocks: Iterable[Block], at: int) -> list[Block]:
    """The compound commands around a place of a script, the innermost first."""
    for block in blocks:
        for body in (block.condition, *block.bodies):
            found = _around(body, at)
            if found or any(_starts_at(each, at) for each in body):
                return [*found, block]
    return []


def _starts_at(block: Block, at: int) -> bool:
    command = block.command
    return command is not None and any(word.span.start == at for word in command.words)


def _is_subshell(group: Block) -> bool:
    """Whether a group is in brackets, and not in braces."""
    first = group.bodies[0][0].command
    words = (*first.assignments, *first.words) if first is not None else ()
    return any(word.span.source.text[: word.span.start].rstrip().endswith("(") for word in words[:1])


def _builds_more(first: Run, run: Run) -> bool:
    """Whether a run builds something else than the first."""
    return run.certain and _is_ignored(run) and run.arguments != first.arguments


def _is_ignored(run: Run) -> bool:
    if run.name != "colcon" or run.arguments[:1] != ["build"] or run.command.ends in (*ASKED, "&"):
        return False
    span = run.command.words[0].span
    return CONDITION.search(span.source.line_before(span.start)) is None and not _is_asked(run)


def _is_asked(build: Run) -> bool:
    """Whether somebody looks at the status of a subshell or group that ends with the build."""
    inner = build.words[0].span.start
    around = [] if build.command.ends == "|" else _around(shell_blocks(build.words[0].span.source), inner)
    ends = itertools.takewhile(lambda block: block.kind == "group" and _ends_with(block, inner), around)
    return any(block.ends in ASKED for block in ends)


def _ends_with(group: Block, at: int) -> bool:
    last = group.bodies[0][-1]
    return _starts_at(last, at) or (last.kind == "group" and _ends_with(last, at))


def _sets_up(run: Run) -> bool:
    """Whether a run sources a file, as a script ends that people source in their terminal and watch."""
    return run.name in ("source", ".")


def _moves(run: Run) -> bool:
    """Whether the build is in another folder when the command fails."""
    return run.name == "cd" and run.certain and run.command.ends not in ASKED


def _starts_ros(run: Run) -> bool:
    return run.certain and run.name == "ros2" and run.arguments[:1] in (["launch"], ["run"])
