"""docker compose cannot read a substitution.

## What it finds
A `${` that is neither `${NAME}` nor one of the forms with a default, an error or an alternative (`${NAME:-default}`,
`${NAME:?error}`, `${NAME:+other}`). Often it belongs to the shell of the container: `${path%/*}`, `${1}`.

## Why it matters on a robot
Compose stops with "invalid interpolation format" and starts none of the services. It replaces variables in every value,
commands included.

## Bad
```yaml
command: bash -c 'echo ${path%/*}'
```

## Good
```yaml
command: bash -c 'echo $${path%/*}'
```

## When to ignore it
When the file is always loaded with `--no-interpolate`.

## References
- https://github.com/compose-spec/compose-spec/blob/main/12-interpolation.md
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", symptoms=["invalid interpolation format"])
def bad_substitution(robot: Robot) -> Iterator[Finding]:
    for remark in robot.compose.remarks(Code.EXPANSION):
        yield finding(
            remark.where,
            f"'{remark.where}' {remark.detail}: docker compose refuses the file",
            advice="write $${ for the shell of the container, or close the substitution",
        )
