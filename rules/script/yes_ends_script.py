"""`yes` fails the pipe that it answers for.

## What it finds
`yes | COMMAND` under `set -o pipefail`: in a script that also has `set -e` or goes on with `&&`, and in a step of an
image whose `SHELL` has `pipefail`.

Silent before `||`.

## Why it matters on a robot
`yes` never ends by itself: when COMMAND has its answers and ends, `yes` is killed by SIGPIPE (status 141). With
`pipefail` this is the status of the pipe, although COMMAND succeeded. The installer or the build ends there, or leaves
out what comes after `&&`.

## Bad
```sh
set -euo pipefail
yes | sudo ./driver.run
```

## Good
```sh
set -euo pipefail
sudo ./driver.run <<< y
```

## When to ignore it
When COMMAND reads its input to the end, which it never reaches.

## References
- bash(1), "Pipelines"
- yes(1)
"""

import re
from collections.abc import Iterator
from itertools import takewhile

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import blocks_of_run
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import ended_by_failure
from bringup_lint.api.shell import shell_blocks

YES = regex(r"\byes\b[^\n|]{0,40}\|")
PIPEFAIL = regex(r"^[ \t]*set[ \t][^\n#]*\bpipefail\b", re.M, "pipefail")
IN_STEP = regex(r"\bpipefail\b")
OFF = regex(r"\bset[ \t]+\+o[ \t]+pipefail\b")


@rule("error", symptoms=["exit code: 141"])
def yes_ends_script(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and source.matches(YES) and source.matches(PIPEFAIL):
            if not OFF.search(source.text):
                yield from _of_script(source)
    for file in robot.dockerfiles:
        if file.source.judged and file.source.matches(YES):
            since: dict[Stage, int | None] = {}
            for stage in file.stages:
                yield from _of_stage(stage, since)


def _of_script(source: Source) -> Iterator[Finding]:
    ended = {id(each.block.command) for each in ended_by_failure(source)}
    for yes, last in _pipes(shell_blocks(source)):
        if last.command is not None and last.command.ends == "&&":
            yield _said(yes, "what comes after && never runs")
        elif id(last.command) in ended:
            yield _said(yes, "the script ends here")


def _of_stage(stage: Stage, since: dict[Stage, int | None]) -> Iterator[Finding]:
    for each in reversed(list(takewhile(lambda each: each not in since, stage.chain))):
        since[each] = _since(each, since)
    start = since[stage]
    for run in stage.all("RUN"):
        if (start is not None and start < run.value.span.start) or IN_STEP.search(run.value):
            for blocks in blocks_of_run(run):
                for yes, last in _pipes(blocks):
                    if last is blocks[-1] or (last.command is not None and last.command.ends == "&&"):
                        yield _said(yes, "the build ends here")


def _since(stage: Stage, since: dict[Stage, int | None]) -> int | None:
    """Where the shell of a stage gets `pipefail`: -1 for the whole stage."""
    if stage.base is not None and since[stage.base] is not None:
        return -1
    return next((each.value.span.start for each in stage.all("SHELL") if IN_STEP.search(each.value)), None)


def _said(yes: Located, result: str) -> Finding:
    return finding(
        yes,
        f"yes is killed when the command has its answers, and with pipefail this fails the pipe: {result}",
        advice="write 'COMMAND <<< y', or give the command its option for no questions",
    )


def _pipes(blocks: tuple[Block, ...]) -> Iterator[tuple[Located, Block]]:
    """The pipes that begin with `yes`, each with its last command."""
    last = len(blocks) - 1
    found = []
    for at in range(len(blocks) - 2, -1, -1):
        command = blocks[at].command
        last = last if _ends(blocks[at + 1]) == "|" and last > at + 1 else at + 1
        if command is not None and command.name == "yes" and command.ends == "|":
            found.append((command.words[0], blocks[last]))
    yield from reversed(found)
    for block in blocks:
        for body in (block.condition, *block.bodies):
            yield from _pipes(body)


def _ends(block: Block) -> str:
    return block.command.ends if block.command is not None else block.ends
