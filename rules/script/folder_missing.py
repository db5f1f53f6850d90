"""A script writes into a folder that nothing makes.

## What it finds
A redirection (`> FILE`, `&>> FILE`) into a folder that no `mkdir` or `install -d` of the tree's scripts makes and that
nothing else of the tree names, where a script makes a folder beside it whose name differs in a letter, such as
`/var/log/rover` and `/var/log/rovers`. Also `>` and `tee` into a folder that Debian and Ubuntu do not have before
somebody makes it (`/etc/systemd/journald.conf.d`, `/etc/systemd/system/NAME.service.d`), or that a package brings of
which nothing in the tree speaks (`/etc/iptables`), where no other line of the tree names it. Folders that differ in a
number are two folders, and those that packages of the system bring, such as `/etc/ssh/sshd_config.d` and
`/usr/local/bin`, are there.

Also what a script copies, links or writes into a folder that differs in a letter from one of the system, such as
`/etc/udev/rule.d`, and that no script makes.

## Why it matters on a robot
The shell cannot open the file, and does not run the command: nothing is calibrated, started or logged. The only message
is that of the shell, which at boot nobody sees.

## Bad
```sh
mkdir -p "$HOME/heron/log"
heron-calibrate &>> "$HOME/heron/logs/calibrate.log"
```

## Good
```sh
mkdir -p "$HOME/heron/log"
heron-calibrate &>> "$HOME/heron/log/calibrate.log"
```

## When to ignore it
When a program that is not in the tree makes the folder.

## References
- bash(1), "REDIRECTION"
"""

import posixpath
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
from bringup_lint.api.shell import Written
from bringup_lint.api.shell import runs_in_image
from bringup_lint.api.spelling import nearest
from bringup_lint.api.spelling import numbered

HOME = regex(r"^(?:~|\$HOME|\$\{HOME\}|\{\{ ?HOME ?\}\})(?=/)")
BROUGHT = regex(
    r"/etc/(?:"
    r"ssh/sshd?_config|apt/(?:apt\.conf|sources\.list|preferences|trusted\.gpg|auth\.conf)|udev/(?:rules|hwdb)"
    r"|NetworkManager/(?:conf|dispatcher)|security/(?:limits|namespace)|logrotate|rsyslog|cron|profile|sudoers|modprobe"
    r"|modules-load|sysctl|tmpfiles|binfmt|init|ld\.so\.conf"
    r"|dbus-1/(?:system|session))\.d"
    r"|/etc/systemd/(?:system|user|network)|/usr/(?:local/)?(?:s?bin|lib|share|src|include)"
)
"""Folders that packages of Debian and Ubuntu bring."""
ABSENT = regex(
    r"/etc/systemd/(?:(?:journald|resolved|logind|timesyncd|networkd|coredump|sleep|system|user)\.conf"
    r"|(?:system|user)/[\w@.-]+\.(?:service|target|timer|socket))\.d"
)
"""Drop-in folders that no package of Debian and Ubuntu makes."""
PACKAGED = {
    "/etc/iptables": ("iptables-persistent", "netfilter-persistent"),
    "/etc/hostapd": ("hostapd",),
    "/etc/mosquitto/conf.d": ("mosquitto",),
    "/etc/supervisor/conf.d": ("supervisor",),
    "/etc/nginx/sites-available": ("nginx",),
    "/etc/nginx/conf.d": ("nginx",),
    "/etc/wireguard": ("wireguard",),
}
"""Folder -> the packages that bring it, of which none is there by itself."""
SYSTEM = (
    "/etc/udev/rules.d",
    "/etc/systemd/system",
    "/etc/systemd/network",
    "/etc/sysctl.d",
    "/etc/modprobe.d",
    "/etc/modules-load.d",
    "/etc/sudoers.d",
    "/etc/netplan",
    "/etc/cron.d",
    "/etc/profile.d",
    "/etc/logrotate.d",
    "/etc/security/limits.d",
    "/etc/ld.so.conf.d",
    "/etc/apt/sources.list.d",
    "/etc/NetworkManager/system-connections",
    "/usr/share/keyrings",
    "/usr/local/bin",
)
"""Folders in which people install files, and which every Debian and Ubuntu for robots has."""
COPIES = ("cp", "mv", "ln", "install", "rsync")
PLAIN = regex(r"~?(?:/[\w.-]+){2,}")
TWO = regex(r"(?<![\w.@-])(?=([\w.@-]+/[\w.@-]+))")


@rule("error", confidence="medium", symptoms=["*.sh: line *: *: No such file or directory"])
def folder_missing(robot: Robot) -> Iterator[Finding]:
    made = _made(robot)
    yield from _absent(robot, made)
    yield from _misspelt(robot, made)
    if not made:
        return
    known = set(_known(made))
    beside: dict[str, list[str]] = {}
    for each in made:
        beside.setdefault(posixpath.dirname(each), []).append(posixpath.basename(each))
    seen: dict[str, str] = {}
    written: list[tuple[Located, str]] = []
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or ">" not in source.text:
            continue
        for did in robot.scripts.done(source):
            if not isinstance(did, Written) or not did.by_shell:
                continue
            folder = posixpath.dirname(_path(did.path))
            if folder in known or not PLAIN.fullmatch(folder) or BROUGHT.fullmatch(folder):
                continue
            if folder not in seen:
                seen[folder] = _meant(folder, beside)
            if seen[folder]:
                written.append((did.where, folder))
    lines = _lines(robot, {_end(folder) for _, folder in written})
    for where, folder in written:
        if lines[_end(folder)] <= {(where.span.source, where.span.line)}:
            yield finding(
                where,
                f"Nothing makes {folder}: the shell cannot open the file and does not run the command",
                advice=f"did you mean {seen[folder]}?",
                related=[note(made[seen[folder]], "this folder is made")],
            )


