"""docker run keeps the quotes that systemd removes.

## What it finds
A file with quoted values that a unit reads with EnvironmentFile= and that a `docker run --env-file` in the tree
also reads. Compose removes the quotes and is not reported.

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
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", fix="safe")
def quotes_kept_by_docker(robot: Robot) -> Iterator[Finding]:
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
