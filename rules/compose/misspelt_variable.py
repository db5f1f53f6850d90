"""A variable of a compose file is misspelt.

## What it finds
`${NAME}` of a name that nothing else in the tree has, and that differs in one letter from the key before it, from a
variable of an environment file, from one that the compose file has twice, or from a well-known one such as `DISPLAY`
or `ROS_DOMAIN_ID`. And a key that nothing else in the tree has, and that differs so from the variable in its value,
which a program or script of the tree knows. One letter is left out, there twice, the one beside it on the keyboard, or
exchanged with the next.

Also `${NAME}` that nothing sets, where the `.env` beside the file sets exactly one longer or shorter name of the same
beginning, and nothing reads that: `NTRIP_USER` and `NTRIP_USERNAME`. Silent where the compose file has an `env_file`.

## Why it matters on a robot
docker compose puts nothing in the place of the variable, or its default: the setting of the robot has no effect. A
misspelt key sets a variable that no program of the container reads.

## Bad
```yaml
environment:
  ROVER_NAME: ${ROVER_NAM:-rover}
```

## Good
```yaml
environment:
  ROVER_NAME: ${ROVER_NAME:-rover}
```

## When to ignore it
When whoever starts the project sets the variable, or a program in the image reads it by this name.

## References
- https://docs.docker.com/reference/compose-file/interpolation/
"""

import re
from collections import Counter
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import variables
from bringup_lint.api.spelling import Neighbours
from bringup_lint.api.spelling import is_slip
from bringup_lint.api.spelling import numbered

USED = regex(r"(?<![$\\])\$\{?(?P<name>[A-Za-z_]\w{3,})", hints="$")
KEY = regex(
    r"^[ \t]*(?:-[ \t]+)?[\"']?(?P<key>[A-Za-z_]\w{3,})[\"']?[ \t]*[:=][ \t]*[\"']?\$\{?(?P<name>[A-Za-z_]\w{3,})",
    re.M,
    "$",
)
ASSIGNED = regex(r"^[ \t]*(?:export[ \t]+)?([A-Za-z_]\w{3,})=", re.M, "=")
COMMENT = regex(r"(?:^|[ \t])#")
SETS = ("compose", "env-file")
OF_SHELL = frozenset("HOME USER PATH SHELL LANG TERM LOGNAME HOSTTYPE SUDO_USER SSH_AUTH_SOCK".split())
"""What every shell that starts docker compose has."""
WELL_KNOWN = ("DISPLAY", "HOSTNAME", "XAUTHORITY", "XDG_RUNTIME_DIR", "WAYLAND_DISPLAY", "COMPOSE_PROJECT_NAME")


