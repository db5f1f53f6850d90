"""Sets: CPUs, capabilities, namespaces, address families, controllers, system calls."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.dataclass import replace
from bringup_lint.parsers.systemd_values.enumerations import closest
from bringup_lint.parsers.systemd_values.enumerations import enumerations
from bringup_lint.parsers.systemd_values.names import check_words_of
from bringup_lint.parsers.systemd_values.numbers import parse_bool
from bringup_lint.parsers.systemd_values.numbers import parse_integer
from bringup_lint.parsers.systemd_values.problems import WORD
from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.parsers.systemd_values.specifiers import check_specifiers
from bringup_lint.parsers.systemd_values.specifiers import literal
from bringup_lint.parsers.systemd_values.word_splitting import BLANKS
from bringup_lint.parsers.systemd_values.word_splitting import split_words
from bringup_lint.pattern import regex
from bringup_lint.source import Located

CPUS = "CPU numbers and ranges such as 0 2-3"
_SYSTEM_CALL = regex(r"[a-z_][a-z0-9_]*|@[a-z-]+")
_HIGHEST_ERRNO = 4095
_HIGHEST_CPU = 8191


def _without_tilde(value: Located) -> Located:
    return value.part(1, len(value)) if value.startswith("~") else value


def _range(word: str) -> range | None:
    low, dash, high = word.partition("-")
    first = parse_integer(low)
    last = parse_integer(high) if dash else first
    if first is None or last is None or first < 0 or not 0 <= last <= _HIGHEST_CPU:
        return None
    return range(first, last + 1)


def parse_cpus(text: str) -> frozenset[int] | None:
    """The CPU numbers of a list; None when systemd would reject it."""
    found: set[int] = set()
    for word in re.split(r"[,\s]+", text.strip(BLANKS + ",")):
        cpus = _range(word)
        if cpus is None:
            return None
        found.update(cpus)
    return frozenset(found)


def check_cpuset(value: Located, version: int) -> Iterator[ValueProblem]:
    bad = list(check_specifiers(value, version))
    yield from bad
    if bad or literal(value) is None:
        return
    found = split_words(value, separators=BLANKS + ",")
    yield from found.problems
    for word in found.words:
        cpus = _range(word)
        if cpus is None:
            yield ValueProblem("invalid", word, CPUS)
            return
        if not cpus:
            yield ValueProblem("invalid", word, "a range from the lower to the higher CPU", WORD)


def check_cpu_affinity(value: Located, version: int) -> Iterator[ValueProblem]:
    if value != "numa":
        yield from check_cpuset(value, version)


def check_numa_mask(value: Located, version: int) -> Iterator[ValueProblem]:
    if value != "all":
        yield from check_cpuset(value, version)


def check_capabilities(value: Located, version: int) -> Iterator[ValueProblem]:
    known = enumerations()["capability"]
    for word in split_words(_without_tilde(value)).words:
        number = parse_integer(word)
        if word.lower() not in known and not (number is not None and 0 <= number < 64):
            meant = closest(word.lower(), known) or closest("cap_" + word.lower(), known)
            yield ValueProblem(
                "invalid", word, "a capability such as CAP_NET_ADMIN", WORD, meant.upper() if meant else None
            )


def check_namespaces(value: Located, version: int) -> Iterator[ValueProblem]:
    """A boolean, or a list of namespace types, with ``~`` in front to turn it round."""
    if parse_bool(value) is None:
        for problem in check_words_of("namespace", _without_tilde(value), version):
            yield replace(problem, effect="line")


def check_address_families(value: Located, version: int) -> Iterator[ValueProblem]:
    if value != "none":
        yield from check_words_of("address-family", _without_tilde(value), version, fold=True)


def check_architectures(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from check_words_of("architecture", value, version)


def check_controllers(value: Located, version: int) -> Iterator[ValueProblem]:
    known = enumerations()["controller"]
    if not any(word in known for word in split_words(value).words):
        yield ValueProblem("invalid", value, "control group controllers such as cpu memory")


def check_delegate(value: Located, version: int) -> Iterator[ValueProblem]:
    """A boolean, or a list of controllers."""
    if parse_bool(value) is None:
        yield from check_words_of("controller", value, version)


def check_coredump_filter(value: Located, version: int) -> Iterator[ValueProblem]:
    for word in split_words(value, quotes=False).words:
        if word not in enumerations()["coredump-filter"] and re.fullmatch(r"(0[xX])?[0-9a-fA-F]+", word) is None:
            yield ValueProblem("invalid", word, "names such as private-anonymous, or a hexadecimal mask")
            return


def is_errno(text: str) -> bool:
    number = parse_integer(text)
    return 0 <= number <= _HIGHEST_ERRNO if number is not None else text.upper() in enumerations()["errno"]


def check_errno(value: Located, version: int) -> Iterator[ValueProblem]:
    if value != "kill" and (not is_errno(value) or parse_integer(value) == 0):
        yield ValueProblem("invalid", value, "kill, or an error such as EPERM")


def check_system_call_names(value: Located, version: int) -> Iterator[ValueProblem]:
    """Like a filter, but no word takes an error."""
    for word in split_words(_without_tilde(value), quotes=False).words:
        if ":" in word:
            yield ValueProblem("invalid", word, "a system call or a group, without an error", WORD)
    if ":" not in value:
        yield from check_system_calls(value, version)


def check_system_calls(value: Located, version: int) -> Iterator[ValueProblem]:
    """Groups, and the shape of the rest: the names of calls depend on the kernel and the architecture."""
    denied = value.startswith("~")
    groups = enumerations()["system-call-group"]
    for word in split_words(_without_tilde(value), quotes=False).words:
        name, colon, error = word.partition(":")
        if _SYSTEM_CALL.fullmatch(name) is None or (name.startswith("@") and name not in groups):
            meant = closest(name, groups)
            yield ValueProblem("invalid", word, "a system call or a group such as @system-service", WORD, meant)
        elif colon and (not denied or not (error == "kill" or is_errno(error))):
            yield ValueProblem("invalid", word, "a system call, with :ERROR only in a list that starts with ~", WORD)
