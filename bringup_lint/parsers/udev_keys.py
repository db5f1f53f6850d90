"""What udev accepts: operators, attributes and values of each key."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from bringup_lint import facts
from bringup_lint.model.udev import Token
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.udev_substitutions import substitution_problems
from bringup_lint.pattern import regex
from bringup_lint.source import Problem
from bringup_lint.spelling import nearest

_MODE = regex(r"[0-7]+\Z")
_INTEGER = regex(r"[ \t]*[-+]?(?:0[xX][0-9a-fA-F]+|0[bB][01]+|0[oO]?[0-7]*|[1-9][0-9]*)\Z")

DROPPING = frozenset(
    {
        "unknown-key",
        "removed-key",
        "byte-order-mark",
        "match-only-key",
        "invalid-operator",
        "invalid-attribute",
        "missing-attribute",
        "unexpected-attribute",
        "bad-test-mode",
        "assignment-of-any-case",
        "any-case-not-allowed",
        "read-only-property",
        "name-without-effect",
        "unknown-builtin",
        "bad-option-value",
    }
)
"""The problems for which udev ignores the whole line, with all that is on it."""


class Key(NamedTuple):
    """One row of the table of keys."""

    operators: tuple[str, ...]
    coerced: tuple[str, ...]
    attribute: str
    attributes: tuple[str, ...]
    substitutions: tuple[str, ...]
    replacement: str

    @property
    def match_only(self) -> bool:
        return self.operators == ("==", "!=")


@cache
def keys() -> dict[str, Key]:
    return {
        row["key"]: Key(
            tuple(row["operators"].split()),
            tuple(row["coerced"].split()),
            row["attribute"],
            tuple(row["attributes"].split()),
            tuple(row["substitutions"].split()),
            row["replacement"],
        )
        for row in facts.table("udev/keys")
    }


@cache
def words(kind: str) -> dict[str, str]:
    """The names of a closed list, each with its note."""
    return {row["name"]: row["note"] for row in facts.table("udev/words") if row["kind"] == kind}


def token_problems(token: Token) -> Iterator[Problem]:
    """What udev has against one token, in its own order, up to the first error that drops the line."""
    key = keys().get(token.key)
    if key is None or not key.operators:
        yield _unknown_key(token, key)
        return
    for stage in _STAGES:
        for problem in stage(token, key):
            yield problem
            if problem.code in DROPPING:
                return


def _unknown_key(token: Token, key: Key | None) -> Problem:
    if key is not None:
        return Problem("removed-key", token.key, key.replacement)
    if token.key.startswith("\ufeff"):
        return Problem("byte-order-mark", token.key.part(0, 1))
    return Problem("unknown-key", token.key, _nearest(token.key))


def _nearest(name: str) -> str:
    """The key that was meant, when one is closer than all others."""
    near = nearest(name.upper(), (key for key, row in keys().items() if row.operators))
    return near[0] if len(near) == 1 else ""


def _prefix_of_assignment(token: Token, key: Key) -> Iterator[Problem]:
    if "i" in token.prefix and not token.is_match:
        yield Problem("assignment-of-any-case", token.span, token.key)


def _attribute(token: Token, key: Key) -> Iterator[Problem]:
    given = token.attribute
    if key.attribute == "none" and given is not None:
        yield Problem("unexpected-attribute", given if given else token.key)
    elif key.attribute == "required" and not given:
        yield Problem("missing-attribute", token.key)
    elif given and token.key == "TEST" and not (_MODE.match(given) and int(given, 8) <= 0o7777):
        yield Problem("bad-test-mode", given)
    elif given and token.key in ("ATTR", "ATTRS", "SYSCTL"):
        yield from substitution_problems(given)


def _value(token: Token, key: Key) -> Iterator[Problem]:
    if "always" in key.substitutions:
        yield from _value_problems(token, key)


def _operator(token: Token, key: Key) -> Iterator[Problem]:
    if token.operator in key.operators:
        return
    if token.operator in key.coerced:
        yield Problem("coerced-operator", token.operator, token.key)
    else:
        yield Problem("match-only-key" if key.match_only else "invalid-operator", token.operator, token.key)


def _assigned_value(token: Token, key: Key) -> Iterator[Problem]:
    if "assigned" in key.substitutions and not token.is_match:
        yield from _value_problems(token, key)


def _value_problems(token: Token, key: Key) -> Iterator[Problem]:
    if "nonempty" in key.substitutions and not token.value:
        yield Problem("empty-value", token.span, token.key)
    yield from substitution_problems(token.value)


def _known_attribute(token: Token, key: Key) -> Iterator[Problem]:
    given = token.attribute
    if key.attributes and given is not None and given not in key.attributes:
        yield Problem("invalid-attribute", given if given else token.key, " ".join(key.attributes))


def _prefix(token: Token, key: Key) -> Iterator[Problem]:
    if "i" in token.prefix and token.key in ("TEST", "PROGRAM", "IMPORT"):
        yield Problem("any-case-not-allowed", token.span, token.key)


def _own(token: Token, key: Key) -> Iterator[Problem]:
    check = _BY_KEY.get(token.key)
    if check is not None:
        yield from check(token)


def _env(token: Token) -> Iterator[Problem]:
    if not token.is_match and token.attribute in words("read-only-property"):
        yield Problem("read-only-property", token.attribute)


def _name(token: Token) -> Iterator[Problem]:
    if not token.is_match and token.value in ("%k", ""):
        yield Problem("name-without-effect", token.span, token.value)


def _builtin(token: Token) -> Iterator[Problem]:
    if token.attribute == "builtin" and not _is_builtin(token):
        yield Problem("unknown-builtin", token.value)


def _is_builtin(token: Token) -> bool:
    """udev compares no more than the letters that are given, so that ``kmo`` means ``kmod``."""
    word = token.value.partition(" ")[0]
    return any(name.startswith(word) for name in words("builtin"))


def _options(token: Token) -> Iterator[Problem]:
    name, equals, value = token.value.partition("=")
    if token.value in words("option"):
        return
    if name + equals not in words("option-with-value"):
        yield Problem("unknown-option", token.value)
    elif name == "link_priority":
        if not _INTEGER.match(value):
            yield Problem("bad-option-value", token.value)
    elif name == "log_level" and value not in words("log-level"):
        yield Problem("bad-option-value", token.value)


_BY_KEY = {"ENV": _env, "NAME": _name, "IMPORT": _builtin, "RUN": _builtin, "OPTIONS": _options}
_STAGES = (
    _prefix_of_assignment,
    _attribute,
    _value,
    _operator,
    _assigned_value,
    _known_attribute,
    _prefix,
    _own,
)