@rule("warning", confidence="medium", symptoms=['The "*" variable is not set. Defaulting to a blank string.'])
def misspelt_variable(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("compose"):
        if source.judged and not source.template and "$" in source.text:
            yield from _misspelt_names(robot, source)
            yield from _misspelt_keys(robot, source)


def _misspelt_names(robot: Robot, source: Source) -> Iterator[Finding]:
    used = [match for match in USED.finditer(source.text) if not _in_comment(source, match.start())]
    counted = Counter(match["name"] for match in used)
    keys = (match["key"] for match in KEY.finditer(source.text))
    files = (name for file in robot.of_kind("env-file") for name in ASSIGNED.findall(file.text))
    repeated = (name for name, count in counted.items() if count > 1)
    slips = Neighbours((*keys, *files, *repeated, *WELL_KNOWN, *variables()))
    for match in used:
        name = match["name"]
        meant = [each for each in slips.meant(name) if _is_slip(name, each)]
        if meant and counted[name] == 1 and not _is_elsewhere(robot, source, name, match.start("name")):
            yield finding(
                source.located(*match.span("name")),
                f"Nothing sets {name}: docker compose puts nothing or the default in its place",
                advice=f"did you mean {meant[0]}?",
            )
    yield from _abridged_names(robot, source, {match["name"]: match for match in reversed(used)})


def _abridged_names(robot: Robot, source: Source, used: dict[str, re.Match[str]]) -> Iterator[Finding]:
    beside = _beside(robot, source)
    if not beside:
        return
    for name, match in used.items():
        other = _abridged(robot, source, name, beside)
        if other is not None:
            yield finding(
                source.located(*match.span("name")),
                f"Nothing sets {name}: docker compose puts nothing or the default in its place, and nothing reads "
                f"{other}",
                advice=f"did you mean {other}?",
                related=[note(other, "set here")],
            )


def _beside(robot: Robot, source: Source) -> list[Located]:
    """What the ``.env`` beside a compose file sets; nothing where containers may get it, too."""
    if "env_file" in source.text:
        return []
    path = f"{source.name.rpartition('/')[0]}/.env".lstrip("/")
    files = (file for file in robot.of_kind("env-file") if file.name == path)
    return [file.located(*match.span(1)) for file in files for match in ASSIGNED.finditer(file.text)]


def _abridged(robot: Robot, source: Source, name: str, beside: list[Located]) -> Located | None:
    """The only variable beside a file that begins as a name, or the reverse, where nothing reads it."""
    if name in OF_SHELL or name in WELL_KNOWN or name in variables():
        return None
    near = [
        each
        for each in beside
        if _begins_as(name, each) and not _is_elsewhere(robot, each.span.source, each, each.span.start)
    ]
    return near[0] if len(near) == 1 and not _is_set(robot, source, name) else None


def _begins_as(name: str, other: str) -> bool:
    """Whether one name is the other and more than a letter, which would be a slip."""
    return abs(len(name) - len(other)) > 1 and (other.startswith(name) or name.startswith(other))


def _is_set(robot: Robot, source: Source, name: str) -> bool:
    """Whether another file may set a variable before docker compose reads it."""
    word = re.escape(name)
    sets = re.compile(
        rf"\bexport[ \t]+{word}\b|(?<!\w){word}[\"'\]]{{0,2}}[ \t]{{0,9}}[:?+]{{0,2}}=|^[ \t]*{word}:", re.M
    )
    return any(name in each.text and sets.search(each.text) for each in robot.sources if each is not source)


def _misspelt_keys(robot: Robot, source: Source) -> Iterator[Finding]:
    for match in KEY.finditer(source.text):
        key, name = match["key"], match["name"]
        if key != name and _is_slip(key, name) and Neighbours((name,)).meant(key):
            if (name in variables() or _is_read(robot, name)) and not _is_elsewhere(
                robot, source, key, match.start("key")
            ):
                yield finding(
                    source.located(*match.span("key")),
                    f"Nothing reads {key}: the container does not get {name}",
                    advice=f"write {name}",
                )


def _is_slip(name: str, meant: str) -> bool:
    """Whether one is the other misspelt, and not several of them or another of several."""
    return is_slip(name, meant) and name.rstrip("sS") != meant.rstrip("sS") and not numbered(name, meant)


def _is_read(robot: Robot, name: str) -> bool:
    """Whether another file than those of docker compose has the name, so that a program may read it."""
    alone = _alone(name)
    return any(name in each.text and alone.search(each.text) for each in robot.sources if each.kind not in SETS)


def _alone(name: str) -> re.Pattern[str]:
    return re.compile(rf"(?<!\w){re.escape(name)}(?!\w)")


def _is_elsewhere(robot: Robot, source: Source, name: str, at: int) -> bool:
    """Whether a name is in another place of the tree than one of a file."""
    alone = _alone(name)
    if any(found.start() != at for found in alone.finditer(source.text)):
        return True
    return any(name in each.text and alone.search(each.text) for each in robot.sources if each is not source)


def _in_comment(source: Source, at: int) -> bool:
    return COMMENT.search(source.line_before(at)) is not None
