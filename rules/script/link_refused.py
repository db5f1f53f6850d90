"""A link is to be where there is a file already.

## What it finds
`ln -s` without `-f`, `-b` or a backup suffix whose name is that of a file that every Debian and Ubuntu has:
`/etc/resolv.conf`, `/etc/localtime`, `/etc/hosts`, `/etc/hostname`, `/etc/fstab`, `/bin/sh`. Silent where the script
may remove or move this file, names it a second time or works in another root, where a variable has the name, where the
failure is handled, and in scripts that build an image; for `/etc/localtime` in all trees with images, which may
have no tzdata.

## Why it matters on a robot
ln says "File exists", and changes nothing. The robot keeps the file of before: the name servers of the workshop, or the
time zone of the image.

## Bad
```sh
sudo ln -s /run/systemd/resolve/resolv.conf /etc/resolv.conf
```

## Good
```sh
sudo ln -sf /run/systemd/resolve/resolv.conf /etc/resolv.conf
```

## When to ignore it
When another program has removed the file before.

## References
- ln(1), "--force"
"""

import posixpath
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

THERE = ("/etc/resolv.conf", "/etc/localtime", "/etc/hosts", "/etc/hostname", "/etc/fstab", "/bin/sh", "/usr/bin/sh")
REPLACES = regex(r"-[a-zA-Z]*[fbiS][a-zA-Z]*|--(?:force|backup|interactive|suffix).*")
ZONE = "/etc/localtime"
"""Of the package tzdata, which images of containers lack."""
PAIR = 2
"""What a link leads to, and its name."""
REMOVES = ("rm", "mv", "unlink")
PLAIN = regex(r"[^$*?\[{`~\\]*")
"""The start of a word that the shell leaves as it is."""
MAKES_ROOM = regex(
    r"\b(?:xargs|rename|dpkg-divert|debootstrap|mmdebstrap|(?:arch-)?chroot|nspawn|nsenter)\b|-(?:delete|exec)\b"
    r"|\bapt(?:-get|itude)?[ \t][^\n]{0,80}\b(?:purge|remove)\b"
)
"""What may have taken a file away before, or have another root."""


@rule("warning", symptoms=["ln: failed to create symbolic link '*': File exists"])
def link_refused(robot: Robot) -> Iterator[Finding]:
    seen: set[tuple[Source, str]] = set()
    for source, run in robot.scripts.run("ln"):
        paths = [word for word in run.words[1:] if not word.startswith("-")]
        if len(paths) != PAIR or not _is_plain_link(run):
            continue
        target, name = paths
        path = run.text(name)
        path = posixpath.join(path, posixpath.basename(run.text(target))) if path.endswith("/") else path
        if path not in THERE or (source, path) in seen:
            continue
        seen.add((source, path))
        if not _is_handled(robot, source, name, path) and not robot.scripts.is_for_image(source):
            yield finding(
                name,
                f"Every robot has {path}: ln says 'File exists', and changes nothing",
                advice="write ln -sf",
            )


def _is_plain_link(run: Run) -> bool:
    """Whether a symbolic link is made, the name must be free, and the failure counts."""
    options = [word for word in run.words[1:] if word.startswith("-")]
    if any(REPLACES.fullmatch(word) for word in options) or run.command.ends == "||" or run.command.hides_errors:
        return False
    return any("s" in word for word in options)


def _is_handled(robot: Robot, source: Source, name: str, path: str) -> bool:
    """Whether the file may be none there, or the script may know of it."""
    if "$" in name or source.says(MAKES_ROOM) or source.said.count(path) > 1:
        return True
    if path == ZONE and robot.of_kind("dockerfile"):
        return True
    runs = (did for did in robot.scripts.done(source) if isinstance(did, Run) and did.name in REMOVES)
    return any(_may_be(word, path) for run in runs for word in run.words[1:] if not word.startswith("-"))


def _may_be(word: str, path: str) -> bool:
    """Whether a word of a command may stand for a path, or for a folder that has it."""
    return not word.startswith("/") or path.startswith(PLAIN.match(word)[0])  # type: ignore[index]
