"""The user of a service comes from a variable that shells do not export.

## What it finds
`${UID}` or `${GID}` without a default in `user:` of a service, when no `.env` file beside the compose file and nothing
else in the tree sets it.

## Why it matters on a robot
bash has UID as a variable of its own and does not hand it to programs, and GID does not exist. Compose puts in nothing:
`user: ":"`, or a service that starts as root. Its files then belong to root, and the next run without root fails.

## Bad
```yaml
user: "${UID}:${GID}"
```

## Good
```yaml
user: "${UID:-1000}:${GID:-1000}"
```

## When to ignore it
When whoever calls docker compose exports both.

## References
- bash(1), "Shell Variables": UID
- https://docs.docker.com/reference/compose-file/interpolation/
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

BARE = regex(r"\$\{?([UG]ID)(?:\}|(?![\w:}-]))")


@rule("warning", symptoms=['The "UID" variable is not set. Defaulting to a blank string'])
def uid_not_exported(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        bare = BARE.search(service.user or "")
        if service.user is None or bare is None:
            continue
        name = bare[1]
        written = re.escape(name)
        sets = re.compile(rf"(?:^|[\s;'\"(]){written}\s*[:?]?=|\bexport\s+(?:\w+\s+)*{written}\b|\b{written}:\s", re.M)
        if _named_beside(robot, service.source.name, name) or robot.mentions(sets):
            continue
        yield finding(
            service.user,
            f"No shell exports {name}: docker compose puts in nothing, and '{service.name}' does not get this user",
            advice=f"write ${{{name}:-1000}}, or set {name} in the .env file",
        )


def _named_beside(robot: Robot, name: str, variable: str) -> bool:
    """Whether a file beside the compose file that people copy or read sets the variable."""
    folder = name.rpartition("/")[0]
    beside = [path for path in robot.tree.paths if path.rpartition("/")[0].endswith(folder)]
    texts = (robot.tree.read(path, judged=False) for path in beside if re.search(r"env|[Mm]ake|just|\.md$", path))
    return any(source is not None and re.search(rf"\b{re.escape(variable)}\b", source.text) for source in texts)
