"""A step of an image fails, and its build goes on.

## What it finds
A command of a `RUN` that installs packages or builds the workspace, and whose failure does not end the build:
- `A && B && C || D`, where `D` is meant for `C` and hides the failure of `A` and `B`, too;
- a `;` or a new line after `colcon build` without `set -e`, and after an installation where all that follows succeeds
  without it, such as `rm`;
- `colcon build || true`, `rosdep install || true`, `poetry install || true`, `uv sync || true`, `npm ci || true`,
  `apt-get update || true`, and `colcon build | tee` without `pipefail`.

A fallback directly after another command that installs something is taken for meant, and so is one that does more than
print a message. So is one that is followed, with `&&`, by commands that need what was installed: they end the build.
Loops are not judged, nor is a step that asks for `$?` or has a trap for ERR. `apt-get update || true` is an info: what
is installed next mostly tells. A command that only looks (`--check`, `--dry-run`) is no installation. The import of a
`.repos` file of the tree that lists nothing is left alone.

## Why it matters on a robot
A mirror that does not answer for a moment, or a package that does not compile, gives an image that looks well and lacks
a driver. It is found on the robot, when a node does not start.

## Bad
```dockerfile
RUN apt-get update && apt-get install -y python3-rosdep && rosdep init || echo "rosdep is initialized"
```

## Good
```dockerfile
RUN apt-get update && apt-get install -y python3-rosdep && (rosdep init || echo "rosdep is initialized")
```

## When to ignore it
When the image is to be built without the result, too.

## References
- POSIX, Shell Command Language, "AND-OR Lists"
- https://docs.docker.com/reference/dockerfile/#run
"""

import re
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Purpose
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import blocks_of_run
from bringup_lint.api.shell import STRICT
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped

INSTALLERS = {
    "apt": "install",
    "apt-get": "install",
    "rosdep": "install",
    "pip": "install",
    "pip3": "install",
    "vcs": "import",
    "poetry": "install",
    "uv": "sync",
    "npm": "ci",
}
"""Program -> its command that brings something into the image."""
WHOLE = ("colcon", "rosdep", "poetry", "uv", "npm")
"""Programs that bring all that a workspace or a project says that it needs."""
STOPS = regex(STRICT, re.M)
STRICT_SHELL = regex(r'"-\w{0,8}e\w{0,8}"|"errexit"')
"""In SHELL."""
STRICT_READER = regex(r"\b(?:ba|da|z)?sh[ \t]+(?:-\w+[ \t]+)*-\w{0,8}e")
"""The shell that a here-document is for."""
TRAP = regex(r"\btrap\b[^\n]{0,200}\bERR\b", hints="trap")
STATUS = regex(r"\$(?:\?|\{\?\})")
PIPES = regex(r"\bpipefail\b|\bPIPESTATUS\b")
PASSIVE = ("echo", "printf", "true", ":")
"""Fallbacks that make up for nothing."""
INDEPENDENT = (*PASSIVE, "rm", "mkdir", "useradd", "groupadd", "usermod", "ldconfig", "cd", "chmod", "ln")
"""Commands that succeed without what an installation brings."""


LISTS = regex(r"([\w.-]{1,80}\.repos)\b")
FETCHED = regex(r"(?m)^[ \t]*url:", hints="url:")
MOST = 100_000
"""How much is read of a list of repositories."""
PACKAGE_LISTS = ("apt", "apt-get")
WITHOUT = "the image is built without its result"
OLD_LISTS = "apt goes on with the package lists of the base image, if it has any"

SILENT = (Purpose.CI, Purpose.TEST, Purpose.ARCHIVE)
"""Images of these are no robot's, and often try what may fail."""

JOIN = "join the commands with &&"
SKIP = "leave out keys that cannot be resolved with --skip-keys, and let others end the build"
GROUP = "put the fallback in parentheses with its own command"


class Hiding(NamedTuple):
    """What runs although a command failed."""

    by: Located
    how: str
    advice: str
    does: str = "this hides the failure"
    result: str = WITHOUT


class Hidden(NamedTuple):
    command: Located
    hiding: Hiding


