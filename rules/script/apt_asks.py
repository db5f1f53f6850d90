"""apt asks for a confirmation where nobody answers.

## What it finds
`apt install`, `upgrade` and `build-dep` (of `apt` and `apt-get`) without `-y`:
- in a `RUN` of a Dockerfile, which has no terminal; information unless it installs packages of ROS, because an image
  may have all that other packages need;
- in a script whose other calls of apt pass `-y`, so that it is meant to run by itself; information where it only
  upgrades, where it ends at the first failure (`set -e`) and fewer of its calls pass `-y`, and where nothing of the
  tree starts it and it asks for packages once or twice, because the person who started it may answer;
- in a script without any `-y` that sets the robot up afterwards: it copies to `/etc` or `/opt`, or enables units;
  information unless something of the tree starts the script, because a person may answer.

Silent in scripts that open an editor or read an answer, for packages that are files, for those that need nothing else
(`nano`, `unzip` and the like), for those that an earlier step installs and what belongs to them, for packages of ROS on
top of a desktop variant, in branches of a `RUN`, for answers through a pipe, and where `APT::Get::Assume-Yes` is set.
`-qq` is an answer, too.

## Why it matters on a robot
apt asks as soon as it has to install more than the packages that are named. In the build of an image it ends with
"Abort.", and the robot keeps the old image. In a script over SSH or in the first boot it ends in the same way, and
without `set -e` the next steps run on a robot that lacks the packages.

## Bad
```dockerfile
RUN apt-get update && apt-get install ros-jazzy-nav2-bringup
```

## Good
```dockerfile
RUN apt-get update && apt-get install -y ros-jazzy-nav2-bringup
```

## When to ignore it
When the packages are known to need no others, or somebody is to read what apt is about to do.

## References
- apt-get(8), --yes and --quiet
"""

import re
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Sequence
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Dockerfile
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of
from bringup_lint.api.shell import STRICT
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import unwrapped

PROGRAMS = ("apt", "apt-get")
ASKING = ("install", "upgrade", "dist-upgrade", "full-upgrade", "build-dep")
DESKTOP = "-desktop"
VALUED = ("-t", "-o", "-c", "-a", "--target-release", "--option", "--config-file")
ANSWERED = regex(
    r"-[a-zA-Z]*y[a-zA-Z]*|-[a-zA-Z]*qq[a-zA-Z]*|--(?:assume-)?yes|--force-yes|--assume-no|--quiet=[2-9]|-q=[2-9]"
    r"|-s|--simulate|--dry-run|--just-print|--no-act|--recon|--print-uris|-h|--help"
)
CONFIGURED = regex(r"APT::Get::Assume-Yes", re.I, hints="apt::get::assume-yes")
PIPED = regex(r"\|[ \t]*(?:sudo[ \t]+(?:-\w+[ \t]+)*)?(?:\w+=\S*[ \t]+)*$")
STOPS = regex(STRICT, re.M)
COPIES = ("cp", "install", "ln", "tee")
OF_ROBOT = regex(r"/(?:etc|opt|lib|usr)/")
SETTINGS = regex(r"(?:^|/)(?:apt\.conf|\d\d[\w-]+(?:\.conf)?|[^/]*apt[^/]*)$")
SEVERAL = 3
"""Questions that nobody waits for."""
MOST = 4096
"""Characters of a file of settings that are read."""
ALONE = frozenset("bash-completion gosu less locales make nano python3 sudo time tree unzip zip".split())
"""Packages that need only what every image of Debian and Ubuntu has."""
BY_HAND = regex(
    r"(?m)^[ \t]*(?:sudo[ \t]+)?(?:vi|vim|nano|emacs|read|select)[ \t]|\b(?:whiptail|dialog|zenity|expect)[ \t]"
)
"""What only a person in front of a terminal goes on from."""


