"""Programs that a callback may wait for: they return at once, or end everything."""

from __future__ import annotations

from collections.abc import Sequence

_SHORT = frozenset(
    "clear cls reset tput stty echo true false date mkdir touch rm ln cp mv chmod chown kill killall pkill sync "
    "reboot poweroff halt shutdown amixer notify-send".split()
)
_SYSTEMCTL = frozenset({"reboot", "poweroff", "halt", "suspend", "kexec", "kill", "is-active", "is-enabled"})


def returns_at_once(words: Sequence[str]) -> bool:
    """Whether the words of a command start a program that its caller need not wait for."""
    while len(words) > 1 and words[0] == "sudo":
        words = words[1:]
    if not words:
        return False
    program = words[0].rpartition("/")[2]
    if program == "systemctl":
        return "--no-block" in words or not _SYSTEMCTL.isdisjoint(words)
    return program in _SHORT or words[-1].endswith("&")
