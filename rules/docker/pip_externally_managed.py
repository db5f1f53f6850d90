"""pip is to install into the system's Python, which refuses it.

## What it finds
`pip install` in an image of Ubuntu 24.04 (ROS 2 Jazzy and later) or Debian 12 and later, without
`--break-system-packages` and outside of a virtual environment.

Silent where anything in the Dockerfile sets that option (`PIP_BREAK_SYSTEM_PACKAGES`, `pip.conf`), removes the mark
`EXTERNALLY-MANAGED`, or has to do with virtual environments, conda or uv, and where the step may fail.

## Why it matters on a robot
These systems mark their Python as managed by apt: pip ends with `error: externally-managed-environment`, and the image
is not built. The same file worked for Humble.

## Bad
```dockerfile
FROM ros:jazzy-ros-base
RUN pip3 install pyrtcm
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
RUN pip3 install --break-system-packages pyrtcm
```

## When to ignore it
When the base image is another one of that name, without the mark.

## References
- PEP 668
- pip, "--break-system-packages"
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
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of
from bringup_lint.api.docker import has_dash
from bringup_lint.api.docker import ubuntu_codename
from bringup_lint.api.shell import unwrapped

MANAGED = ("noble", "resolute")
DEBIAN = regex(
    r"(?:docker\.io/)?(?:library/)?(?:(?:arm64v8|amd64|arm32v7)/)?debian:(?:12|13|bookworm|trixie)(?:[.-].*)?"
)
ALLOWED = regex(
    r"break[-_]system[-_]packages|(?<!pip-)EXTERNALLY|venv|virtualenv|conda|mamba|pyenv|\buv\b|pip\.conf|deadsnakes|altinstall"
    r"|python\.org/ftp|PIP_(?:TARGET|PREFIX|ROOT|PYTHON|CONFIG_FILE)\b|^ENV[ \t]+PATH\b"
    r"|^(?:COPY|ADD)[ \t][^\n]*[ \t]/(?:etc|root|usr|usr/local)?/?[ \t]*$",
    re.I | re.M,
)
PIP = regex(r"(?:/usr/bin/)?pip3?")
PYTHON = regex(r"(?:/usr/bin/)?python3?")
SCRIPT = regex(r"(?!/usr/bin/|/bin/)[^=]*/.*|.*\.(?:ba)?sh")
ELSEWHERE = regex(r"-t|--(?:target|prefix|root|dry-run|python|help)(?:=.*)?")


@rule("error", symptoms=["error: externally-managed-environment", "This environment is externally managed"])
def pip_externally_managed(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if "pip" not in file.source.text:
            continue
        for stage in file.stages:
            if not _is_managed(stage) or robot.compose.images.is_chosen(stage, tag=True):
                continue
            if any(ALLOWED.search(each.start.value.span.source.text) for each in stage.chain):
                continue
            word = next(_installs(stage), None)
            if word is not None:
                yield finding(
                    word,
                    "The Python of this system is managed by apt: pip refuses to install into it, and the build stops",
                    advice="add --break-system-packages, or install into a virtual environment",
                    related=[note(stage.start.value, "the image")],
                )


def _is_managed(stage: Stage) -> bool:
    image = stage.origin
    return has_dash(image) and (ubuntu_codename(image) in MANAGED or DEBIAN.fullmatch(image) is not None)


def _installs(stage: Stage) -> Iterator[Located]:
    """The steps that surely run pip for the system's Python."""
    before = ""
    for command in commands_of(stage):
        words = unwrapped(command.words)
        if _may_prepare(words):
            return
        if len(words) > 2 and PYTHON.fullmatch(words[0]) and words[1:3] == ("-m", "pip"):
            words = words[2:]
        may_fail = command.depth or "||" in (before, command.ends) or command.ends == "|"
        before = command.ends
        asked = next((word for word in words[1:] if not word.startswith("-")), None)
        if may_fail or asked != "install":
            continue
        if PIP.fullmatch(words[0]) and not any(map(ELSEWHERE.fullmatch, words)):
            yield words[0]


def _may_prepare(words: tuple[Located, ...]) -> bool:
    """Whether a command is a script, which may let pip through, or enters an environment."""
    if words and words[0] in (".", "source"):
        return "/setup." not in words[-1]
    return any(SCRIPT.fullmatch(word) for word in words[: 2 if words and words[0] in ("sh", "bash") else 1])
