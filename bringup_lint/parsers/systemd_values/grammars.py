"""Which grammar a directive's value type has, and the small ones."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import partial

from bringup_lint.parsers.systemd_values import addresses
from bringup_lint.parsers.systemd_values import lists
from bringup_lint.parsers.systemd_values import names
from bringup_lint.parsers.systemd_values import paths
from bringup_lint.parsers.systemd_values.calendar import is_calendar
from bringup_lint.parsers.systemd_values.commands import check_command_line
from bringup_lint.parsers.systemd_values.enumerations import check_choice
from bringup_lint.parsers.systemd_values.enumerations import choices
from bringup_lint.parsers.systemd_values.enumerations import enumerations
from bringup_lint.parsers.systemd_values.environment import check_environment
from bringup_lint.parsers.systemd_values.environment import check_environment_names
from bringup_lint.parsers.systemd_values.environment import check_environment_unset
from bringup_lint.parsers.systemd_values.environment import check_log_fields
from bringup_lint.parsers.systemd_values.numbers import parse_bool
from bringup_lint.parsers.systemd_values.numbers import parse_integer
from bringup_lint.parsers.systemd_values.numbers import parse_mode
from bringup_lint.parsers.systemd_values.numbers import parse_share
from bringup_lint.parsers.systemd_values.numbers import parse_size
from bringup_lint.parsers.systemd_values.problems import LINE
from bringup_lint.parsers.systemd_values.problems import UNIT
from bringup_lint.parsers.systemd_values.problems import WORD
from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.parsers.systemd_values.specifiers import check_specifiers
from bringup_lint.parsers.systemd_values.specifiers import literal
from bringup_lint.parsers.systemd_values.timespan import parse_timespan
from bringup_lint.parsers.systemd_values.word_splitting import KEEP
from bringup_lint.parsers.systemd_values.word_splitting import extract
from bringup_lint.parsers.systemd_values.word_splitting import split_words
from bringup_lint.pattern import regex
from bringup_lint.source import Located

Grammar = Callable[[Located, int], Iterator[ValueProblem]]

SIZE = "a size such as 512M or 2G (K, M, G, T without B)"
SPAN = "a time span such as 5, 500ms or 1min 30s"
_WRONG_SIZE = regex(r"([0-9.]+\s*[KMGTPE])i?[bB]|([0-9.]+)\s*([kmgtpe])i?[bB]?")
_URL = regex(r"(https?://|file:/|man:|info:)[\x00-\x7f]+")
_INT_MAX = 2**31 - 1


def _meant_size(text: str) -> str | None:
    found = _WRONG_SIZE.fullmatch(text)
    if found is None:
        return None
    return found[1] or found[2] + found[3].upper()


def anything(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from ()


def text(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from check_specifiers(value, version)


def boolean(value: Located, version: int) -> Iterator[ValueProblem]:
    if parse_bool(value) is None:
        yield ValueProblem("invalid", value, "yes or no")


def _integer(low: int, high: int, value: Located, version: int, expected: str = "") -> Iterator[ValueProblem]:
    number = parse_integer(value)
    if number is None:
        yield ValueProblem("invalid", value, expected or f"a whole number from {low} to {high}")
    elif not low <= number <= high:
        yield ValueProblem("out-of-range", value, expected or f"a whole number from {low} to {high}")


def _span(value: Located, version: int, unit: float = 1.0, nanoseconds: bool = False) -> Iterator[ValueProblem]:
    if parse_timespan(value, unit=unit, nanoseconds=nanoseconds) is None:
        yield ValueProblem("invalid", value, SPAN)


def _expanded(check: Grammar, value: Located, version: int) -> Iterator[ValueProblem]:
    """A grammar behind specifiers: judged only when there are none."""
    bad = list(check_specifiers(value, version))
    yield from bad
    if not bad and literal(value) == value:
        yield from check(value, version)


def calendar(value: Located, version: int) -> Iterator[ValueProblem]:
    if not is_calendar(value):
        yield ValueProblem("invalid", value, "a calendar event such as daily or Mon..Fri 08:00")


def size(value: Located, version: int) -> Iterator[ValueProblem]:
    if parse_size(value) is None:
        meant = _meant_size(value)
        yield ValueProblem("invalid", value, SIZE, suggestion=meant, safe=True)


def _memory(floor: bool, value: Located, version: int) -> Iterator[ValueProblem]:
    if value == "infinity":
        return
    share = parse_share(value)
    bytes_ = parse_size(value) if share is None else share
    if bytes_ is None:
        yield ValueProblem("invalid", value, f"{SIZE}, a percentage or infinity", LINE, _meant_size(value), True)
    elif (share is not None and share > 100) or bytes_ >= 2**64 - 1 or (bytes_ == 0 and not floor):
        yield ValueProblem("out-of-range", value, f"{SIZE}, a percentage or infinity")


def cpu_quota(value: Located, version: int) -> Iterator[ValueProblem]:
    share = parse_share(value)
    if share is None or share <= 0:
        bare = value.strip()
        meant = (
            f"{bare}%" if share is None and re.fullmatch(r"[0-9]+(\.[0-9]{1,2})?", bare) and float(bare) > 0 else None
        )
        yield ValueProblem("invalid", value, "a percentage of one CPU such as 50% or 200%", LINE, meant)


def percent(value: Located, version: int) -> Iterator[ValueProblem]:
    share = parse_share(value)
    if share is None or share > 100:
        yield ValueProblem("invalid", value, "a percentage up to 100%")


def tasks_max(value: Located, version: int) -> Iterator[ValueProblem]:
    if value == "infinity":
        return
    share = parse_share(value)
    number = parse_integer(value)
    if (share is None or share > 100) and (number is None or not 0 < number < 2**64 - 1):
        yield ValueProblem("invalid", value, "a number of tasks, a percentage up to 100% or infinity")


def cpu_weight(value: Located, version: int) -> Iterator[ValueProblem]:
    if value == "idle":
        if version < 252:
            yield ValueProblem("too-new", value, "a weight from 1 to 10000", since=252)
        return
    yield from _integer(1, 10000, value, version)


def _limit(one: Callable[[str], float | None], expected: str, value: Located, version: int) -> Iterator[ValueProblem]:
    """``LIMIT`` or ``SOFT:HARD``, each with infinity."""
    parts = split_words(value, separators=":", quotes=False, coalesce=False).words
    if len(parts) == 3 and not parts[2]:
        parts = parts[:2]
    found = [math.inf if part == "infinity" and one is not _nice_limit else one(part) for part in parts]
    if len(found) not in (1, 2) or None in found:
        meant = ":".join(_meant_size(part) or part for part in parts) if one is parse_size else None
        yield ValueProblem("invalid", value, expected, LINE, meant if meant != value else None, True)
    elif found[0] > found[-1]:  # type: ignore[operator]
        yield ValueProblem("invalid", value, "a soft limit that is not above the hard one")


def _count(text: str) -> float | None:
    number = parse_integer(text)
    return None if number is None or number < 0 else number


def _nice_limit(text: str) -> float | None:
    """A nice level with its sign, -20 to +19, or the raw limit from 0 to 40."""
    if text[:1] in "+-" and text[:1]:
        number = parse_integer(text[1:])
        if number is None or not 0 <= number <= (19 if text[0] == "+" else 20):
            return None
        return 20 - number if text[0] == "+" else 20 + number
    number = parse_integer(text)
    return number if number is not None and 0 <= number <= 40 else None


def mode(value: Located, version: int) -> Iterator[ValueProblem]:
    if parse_mode(value) is None:
        yield ValueProblem("invalid", value, "an octal mode such as 0644")


def _choice_or_number(kind: str, high: int, value: Located, version: int) -> Iterator[ValueProblem]:
    number = parse_integer(value)
    if number is None or not 0 <= number <= high:
        yield from check_choice(kind, value, version)


def _stream(kind: str, value: Located, version: int) -> Iterator[ValueProblem]:
    """Standard input and output: a word, ``fd:NAME``, or a file."""
    head, colon, rest = value.partition(":")
    start = len(head) + 1
    if colon and head == "fd":
        if rest:
            yield from names.check_fd_name(value.part(start, len(value)), version)
    elif colon and head in (("file",) if kind == "input" else ("file", "append", "truncate")):
        yield from paths.check_path(value.part(start, len(value)), version)
    else:
        yield from check_choice(kind, value, version)


def _device_and(check: Grammar, value: Located, version: int) -> Iterator[ValueProblem]:
    """A path and what applies to it."""
    found = extract(value, escapes="drop")
    if found.word is None or found.broken or found.next < 0:
        yield ValueProblem("invalid", value, "a device or path, then the value")
        return
    bad = list(paths.check_path(found.word, version, absolute=None))
    yield from bad or check(value.part(found.next, len(value)), version)


def _io_limit(value: Located, version: int) -> Iterator[ValueProblem]:
    if value != "infinity" and not parse_size(value, 1000):
        yield ValueProblem("invalid", value, SIZE, suggestion=_meant_size(value), safe=True)


def documentation(value: Located, version: int) -> Iterator[ValueProblem]:
    bad = list(check_specifiers(value, version))
    yield from bad
    if bad:
        return
    found = split_words(value, escapes=KEEP)
    yield from found.problems
    for word in found.words:
        if _URL.fullmatch(word) is None and "%" not in word[:1]:
            yield ValueProblem("invalid", word, "a URI that starts with http://, https://, file:, man: or info:", WORD)


def condition_string(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from check_specifiers(value, version)


def label(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from check_specifiers(value, version, LINE if value.startswith("-") else UNIT)


def credential(value: Located, version: int) -> Iterator[ValueProblem]:
    name = value.partition(":")[0]
    bad = list(check_specifiers(value.part(0, len(name)), version))
    yield from bad
    if not bad and (not name or "/" in name or name in (".", "..")):
        yield ValueProblem("invalid", value, "NAME:SOURCE")


GRAMMARS: dict[str, Grammar] = {
    "any": anything,
    "ignored": anything,
    "secure-bits": anything,
    "base64": anything,
    "credential-value": anything,
    "file-systems": anything,
    "instance": anything,
    "string": text,
    "condition-string": condition_string,
    "label": label,
    "bool": boolean,
    "tristate": boolean,
    "timespan": _span,
    "timespan-ns": partial(_span, unit=1e-9, nanoseconds=True),
    "timespan-expanded": partial(_expanded, _span),
    "calendar": partial(_expanded, calendar),
    "size": size,
    "memory-limit": partial(_memory, False),
    "memory-floor": partial(_memory, True),
    "cpu-quota": cpu_quota,
    "percent": percent,
    "tasks-max": tasks_max,
    "weight": partial(_integer, 1, 10000),
    "cpu-weight": cpu_weight,
    "cpu-shares": partial(_integer, 2, 262144),
    "blockio-weight": partial(_integer, 10, 1000),
    "unsigned": partial(_integer, 0, 2**32 - 1),
    "int": partial(_integer, -(2**31), _INT_MAX),
    "long": partial(_integer, -(2**63), 2**63 - 1),
    "nice": partial(_integer, -20, 19),
    "oom-score": partial(_integer, -1000, 1000),
    "rt-priority": partial(_integer, 0, 99),
    "io-priority": partial(_integer, 0, 7),
    "swap-priority": partial(_integer, -1, 32767),
    "exit-status": partial(_integer, 0, 255),
    "limit-size": partial(_limit, parse_size, f"{SIZE}, SOFT:HARD or infinity"),
    "limit-number": partial(_limit, _count, "a number, SOFT:HARD or infinity"),
    "limit-time": partial(_limit, parse_timespan, f"{SPAN}, SOFT:HARD or infinity"),
    "limit-rttime": partial(
        _limit, partial(parse_timespan, unit=1e-6), "microseconds or a time span, SOFT:HARD or infinity"
    ),
    "limit-nice": partial(_limit, _nice_limit, "a nice level such as +5 or -10, or 1 to 40"),
    "mode": mode,
    "log-level": partial(_choice_or_number, "log-level", 7),
    "scheduling-policy": partial(_choice_or_number, "scheduling-policy", _INT_MAX),
    "io-class": partial(_choice_or_number, "io-class", 8),
    "ip-tos": partial(_choice_or_number, "ip-tos", 255),
    "input": partial(_stream, "input"),
    "output": partial(_stream, "output"),
    "io-limit": partial(_device_and, _io_limit),
    "io-weight": partial(_device_and, partial(_integer, 1, 10000)),
    "blockio-device-weight": partial(_device_and, partial(_integer, 10, 1000)),
    "io-latency": partial(_device_and, _span),
    "documentation": documentation,
    "credential-source": credential,
    "command": check_command_line,
    "environment": check_environment,
    "environment-names": check_environment_names,
    "environment-unset": check_environment_unset,
    "environment-file": paths.check_environment_file,
    "log-fields": check_log_fields,
    "path": paths.check_path,
    "path-fatal": paths.check_path_fatal,
    "paths": paths.check_paths,
    "mounts-for": paths.check_mounts_for,
    "symlinks": paths.check_mounts_for,
    "colon-paths": paths.check_colon_paths,
    "condition-path": paths.check_condition_path,
    "working-directory": paths.check_working_directory,
    "pid-file": paths.check_pid_file,
    "directories": paths.check_directories,
    "plain-directories": paths.check_plain_directories,
    "bind-paths": paths.check_bind_paths,
    "temporary-file-systems": paths.check_temporary_file_systems,
    "open-file": paths.check_open_file,
    "device-allow": paths.check_device_allow,
    "signal": names.check_signal,
    "exit-statuses": names.check_exit_statuses,
    "user": names.check_user_name,
    "users": names.check_users,
    "interface": names.check_interface,
    "interfaces": names.check_interfaces,
    "units": names.check_units,
    "install-units": names.check_units,
    "aliases": names.check_units,
    "socket-units": names.check_socket_units,
    "service-unit": names.check_service_unit,
    "trigger-unit": names.check_trigger_unit,
    "slice": names.check_slice,
    "bus-name": names.check_bus_name,
    "fd-name": names.check_fd_name,
    "log-namespace": names.check_log_namespace,
    "listen": addresses.check_listen,
    "listen-local": addresses.check_listen_local,
    "listen-netlink": addresses.check_listen_netlink,
    "address-prefixes": addresses.check_address_prefixes,
    "socket-bind": addresses.check_socket_bind,
    "cpuset": lists.check_cpuset,
    "cpu-affinity": lists.check_cpu_affinity,
    "numa-mask": lists.check_numa_mask,
    "capabilities": lists.check_capabilities,
    "namespaces": lists.check_namespaces,
    "address-families": lists.check_address_families,
    "architectures": lists.check_architectures,
    "controllers": lists.check_controllers,
    "delegate": lists.check_delegate,
    "coredump-filter": lists.check_coredump_filter,
    "errno": lists.check_errno,
    "system-calls": lists.check_system_calls,
    "system-call-names": lists.check_system_call_names,
}


def grammar(kind: str) -> Grammar:
    """The grammar of a value type of the directive table; ``enum:NAME`` is a word of that enumeration."""
    if kind.startswith("enum:"):
        return partial(check_choice, kind[5:])
    return GRAMMARS[kind]


def expected(kind: str, version: int) -> str:
    """The words of an enumeration, for messages."""
    return choices(kind[5:], version) if kind[5:] in enumerations() else ""


def check(kind: str, value: Located, version: int) -> Iterator[ValueProblem]:
    """What systemd of this release finds wrong with a value of this type; an empty one resets and is right."""
    if value.strip():
        yield from grammar(kind)(value, version)
