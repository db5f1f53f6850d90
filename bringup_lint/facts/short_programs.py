"""Programs that a callback may wait for: they return at once, or end everything."""

from __future__ import annotations

from collections.abc import Sequence

_SHORT = frozenset(
    "clear cls reset tput stty echo true false date mkdir touch rm ln cp mv chmod chown kill killall pkill sync "
    "reboot poweroff halt shutdown amixer notify-send "
    "iwconfig iw ifconfig ip hostname uname uptime df free cat grep awk sed head tail cut wc ls pgrep pidof which "
    "v4l2-ctl vcgencmd sensors lsusb getent id".split()
)
_FOLLOWS = frozenset({"-f", "-F", "--follow", "monitor"})
"""Options and words with which a short program goes on until it is stopped."""
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
    if words[-1].endswith("&"):
        return True
    return program in _SHORT and _FOLLOWS.isdisjoint(words) and _ends_short(words)


def _ends_short(words: Sequence[str]) -> bool:
    """Whether the other programs of a pipeline or list return at once, too."""
    starts = [at + 1 for at, word in enumerate(words[:-1]) if word in ("|", "||", "&&", ";")]
    return all(words[at].rpartition("/")[2] in _SHORT for at in starts)
