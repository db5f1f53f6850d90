"""Environment assignments and variable names."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.dataclass import replace
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values.problems import LINE
from bringup_lint.parsers.systemd_values.problems import WORD
from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.parsers.systemd_values.specifiers import check_specifiers
from bringup_lint.parsers.systemd_values.specifiers import literal
from bringup_lint.parsers.systemd_values.word_splitting import DECODE
from bringup_lint.parsers.systemd_values.word_splitting import DROP
from bringup_lint.parsers.systemd_values.word_splitting import split_words
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_NAME = regex(r"[A-Za-z_][A-Za-z0-9_]*")
_FIELD = regex(r"[A-Z][A-Z0-9_]{0,63}")
ASSIGNMENT = "NAME=VALUE"


class Variable(NamedTuple):
    name: Located
    value: Located


def is_variable_name(text: str) -> bool:
    return _NAME.fullmatch(text) is not None


def split_environment(value: Located) -> tuple[Variable, ...]:
    """The valid assignments of an ``Environment=`` value, quotes removed, specifiers as they are written."""
    found = []
    for word in split_words(value, escapes=DECODE).words:
        equals = word.find("=")
        if equals > 0 and is_variable_name(word[:equals]):
            found.append(Variable(word.part(0, equals), word.part(equals + 1, len(word))))
    return tuple(found)


def _checked_words(value: Located, version: int, escapes: str = DECODE) -> Iterator[ValueProblem | Located]:
    found = split_words(value, escapes=escapes)
    yield from (replace(problem, effect=LINE) for problem in found.problems)
    for word in found.words:
        bad = list(check_specifiers(word, version, WORD))
        if bad:
            yield from bad
        else:
            yield word


def check_environment(value: Located, version: int) -> Iterator[ValueProblem]:
    for item in _checked_words(value, version):
        if isinstance(item, ValueProblem):
            yield item
            continue
        name = literal(item.partition("=")[0])
        if name is not None and not ("=" in item and is_variable_name(name)):
            yield ValueProblem("invalid", item, ASSIGNMENT, WORD)


def check_environment_names(value: Located, version: int) -> Iterator[ValueProblem]:
    for item in _checked_words(value, version, DROP):
        if isinstance(item, ValueProblem):
            yield item
        elif (name := literal(item)) is not None and not is_variable_name(name):
            yield ValueProblem("invalid", item, "the name of a variable", WORD)


def check_environment_unset(value: Located, version: int) -> Iterator[ValueProblem]:
    for item in _checked_words(value, version):
        if isinstance(item, ValueProblem):
            yield item
        elif (name := literal(item.partition("=")[0])) is not None and not is_variable_name(name):
            yield ValueProblem("invalid", item, "the name of a variable, or NAME=VALUE", WORD)


def check_log_fields(value: Located, version: int) -> Iterator[ValueProblem]:
    for item in _checked_words(value, version):
        if isinstance(item, ValueProblem):
            yield item
        elif "=" not in item or not ("%" in item or _FIELD.fullmatch(item.partition("=")[0])):
            yield ValueProblem("invalid", item, "FIELD=VALUE in capital letters", WORD)
