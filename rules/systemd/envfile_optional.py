"""An environment file is optional, but the command needs it.

## What it finds
`EnvironmentFile=-...` with a file of the tree that alone defines a variable used in an `Exec` line.

## Why it matters on a robot
The dash hides a missing file. On a robot where the file was forgotten, the variable is empty, and the service
fails elsewhere with another message: `source /opt/ros//setup.bash: No such file or directory`.

## Bad
```ini
[Service]
EnvironmentFile=-/etc/rover/ros.env
ExecStart=/bin/bash -c 'source /opt/ros/${ROS_DISTRO}/setup.bash && exec ros2 launch rover rover.launch.py'
```

## Good
```ini
[Service]
EnvironmentFile=/etc/rover/ros.env
ExecStart=/bin/bash -c 'source /opt/ros/${ROS_DISTRO}/setup.bash && exec ros2 launch rover rover.launch.py'
```

## When to ignore it
When the command works with an empty value, for example because the variable holds optional extra arguments.

## References
- systemd.exec(5), "EnvironmentFile="
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", fix="unsafe", symptoms=["Referenced but unset environment variable evaluates to an empty string"])
def envfile_optional(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.services:
        environment = units.environment(unit)
        for file in units.environment_files(unit):
            if not file.optional or file.source is None:
                continue
            chains = ((name, environment.chain(name)) for name in environment.chains)
            only = {
                name: chain[-1]
                for name, chain in chains
                if chain and all(v.value.span.source is file.source for v in chain)
            }
            for process in units.processes(unit):
                used = next(
                    (name for name in only if re.search(rf"(?<!\$)\$\{{{re.escape(name)}\}}", process.line)), None
                )
                if used:
                    dash = file.value.span.source.span(file.value.span.start - 1, file.value.span.start)
                    yield finding(
                        file.value,
                        f"{process.key}= needs {used} from this file: without the file, {used} is silently empty",
                        advice="remove the '-'",
                        related=[note(only[used].value, "defined here"), note(process.line, "used here")],
                        fix=fix("make the file required", (dash, ""), safe=False) if dash.text == "-" else None,
                    )
                    break
