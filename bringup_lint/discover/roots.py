"""Where a tree is on the robot: root file systems, overlays, and the vendor's folders beside a checked ``/etc``."""

from __future__ import annotations

import os

from bringup_lint.discover import disk
from bringup_lint.pattern import regex

VENDOR_FOLDERS = (
    "usr/local/lib/systemd",
    "usr/lib/systemd",
    "lib/systemd",
    "run/systemd",
    "usr/lib/udev/rules.d",
    "lib/udev/rules.d",
    "run/udev/rules.d",
    "usr/lib/netplan",
    "run/netplan",
    "usr/lib/sysctl.d",
    "usr/lib/sysusers.d",
    "usr/lib/tmpfiles.d",
    "usr/lib/modules-load.d",
    "usr/lib/environment.d",
)
"""Folders of the distribution that /etc builds on, by systemd.unit(5), udev(7), netplan(5), sysctl.d(5),
sysusers.d(5)."""

PASSED_OVER = frozenset(
    "bin boot cdrom dev lib lib32 lib64 libx32 lost+found media mnt proc run sbin snap swapfile sys tmp usr/bin "
    "usr/games "
    "usr/include usr/lib usr/lib32 usr/lib64 usr/libexec usr/libx32 usr/sbin usr/share usr/src var/cache var/crash "
    "var/lib/apt var/lib/docker var/lib/dpkg var/lib/snapd var/log var/mail var/run var/spool var/tmp".split()
)
"""Folders of a root file system that hold programs, data and state; the vendor's configuration there is context."""

_OVERLAY = regex(
    r"(?:^|/)((?:etc|usr/lib|usr/local|lib/systemd|lib/udev|run/systemd|opt|home|root|var/lib)/.*)",
    hints="etc/ usr/ lib/ run/ opt/ home/ root/",
)


def is_root(folder: str) -> bool:
    """Whether the folder is a root file system: it names its release and its users, and has a /usr."""
    release = (os.path.join(folder, name) for name in ("etc/os-release", "usr/lib/os-release"))
    if not any(map(disk.lexists, release)):
        return False
    users, programs = resolve_inside(folder, "/etc/passwd"), resolve_inside(folder, "/usr")
    return users is not None and disk.isfile(users) and programs is not None and disk.isdir(programs)


def root_of(path: str) -> str | None:
    """The root file system that an absolute path lies in, or None for a path of a repository."""
    for folder in (path, *disk.above(path)):
        if is_root(folder):
            return None if folder == "/" and not _is_system_path(path) else folder
    return None


def _is_system_path(path: str) -> bool:
    """Whether a path of the running system is configuration of this machine, not a checkout that lies on it."""
    return path == "/" or path.split("/")[1] in ("etc", "usr", "lib", "run")


def overlay_path(path: str) -> tuple[str, str] | None:
    """Split the path of an overlay (``board/rootfs/etc/udev/x.rules``) in its root and the path on the robot."""
    match = _OVERLAY.search(path)
    if match is None:
        return None
    return path[: match.start(1)], "/" + match.group(1)


def resolve_inside(root: str, path: str, hops: int = 40) -> str | None:
    """Follow a path as the system booted from ``root`` would; None when it leaves the root, loops or dangles."""
    base = disk.realpath(root)
    pending = [part for part in path.split("/") if part not in ("", ".")][::-1]
    done: list[str] = []
    while pending:
        part = pending.pop()
        if part == "..":
            done = done[:-1]
            continue
        here = os.path.join(base, *done, part)
        try:
            target = disk.readlink(here)
        except OSError:
            done.append(part)
            continue
        hops -= 1
        if hops < 0:
            return None
        if target.startswith("/"):
            done = []
        pending += [step for step in target.split("/") if step not in ("", ".")][::-1]
    resolved = os.path.join(base, *done)
    return resolved if disk.exists(resolved) else None
