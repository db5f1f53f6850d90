"""Several definitions for CMake are one argument.

## What it finds
`--cmake-args "-DA=1 -DB=2"` of `colcon build`, and `cmake "-DA=1 -DB=2"`: a word in quotes that holds a further ` -D`.
In scripts, Dockerfiles, tasks and command lines. Flags of compilers (`-DCMAKE_CXX_FLAGS="-O2 -DARM"`) are left alone.

## Why it matters on a robot
CMake gives A the value `1 -DB=2`, and knows nothing of B. A build type of `Release -DBUILD_TESTING=OFF` is none: the
robot's code is compiled without any optimisation, and nothing says so.

## Bad
```sh
colcon build --cmake-args "-DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF"
```

## Good
```sh
colcon build --cmake-args -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF
```

## When to ignore it
When the value really holds a text that begins with `-D`.

## References
- cmake(1), "-D"
- https://colcon.readthedocs.io/en/released/reference/verb/build.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import every_command
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped

JOINED = regex(r"\s*-D(?P<first>\w+)(?::\w+)?=(?P<value>[^\s=]*)\s+-D(?P<second>\w+)(?::\w+)?=[\s\S]*")
PROGRAMS = ("colcon", "cmake")


@rule("warning", silent="CMake takes the rest of the line for the value of the first definition")
def cmake_arguments_joined(robot: Robot) -> Iterator[Finding]:
    for command in every_command(robot.runners):
        words = unwrapped(command.words)
        if not words or program_name(words[0]) not in PROGRAMS:
            continue
        for word in words[1:]:
            match = JOINED.fullmatch(word)
            if match is not None and "FLAGS" not in match["first"]:
                yield finding(
                    word,
                    f"{match['first']} gets the value '{match['value']} -D...', and {match['second']} is not set",
                    advice="take the quotes away",
                )