@rule("warning", confidence="medium", silent="the step ends with success, so the build reports nothing")
def failure_hidden(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if robot.purpose(file.source) in SILENT:
            continue
        for stage in file.stages:
            for hidden in _of_stage(stage):
                if _imports_nothing(robot, hidden):
                    continue
                yield finding(
                    hidden.command,
                    f"When this fails, {hidden.hiding.how}: {hidden.hiding.result}",
                    advice=hidden.hiding.advice,
                    related=[note(hidden.hiding.by, hidden.hiding.does)],
                    severity="info" if hidden.hiding.result == OLD_LISTS else None,
                )


def _imports_nothing(robot: Robot, hidden: Hidden) -> bool:
    """Whether what is hidden is the import of a list of repositories that has none."""
    text = hidden.command.span.source.text[hidden.command.span.start : hidden.hiding.by.span.start]
    lists = {name for match in LISTS.finditer(text) for name in robot.tree.named(match[1])}
    return bool(lists) and not any(FETCHED.search(robot.tree.head(name, MOST)) for name in lists)


def _of_stage(stage: Stage) -> Iterator[Hidden]:
    """The first command of each RUN whose failure is hidden."""
    shells = " ".join(str(each.value) for one in stage.chain for each in one.all("SHELL"))
    strict, pipes = STRICT_SHELL.search(shells) is not None, PIPES.search(shells) is not None
    for run in stage.all("RUN"):
        text = "\n".join([str(run.value), *map(str, run.heredocs)])
        if strict or STOPS.search(text) or TRAP.search(text) or (run.heredocs and STRICT_READER.search(run.value)):
            continue
        pipefail = pipes or PIPES.search(text) is not None
        found = (each for blocks in blocks_of_run(run) for each in _hidden(list(blocks), pipefail))
        hidden = next(found, None)
        if hidden is not None:
            yield hidden


class Chain(NamedTuple):
    """The commands of one script, each looked at once."""

    blocks: Sequence[Block]
    stops: list[int]
    """For each command, the first one from it on after which neither ``&&`` nor ``|`` stands."""
    succeed: list[bool]
    """For each command, and for the end: whether all from it on succeeds without an installation."""
    checked: int
    """The last `rosdep check`, which fails where something is missing; -1 without one."""
    last_update: int
    """The last update of the package lists whose failure counts; -1 without one."""


def _chain(blocks: Sequence[Block]) -> Chain:
    last = len(blocks) - 1
    stops, succeed = list(range(len(blocks))), [True] * (len(blocks) + 1)
    for at in range(last, -1, -1):
        if at < last and _ends(blocks[at]) in ("&&", "|"):
            stops[at] = stops[at + 1]
        succeed[at] = succeed[at + 1] and _name(blocks[at]) in INDEPENDENT
    counts = (at for at in range(last, -1, -1) if _updates_lists(blocks[at]) and _ends(blocks[at]) != "||")
    checks = (at for at in range(last, -1, -1) if _name(blocks[at]) == "rosdep" and "check" in _words(blocks[at]))
    return Chain(blocks, stops, succeed, next(checks, -1), next(counts, -1))


def _hidden(blocks: Sequence[Block], pipefail: bool) -> Iterator[Hidden]:
    chain = _chain(blocks)
    for at, block in enumerate(blocks):
        if _updates_lists(block) and _ends(block) == "||" and at + 1 < len(blocks):
            if chain.last_update < at + 2:
                yield from _hidden_update(block, blocks[at + 1])
        elif block.command is not None and _brings(block.command):
            hiding = _hiding(chain, at, pipefail)
            if hiding is not None:
                yield Hidden(block.command.words[0], hiding)
        if block.kind == "branches":
            for body in block.bodies:
                yield from _hidden(body, pipefail)


def _brings(command: Command) -> bool:
    words = unwrapped(command.words)
    name = program_name(words[0]) if words else ""
    rest = [word for word in words[1:] if not word.startswith("-")]
    simulated = {"-s", "--simulate", "--dry-run", "--download-only", "--check"} & set(words)
    if name == "colcon":
        return "build" in rest
    return name in INSTALLERS and rest[:1] == [INSTALLERS[name]] and not simulated


def _updates_lists(block: Block) -> bool:
    return _name(block) in PACKAGE_LISTS and "update" in _words(block)


def _hidden_update(block: Block, fallback: Block) -> Iterator[Hidden]:
    """An update of the package lists whose failure is hidden."""
    name = _name(fallback)
    if name in PASSIVE:
        how, advice = f"'|| {name}' takes the failure for its own", f"remove '|| {name}'"
        yield Hidden(_words(block)[0], Hiding(_words(fallback)[0], how, advice, result=OLD_LISTS))


def _hiding(chain: Chain, at: int, pipefail: bool) -> Hiding | None:
    """What runs although a command failed, and how it comes to that; None where the build ends."""
    blocks, stop = chain.blocks, chain.stops[at]
    builds = _name(blocks[at]) == "colcon"
    if _ends(blocks[at]) == "|" and stop > at:
        tees = builds and not pipefail and _name(blocks[at + 1]) == "tee"
        what, advice = "tee succeeds all the same", "write set -o pipefail before the command"
        return Hiding(_words(blocks[at + 1])[0], what, advice) if tees else None
    if stop + 1 == len(blocks):
        return None
    following = blocks[stop + 1]
    if _ends(blocks[stop]) == "||":
        return _fallback(chain, at, following)
    if any(STATUS.search(word) for word in _words(following)) or not (builds or chain.succeed[stop + 1]):
        return None
    return Hiding(_words(following)[0], "the next command runs", JOIN, "this runs all the same")


def _fallback(chain: Chain, at: int, following: Block) -> Hiding | None:
    """The command after ``||`` that does nothing about a failure."""
    stop, name = chain.stops[at], _name(following)
    meant = _name(chain.blocks[at]) not in WHOLE
    if name not in PASSIVE or chain.checked > stop or (meant and (stop == at or not chain.succeed[stop + 1])):
        return None
    remedy = SKIP if _name(chain.blocks[stop]) == "rosdep" else f"remove '|| {name}'"
    return Hiding(_words(following)[0], f"'|| {name}' takes the failure for its own", remedy if stop == at else GROUP)


def _ends(block: Block) -> str:
    return str(block.command.ends if block.command is not None else block.ends)


def _words(block: Block) -> tuple[Located, ...]:
    return block.command.words if block.command is not None else ()


def _name(block: Block) -> str:
    words = unwrapped(_words(block))
    return program_name(words[0]) if words else ""
