"""docker run keeps the quotes of an environment file.

## What it finds
A file with quoted values that a `docker run --env-file` of a unit reads, whether a unit reads it with EnvironmentFile=
as well or not. Compose removes the quotes of env files and is not reported. In the list form of `environment:` it does
not: `- NAME="value"` keeps them.

## Why it matters on a robot
In the container the quotes are part of the value: an RMW implementation called "rmw_cyclonedds_cpp", with its
quotes, does not exist, and the nodes stop.

## Bad
```sh
RMW_IMPLEMENTATION="rmw_cyclonedds_cpp"
```

## Good
```sh
RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
```

## When to ignore it
When the program in the container does not use the variable.

## References
- docker run reference, "--env-file"; systemd.exec(5), "EnvironmentFile="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.environment import docker_env_files

MOST = 20


@rule("warning", fix="unsafe", symptoms=["Expected RMW implementation identifier of '\"*\"' but instead found"])
def quotes_kept_by_docker(robot: Robot) -> Iterator[Finding]:
    yield from _of_env_files(robot)
    yield from _of_docker_alone(robot)
    if robot.of_kind("compose"):
        yield from _of_services(robot)


def _of_services(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        quoted: dict[Source, list[tuple[Located, Located]]] = {}
        for variable in service.environment.values():
            value = variable.value
            if value is not None and variable.in_list and value[:1] in ("'", '"') and len(value) > 1:
                if value[-1] == value[0] and value[0] not in value[1:-1]:
                    quoted.setdefault(value.span.source, []).append((variable.name, value))
        for found in quoted.values():
            yield _of_list(found)


def _of_list(found: list[tuple[Located, Located]]) -> Finding:
    """One finding for the variables of a service in one file."""
    (name, value), *others = found
    more = f" (and {len(others)} more)" if others else ""
    plain = [(each, each[1:-1]) for _, each in found if each[1:-1].isascii() and " " not in each]
    return finding(
        value,
        f"Compose keeps the quotes of {name}{more} as part of the value",
        advice=f"write {name}={value[1:-1]}, or quote the whole entry",
        related=[note(each, "and here") for _, each in others[:MOST]],
        fix=fix("remove the quotes", *plain) if len(plain) == len(found) else None,
    )


def _of_env_files(robot: Robot) -> Iterator[Finding]:
    for file in robot.env_files:
        reader = file.docker_run
        if reader is None:
            continue
        for entry in file.model.entries:
            if not entry.quoted:
                continue
            written = entry.span.text.partition("=")[2].strip()
            plain = len(written) >= 2 and written[1:-1] == entry.value and not set(entry.value) & set(" \t\n#'\"\\")
            start = entry.span.end - len(entry.span.text.partition("=")[2])
            edit = (file.source.span(start, entry.span.end), str(entry.value))
            yield finding(
                entry.name,
                f"docker keeps the quotes of {entry.name} as part of the value, but systemd removes them",
                advice="write the value without quotes",
                related=[
                    note(reader, "docker reads it here"),
                    note(file.readers[0].value, "systemd reads it here"),
                ],
                fix=fix("remove the quotes", edit) if plain else None,
            )


def _of_docker_alone(robot: Robot) -> Iterator[Finding]:
    """The files that no unit reads itself."""
    for model, reader in docker_env_files(robot.files, robot.units):
        quoted = [each for each in model.entries if each.quoted]
        if quoted:
            first, *others = quoted
            more = f" (and {len(others)} more)" if others else ""
            yield finding(
                first.name,
                f"docker keeps the quotes of {first.name}{more} as part of the value",
                advice="write the value without quotes",
                related=[
                    note(reader, "docker reads it here"),
                    *(note(each.name, "and here") for each in others[:MOST]),
                ],
            )
