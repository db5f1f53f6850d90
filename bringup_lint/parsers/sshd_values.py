"""The values of sshd_config, judged as sshd does (servconf.c of OpenSSH 9.2)."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Sequence
from functools import cache

from bringup_lint import facts
from bringup_lint.addresses import is_port
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_TIME = regex(r"\d+(?:[smhdwSMHDW]\d+)*[smhdwSMHDW]?")
_INTEGER = regex(r"\+?\d{1,10}")
_REKEY = regex(r"\d+(?:\.\d+)?[kKmMgGtTbB]?")
_STARTUPS = regex(r"([+-]?\d+)(?::([+-]?\d+):([+-]?\d+))?")
_NETBLOCK = regex(r"([+-]?\d+)(?::([+-]?\d+))?")
_LEVELS = frozenset(["SILENT", "QUIET", "FATAL", "ERROR", "INFO", "VERBOSE", "DEBUG", "DEBUG1", "DEBUG2", "DEBUG3"])
_FACILITIES = frozenset(
    [
        "DAEMON",
        "USER",
        "AUTH",
        "AUTHPRIV",
        "LOCAL0",
        "LOCAL1",
        "LOCAL2",
        "LOCAL3",
        "LOCAL4",
        "LOCAL5",
        "LOCAL6",
        "LOCAL7",
    ]
)
_TUNNEL = ("no", "point-to-point", "ethernet", "yes")
_QOS = frozenset(
    [
        "none",
        "af11",
        "af12",
        "af13",
        "af21",
        "af22",
        "af23",
        "af31",
        "af32",
        "af33",
        "af41",
        "af42",
        "af43",
        "cs0",
        "cs1",
        "cs2",
        "cs3",
        "cs4",
        "cs5",
        "cs6",
        "cs7",
        "ef",
        "le",
        "lowdelay",
        "throughput",
        "reliability",
    ]
)

Words = Sequence[Located]
Verdict = tuple[int, str]
"""How many arguments the keyword takes, and what it expects where it was not given; empty when all is well."""


@cache
def algorithms(kind: str) -> dict[str, bool]:
    """The known names of ``cipher``, ``mac``, ``kex`` or ``keys``, and whether each is weak."""
    return {name: bool(weak) for group, name, weak in facts.rows("host/ssh_algorithms")[1] if group == kind}


def judge(kind: str, words: Words) -> Verdict:
    """What sshd makes of the arguments of a keyword of this kind."""
    if kind.startswith("states:"):
        choices = kind[7:].split(",")
        return _one(words, lambda word: word.lower() in choices, " or ".join(_listed(choices)))
    if kind.startswith("words:"):
        choices = kind[6:].split(",")
        return len(words), "" if all(word.lower() in choices for word in words) else " or ".join(_listed(choices))
    if kind in ("cipher", "mac", "kex", "keys"):
        return _one(words, lambda word: _are_algorithms(kind, word), f"a list of {_NAMES[kind]} that OpenSSH knows")
    return _KINDS[kind](words)


_NAMES = {"cipher": "ciphers", "mac": "MACs", "kex": "key exchange methods", "keys": "key types"}


def _listed(choices: list[str]) -> list[str]:
    return [", ".join(choices[:-1]), choices[-1]] if len(choices) > 1 else choices


def _one(words: Words, fits: Callable[[str], object], expected: str) -> Verdict:
    return 1, "" if words and words[0] and fits(words[0]) else expected


def _are_algorithms(kind: str, word: str) -> bool:
    if word.startswith("-"):
        return True
    names = word[1:] if word[0] in "+^" else word
    patterns = kind == "keys"
    return bool(names) and all(
        name in algorithms(kind) or (patterns and bool({"*", "?"} & set(name))) for name in names.split(",")
    )


def _time(word: str) -> bool:
    return bool(_TIME.fullmatch(word))


def _integer(word: str) -> bool:
    return bool(_INTEGER.fullmatch(word)) and int(word) < 2**31


def _port(word: str) -> bool:
    return is_port(word) or word == "ssh"


def _listen(words: Words) -> Verdict:
    if not words or not words[0]:
        return 1, "an address"
    address = words[0]
    used = 3 if len(words) > 1 else 1
    if "[" not in address and address.count(":") > 1:
        return used, ""
    port = address.rpartition("]")[2].partition(":")[2] if "[" in address else address.partition(":")[2]
    return used, "" if not port or _port(port) else "ADDRESS or ADDRESS:PORT"


def _rekey(words: Words) -> Verdict:
    if not words or not (words[0] == "default" or _REKEY.fullmatch(words[0])):
        return 1, "an amount such as 1G, optionally followed by a time"
    if words[0].isdecimal() and 0 < int(words[0]) < 16:
        return 1, "an amount of at least 16 bytes"
    if len(words) > 1:
        return 2, "" if words[1] == "none" or _time(words[1]) else "a time such as 1h"
    return 1, ""


def _startups(words: Words) -> Verdict:
    found = _STARTUPS.match(words[0]) if words else None
    if found is None or (found[2] is None and ":" in words[0] and re.match(r"[+-]?\d+:[+-]?\d", words[0])):
        return 1, "START:RATE:FULL"
    begin, full = int(found[1]), int(found[3] or found[1])
    rate = int(found[2]) if found[2] else 1
    return 1, "" if 0 < begin <= full and 1 <= rate <= 100 else "START:RATE:FULL"


def _netblock(words: Words) -> Verdict:
    found = _NETBLOCK.match(words[0]) if words else None
    fits = found and 0 <= int(found[1]) <= 32 and 0 <= int(found[2] or 0) <= 128
    return 1, "" if fits else "bits for IPv4 and perhaps for IPv6, such as 32:128"


def _qos(words: Words) -> Verdict:
    fits = bool(words) and all(
        word.lower() in _QOS or (_INTEGER.fullmatch(word) and int(word) < 256) for word in words[:2]
    )
    return 2, "" if fits else "a class such as af21, lowdelay or none"


def _mask(words: Words) -> Verdict:
    found = re.match(r"\s*\+?([0-7]+)", words[0]) if words else None
    return 1, "" if found and int(found[1], 8) <= 0o777 else "an octal mode"


def _opens(words: Words) -> Verdict:
    if not words or not words[0]:
        return 1, "HOST:PORT, any or none"
    if words[0] in ("any", "none"):
        return 1, ""
    return len(words), ""


def _names(words: Words) -> Verdict:
    return len(words), "" if all(word and "=" not in word for word in words) else "names of variables"


def _settings(words: Words) -> Verdict:
    return len(words), "" if all("=" in word for word in words) else "NAME=VALUE"


def _command(words: Words) -> Verdict:
    fits = bool(words) and (words[0].startswith("/") or words[0].lower() == "none")
    return len(words), "" if fits else "an absolute path or none"


def _any(words: Words) -> Verdict:
    return len(words), ""


def _words(words: Words) -> Verdict:
    return len(words), "" if all(words) else "words that are not empty"


_KINDS: dict[str, Callable[[Words], Verdict]] = {
    "flag": lambda words: _one(words, lambda word: word.lower() in ("yes", "no"), "yes or no"),
    "one": lambda words: _one(words, lambda word: True, "a value"),
    "time": lambda words: _one(words, _time, "a time such as 30, 5m or 1h"),
    "time-or-none": lambda words: _one(words, lambda word: word.lower() == "none" or _time(word), "a time or none"),
    "int": lambda words: _one(words, _integer, "a whole number"),
    "number-or-none": lambda words: _one(
        words, lambda word: word == "none" or _integer(word), "a whole number or none"
    ),
    "port": lambda words: _one(words, _port, "a port from 1 to 65535"),
    "loglevel": lambda words: _one(words, lambda word: word.upper() in _LEVELS, "a level such as INFO or VERBOSE"),
    "facility": lambda words: _one(
        words, lambda word: word.upper() in _FACILITIES, "a facility such as AUTH or LOCAL0"
    ),
    "tunnel": lambda words: _one(words, lambda word: word in _TUNNEL, "yes, no, point-to-point or ethernet"),
    "listen": _listen,
    "rekey": _rekey,
    "startups": _startups,
    "netblock": _netblock,
    "qos": _qos,
    "mask": _mask,
    "opens": _opens,
    "names": _names,
    "settings": _settings,
    "command": _command,
    "words": _words,
    "rest": _any,
    "ignored": _any,
    "deprecated": _any,
    "methods": lambda words: (len(words), "" if words else "lists of methods"),
    "include": lambda words: (len(words), "" if words and all(words) else "a file name"),
    "subsystem": lambda words: (
        len(words),
        "" if len(words) > 1 and all(words[:2]) else "a name and a command",
    ),
    "match": _any,
}
