"""A script installs a file under a name that nothing reads.

## What it finds
Files that `cp`, `install`, `mv`, `ln`, `tee` or a redirection of a script puts into a folder of which a program reads
the names of one ending only: `.conf` in `sysctl.d`, `modules-load.d`, `modprobe.d`, `tmpfiles.d`, `sysusers.d`,
`limits.d`, `ld.so.conf.d`, `sshd_config.d`, `rsyslog.d`, NetworkManager's and systemd's `conf.d`; `.network`,
`.netdev` and `.link` in `systemd/network`; `.list` and `.sources` in `sources.list.d`; `.sh` in `profile.d`; and
names with a dot in `sudoers.d`, which sudo leaves out.

Names for backups (`.bak`, `.disabled`, ...) are not reported, nor what a variable names, files that were in the folder
before, and files that the script moves, removes, sources or includes by that name.

## Why it matters on a robot
The file is there, and nothing reads it or says so: the buffers are small, the interface has no address, the limits are
the usual ones. `sysctl -p FILE` in the same script makes it work until the next boot.

## Bad
```sh
install -m 644 60-dds.conf /etc/sysctl.d/60-dds
```

## Good
```sh
install -m 644 60-dds.conf /etc/sysctl.d/60-dds.conf
```

## When to ignore it
When another program reads the file by this name.

## References
- sysctl.d(5), systemd.network(5), modules-load.d(5), tmpfiles.d(5)
- sudoers(5), "Including other files from within sudoers"
"""

import posixpath
import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import Written

FOLDERS = {
    "/etc/sysctl.d": (".conf",),
    "/etc/modules-load.d": (".conf",),
    "/etc/modprobe.d": (".conf",),
    "/etc/tmpfiles.d": (".conf",),
    "/etc/sysusers.d": (".conf",),
    "/etc/security/limits.d": (".conf",),
    "/etc/ld.so.conf.d": (".conf",),
    "/etc/ssh/sshd_config.d": (".conf",),
    "/etc/rsyslog.d": (".conf",),
    "/etc/NetworkManager/conf.d": (".conf",),
    "/etc/systemd/journald.conf.d": (".conf",),
    "/etc/systemd/logind.conf.d": (".conf",),
    "/etc/systemd/system.conf.d": (".conf",),
    "/etc/systemd/network": (".network", ".netdev", ".link"),
    "/etc/apt/sources.list.d": (".list", ".sources"),
    "/etc/profile.d": (".sh",),
    "/etc/sudoers.d": ("",),
}
COPIES = ("cp", "install", "mv", "ln")
VALUED = ("-o", "-g", "-m", "-S", "--owner", "--group", "--mode")
FOLDERS_TOO = regex(r"-[bce-qs-zA-QS-Z]*[adrR][a-zA-Z]*|--(?:directory|recursive|archive)")
PLAIN = regex(r"[\w.@+~:-]+")
LEFTOVER = regex(
    r"~$|\.(?:bak|orig|rej|swp|save|old|new|tmp|gpg|asc|zsh|fish|disabled|off|example|sample|d|csh|dpkg-\w+)$|^(?:README|\.placeholder)",
    re.I,
)


@rule("error", silent="what reads the folder leaves the file out and does not say so")
def ignored_name(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or not any(folder in source.text for folder in FOLDERS):
            continue
        for did in robot.scripts.done(source):
            for word, folder, name in _put(did):
                if _is_ignored(folder, name) and not _is_used(source, f"{folder}/{name}"):
                    yield finding(
                        word,
                        f"Nothing reads {folder}/{name}: " + _because(folder),
                        advice=f"call it {_advice(folder, name)}",
                    )


def _put(did: Run | Written) -> Iterator[tuple[Located, str, str]]:
    """The words that say where a file is put, with its folder and name."""
    if isinstance(did, Written):
        folder, _, name = did.path.rpartition("/")
        if folder in FOLDERS:
            yield did.where, folder, name
        return
    if did.name not in COPIES or any(map(FOLDERS_TOO.fullmatch, did.words)):
        return
    words = [
        word for before, word in zip(did.words, did.words[1:]) if not word.startswith("-") and before not in VALUED
    ]
    if len(words) < 2:
        return
    target = did.text(words[-1])
    folder, _, name = target.rpartition("/")
    if folder in FOLDERS and name and not did.text(words[0]).startswith(f"{folder}/"):
        yield words[-1], folder, name
    elif target.rstrip("/") in FOLDERS:
        for word in words[:-1]:
            yield word, target.rstrip("/"), posixpath.basename(did.text(word))


def _is_ignored(folder: str, name: str) -> bool:
    if not PLAIN.fullmatch(name) or LEFTOVER.search(name):
        return False
    endings = FOLDERS[folder]
    return "." in name if endings == ("",) else not name.endswith(endings)


def _is_used(source: Source, path: str) -> bool:
    """Whether the script moves, removes, sources or includes the file by this name."""
    written = re.escape(path)
    moves = rf"\b(?:mv|cp|ln)[ \t][^\n;&|]{{0,200}}{written}[\"']?[ \t]+[\"']?[\w/$.]"
    removes = rf"\brm[ \t][^\n;&|]{{0,200}}{written}(?![\w.-])"
    reads = rf"(?:\bsource|include|[ \t;&\"']\.)[ \t]+{written}(?![\w.-])"
    return re.search(f"{moves}|{removes}|{reads}", source.text) is not None


def _because(folder: str) -> str:
    endings = FOLDERS[folder]
    if endings == ("",):
        return "sudo leaves out names with a dot"
    return f"only names that end in {' or '.join(endings)} are read there"


def _advice(folder: str, name: str) -> str:
    ending = FOLDERS[folder][0]
    return f"{name.rpartition('.')[0] or name}{ending}" if ending in ("", ".network") else f"{name}{ending}"
