"""The path of a setup file of ROS is misspelt.

## What it finds
A path below `/opt/ros/<distribution>`, or in a folder `install` or `devel`, whose file is called nearly like the one
that is there: `setup.bassh`, `stup.bash`, `setup.bsh`. Also such a path whose folders differ in one letter from
`/opt/ros`, from a distribution or from `install`. One letter is left out, there twice, the one beside it on the
keyboard, or exchanged with the next. Comments are not read.

## Why it matters on a robot
The shell says "No such file or directory" and goes on without the environment: `ros2` is not found, nor the packages
of the workspace. Under `set -e` and in a build step everything ends there.

## Bad
```sh
source /opt/ros/jazzy/setup.bassh
```

## Good
```sh
source /opt/ros/jazzy/setup.bash
```

## When to ignore it
When something makes a file of this name.

## References
- https://docs.ros.org/en/rolling/Tutorials/Beginner-CLI-Tools/Configuring-ROS2-Environment.html
- https://colcon.readthedocs.io/en/released/user/quick-start.html
"""

import re
from collections.abc import Iterator
from functools import cache

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import distro_names
from bringup_lint.api.spelling import Neighbours
from bringup_lint.api.spelling import is_slip

KINDS = ("shell-script", "dockerfile", "compose", "ansible", "systemd-unit", "systemd-dropin", "cloud-init")
NAMES = tuple(f"{start}setup.{end}" for start in ("", "local_") for end in ("bash", "sh", "zsh", "ps1"))
NAME = regex(
    r"(?:/opt/ros/[\w${}\"]+|(?:/|[ \t])(?:install|devel))/(?P<name>[a-z]\w{2,12}\.[a-z]\w{1,4})(?![\w./-])",
    hints="/opt/ros/ install/ devel/",
)
ROOT = regex(
    r"(?<![\w.~}\")/-])(?P<root>/[a-z]{2,4}/[a-z]{2,4})/[\w${}\"]+/(?:local_)?setup\.(?:bash|sh|zsh)(?![\w./-])",
    hints="setup.",
)
DISTRO = regex(r"/opt/ros/(?P<distro>[a-z]{4,10})/(?:local_)?setup\.(?:bash|sh|zsh)(?![\w./-])", hints="/opt/ros/")
BUILT = regex(r"/(?P<built>[a-z]{4,9})/(?:local_)?setup\.(?:bash|sh|zsh)(?![\w./-])", hints="setup.")
COMMENT = regex(r"(?:^|[ \t])#")


@rule("error", confidence="medium", symptoms=["/opt/ros/*: No such file or directory"])
def setup_file_misspelt(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("setup.", "/opt/ros/"):
        return
    for source in robot.of_kind(*KINDS):
        if source.judged and not source.template and ("setup." in source.text or "/opt/ros/" in source.text):
            for where, meant in _misspelt(source):
                yield finding(
                    where,
                    f"There is no '{where}' here: the shell goes on without what the setup file sets",
                    advice=f"write {meant}",
                )


@cache
def _known() -> dict[re.Pattern[str], Neighbours]:
    return {
        NAME: Neighbours(NAMES),
        ROOT: Neighbours(("/opt/ros",)),
        DISTRO: Neighbours(distro_names()),
        BUILT: Neighbours(("install", "devel")),
    }


def _misspelt(source: Source) -> Iterator[tuple[Located, str]]:
    for pattern, slips in _known().items():
        for match in pattern.finditer(source.text):
            meant = [each for each in slips.meant(match[1]) if is_slip(match[1], each)]
            before = source.text[source.text.rfind("\n", 0, match.start()) + 1 : match.start()]
            if meant and not COMMENT.search(before):
                yield source.located(*match.span(1)), meant[0]
