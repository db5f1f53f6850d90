"""docker compose does not know a key.

## What it finds
A key that the compose specification does not have at that place: a typing mistake, a key one level too high or too low,
or a key of an old version. Extensions (`x-...`) are free.

## Why it matters on a robot
docker compose refuses the whole file ("additional properties not allowed") and starts none of the services.

## Bad
```yaml
services:
  driver:
    image: robot/driver:1.2
    priviledged: true
```

## Good
```yaml
services:
  driver:
    image: robot/driver:1.2
    privileged: true
```

## When to ignore it
When the robot has a docker compose that is newer than the schema of this linter and knows the key, or when another
program reads the file.

## References
- https://github.com/compose-spec/compose-spec/blob/main/spec.md
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.compose import homes_of
from bringup_lint.api.schema import Code
from bringup_lint.api.schema import Remark
from bringup_lint.api.schema import unknown_name
from bringup_lint.api.spelling import nearest
from bringup_lint.api.yaml import is_free_key

OLD = {
    "net": "write network_mode",
    "log_driver": "write logging: {driver: ...}",
    "log_opt": "write logging: {options: ...}",
    "dockerfile": "move it into build",
    "volume_driver": "write driver at the volume",
    "env": "write environment",
    "envs": "write environment",
    "args": "move it into build",
    "gpus": "update docker compose, or write deploy.resources.reservations.devices",
}
"""Keys of old versions and of other tools, and what compose has instead."""


@rule(
    "error",
    fix="unsafe",
    symptoms=["additional properties", "Additional property is not allowed", "Unsupported config option for services"],
)
def unknown_key(robot: Robot) -> Iterator[Finding]:
    for remark in robot.compose.remarks(Code.UNKNOWN):
        key, inside = str(remark.where), remark.item
        known = [name for name in inside.children if name not in ("*", "x-*")] if inside else []
        near = [] if key in OLD else nearest(key, known)
        message = f"Unknown key '{key}' {_place(remark)}: docker compose refuses the file"
        is_free = bool(near) and is_free_key(near[0], remark.word, known)
        yield unknown_name(remark.where, message, near, _otherwise(key), is_free=is_free)


def _place(remark: Remark) -> str:
    kind = remark.path.strip("{}").replace("_", " ")
    return "at the top of the file" if kind == "root" else f"in {kind}"


def _otherwise(key: str) -> str:
    if key in OLD:
        return OLD[key]
    homes = homes_of(key)
    return f"move it into {homes[0]}" if len(homes) == 1 else "remove it, or begin its name with x-"
