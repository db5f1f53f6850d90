"""A variable in a setting where systemd expands none.

## What it finds
$NAME or ${NAME} in User=, WorkingDirectory=, EnvironmentFile=, Environment=, ReadWritePaths= and other
settings. systemd expands variables only in Exec lines. In Environment=, secrets and variables whose reader
expands them are exempt.

## Why it matters on a robot
systemd uses the text unchanged. The path does not exist, the unit does not load, or PATH contains the literal
text $PATH, and the service no longer finds any program.

## Bad
```ini
[Service]
WorkingDirectory=$HOME/robot_ws
Environment=PATH=/opt/robot/bin:$PATH
```

## Good
```ini
[Service]
WorkingDirectory=/home/robot/robot_ws
Environment=PATH=/opt/robot/bin:/usr/local/bin:/usr/bin:/bin
```

## When to ignore it
When the program that reads the value expands the variable itself.

## References
- systemd.exec(5), "Environment="; systemd.service(5), "Command lines"; systemd.unit(5), "Specifiers"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.systemd import Line

_EXPANDED_BY_READER = ("CYCLONEDDS_URI",)
_SECRET = ("PASS", "SECRET", "TOKEN", "KEY", "PSK")


@rule("error", symptoms=["path is not absolute", "status=200/CHDIR"])
def var_in_nonexec_key(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.lines:
        variable = line.variable
        if variable is None or line.file.source.template:
            continue
        if line.directive.type == "environment" and not _judged(line, variable):
            continue
        yield finding(
            variable,
            f"systemd expands variables only in Exec lines: {line.key}= contains the literal text '{variable}'",
            advice="write the full value, or use a specifier such as %i where one fits",
        )


def _judged(line: Line, variable: Located) -> bool:
    """Neither variables that a later reader expands, nor passwords that happen to contain a dollar."""
    names = [str(name) for name, value in line.environment if variable in value]
    name = names[0] if names else ""
    if name in _EXPANDED_BY_READER or any(word in name.upper() for word in _SECRET):
        return False
    return not any(
        f"${name}" in other.value or f"${{{name}}}" in other.value
        for other in line.file.assignments
        if other.key.startswith("Exec")
    )
