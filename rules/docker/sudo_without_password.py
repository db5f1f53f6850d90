"""The user of an image may become root without a password.

## What it finds
An image that runs a program as another user than root, and a step of it that gives a user or group `NOPASSWD: ALL` in
the files of sudo. Not reported: images in which somebody works, such as those that only start a shell, and those where
a later step removes sudo or its file, lines for another user than the one of the image, and those under a condition
that asks for an argument of the build.

## Why it matters on a robot
`USER` is there so that a hole in a node is not a hole in the whole container. With this line every program of the
container is root whenever it likes, and with `--privileged`, a mounted `/dev` or `/var/run/docker.sock` it has the
robot.

## Bad
```dockerfile
RUN useradd -m rover && echo 'rover ALL=(ALL) NOPASSWD: ALL' > /etc/sudoers.d/rover
USER rover
CMD ["ros2", "launch", "rover_bringup", "rover.launch.py"]
```

## Good
```dockerfile
RUN useradd -m rover
USER rover
CMD ["ros2", "launch", "rover_bringup", "rover.launch.py"]
```

## When to ignore it
When the image is for development only. Give it a target of its own then: `FROM robot AS development`.

## References
- sudoers(5), "NOPASSWD and PASSWD"
- CWE-250: Execution with Unnecessary Privileges
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Instruction
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import is_deployed
from bringup_lint.api.docker import last_user
from bringup_lint.api.docker import user_name
from bringup_lint.api.shell import SHELLS
from bringup_lint.api.shell import program_name

GIVES = regex(r"\bALL[ \t]*=[ \t]*\\?\(?[^\n;&|]{0,40}?NOPASSWD:[ \t]*ALL\b", hints="NOPASSWD")
TAKES = regex(
    r"\b(?:remove|purge)\b[^\n;&|]{0,200}\bsudo\b|\b(?:rm|truncate)\b[^\n;&|]{0,100}/etc/sudoers"
    r"|\bsed\b[^\n;&|]{0,60}/[^/\n;&|]{0,60}NOPASSWD[^/\n;&|]{0,60}/d"
)

NAMED = regex(r"(?<![\w%$@{}+-])([a-z_][a-z0-9_-]*)[ \t]+\Z")
PLAIN = regex(r"[a-z_][a-z0-9_-]*")
CHOOSES = regex(
    r"\bif\b(?:(?!\b(?:fi|then)\b)[^$]){0,200}\$(?:(?!\bfi\b)[\s\S])*\Z"
    r"|(?:\[|\btest\b)[^\n;&|$]{0,80}\$[^\n;&|]{0,80}&&[^;|]*\Z"
)
"""A condition that asks for an argument of the build."""
DEVELOPMENT = regex(r"(?:^|[-_])dev(?:el|elop|elopment|elopers?|container)?(?:$|[-_])", re.I)
"""The name of a stage in which somebody works."""
SUDO = regex(r"(?:^|[;&|][ \t]*)sudo[ \t]", re.M)
"""The start of a command that needs it."""
WAITS = ("tail", "sleep")


@rule("warning", silent="sudo does what it is told", tags=["CWE-250", "CWE-269"])
def sudo_without_password(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if "NOPASSWD" not in file.source.text or file.final is None or not is_deployed(robot.compose, file):
            continue
        if DEVELOPMENT.search(file.final.name or ""):
            continue
        runs = file.final.last("CMD")
        user = last_user(file.final) if runs is not None and not _only_waits(runs) else None
        if user is None or user_name(user) in (None, "root"):
            continue
        given = _given(file.final, user_name(user))
        if given is not None:
            yield finding(
                given,
                f"Every program of the image can become root without a password: USER {user} protects nothing",
                advice="leave the line out of the image that runs on the robot",
                related=[note(user, "the user that it runs as")],
                severity="info" if _is_needed(file.final, given) else None,
            )


def _only_waits(runs: Instruction) -> bool:
    """Whether a command only keeps a container open in which somebody works."""
    given = runs.exec_form if runs.exec_form is not None else runs.value.split()
    words = [word for word in given if not word.startswith("-")]
    name = program_name(words[0]) if words else ""
    return not name or name in WAITS or (name in SHELLS and (len(words) == 1 or words[1].startswith(WAITS)))


def _is_needed(stage: Stage, given: Located) -> bool:
    """Whether later steps of the same Dockerfile call sudo: without the line they would fail."""
    later = (each for each in stage.all("RUN") if each.keyword.span.start > given.span.end)
    return any(SUDO.search(each.value) for each in later)


def _given(stage: Stage, user: str | None) -> Located | None:
    """The text that a step writes to a file of sudo, where no step takes it back."""
    steps = [step for one in stage.chain for step in one.all("RUN")]
    texts = [text for step in steps for text in (step.value, *step.heredocs)]
    if any(map(TAKES.search, texts)):
        return None
    for text in texts:
        for match in GIVES.finditer(text):
            before = text[: match.start()]
            named = NAMED.search(before)
            is_other = named is not None and user is not None and PLAIN.fullmatch(user) and named[1] != user
            if "sudoers" in text and not is_other and not CHOOSES.search(before):
                return text.part(*match.span())
    return None
