"""A command of a service has operators of the shell outside of quotes: what follows is dropped.

## What it finds
`&&`, `||`, `|`, `;`, `&`, `<` and `>` without quotes around them in a `command` or `entrypoint` that is one text.

## Why it matters on a robot
Compose splits the text into words and stops at the first operator. It says nothing. Of
`bash -c source setup.bash && ros2 launch ...` the container runs `bash -c source setup.bash`: it ends at once, is
started again and again, and no node comes up.

## Bad
```yaml
services:
  drivers:
    command: bash -c source /ws/install/setup.bash && ros2 launch tug tug.launch.py
```

## Good
```yaml
services:
  drivers:
    command: bash -c "source /ws/install/setup.bash && ros2 launch tug tug.launch.py"
```

## When to ignore it
When another program than Docker Compose reads the file, and it keeps the operators.

## References
- https://docs.docker.com/reference/compose-file/services/#command
- https://github.com/mattn/go-shellwords, which Compose splits commands with
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.shell import tokens
from bringup_lint.api.yaml import Scalar

SHOWN = 40


@rule(
    "error",
    symptoms=['exec: "source": executable file not found in $PATH', "source: filename argument required"],
)
def command_cut(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        for key in ("entrypoint", "command"):
            node = service.body.get(key)
            cut = _cut(node.value) if isinstance(node, Scalar) else None
            if cut is not None:
                operator, rest = cut
                yield finding(
                    operator,
                    f"Compose reads this {key} up to '{operator}' and drops the rest: {rest}",
                    advice="put quotes around the script of bash -c",
                )


def _cut(text: Located) -> tuple[Located, str] | None:
    """The first operator after words of a command, and the beginning of what follows."""
    found = [each for each in tokens(text) if each.text != "\n"]
    at = next((at for at, each in enumerate(found) if each.operator and each.text not in ("(", ")")), 0)
    if not at:
        return None
    rest = " ".join(each.text for each in found[at + 1 :])
    return found[at].text, rest if len(rest) <= SHOWN else f"{rest[:SHOWN]}..."
