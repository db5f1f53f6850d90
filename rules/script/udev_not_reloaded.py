"""Rules are copied, and udev is not told.

## What it finds
A script that copies files to a `rules.d` folder of udev, or writes one, and neither runs `udevadm trigger`, nor
restarts the machine, nor says that somebody has to do that, or to plug the devices in again; no page that names it, or
a script that calls it, says so either. `udevadm control --reload` and `service udev restart` only make udev read the
rules: no device gets them before its next event.

## Why it matters on a robot
Devices that are plugged in keep the names and modes that they have. The links that drivers open are not there until
each device is plugged in anew or the robot is started again, and the first start after the set-up fails.

## Bad
```sh
sudo cp 99-rover.rules /etc/udev/rules.d/
```

## Good
```sh
sudo cp 99-rover.rules /etc/udev/rules.d/
sudo udevadm control --reload && sudo udevadm trigger
```

## When to ignore it
When the script is a step of the making of an image, or whoever calls it tells udev.

## References
- udevadm(8), "udevadm control", "udevadm trigger"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import runs_in_image

TOLD = regex(
    r"udevadm\s[^\n]{0,200}trigger|udev-trigger|\breboot\b|\bchroot\b|\bqemu\b|shutdown\s+-r|\binit\s+6\b|re-?plug|unplug"
    r"|(?:re|dis)connect|power[ -]?cycl|\boff\s+and\b[^\n]{0,20}\bon\b"
    r"|plug[^\n]{0,40}(?:again|back)|\brestart\b[^\n;&|]{0,40}\b(?:pc|computer|machine|system|robot|pi)\b",
    re.I,
    hints="udevadm udev-trigger reboot chroot qemu shutdown init plug connect power off restart",
)
RELOADS = regex(
    r"^[^#\n]*(?:udevadm\s|udev\s+(?:restart|reload)|(?:restart|reload)\s+\S*udev)", re.I | re.M, hints="udev"
)
FOLDER = "/udev/rules.d"
PUT_AWAY = (".bak", ".old", ".orig", ".disabled", ".backup", "~")
"""Names that udev does not read."""
SYSTEM = ("/etc/", "/lib/", "/usr/lib/")
PAGE = regex(r"\.(?:md|rst|txt|py|mk)$|(?:^|/)(?:makefile|justfile)$", re.I)
"""Files that may tell udev, or say how the script is used."""
MOST = 100_000
SCRIPT = regex(r"(?<![\w.-])[\w.-]{1,80}\.(?:sh|bash)(?![\w-])")
CALLS = 3
"""Scripts that call each other, up to the one that a page names."""
NAMES = 20


@rule("warning", symptoms=["No such file or directory: '/dev/", "could not open port /dev/*No such file or directory"])
def udev_not_reloaded(robot: Robot) -> Iterator[Finding]:
    copied: dict[Source, list[Located]] = {}
    for source, run in robot.scripts.run("cp", "install", "ln", "mv"):
        target = run.text(run.words[-1]) if len(run.words) > 2 else ""
        is_rule = not target.endswith(PUT_AWAY) and "/dev/null" not in run.words
        if target.startswith(SYSTEM) and FOLDER in target and is_rule:
            copied.setdefault(source, []).append(run.words[-1])
    for source, written in robot.scripts.written(FOLDER):
        if written.path.startswith(SYSTEM) and FOLDER in written.path:
            copied.setdefault(source, []).append(written.where)
    if not copied:
        return
    telling = [each for each in robot.sources if each.kind == "dockerfile" or TOLD.search(each.said)]
    pages = [page for page in robot.tree.pages(PAGE, MOST) if TOLD.search(page)]
    callers = _callers(robot) if pages else {}
    for source, (first, *others) in copied.items():
        if TOLD.search(source.said) or _is_called(telling, source) or runs_in_image(source):
            continue
        names = _with_callers(source.basename, callers)
        if any(name in page for page in pages for name in names):
            continue
        reloads = RELOADS.search(source.said)
        cause = "udev only reads the new rules" if reloads else "udev is not told of the new rules"
        yield finding(
            first,
            f"{cause}: devices that are plugged in keep their names and modes",
            advice=f"run {'' if reloads else 'udevadm control --reload and '}udevadm trigger afterwards",
            related=[note(other, "rules are copied here too") for other in others],
        )


def _is_called(telling: list[Source], source: Source) -> bool:
    """Whether another file that tells udev, or builds an image, names the script, or the script one that tells udev."""
    return any(
        each is not source
        and (source.basename in each.text or (each.kind == "shell-script" and each.basename in source.text))
        for each in telling
    )


def _callers(robot: Robot) -> dict[str, set[str]]:
    """The names of scripts, each with those of the scripts that say it."""
    callers: dict[str, set[str]] = {}
    for source in robot.of_kind("shell-script"):
        for match in SCRIPT.finditer(source.said):
            callers.setdefault(match[0], set()).add(source.basename)
    return callers


def _with_callers(name: str, callers: dict[str, set[str]]) -> list[str]:
    """The name of a script, and those of scripts that call it, themselves or through others."""
    names = [name]
    for _ in range(CALLS):
        names += sorted({caller for each in names for caller in callers.get(each, ())} - set(names))[:NAMES]
    return names
