"""rosdep is to skip a key that is none.

## What it finds
`rosdep install --skip-keys` with the name of a Debian package of ROS, such as `ros-jazzy-rviz2`, instead of a key of
rosdep, such as `rviz2`. In scripts, Dockerfiles, tasks and command lines. Silent where the key is among the words, too,
and where a package.xml or a list of keys of the tree has such a name.

## Why it matters on a robot
rosdep compares the words with the names in package.xml, and says nothing of those that it does not find. It installs
what was to be left out: a small computer gets RViz, Gazebo and the desktop that they need.

## Bad
```sh
rosdep install --from-paths src -i -y --skip-keys "ros-jazzy-rviz2 ros-jazzy-joint-state-publisher-gui"
```

## Good
```sh
rosdep install --from-paths src -i -y --skip-keys "rviz2 joint_state_publisher_gui"
```

## When to ignore it
When a list of rosdep outside this tree has a key of this name.

## References
- https://docs.ros.org/en/independent/api/rosdep/html/commands.html, "--skip-keys"
"""

from collections.abc import Iterator
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import distro_names
from bringup_lint.api.shell import every_command
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped

OPTION = "--skip-keys"
DEBIAN = regex(rf"ros-(?:{'|'.join(distro_names())}|\$\{{?\w+\}}?)-(?P<name>[a-z0-9-]+)")
LISTS = regex(r"(?:^|/)package\.xml$|\.ya?ml$")
DECLARED = regex(
    rf">\s{{0,9}}ros-(?:{'|'.join(distro_names())})-[a-z0-9-]{{1,80}}\s{{0,9}}<"
    rf"|(?m:^)[ \t]{{0,40}}[\"']?ros-(?:{'|'.join(distro_names())})-[a-z0-9-]{{1,80}}[\"']?:",
    hints="ros-",
)
"""Names of Debian packages that are keys of rosdep here."""
MOST = 400_000


@rule("warning", silent="rosdep passes over keys that it does not know")
def skip_keys_debian(robot: Robot) -> Iterator[Finding]:
    for command in every_command(robot.runners):
        words = unwrapped(command.words)
        if not words or program_name(words[0]) != "rosdep":
            continue
        keys = [key for text in _skipped(words) for key in text.words()]
        debian = [(key, match) for key in keys if (match := DEBIAN.fullmatch(key)) is not None]
        named = ((key, match["name"].replace("-", "_")) for key, match in debian)
        written = frozenset(map(str, keys))
        wrong = [(key, name) for key, name in named if name not in written]
        if wrong and not robot.tree.says(LISTS, MOST, DECLARED):
            (first, name), *others = wrong
            yield finding(
                first,
                f"{first} is a Debian package and no key of rosdep: it is not skipped",
                advice=f"write {name}, as in package.xml",
                related=[note(other, "nor is this") for other, _ in others],
            )


def _skipped(words: tuple[Located, ...]) -> Iterator[Located]:
    """The values of the option, each with one or several keys."""
    for before, word in pairwise(words):
        if before == OPTION:
            yield word
        elif word.startswith(f"{OPTION}="):
            yield word.part(len(OPTION) + 1, len(word))
