"""A script writes a file with a variable that nothing sets.

## What it finds
`>`, `>>` and `tee`, outside of branches, of a text with a variable whose name stands nowhere else in the tree: no line
of a script sets, reads or tests it, no unit, image or compose file gives it, and no page speaks of it.

Silent for variables that a login, a shell or ROS sets, for defaults (`${NAME:-value}`), in scripts that source another
file than the setup files of ROS or `.bashrc`, in those that build images, and under `set -u`, where the script ends.

## Why it matters on a robot
The shell puts nothing in its place: `export ROS_IP=` in `.bashrc` takes the address away that was set above, and a unit
starts without its argument. The script ends with success.

## Bad
```sh
echo "export ROBOT_IP=${ROVER_IP}" >> ~/.bashrc    # ROVER_IP is set nowhere
```

## Good
```sh
ROVER_IP=${1:?the address of the rover}
echo "export ROBOT_IP=${ROVER_IP}" >> ~/.bashrc
```

## When to ignore it
When whoever runs the script always exports the variable before.

## References
- bash(1), "Parameter Expansion"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import runs_in_image

UNKNOWN = regex(r"\{\{ (?P<name>[A-Za-z_]\w*) \}\}")
USE = regex(r"(?<!\\)\$\{?([A-Za-z_]\w*)(?![\w:])")
SOURCED = regex(r"^[ \t]*(?:source|\.)[ \t]+(?![^\n]*(?:setup\.(?:ba|z)?sh|\.bashrc)[\"']?[ \t]*$)", re.M)
"""Reads a file that may set anything."""
STRICT = regex(r"^[ \t]*set[ \t]+(?:-\w*u|-o[ \t]+nounset)|\A#![^\n]*[ \t]-\w*u\w*", re.M)
"""The script ends at a variable that is not set: whoever runs it is to give it."""
GIVEN = regex(
    r"(?:HOME|USER|LOGNAME|PATH|PWD|OLDPWD|HOST\w*|SHELL|TERM|LANG|DISPLAY|XAUTHORITY|EDITOR|U?ID|EUID|RANDOM|SECONDS"
    r"|LINENO|IFS|OSTYPE|MACHTYPE|TMPDIR|PYTHONPATH|LD_LIBRARY_PATH|VIRTUAL_ENV|CYCLONEDDS_URI|no_proxy"
    r"|(?:UBUNTU|VERSION)_CODENAME|VERSION_ID|\w+_(?:proxy|PROXY)"
    r"|(?:LC|XDG|SSH|SUDO|DBUS|BASH|ROS|RMW|RCUTILS|AMENT|COLCON|CMAKE|GAZEBO|IGN|GZ|CONDA|CUDA|CI|GITHUB|GITLAB|RUNNER"
    r"|DOCKER|WSL|FASTRTPS|FASTDDS)_\w+)"
)
"""Variables that a login, a shell, ROS or a service of builds sets."""
PAGE = regex(
    r"\.(?:md|rst|txt|ya?ml|mk|env|json|toml|cfg|ini|py)$|(?:^|/)(?:Makefile|Dockerfile|Jenkinsfile|\.env)[^/]*$"
)
MOST = 100_000
MOST_NAMES = 200
"""Variables that are looked for in the whole tree."""
PASSING = ("/dev/", "/proc/", "/sys/")


@rule("warning", confidence="medium", silent="the shell puts nothing in the place of the variable")
def written_variable_unset(robot: Robot) -> Iterator[Finding]:
    seen: set[tuple[Source, str]] = set()
    for source, written in robot.scripts.written("$"):
        names = dict.fromkeys(UNKNOWN.findall(str(written.text or ""))) if written.certain else {}
        if not names or written.path.startswith(PASSING) or _is_given(source):
            continue
        uses = _uses(source)
        for name in names:
            places = uses.get(name, ())
            if not places or (source, name) in seen or GIVEN.fullmatch(name):
                continue
            seen.add((source, name))
            if len(seen) <= MOST_NAMES and not _is_said(robot, source, name, len(places)):
                yield finding(
                    source.located(*places[0]),
                    f"Nothing sets {name}: {written.where} gets nothing in its place",
                    advice="set it before, or take it from an argument",
                )


def _is_given(source: Source) -> bool:
    """Whether a file that the script reads, an image or whoever runs it may give it variables."""
    text = source.text
    return SOURCED.search(text) is not None or STRICT.search(text) is not None or runs_in_image(source)


def _uses(source: Source) -> dict[str, list[tuple[int, int]]]:
    """Variable -> where the script uses it."""

    def made() -> dict[str, list[tuple[int, int]]]:
        found: dict[str, list[tuple[int, int]]] = {}
        for match in USE.finditer(source.text):
            found.setdefault(match[1], []).append(match.span())
        return found

    return source.once(_uses, made)


def _is_said(robot: Robot, source: Source, name: str, uses: int) -> bool:
    """Whether anything but the uses in the script has the name."""
    word = re.compile(rf"(?<!\w){re.escape(name)}(?!\w)")
    if len(word.findall(source.text)) > uses:
        return True
    others = (each.text for each in robot.sources if each is not source and name in each.text)
    if any(map(word.search, others)):
        return True
    pages = robot.tree.pages(PAGE, MOST)
    return any(name in page and word.search(page) for page in pages)
