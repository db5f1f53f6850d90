"""A script makes configuration writable for everybody.

## What it finds
`chmod 777`, `chmod 666`, `chmod a+w` and the like on a file or folder in `/etc`, `/usr`, `/boot`, `/lib`, `/opt`,
on a hidden file of a home folder, on a private key, or on a file `.env`. Also such a mode of `mkdir -m`, of
`install -m` and of a task of Ansible.

Silent where the script takes the write access off again afterwards.

## Why it matters on a robot
Every service and every user of the robot can change the file. Configuration that root reads, such as /etc/hosts or
a script that a unit runs, lets them become root or lead the robot's traffic elsewhere. sshd refuses keys with such
modes.

## Bad
```sh
sudo chmod 777 /etc/rover/robot.yaml
```

## Good
```sh
sudo chown root:rover /etc/rover/robot.yaml
sudo chmod 664 /etc/rover/robot.yaml
```

## When to ignore it
When the file holds nothing that anything trusts.

## References
- chmod(1)
- CWE-732: Incorrect Permission Assignment for Critical Resource
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import FileMode
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import file_modes

OPEN = regex(r"0?[0-7]?[0-7][0-7][2367]|[ugo]*[ao][ugo]*\+r?wx?X?|[ugo]*[ao][ugo]*=r?wx?X?")
OF_ALL = regex(r"\+r?wx?X?")
"""Without a letter before it, umask takes the write access of others off again, but for mkdir."""
CLOSED = regex(r"0?[0-7]?[0-7][0-7][0145]|[ugo]{0,2}[oa][ugo]{0,2}(?:-[rwx]{1,3}|=[rxX]{0,3})")
STICKY = regex(r"[1357][0-7]{3}|0[1357][0-7]{3}")
TRUSTED = regex(
    r"/(?:etc|usr|boot|lib|opt)/.+|(?:/home/[^/]+|/root|~|\{\{ HOME \}\})/\.[^/]+.*|.*/id_(?:rsa|ed25519|ecdsa)"
    r"|(?:[^*]*/)?\.env"
)
NO_MATTER = regex(r"/(?:logs?|tmp|cache|run|data)(?:/|$)|\.log$|\.Xauth|\.docker\.xauth")


MODE = regex(r"(?:--mode=|-[a-zA-Z]*m)(?P<mode>\S*)")
KINDS = {
    "file": ("file", "mode 664 or 640"),
    "program": ("file", "mode 775, or 664 if nobody runs it"),
    "changed": ("file", "mode g+w,o-w"),
    "folder": ("folder", "mode 2775 or 750"),
    "file or folder": ("file or folder", "chmod g+w,o-w"),
    "files": ("files", "chmod -R u+rwX,g+rwX,o-w"),
    "files of a task": ("files", "mode u=rwX,g=rwX,o=rX"),
}
"""What is opened, and the modes that are enough for a group."""
OF_FILE = regex(r"[0246]+")
"""A folder with such a mode cannot be entered, and a program not be run."""
DATA = regex(r"/\.?[\w-]*\.(?:ya?ml|json|xml|conf|cfg|ini|env|txt|rules|service|list)$|/\.env$|^\.env$|/id_\w+$")
YES = ("true", "yes", "on", "1")
RECURSIVE = regex(r"-\w*R\w*|--recursive")
DEEPEST = 64
"""Folders above a path that are looked at."""
OPTIONS = frozenset(("-o", "-g", "-S", "-t", "--owner", "--group", "--suffix", "--target-directory"))
"""Options of install whose values are words of their own."""


@rule("warning", tags=["CWE-732"], symptoms=["is marked world-writable"])
def world_writable(robot: Robot) -> Iterator[Finding]:
    runs = list(robot.scripts.run("chmod", "mkdir", "install"))
    closed = _closed(runs)
    for at, (source, run) in enumerate(runs):
        mode, paths = _opened(run) if run.name == "chmod" else _made(run)
        for path, word in paths:
            if _is_trusted(path) and not closed.is_after(at, source, path):
                what = _kind(run, mode, path)
                yield _of(word, f"{run.name} {mode}", path, what, None if run.certain else "medium")
    for source in robot.of_kind("ansible"):
        if source.judged and "mode" in source.text:
            for where, mode, path, what in _of_tasks(source):
                yield _of(where, mode, path, what, None)


def _of(where: Located, mode: str, path: str, kind: str, confidence: str | None) -> Finding:
    what, instead = KINDS[kind]
    return finding(
        where,
        f"{mode} lets every user and every service of the robot change {path}",
        advice=f"give the {what} to a group that needs {'them' if what == 'files' else 'it'}, with {instead}",
        confidence=confidence,
    )


def _kind(run: Run, mode: str, path: str) -> str:
    """What a command opens: a folder and a program are of no use without the right to enter or run them."""
    if run.name != "chmod":
        return "folder" if _makes_folder(run) else _of_new(mode.removeprefix("-m "), path)
    if any(map(RECURSIVE.fullmatch, run.words)):
        return "files"
    if path.endswith("/"):
        return "folder"
    return "file" if OF_FILE.fullmatch(mode) or DATA.search(path) else "file or folder"


def _of_new(mode: str, path: str) -> str:
    """What a file is that gets its mode with its text: a program where the mode lets somebody run it."""
    is_run = "x" in mode.lower() or (mode.isdigit() and not OF_FILE.fullmatch(mode))
    return "program" if is_run and not DATA.search(path) else "file"


def _is_trusted(path: str) -> bool:
    return TRUSTED.fullmatch(path) is not None and not NO_MATTER.search(path)


def _is_open(mode: str) -> bool:
    return OPEN.fullmatch(mode) is not None and not STICKY.fullmatch(mode)


def _opened(run: Run) -> tuple[str, list[tuple[str, Located]]]:
    """The mode that a command gives to everybody, and the paths with their words; no paths for other modes."""
    words = [(run.text(word), word) for word in run.words[1:]]
    plain = [each for each in words if not re.match(r"-[A-Za-z-]", each[0])]
    return (plain[0][0], plain[1:]) if plain and _is_open(plain[0][0]) else ("", [])


class Closed(NamedTuple):
    """Where scripts take the write access of others off again: script and path -> the last command that does."""

    itself: dict[tuple[Source, str], int]
    below: dict[tuple[Source, str], int]
    """With all in the folder."""

    def is_after(self, at: int, source: Source, path: str) -> bool:
        """Whether a command after another one of a script closes a path, or a folder above it."""
        here = path.rstrip("/")
        parts = here.split("/")[:DEEPEST]
        above = ("/".join(parts[:count]) for count in range(1, len(parts)))
        return self.itself.get((source, here), -1) > at or any(
            self.below.get((source, each), -1) > at for each in above
        )


def _closed(runs: list[tuple[Source, Run]]) -> Closed:
    closed = Closed({}, {})
    for at, (source, run) in enumerate(runs):
        words = [run.text(word).rstrip("/") for word in run.words[1:]] if run.name == "chmod" else []
        if any(map(CLOSED.fullmatch, words)):
            closed.itself.update(((source, word), at) for word in words)
            if any(map(RECURSIVE.fullmatch, words)):
                closed.below.update(((source, word), at) for word in words if len(word) > 1)
    return closed


def _made(run: Run) -> tuple[str, list[tuple[str, Located]]]:
    """The mode with which everybody may write to what mkdir or install makes, and the paths; no paths for others."""
    mode = ""
    paths: list[tuple[str, Located]] = []
    words = iter(run.words[1:])
    for word in words:
        given = MODE.fullmatch(word)
        if given is not None:
            mode = given["mode"] or str(next(words, ""))
        elif word in OPTIONS:
            next(words, None)
        elif not word.startswith("-"):
            paths.append((run.text(word), word))
    if not _is_open(mode) and not (run.name == "mkdir" and OF_ALL.fullmatch(mode)):
        return "", []
    return f"-m {mode}", paths if _makes_folder(run) else paths[-1:]


def _makes_folder(run: Run) -> bool:
    return run.name == "mkdir" or any(re.fullmatch(r"-[a-zA-Z]*d\w*|--directory", word) for word in run.words)


def _of_tasks(source: Source) -> Iterator[tuple[Located, str, str, str]]:
    """The modes of tasks that everybody may write with, the paths, and what is there."""
    for given in file_modes(source):
        mode, state = given.mode.value, given.settings.scalar("state")
        path = given.settings.scalar("path") or given.settings.scalar("dest")
        if path is None or (state is not None and state.value in ("link", "absent")):
            continue
        if (given.is_octal or not mode.isdigit()) and _is_open(mode) and _is_trusted(path.value):
            yield mode, f"mode {mode}", path.value, _kind_of_task(given, path.value)


def _kind_of_task(given: FileMode, path: str) -> str:
    state, source = given.settings.scalar("state"), given.settings.scalar("src")
    if state is not None and state.value == "directory":
        again = given.settings.scalar("recurse")
        return "files of a task" if again is not None and again.value.lower() in YES else "folder"
    if source is not None and source.value.endswith("/"):
        return "files of a task"
    mode = str(given.mode.value)
    is_changed = not mode.isdigit() and "=" not in mode and not DATA.search(path)
    return "changed" if is_changed else _of_new(mode, path)
