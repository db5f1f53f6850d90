"""The name of a package for apt is misspelt.

## What it finds
A package that `apt install`, `apt-get install` or the modules `apt` and `package` of Ansible install, whose name
nothing else in the tree has, and that differs in one letter from a package that many robots install, or from one that
the tree installs elsewhere: a letter is left out, there twice, the one beside it on the keyboard, or exchanged with the
next.
Names that Debian has are known.

## Why it matters on a robot
"Unable to locate package": apt installs none of the packages that are named with it. A build step ends there; a script
without `set -e` goes on without them.

## Bad
```sh
sudo apt-get install -y python3-rosdp can-utils
```

## Good
```sh
sudo apt-get install -y python3-rosdep can-utils
```

## When to ignore it
When an archive of your own has a package of this name.

## References
- apt-get(8)
- https://packages.ubuntu.com
"""

import re
from collections.abc import Iterator
from itertools import islice

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.host import near_packages
from bringup_lint.api.host import packages
from bringup_lint.api.shell import every_command
from bringup_lint.api.shell import tasks
from bringup_lint.api.shell import unwrapped
from bringup_lint.api.spelling import Neighbours
from bringup_lint.api.spelling import is_slip
from bringup_lint.api.spelling import numbered
from bringup_lint.api.yaml import Mapping
from bringup_lint.api.yaml import Scalar
from bringup_lint.api.yaml import Sequence

APTS = ("apt", "apt-get", "aptitude")
MODULES = ("apt", "package")
NAME = regex(r"[a-z0-9][a-z0-9.+-]{5,60}")


@rule("error", confidence="medium", symptoms=["E: Unable to locate package *"])
def package_misspelt(robot: Robot) -> Iterator[Finding]:
    words = [word for word in _installed(robot) if NAME.fullmatch(word) and word.span.text == word]
    places: dict[str, Located] = {}
    for word in words:
        places.setdefault(str(word), word)
    own = Neighbours(places)
    for word in places.values():
        if word not in packages().known and word not in near_packages():
            known = [each for each in packages().meant(word) if _is_slip(word, each)]
            meant = known or [each for each in own.near(word) if _is_slip(word, each)]
            if meant and _count(robot, word) == 1 and (known or _count(robot, meant[0]) > 1):
                yield finding(
                    word,
                    f"There is no package '{word}': apt installs none of those that are named with it",
                    advice=f"write {meant[0]}",
                    related=[note(places[each], "installed here") for each in meant[:1] if each in places],
                )


def _installed(robot: Robot) -> Iterator[Located]:
    for command in every_command(robot.runners):
        words = unwrapped(command.words)
        if words and words[0] in APTS and "install" in words:
            yield from (word for word in words[words.index("install") + 1 :] if not word.startswith("-"))
    judged = (source for source in robot.of_kind("ansible") if source.judged)
    for module in (module for source in judged for task in tasks(source) for module in task.modules):
        if module.name in MODULES and isinstance(module.settings, Mapping):
            yield from _scalars(module.settings)


def _scalars(settings: Mapping) -> Iterator[Located]:
    """The packages of a task."""
    for key in ("name", "pkg", "package"):
        given = settings.get(key)
        if isinstance(given, Scalar):
            yield given.value
        elif isinstance(given, Sequence):
            yield from (each.value for each in given.scalars)


def _is_slip(name: str, meant: str) -> bool:
    """Whether one is the other misspelt, and not another release or part of it."""
    return is_slip(name, meant) and not numbered(name, meant) and name[0] == meant[0]


def _count(robot: Robot, name: str) -> int:
    """How often the tree has a name, up to two."""
    alone = re.compile(rf"(?<![\w.+-]){re.escape(name)}(?![\w.+-])")
    found = (match for each in robot.sources if name in each.text for match in alone.finditer(each.text))
    return len(list(islice(found, 2)))
