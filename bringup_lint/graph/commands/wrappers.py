"""Programs that run another program: ``exec``, ``nice``, ``sudo``, ``env`` and the like."""

from __future__ import annotations

from bringup_lint.source import Located

_WRAPPERS = {
    "exec": ("-a", 0),
    "command": ("", 0),
    "nohup": ("", 0),
    "setsid": ("", 0),
    "time": ("-f -o", 0),
    "nice": ("-n", 0),
    "ionice": ("-c -n", 0),
    "chroot": ("--userspec --groups", 1),
    "chrt": ("-T -P -D", 1),
    "taskset": ("", 1),
    "timeout": ("-k -s", 1),
    "stdbuf": ("-i -o -e", 0),
    "env": ("-u -C", 0),
    "sudo": ("-u -g -h -p -C -r -t -U -D -R", 0),
    "setpriv": (
        "--reuid --regid --ruid --euid --rgid --egid --groups --inh-caps --ambient-caps --bounding-set",
        0,
    ),
    "runuser": ("-u -g -G", 0),
    "gosu": ("", 1),
    "su-exec": ("", 1),
    "doas": ("-u -C", 0),
    "flock": ("-w --timeout --wait -E --conflict-exit-code", 1),
    "cgexec": ("-g", 0),
    "numactl": ("-C -m -N -i -p", 0),
    "prlimit": ("", 0),
    "unshare": ("", 0),
    "systemd-inhibit": ("", 0),
    "systemd-cat": ("-t -p", 0),
    "dbus-run-session": ("", 0),
    "tini": ("-p -e", 0),
    "dumb-init": ("-r --rewrite", 0),
    "catatonit": ("", 0),
    "xvfb-run": ("-e -f -n -p -s -w", 0),
}
"""Programs that run another one: their options that take a value, and how many words of their own they
need."""

_OWN_SHELL = ("chroot",)
"""Those that start a shell of their own when no program is named: it reads what the script gives it."""


def program_name(word: str) -> str:
    """The last component of a program's path."""
    return word.rpartition("/")[2]


def _only_asks(words: tuple[Located, ...]) -> bool:
    """Whether a shell is asked where a program is: ``command -v hostapd`` runs nothing."""
    return words[0] == "command" and words[1:2] in (("-v",), ("-V",))


def unwrapped(words: tuple[Located, ...]) -> tuple[Located, ...]:
    """The words without ``exec``, ``nice -n 5``, ``sudo -u rover``, ``env A=1`` and the like in front."""
    while words and (wrapper := _WRAPPERS.get(program_name(words[0]))) and not _only_asks(words):
        options, own = wrapper
        at = 1
        while at < len(words) and (words[at].startswith("-") or "=" in words[at]):
            at += 2 if words[at] in options.split() else 1
            if words[at - 1 : at] == ("--",):
                break
        if program_name(words[0]) in _OWN_SHELL and len(words) <= at + own:
            break
        words = words[at + own :]
    return words
