"""PID 1 is a shell, so signals do not reach ROS.

## What it finds
CMD or ENTRYPOINT in shell form in an image that runs ROS. The instruction is correct if `exec` precedes the last
command, and is not reported then. A CMD after an ENTRYPOINT in JSON form is checked too. A CMD that an ENTRYPOINT
in shell form hides is not. It is info for images that a robot hardly runs by themselves, such as a demonstration.

## Why it matters on a robot
Docker runs `/bin/sh -c` and sends the stop signal to it. dash neither forwards the signal nor replaces itself with
the command: `ros2 launch` never gets SIGINT, and Docker kills everything after ten seconds.

## Bad
```dockerfile
CMD ros2 launch base base.launch.py
```

## Good
```dockerfile
CMD ["ros2", "launch", "base", "base.launch.py"]
```

## When to ignore it
When the container runs with `--init` and a script that forwards signals, or when its nodes need no clean stop.

## References
- Dockerfile reference, "Shell and exec form"
- verified with dash 0.5.12
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import is_deployed
from bringup_lint.api.docker import stays_in_shell

ROS = regex(r"\bros2\s|/ros_entrypoint\.sh|\.launch\.(?:py|xml)")


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "exited with code 137",
        "JSONArgsRecommended: JSON arguments recommended for * to prevent unintended behavior related to OS signals",
    ],
)
def shell_form_cmd(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        stage = file.final
        if not stage:
            continue
        for name in ("ENTRYPOINT", "CMD"):
            instruction = stage.last(name)
            if instruction is None or not ROS.search(instruction.value) or not stays_in_shell(stage, instruction):
                continue
            words = instruction.value.split()
            plain = all(char not in instruction.value for char in "&|;<>$*?`'\"\\~")
            json = "[" + ", ".join(f'"{word}"' for word in words) + "]"
            yield finding(
                instruction.value,
                f"{name} in shell form: PID 1 is sh, and the stop signal does not reach ROS",
                advice=f"write {json}" if plain else "put exec before the last command",
                fix=fix("write the JSON form", (instruction.value, json), safe=False) if plain else None,
                severity=None if is_deployed(robot.compose, file) else "info",
            )
            break
