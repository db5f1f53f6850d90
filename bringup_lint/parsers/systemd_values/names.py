"""Names: users, interfaces, signals, units, buses, file descriptors."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.facts.systemd.directives import SECTION_OF_TYPE
from bringup_lint.parsers.systemd_values.enumerations import closest
from bringup_lint.parsers.systemd_values.enumerations import enumerations
from bringup_lint.parsers.systemd_values.numbers import parse_integer
from bringup_lint.parsers.systemd_values.problems import LINE
from bringup_lint.parsers.systemd_values.problems import NOTHING
from bringup_lint.parsers.systemd_values.problems import UNIT
from bringup_lint.parsers.systemd_values.problems import WORD
from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.parsers.systemd_values.specifiers import check_specifiers
from bringup_lint.parsers.systemd_values.specifiers import literal
from bringup_lint.parsers.systemd_values.unit_names import escape_path
from bringup_lint.parsers.systemd_values.unit_names import is_unit_name
from bringup_lint.parsers.systemd_values.word_splitting import DROP
from bringup_lint.parsers.systemd_values.word_splitting import KEEP
from bringup_lint.parsers.systemd_values.word_splitting import split_words
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_STRICT_USER = regex(r"[A-Za-z_][A-Za-z0-9_-]{0,30}")
_BUS_NAME = regex(r"[A-Za-z_-][A-Za-z0-9_-]*(\.[A-Za-z_-][A-Za-z0-9_-]*)+")
_SIGNAL_RT = regex(r"RTM(?:IN(?:\+([0-9]+))?|AX(?:-([0-9]+))?)")
RT_SIGNALS = 30
"""SIGRTMAX - SIGRTMIN with the GNU C library."""
SIGNALS = "a signal such as SIGINT, INT or 2"
UNIT_NAME = "a unit name with its suffix, separated by blanks"


def is_signal(text: str) -> bool:
    number = parse_integer(text)
    if number is not None:
        return 0 < number <= 64
    name = text.removeprefix("SIG")
    if name in enumerations()["signal"]:
        return True
    found = _SIGNAL_RT.fullmatch(name)
    return found is not None and int(found[1] or found[2] or 0) <= RT_SIGNALS


def check_signal(value: Located, version: int) -> Iterator[ValueProblem]:
    if not is_signal(value):
        upper = value.upper()
        yield ValueProblem("invalid", value, SIGNALS, suggestion=upper if is_signal(upper) else None, safe=True)


def check_exit_statuses(value: Located, version: int) -> Iterator[ValueProblem]:
    """Numbers up to 255, names of exit statuses, signals."""
    for word in split_words(value, quotes=False).words:
        number = parse_integer(word)
        since = enumerations()["exit-status"].get(word)
        if since is not None and since > version:
            yield ValueProblem("too-new", word, "an exit status or a signal", WORD, since=since)
        elif since is None and not is_signal(word) and not (number is not None and 0 <= number <= 255):
            upper = word.upper()
            known = is_signal(upper) or upper in enumerations()["exit-status"]
            yield ValueProblem(
                "invalid",
                word,
                "an exit status up to 255, or a signal",
                WORD,
                upper if known else None,
                known,
            )


def check_user_name(name: Located, version: int) -> Iterator[ValueProblem]:
    bad = list(check_specifiers(name, version, UNIT))
    yield from bad
    text = literal(name)
    if bad or text is None:
        return
    if text.isdecimal():
        if int(text) >= 2**32 - 1 or int(text) == 65535 or (len(text) > 1 and text[0] == "0"):
            yield ValueProblem("out-of-range", name, "a name, or a number up to 4294967294", UNIT)
    elif (
        (":" in text or "/" in text or text in (".", "..") or (text[0] == "-" and text[1:].isdecimal()) or text == "-")
        or any(ord(char) < 32 or ord(char) == 127 for char in text)
        or text != text.strip(" ")
    ):
        yield ValueProblem("invalid", name, "the name of a user or group", UNIT)
    elif _STRICT_USER.fullmatch(text) is None:
        yield ValueProblem("odd-name", name, "a name of letters, digits, '-' and '_'", NOTHING)


def check_users(value: Located, version: int) -> Iterator[ValueProblem]:
    for word in split_words(value, quotes=False).words:
        yield from check_user_name(word, version)


def is_interface_name(text: str) -> bool:
    """What the kernel and systemd take as the name of a network interface."""
    if not 0 < len(text) < 16 or text in (".", "..", "all", "default") or text.isdecimal():
        return False
    return all(32 < ord(char) < 127 and char not in ":/%" for char in text)


def check_interface(value: Located, version: int) -> Iterator[ValueProblem]:
    if value != "*" and not is_interface_name(value):
        yield ValueProblem("invalid", value, "the name of a network interface, at most 15 characters")


def check_interfaces(value: Located, version: int) -> Iterator[ValueProblem]:
    found = split_words(value.part(1, len(value)) if value.startswith("~") else value)
    yield from found.problems
    for word in found.words:
        if not is_interface_name(word):
            yield ValueProblem("invalid", word, "the name of a network interface, at most 15 characters", WORD)


def check_unit_name(name: Located, version: int, effect: str, suffix: str = "") -> Iterator[ValueProblem]:
    """A unit name, of one type if ``suffix`` says so."""
    bad = list(check_specifiers(name, version, effect, unit_name=True))
    yield from bad
    if bad:
        return
    text = literal(name)
    if text is None:
        tail = name.rpartition(".")[2]
        if "%" in tail or (tail in SECTION_OF_TYPE and name.endswith(suffix)):
            return
    elif is_unit_name(text) and text.endswith(suffix):
        return
    meant = next((name.rstrip(mark) for mark in (",", ";") if is_unit_name(name.rstrip(mark))), None)
    if meant is None and text is not None and text.startswith("/dev/"):
        meant = f"{escape_path(text)}.device"
    expected = f"the name of a unit that ends in {suffix}" if suffix else UNIT_NAME
    yield ValueProblem("bad-unit-name", name, expected, effect, meant, meant is not None)


def check_units(value: Located, version: int) -> Iterator[ValueProblem]:
    found = split_words(value, quotes=False, escapes=KEEP)
    for word in found.words:
        yield from check_unit_name(word, version, WORD)


def check_socket_units(value: Located, version: int) -> Iterator[ValueProblem]:
    for word in split_words(value, quotes=False, escapes=DROP).words:
        yield from check_unit_name(word, version, WORD, ".socket")


def check_service_unit(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from check_unit_name(value, version, LINE, ".service")


def check_trigger_unit(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from check_unit_name(value, version, LINE)


def check_slice(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from check_unit_name(value, version, LINE, ".slice")


def check_bus_name(value: Located, version: int) -> Iterator[ValueProblem]:
    bad = list(check_specifiers(value, version))
    yield from bad
    text = literal(value)
    if not bad and text is not None and (_BUS_NAME.fullmatch(text) is None or len(text) > 255):
        yield ValueProblem("invalid", value, "a D-Bus name with a dot, such as org.example.Robot")


def check_fd_name(value: Located, version: int) -> Iterator[ValueProblem]:
    bad = list(check_specifiers(value, version))
    yield from bad
    if not bad and (any(not 32 <= ord(char) < 127 or char == ":" for char in value) or len(value) > 255):
        yield ValueProblem("invalid", value, "ASCII characters without ':'")


def check_log_namespace(value: Located, version: int) -> Iterator[ValueProblem]:
    bad = list(check_specifiers(value, version))
    yield from bad
    text = literal(value)
    if not bad and text is not None and re.fullmatch(r"[A-Za-z0-9:_.@-]{1,222}", text) is None:
        yield ValueProblem("invalid", value, "a name of letters, digits, ':', '-', '_', '.' and '@'")


def check_words_of(kind: str, value: Located, version: int, *, fold: bool = False) -> Iterator[ValueProblem]:
    """A list of words out of one enumeration of capital letters if ``fold``, which ignores case."""
    known = enumerations()[kind]
    found = split_words(value)
    yield from found.problems
    for word in found.words:
        since = known.get(word.upper() if fold else word)
        if since is None:
            yield ValueProblem("invalid", word, f"words such as {next(iter(known))}", WORD, closest(word, known))
        elif since > version:
            yield ValueProblem("too-new", word, "", WORD, since=since)
