"""A build step, a command or a health check uses what only bash understands, and sh reads it.

## What it finds
A `RUN` in shell form with `source`, `pushd`, `[[ ]]`, `set -o pipefail`, `echo -e` to a file or pipe, or braces such as
`{a,b}` in the words of `mkdir`, `rm`, `cp`, `mv`, `touch`, `chmod` or `chown`, in an image of Ubuntu, Debian, ROS or
CUDA, where `/bin/sh` is dash. The same in a here-document without `#!`, in CMD, ENTRYPOINT and HEALTHCHECK in shell
form, and in the `healthcheck:` of a compose service that is one text or begins with `CMD-SHELL`.

Silent after `SHELL`, after a step that makes `/bin/sh` bash, in branches, and in texts that another shell gets.
Braces of `rm` are information: nothing is removed, and the image is only larger.

## Why it matters on a robot
dash has no `source`: the step ends with "source: not found". After a `;` the build goes on without the environment of
ROS. A container whose CMD begins so ends at once, and a health check never succeeds. dash does not expand braces
either: `mkdir -p {maps,logs}` makes one folder called `{maps,logs}`, and the node that writes to `logs` fails on the
robot.

## Bad
```dockerfile
RUN source /opt/ros/jazzy/setup.bash && colcon build
```

## Good
```dockerfile
RUN . /opt/ros/jazzy/setup.sh && colcon build
```

## When to ignore it
When the base image of that name has bash as `/bin/sh`.

## References
- https://docs.docker.com/reference/dockerfile/#shell
- dash(1)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Reads
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import checks_of
from bringup_lint.api.docker import has_dash
from bringup_lint.api.docker import shell_texts
from bringup_lint.api.shell import Command

SH_IS_BASH = regex(
    r"\b(?:ln|cp|mv)\b[^;&]{0,80}\bbash\s{1,80}[^\n;&]{0,80}/bin/sh\b|/bin/sh\b[^\n;&]{0,80}\bbash\b"
    r"|\bln\b[^\n;&]{0,80}\bbash[ \t]{1,80}sh\b|dpkg-reconfigure[^\n;&]{0,80}\bdash\b"
)
BRACES = regex(r"[^\s\"'$]*(?<!\$)\{(?=[^\s{}\"'.,]*(?:\.(?!\.)[^\s{}\"'.,]*)*(?:,|\.\.))[^\s{}\"']*\}[^\s\"']*")
ENDS = {
    Reads.STEP: "the step fails",
    Reads.START: "the container ends at once",
    Reads.CHECK: "the container is never healthy",
}
STRICT = regex(r"-[a-z]{0,20}e[a-z]{0,20}|errexit")
FILES = ("mkdir", "rm", "cp", "mv", "touch", "chmod", "chown")


@rule(
    "error", symptoms=["/bin/sh: 1: [[: not found", "/bin/sh: 1: set: Illegal option -o pipefail", "source: not found"]
)
def bash_in_sh(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        stages = [stage for stage in file.stages if _is_dash(stage)]
        texts = (text for stage in stages for text in shell_texts(robot.compose, file, stage))
        found = [each for text in texts for each in _foreign(text.reads, text.commands)]
        if found:
            (word, message, severity), *others = sorted(found, key=lambda each: each[2] is not None)
            related = [note(other, "here too") for other, _, _ in others[:9]]
            yield finding(word, message, advice=ADVICE, related=related, severity=severity)
    for service in robot.compose.services:
        stage = robot.compose.stage(service)
        pulled = str(service.image or "") if service.build is None else ""
        if has_dash(pulled) if stage is None else _is_dash(stage):
            for word, message, severity in _foreign(Reads.CHECK, checks_of(service)):
                yield finding(word, message, advice=ADVICE_OF_CHECK, severity=severity)


ADVICE = 'write SHELL ["/bin/bash", "-c"] before it, or what sh understands'
ADVICE_OF_CHECK = 'let bash read it: ["CMD", "bash", "-c", "..."]'


def _is_dash(stage: Stage) -> bool:
    return has_dash(stage.origin) and not _has_shell(stage)


def _has_shell(stage: Stage) -> bool:
    """Whether something makes bash the shell of the steps."""
    for one in stage.chain:
        if any(one.all("SHELL")) or any(SH_IS_BASH.search(each.value) for each in one.all("RUN")):
            return True
    return False


def _foreign(reads: Reads, commands: list[Command]) -> Iterator[tuple[Located, str, str | None]]:
    if reads is Reads.CHECK and any(set(map(str, each.words)) & {"true", ":", "0"} for each in commands):
        return
    is_strict = False
    for command in commands:
        found = _wrong(reads, command, is_strict=is_strict) if not command.depth else None
        if found is not None:
            yield found
        is_strict = is_strict or (command.name == "set" and any(map(STRICT.fullmatch, command.words)))


def _wrong(reads: Reads, command: Command, *, is_strict: bool) -> tuple[Located, str, str | None] | None:
    words = command.words
    if not words or command.ends == "||":
        return None
    name = str(words[0])
    if name in ("source", "pushd"):
        is_last = is_strict or reads is Reads.CHECK or command.ends in ("&&", "")
        return words[0], f"sh has no '{name}': {ENDS[reads] if is_last else 'the next command runs without it'}", None
    if name == "[[":
        return words[0], "sh has no '[[': the condition is never true", None
    if name == "set" and "pipefail" in words[1:]:
        return words[0], f"dash has no pipefail: {ENDS[reads]}", None
    if (
        name == "echo"
        and words[1:2] == ("-e",)
        and (command.ends == "|" or any(each.writes for each in command.redirects))
    ):
        return words[1], "dash has no -e for echo: it is written too", "warning"
    braced = next((word for word in words[1:] if BRACES.fullmatch(word.span.text)), None) if name in FILES else None
    if braced is None:
        return None
    if name == "rm":
        return braced, f"sh does not expand braces: rm finds no '{braced}', and the files stay in the image", "info"
    return braced, f"sh does not expand braces: {name} takes '{braced}' for one name", None