@rule("warning", confidence="medium", symptoms=["Do you want to continue? [Y/n] Abort.", "[Y/n] Abort."])
def apt_asks(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if "apt" in file.source.text and not CONFIGURED.search(file.source.text) and not _takes_answers(robot, file):
            for stage in file.stages:
                yield from _of_image(stage)
    yield from _of_scripts(robot)


def _takes_answers(robot: Robot, file: Dockerfile) -> bool:
    """Whether an image copies settings of apt, and a file of the tree answers for it."""
    copies = (str(each.value) for stage in file.stages for each in stage.all("COPY", "ADD"))
    if not any("apt.conf" in text for text in copies):
        return False
    return robot.tree.says(SETTINGS, MOST, CONFIGURED)


def _of_image(stage: Stage) -> Iterator[Finding]:
    """One finding for all calls of a stage."""
    installed = set(_brought([stage.origin]))
    for base in list(stage.chain)[1:]:
        installed.update(word for command in commands_of(base) for word in _brought(command.words))
    asking = []
    brings_ros = False
    for command in commands_of(stage):
        words = unwrapped(command.words)
        if not command.depth and _asks(words, installed):
            asking.append(words[0])
            brings_ros |= any(word.startswith("ros-") for word in words)
        installed.update(_brought(words))
    if asking:
        yield finding(
            asking[0],
            "apt asks whether to go on when a package brings others along: nobody answers in a build, and it stops",
            advice="write -y after the command of apt",
            related=[note(each, "and here") for each in asking[1:]],
            severity=None if brings_ros else "info",
        )


def _of_scripts(robot: Robot) -> Iterator[Finding]:
    calls: dict[Source, list[tuple[Sequence[Located], bool]]] = {}
    installed: dict[Source, set[str]] = {}
    for source, run in robot.scripts.run(*PROGRAMS):
        if source.says(CONFIGURED) or source.says(BY_HAND):
            continue
        words = run.words
        known = installed.setdefault(source, set())
        answers = any(each.operator.startswith("<") for each in run.command.redirects)
        calls.setdefault(source, []).append((words, not answers and _asks(words, known)))
        known.update(_brought(words))
    for source, each in calls.items():
        asking = sorted((words for words, asks in each if asks), key=lambda words: not _installs(words))
        answered = [words[0] for words, _ in each if _is_answered(words)]
        if asking and answered:
            is_attended = sum(map(_installs, asking)) < SEVERAL and not _is_unattended(robot, source)
            yield _of_script(asking, answered, is_attended=is_attended)
        elif asking and _installs(asking[0]):
            yield from _of_set_up(robot, source, asking)


def _of_set_up(robot: Robot, source: Source, asking: list[Sequence[Located]]) -> Iterator[Finding]:
    """One finding for a script that sets the robot up after its first question."""
    first, *others = asking
    runs = [did for did in robot.scripts.done(source) if isinstance(did, Run)]
    following = (run for run in runs if run.words and run.words[0].span.start > first[0].span.start)
    after = next((run for run in following if run.certain and _sets_up(run)), None)
    if after is None:
        return
    stops = STOPS.search(source.text) is not None
    yield finding(
        first[0],
        "apt asks whether to go on when a package brings others along: without a terminal the set-up "
        + ("ends here" if stops else "goes on without the packages"),
        advice="write -y after the command of apt",
        related=[
            note(after.words[0], "this is not reached then" if stops else "this runs all the same"),
            *(note(other[0], "asks, too") for other in others),
        ],
        severity=None if _is_unattended(robot, source) else "info",
    )


def _is_unattended(robot: Robot, source: Source) -> bool:
    """Whether something of the tree runs the script where nobody answers."""
    if robot.scripts.starts_by_itself(source):
        return True
    return any(source.basename in each.text for each in robot.of_kind("cloud-init", "ansible"))


def _sets_up(run: Run) -> bool:
    """Whether a command puts something on the robot, or enables a unit."""
    if run.name == "systemctl":
        return "enable" in run.words
    return run.name in COPIES and OF_ROBOT.match(run.arguments[-1] if run.arguments else "") is not None


def _of_script(asking: list[Sequence[Located]], answered: list[Located], *, is_attended: bool) -> Finding:
    first, *others = asking
    stops = STOPS.search(first[0].span.source.text) is not None
    return finding(
        first[0],
        "apt asks whether to go on when a package brings others along: the script waits for an answer, and "
        + ("ends where there is no terminal" if stops else "without a terminal goes on without the packages"),
        advice="write -y, as the other calls of this script do",
        related=[note(answered[0], "this call does not ask"), *(note(other[0], "asks, too") for other in others)],
        severity="info" if is_attended or (stops and len(answered) < len(asking)) or not _installs(first) else None,
    )


def _installs(words: Sequence[Located]) -> bool:
    """Whether packages are named; a person may want to read what an upgrade changes."""
    return _parts(words)[0] == "install"


def _asks(words: Sequence[Located], installed: set[str]) -> bool:
    """Whether a call of apt may ask for a confirmation."""
    if not words or words[0].rpartition("/")[2] not in PROGRAMS:
        return False
    place = words[0].span
    if PIPED.search(place.source.line_before(place.start)):
        return False
    if "--reinstall" in words or any(
        "$" in word and "ROS_DISTRO" not in word and word.startswith(("$", "-")) for word in words
    ):
        return False
    command, packages = _parts(words)
    if command not in ASKING or _is_answered(words):
        return False
    if command != "install":
        return True
    return any(_needs_others(each, installed) for each in packages)


def _is_answered(words: Sequence[Located]) -> bool:
    return _parts(words)[0] in ASKING and any(ANSWERED.fullmatch(word) for word in words[1:])


def _parts(words: Sequence[Located]) -> tuple[str, list[str]]:
    """The command of apt and its arguments."""
    plain = [str(word) for before, word in pairwise(words) if not word.startswith("-") and str(before) not in VALUED]
    return (plain[0], plain[1:]) if plain else ("", [])


def _brought(words: Iterable[str]) -> Iterator[str]:
    """The words of a command that may be packages, and the sign of the desktop where one of them is it."""
    for word in words:
        yield str(word)
        if DESKTOP in word:
            yield DESKTOP


def _needs_others(package: str, installed: set[str]) -> bool:
    """Whether a package may need others: what belongs to an installed one, such as git-lfs to git, does not."""
    name = package.partition("=")[0]
    if "/" in package or name.endswith(".deb") or name in ALONE or name in installed:
        return False
    if name.startswith("ros-"):
        return DESKTOP not in installed
    parts = name.split("-")
    return not any("-".join(parts[:count]) in installed for count in range(1, len(parts)))
