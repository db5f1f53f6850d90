"""docker compose replaces a variable that the shell of the container is to read.

## What it finds
`$NAME` or `${NAME}` in the command or entrypoint of a service,
- where the service itself gives NAME to the container, with `environment:`, an `env_file:` or the Dockerfile of its
  image;
- where the same text of a shell sets NAME;
- where the text puts something before or after it: `PYTHONPATH=$PYTHONPATH:/opt/drive`; as information where the text
  sources a setup file after that, which sets it again.

Also the host's side of a mount or a device, where the service itself gives NAME to the container.

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

import posixpath
import re
from collections.abc import Iterator
from itertools import islice

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.docker import environment_of

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
GIVEN = regex(
    r"(?<![\w$-])(?P<set>[A-Za-z_]\w*)[ \t]*[:?]?=|\benviron\b[^\n]{0,40}?[\"'](?P<python>[A-Za-z_]\w*)[\"']"
    r"|\b(?:export|read)[ \t]+(?:-\w+[ \t]+(?:\"[^\"\n]*\"[ \t]+)?)*(?P<shell>[A-Za-z_]\w*)"
    r"|^[ \t-]*[\"']?(?P<yaml>[A-Z_][A-Z0-9_]*)[\"']?:[ \t]",
    re.M,
)
"""How an environment file, a script, a recipe of make, a play, a workflow or a text for people sets a variable."""
TEXTS = regex(r"\.(?:md|rst|txt|env|conf|cfg|ini|py|ya?ml)$|(?:^|/)(?:(?:GNU)?[Mm]akefile|[Jj]ustfile|\.env[^/]*)$")
HANDED = regex(r"--env-file[ =][\"']?(?P<path>[^\s\"']{1,200})", hints="--env-file")
"""An environment file that docker compose itself gets."""
SETUP = regex(r"(?:\bsource|[\s;&|]\.)[ \t]{1,9}[^\s;&|]{0,300}setup\.\w", hints="setup.")
"""What sets the paths of ROS, whatever they were before."""
SAME = r"\$(?:{0}\b|\{{{0}(?:\}}|:?\?))"
"""The value of a variable that the container gets as docker compose knows it."""
OF_LOGIN = regex(
    r"HOME|USER|LOGNAME|PWD|SHELL|TERM|LANG|HOSTNAME|DISPLAY|XAUTHORITY|UID|GID|SSH_AUTH_SOCK|(?:XDG|ROS)_\w+"
)
"""What the shell of whoever calls docker compose has."""
READ = 200_000
LONGEST = 20_000
MOST = 64
"""Of a text that is looked through, and of its variables."""
BEFORE = 500
OF_THE_IMAGE = ("compose", "dockerfile")


class Use(NamedTuple):
    service: Service
    text: Located
    where: Located
    name: str
    before: str
    adds: bool
    """A colon and another folder follow."""
    of_host: bool = False
    """Not what the container runs: docker compose alone reads it."""


class Setter(NamedTuple):
    where: Located | None
    says: str
    again: bool = False
    """The text sets it again before anything reads it."""


@rule("warning", confidence="medium", symptoms=['The "*" variable is not set. Defaulting to a blank string.'])
def variable_of_container(robot: Robot) -> Iterator[Finding]:
    given: dict[str, set[str]] = {}
    for file in robot.compose.files:
        if file.source.judged and not file.source.template and "$" in file.source.text:
            found: set[tuple[str, bool]] = set()
            for use in (use for each in file.services for use in (*_uses(each), *_host_uses(each))):
                setter = _setter(robot, use) if (use.name, False) not in found else None
                if setter is None or (use.name, setter.again) in found:
                    continue
                if setter.where is not None:
                    given = given or _given(robot)
                    if _may_be_given(robot, use, given):
                        continue
                found.add((use.name, setter.again))
                yield _report(use, setter)


def _uses(service: Service) -> Iterator[Use]:
    for text in service.scripts:
        if "$" in text and len(text) <= LONGEST:
            for match in islice(USED.finditer(text), MOST):
                name = match["braced"] or match["plain"]
                where = text.part(*match.span("use"))
                yield Use(service, text, where, name, text[: match.start("use")], match["adds"] is not None)


def _host_uses(service: Service) -> Iterator[Use]:
    """The variables in what compose takes from the host."""
    sources = (volume.source for volume in service.volumes if volume.source is not None)
    for text in (*sources, *(device.host for device in service.devices)):
        for match in islice(USED.finditer(text), MOST):
            name = match["braced"] or match["plain"]
            if not OF_LOGIN.fullmatch(name):
                yield Use(service, text, text.part(*match.span("use")), name, "", False, True)


def _report(use: Use, setter: Setter) -> Finding:
    if use.of_host:
        return finding(
            use.where,
            f"docker compose takes {use.name} from .env or the host alone: nothing is put in here",
            advice=f"set {use.name} in .env beside this file, or write its value here",
            related=[note(setter.where, "set for the container alone")] if setter.where is not None else [],
        )
    in_shell = any(SHELL.fullmatch(word) for word in use.service.scripts)
    return finding(
        use.where,
        f"docker compose puts in the {use.name} of the host before the container starts: {setter.says}",
        advice=f"write $${use.name}"
        if in_shell
        else f"set {use.name} in .env beside this file, or write its value here",
        related=[note(setter.where, "set for the container alone")] if setter.where is not None else [],
        severity="info" if setter.again else None,
    )


def _setter(robot: Robot, use: Use) -> Setter | None:
    """What gives the container the variable."""
    takes = LIST.search(use.before[-BEFORE:])
    if takes is not None and takes["name"] == use.name and (use.adds or takes["adds"]):
        again = use.name != "PATH" and SETUP.search(use.text, len(use.before)) is not None
        return Setter(None, "the one of the image is lost", again)
    if use.of_host:
        given = _set_by_service(robot, use)
        return Setter(given, "") if given is not None else None
    where = _set_in_text(use) or _set_by_service(robot, use) or _set_by_image(robot, use)
    return Setter(where, "nothing, where only the container has it") if where is not None else None


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
    return next((value for name, value in environment_of(stage) if name == use.name), None)


def _given(robot: Robot) -> dict[str, set[str]]:
    """The names that files of the tree set in a shell or for docker compose, each with the files that do; without a
    name, those of the environment files that docker compose gets."""
    sources = ((each.absolute, each.text) for each in robot.sources if each.kind not in OF_THE_IMAGE)
    of_images = {each.absolute for each in robot.of_kind(*OF_THE_IMAGE)}
    paths = (each for each in robot.tree.like(TEXTS) if posixpath.abspath(each) not in of_images)
    told = ((posixpath.abspath(path), robot.tree.head(path, READ)) for path in paths)
    found: dict[str, set[str]] = {"": set()}
    for path, text in (each for texts in (sources, told) for each in texts):
        for name in {match[match.lastgroup or 0] for match in GIVEN.finditer(text)}:
            found.setdefault(name, set()).add(path)
        found[""].update(map(posixpath.basename, HANDED.findall(text)))
    return found


def _may_be_given(robot: Robot, use: Use, given: dict[str, set[str]]) -> bool:
    """Whether something sets the variable in the shell that calls docker compose, or in a file that it reads."""
    of_container = (each for each in robot.compose.env_files(use.service) if each.basename not in (".env", *given[""]))
    own = {each.absolute for each in of_container}
    return not given.get(use.name, set()) <= own
