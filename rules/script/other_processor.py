"""A program for another processor is fetched.

## What it finds
Packages and archives whose names say `amd64`, `x86_64` or `linux-x64` (or `arm64`, `aarch64`, `armhf`), and lists of
apt with such an `[arch=...]`, that

- a script gets which also configures a Raspberry Pi or a Jetson (`config.txt`, `raspi-config`, `nvpmodel`);
- an image gets which is for the other processor: by `--platform=`, by its base (`arm64v8/...`, `l4t`), or by the
  `platform:` of all services that use it.

Silent where the file asks for the processor (`uname -m`, `dpkg --print-architecture`, `TARGETARCH`) or has to do with
cross builds.

## Why it matters on a robot
The download works, and then dpkg refuses the package ("package architecture (amd64) does not match system (arm64)"), or
the program ends with "Exec format error", often only at the first boot of the robot.

## Bad
```dockerfile
FROM arm64v8/ros:humble-ros-base
RUN curl -fsSL https://example.org/releases/tool-linux-amd64.tar.gz | tar xz -C /usr/local/bin
```

## Good
```dockerfile
FROM arm64v8/ros:humble-ros-base
RUN curl -fsSL https://example.org/releases/tool-linux-$(dpkg --print-architecture).tar.gz | tar xz -C /usr/local/bin
```

## When to ignore it
When the file is only kept for another computer.

## References
- dpkg(1), "--print-architecture"; execve(2), ENOEXEC
- https://docs.docker.com/build/building/multi-platform/
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.docker import foreign_programs


@rule(
    "error",
    confidence="medium",
    symptoms=["Exec format error", "package architecture (amd64) does not match system (arm64)"],
)
def other_processor(robot: Robot) -> Iterator[Finding]:
    for foreign in foreign_programs(robot.files, robot.compose):
        own, other = ("amd64", "arm64") if foreign.processor == "amd64" else ("arm64", "amd64")
        refused = ".deb" in foreign.word or foreign.word.startswith("deb ")
        end = "apt does not install it there" if refused else "it ends with 'Exec format error'"
        yield finding(
            foreign.word,
            f"This is for {own}, and the computer is {other}: {end}",
            advice=f"take the one for {other}, or ask dpkg --print-architecture",
            related=[note(foreign.why, "shows the processor")],
        )