def _absent(robot: Robot, made: dict[str, Located]) -> Iterator[Finding]:
    """What scripts write into folders that the system does not have by itself."""
    places: dict[str, list[Located]] = {}
    for source, written in robot.scripts.written("/etc/systemd/", *PACKAGED):
        folder = posixpath.dirname(written.path)
        if f"-d {folder} " in source.text:
            continue
        is_absent = ABSENT.fullmatch(folder) or (folder in PACKAGED and not _is_brought(robot, folder))
        if is_absent and folder not in made and not runs_in_image(source):
            places.setdefault(folder, []).append(written.where)
    lines = _lines(robot, set(map(_end, places)))
    for folder, (first, *others) in places.items():
        if lines[_end(folder)] <= {(each.span.source, each.span.line) for each in (first, *others)}:
            yield finding(
                first,
                f"Nothing makes {folder}: the file cannot be opened, and what it is to hold is lost",
                advice=f"install {PACKAGED[folder][0]}" if folder in PACKAGED else f"run mkdir -p {folder} before it",
                related=[note(each, "nor this") for each in others],
            )


def _misspelt(robot: Robot, made: dict[str, Located]) -> Iterator[Finding]:
    """What scripts put into a folder that is nearly one of the system."""
    seen = set()
    for word, path in _targets(robot):
        for folder in (path.rstrip("/"), posixpath.dirname(path.rstrip("/"))):
            if folder in SYSTEM or folder in made or not folder.startswith(("/etc/", "/usr/")):
                continue
            meant = nearest(folder, SYSTEM, 1) if BROUGHT.fullmatch(folder) is None else []
            if len(meant) == 1 and not numbered(folder, meant[0]) and word.span not in seen:
                seen.add(word.span)
                yield finding(
                    word,
                    f"The system has no {folder}: what is to be there is not read",
                    advice=f"write {meant[0]}",
                )


def _targets(robot: Robot) -> Iterator[tuple[Located, str]]:
    """Where scripts put files on the robot."""
    for source, run in robot.scripts.run(*COPIES):
        if source.judged and len(run.words) > 2:
            yield run.words[-1], run.text(run.words[-1])
    found = robot.scripts.written("/etc/", "/usr/")
    yield from ((written.where, written.path) for source, written in found if source.judged)


def _is_brought(robot: Robot, folder: str) -> bool:
    """Whether something of the tree speaks of the package that brings a folder."""
    own = "|".join(map(re.escape, PACKAGED[folder]))
    return robot.mentions(re.compile(rf"(?<![\w/.-])(?:{own})(?![\w/.])"))


def _path(text: str) -> str:
    return HOME.sub("~", text.strip("\"'"))


def _made(robot: Robot) -> dict[str, Located]:
    """The folders that scripts make."""
    found: dict[str, Located] = {}
    for _, run in robot.scripts.run("mkdir", "install"):
        if run.name == "mkdir" or "-d" in run.words:
            for word in run.words[1:]:
                for folder in _expanded(_path(run.text(word)).rstrip("/")):
                    if PLAIN.fullmatch(folder):
                        found.setdefault(folder, word)
    return found


def _expanded(path: str) -> list[str]:
    """What the braces of bash in a path stand for, where there is one pair of them."""
    before, opened, rest = path.partition("{")
    inner, closed, after = rest.partition("}")
    return [before + each + after for each in inner.split(",")] if opened and closed else [path]


def _known(made: dict[str, Located]) -> Iterator[str]:
    """The folders that are made, and those that they lie in."""
    for folder in made:
        parts = folder.split("/")
        yield from ("/".join(parts[:count]) for count in range(2, len(parts) + 1))


def _meant(folder: str, beside: dict[str, list[str]]) -> str:
    """The folder beside it that is nearly of this name; empty without one, or with several."""
    parent, name = posixpath.split(folder)
    near = [each for each in nearest(name, beside.get(parent, ())) if not numbered(name, each)]
    return f"{parent}/{near[0]}" if len(near) == 1 else ""


def _end(folder: str) -> str:
    return "/".join(folder.split("/")[-2:])


def _lines(robot: Robot, ends: set[str]) -> dict[str, set[tuple[Source, int]]]:
    """The lines of the tree, at most two, that name what may make a folder, by the end of its path."""
    found: dict[str, set[tuple[Source, int]]] = {end: set() for end in ends}
    if not ends:
        return found
    for source in robot.sources:
        for match in TWO.finditer(source.text):
            lines = found.get(match[1])
            if lines is not None and len(lines) <= 1:
                lines.add((source, source.located(*match.span()).span.line))
    return found
