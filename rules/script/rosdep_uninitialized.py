"""rosdep is used before anything sets it up.

## What it finds
`rosdep update` and `rosdep install` in a set-up script or a task of Ansible that installs rosdep itself, in a tree of
which no file says `rosdep init` or `/etc/ros/rosdep/sources.list.d`. Only where the tree takes packages from
packages.ros.org: Ubuntu's own python3-rosdep2 brings the list of sources.

## Why it matters on a robot
The script works for whoever has typed `sudo rosdep init` long ago. On a new robot rosdep answers that it "has not been
initialized yet", installs nothing, and the build fails for the lack of every dependency.

## Bad
```sh
sudo apt-get install -y ros-jazzy-ros-base ros-dev-tools
rosdep update
```

## Good
```sh
sudo apt-get install -y ros-jazzy-ros-base ros-dev-tools
[ -e /etc/ros/rosdep/sources.list.d/20-default.list ] || sudo rosdep init
rosdep update
```

## When to ignore it
When the image of the robot has rosdep set up.

## References
- https://docs.ros.org/en/rolling/Tutorials/Intermediate/Rosdep.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import every_command
from bringup_lint.api.shell import is_forgiven
from bringup_lint.api.shell import unwrapped

KINDS = ("shell-script", "ansible")
INSTALLED = regex(r"\bpython3-rosdep(?!2)\b|\bros-dev-tools\b|\bpip3? install[^\n]{0,80}\brosdep\b")
FROM_ROS = regex(r"packages\.ros\.org|ros2-apt-source|\bros2\.list\b")
SET_UP = regex(r"\brosdep[\"', ]{1,5}init\b|rosdep/sources\.list")
TEXT = regex(r"(?:^|/)[^/.]+$|[Dd]ockerfile|\.(?:sh|bash|zsh|ya?ml|md|rst|txt|py|j2|toml|mk|json)$")
SIZE = 200_000
MOST = 20


@rule("error", confidence="medium", symptoms=["your rosdep installation has not been initialized yet"])
def rosdep_uninitialized(robot: Robot) -> Iterator[Finding]:
    sources = [each for each in robot.of_kind(*KINDS) if each.judged and "rosdep" in each.text]
    installing = {each for each in sources if INSTALLED.search(each.uncommented)}
    if not installing or not any(FROM_ROS.search(each.text) for each in robot.of_kind(*KINDS)):
        return
    used: dict[Source, list[Located]] = {}
    for command in every_command(robot.runners):
        words = unwrapped(command.words)
        if words[:1] == ("rosdep",) and words[1:2] in (("update",), ("install",)) and not is_forgiven(command):
            used.setdefault(words[0].span.source, []).append(words[0])
    found = {source: words for source, words in used.items() if source in installing}
    if found and not robot.tree.says(TEXT, SIZE, SET_UP):
        for first, *others in found.values():
            yield finding(
                first,
                "Nothing runs rosdep init: on a new robot rosdep ends here, and installs nothing",
                advice="run sudo rosdep init before, unless /etc/ros/rosdep/sources.list.d/20-default.list is there",
                related=[note(word, "and here") for word in others[:MOST]],
            )
