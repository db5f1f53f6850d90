"""docker compose replaces a variable that the shell of the container is to read.

## What it finds
`$NAME` or `${NAME}` in the command or entrypoint of a service,
- where the service itself gives NAME to the container, with `environment:`, an `env_file:` or the Dockerfile of its
  image;
- where the same text of a shell sets NAME;
- where the text puts something before or after it: `PYTHONPATH=$PYTHONPATH:/opt/drive`.

Silent where `.env`, a script, a recipe of make or a text for people sets NAME: compose may know it then.

## Why it matters on a robot
Compose replaces variables in all values before it starts the container. It takes them from `.env` and from the shell in
which it is called, and never from `environment:` or `env_file:`. On a robot nothing sets them there: the command runs
with a gap, or with a path of the host.

## Bad
```yaml
environment:
  DRIVE_PORT: /dev/rover-drive
command: bash -c 'ros2 run rover_drive drive --port $DRIVE_PORT'
```

## Good
```yaml
environment:
  DRIVE_PORT: /dev/rover-drive
command: bash -c 'ros2 run rover_drive drive --port $$DRIVE_PORT'
```

## When to ignore it
When whoever calls docker compose sets the variable.

## References
- https://docs.docker.com/reference/compose-file/interpolation/
- https://docs.docker.com/compose/how-tos/environment-variables/variable-interpolation/
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.docker import assignments

USED = regex(
    r"(?<!\$)(?:\$\$)*(?P<use>\$(?:\{(?P<braced>[A-Za-z_]\w*)\}|(?P<plain>[A-Za-z_]\w*)))(?P<adds>:[^\s\"';&|])?",
    hints="$",
)
SHELL = regex(r"(?:^|/)(?:ba|da|z)?sh")
SETS = (
    r"(?:^|[\s;&|(\"'])(?:(?:export|local|readonly|declare)\s+(?:-\w+\s+)*)?{0}\+?=|\bfor\s+{0}\s+in\b"
    r"|\bread\s[^;|&]*\b{0}\b"
)
"""How a shell sets a variable."""
LIST = regex(r"\b(?P<name>\w*PATH)=[\"']?(?P<adds>[^\s;&|\"'$]{1,400}:)?$", hints="PATH=")
"""The assignment of a list of folders, up to what it takes over."""
GIVEN = r"(?<![\w$-]){0}[ \t]*[:?]?="
"""How an environment file, a script, a recipe of make or a text for people sets a variable."""
TEXTS = regex(r"\.(?:md|rst|txt)$|(?:^|/)(?:(?:GNU)?[Mm]akefile|[Jj]ustfile|Taskfile\.ya?ml|\.env[^/]*)$|\.env$")
SAME = r"\$(?:{0}\b|\{{{0}(?:\}}|:?\?))"
"""The value of a variable that the container gets as docker compose knows it."""
READ = 200_000
OF_THE_IMAGE = ("compose", "dockerfile")


class Use(NamedTuple):
    service: Service
    text: Located
    where: Located
    name: str
    before: str
    adds: bool
    """A colon and another folder follow."""


class Setter(NamedTuple):
    where: Located | None
    says: str


@rule("warning", confidence="medium", symptoms=['The "*" variable is not set. Defaulting to a blank string.'])
def variable_of_container(robot: Robot) -> Iterator[Finding]:
    for file in robot.compose.files:
        if file.source.judged and not file.source.template and "$" in file.source.text:
            found: dict[str, tuple[Use, Setter]] = {}
            for use in (use for service in file.services for use in _uses(service)):
                setter = _setter(robot, use) if use.name not in found else None
                if setter is not None:
                    found[use.name] = (use, setter)
            for use, setter in found.values():
                yield _report(use, setter)


def _uses(service: Service) -> Iterator[Use]:
    for text in service.scripts:
        for match in USED.finditer(text):
            name = match["braced"] or match["plain"]
            where = text.part(*match.span("use"))
            yield Use(service, text, where, name, text[: match.start("use")], match["adds"] is not None)


def _report(use: Use, setter: Setter) -> Finding:
    in_shell = any(SHELL.fullmatch(word) for word in use.service.scripts)
    return finding(
        use.where,
        f"docker compose puts in the {use.name} of the host before the container starts: {setter.says}",
        advice=f"write $${use.name}"
        if in_shell
        else f"set {use.name} in .env beside this file, or write its value here",
        related=[note(setter.where, "set for the container alone")] if setter.where is not None else [],
    )


def _setter(robot: Robot, use: Use) -> Setter | None:
    """What gives the container the variable that docker compose does not know; None where it may know it."""
    takes = LIST.search(use.before)
    if takes is not None and takes["name"] == use.name and (use.adds or takes["adds"]):
        return Setter(None, "the one of the image is lost")
    where = _set_in_text(use) or _set_by_service(robot, use) or _set_by_image(robot, use)
    if where is None or _may_be_given(robot, use):
        return None
    return Setter(where, "nothing, where only the container has it")


def _set_in_text(use: Use) -> Located | None:
    match = re.search(SETS.format(re.escape(use.name)), use.before)
    return use.text.part(*match.span()) if match is not None else None


def _set_by_service(robot: Robot, use: Use) -> Located | None:
    own = use.service.environment.get(use.name)
    if own is not None:
        return own.name if own.value is not None and not re.match(SAME.format(re.escape(use.name)), own.value) else None
    return next((value for _, value in robot.compose.variables(use.service, use.name)), None)


def _set_by_image(robot: Robot, use: Use) -> Located | None:
    stage = robot.compose.stage(use.service)
    if stage is None:
        return None
    given = (pair for one in stage.chain for each in one.all("ENV") for pair in assignments(each))
    return next((value for name, value in given if name == use.name), None)


def _may_be_given(robot: Robot, use: Use) -> bool:
    """Whether something sets the variable in the shell that calls docker compose, or in a file that it reads."""
    given = re.compile(GIVEN.format(re.escape(use.name)))
    own = [each for each in robot.compose.env_files(use.service) if each.basename != ".env"]
    others = (each.text for each in robot.sources if each.kind not in OF_THE_IMAGE and each not in own)
    kept = {path for each in own for path in (each.name, each.absolute)}
    told = (robot.tree.head(path, READ) for path in robot.tree.paths if TEXTS.search(path) and path not in kept)
    return any(use.name in text and given.search(text) for texts in (others, told) for text in texts)
