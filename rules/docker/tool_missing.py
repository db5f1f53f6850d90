"""An entrypoint runs a tool that nothing installs into its image.

## What it finds
`gosu`, `tini`, `dumb-init`, `su-exec`, `supervisord`, `xvfb-run`, `socat`, `nginx`, `sshd` or `tmux` as what a
container starts, in the script of the tree that it starts, or after `exec` in a script that a step writes with `echo`,
`printf` or a here-document, in an image on `ros`, `osrf/ros`, `ubuntu` or `debian`, which lack them, where no other
word of the Dockerfile and of the tree names the tool or its package.

Silent where a step installs from a list, or pipes a download into a shell.

## Why it matters on a robot
The container ends at once with status 127, "not found", and with a restart policy again and again.

## Bad
```dockerfile
FROM ros:jazzy-ros-base
ENTRYPOINT ["tini", "--", "/ros_entrypoint.sh"]
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
RUN apt-get update && apt-get install -y --no-install-recommends tini && rm -rf /var/lib/apt/lists/*
ENTRYPOINT ["tini", "--", "/ros_entrypoint.sh"]
```

## When to ignore it
When a build outside of the tree adds the tool.

## References
- https://hub.docker.com/_/ros, https://hub.docker.com/_/ubuntu and https://hub.docker.com/_/debian
"""

import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cache

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Instruction
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of_run
from bringup_lint.api.shell import program_name

TOOLS = {
    "gosu": "gosu",
    "tini": "tini",
    "dumb-init": "dumb-init",
    "su-exec": "su-exec",
    "supervisord": "supervisor",
    "xvfb-run": "xvfb",
    "socat": "socat",
    "nginx": "nginx",
    "sshd": "openssh-server",
    "tmux": "tmux",
}
"""Programs -> their packages in Debian and Ubuntu."""
PLAIN = regex(r"(?:docker\.io/)?(?:library/)?(?:ros|osrf/ros|ubuntu|debian)(?::.*)?")
ALSO = {"sshd": ("ssh", "task-ssh-server")}
"""Packages that bring these packages."""
LISTS = regex(
    r"\b(?:xargs|make|just|ansible-playbook)\b|\$\((?:cat|<)"
    r"|\b(?:curl|wget)\b[^\n|]{0,400}\|[ \t]*(?:sudo[ \t]+)?(?:ba|da)?sh\b"
)
"""Installs what the step does not name."""
STARTED = regex(r"\bexec[ \t]+(?P<tool>gosu|tini|dumb-init|su-exec|supervisord)\b", hints="exec")
USED = regex(r"(?m)^[ \t]*#[^\n]*$|\bexec[ \t]+(?:gosu|tini|dumb-init|su-exec|supervisord)\b")
"""Says nothing of where the tool is from."""
SPEAKS = ("echo", "printf", "cat", ":")
READS = ("RUN", "COPY", "ADD", "ENV", "ARG", "ONBUILD")


@rule(
    "error",
    confidence="medium",
    symptoms=["exec: gosu: not found", 'exec: "tini": executable file not found in $PATH', "exec: *: not found"],
)
def tool_missing(robot: Robot) -> Iterator[Finding]:
    seen = set()
    speaking = _speaking(robot)
    for stage, tool, where in (*_started(robot), *_written(robot)):
        if (stage, tool) in seen or not PLAIN.fullmatch(stage.origin):
            continue
        seen.add((stage, tool))
        if not _is_installed(stage, tool) and not any(each is not where.span.source for each in speaking(tool)):
            yield finding(
                where,
                f"Nothing installs {tool} into the image: the container ends with 'not found'",
                advice=f"install the package {TOOLS[tool]}",
                related=[note(stage.start.keyword, "this image lacks it")],
            )


def _started(robot: Robot) -> Iterator[tuple[Stage, str, Located]]:
    """The tools that containers start, themselves or by their scripts."""
    for runner in robot.runners.all:
        if runner.stage is None or not runner.source.judged:
            continue
        for command in runner.commands:
            words = command.words[1:] if command.name == "exec" else command.words
            tool = program_name(words[0]) if words else ""
            if tool in TOOLS:
                yield runner.stage, tool, words[0]


def _written(robot: Robot) -> Iterator[tuple[Stage, str, Located]]:
    """The tools that images start, and those in scripts that their steps write."""
    judged = (file for file in robot.dockerfiles if file.source.judged)
    for stage in (file.final for file in judged if file.final is not None):
        for start in filter(None, (stage.last("ENTRYPOINT"), stage.last("CMD"))):
            first = next(iter(start.exec_form or ()), "")
            if program_name(first) in TOOLS:
                at = max(start.value.find(first), 0)  # not as it is written where it has escapes
                yield stage, program_name(first), start.value.part(at, at + len(first))
        for text in (text for step in stage.all("RUN") for text in (step.value, *step.heredocs)):
            for match in STARTED.finditer(text):
                yield stage, match["tool"], text.part(*match.span("tool"))


def _is_installed(stage: Stage, tool: str) -> bool:
    """Whether a step may install it."""
    named = _named(tool)
    steps = [step for one in stage.chain for step in one.all(*READS)]
    return any(LISTS.search(step.value) or _names(step, named) for step in steps)


def _speaking(robot: Robot) -> Callable[[str], list[Source]]:
    """The files besides Dockerfiles that name a tool or its package other than to run it: they may bring it."""

    @cache
    def speaking(tool: str) -> list[Source]:
        named = _named(tool)
        others = (each for each in robot.sources if each.kind != "dockerfile")
        found = (each for each in others if named.search(each.text))
        return [each for each in found if named.search(USED.sub("", each.text))][:2]

    return speaking


def _named(tool: str) -> re.Pattern[str]:
    """A tool, or a package that brings it."""
    names = "|".join(map(re.escape, (tool, TOOLS[tool], *ALSO.get(tool, ()))))
    return re.compile(rf"(?<![\w-])(?:{names})(?![\w])")


def _names(step: Instruction, named: re.Pattern[str]) -> bool:
    """Whether a step names the tool other than in the text of a script that it writes."""
    if step.name != "RUN":
        return named.search(step.value) is not None
    if any(named.search(STARTED.sub("", text)) for text in step.heredocs):
        return True
    commands = (command for command in commands_of_run(step) if command.name not in SPEAKS)
    return any(named.search(word) for command in commands for word in (*command.assignments, *command.words))
