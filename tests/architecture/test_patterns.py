"""Every pattern takes time that grows with the text as the text does: none of them can be kept busy by a file.

All patterns of the package and of the rules are collected, and each is pumped: with the strings that its own parts
match, repeated, and with an end that does not match. The text grows fourfold, and the time may grow about as much.
"""

from __future__ import annotations

import ast
import functools
import importlib
import pkgutil
import re
import signal
import time
import warnings
from collections.abc import Iterator
from pathlib import Path
from types import FrameType
from typing import Any
from typing import NamedTuple

import pytest

import bringup_lint
from bringup_lint.pattern import Uncompiled
from bringup_lint.registry import Registry
from bringup_lint.registry import load
from tests.architecture.imports import nodes

with warnings.catch_warnings():
    warnings.simplefilter("ignore", DeprecationWarning)
    import sre_constants as codes
    import sre_parse as parser

SIZES = (2_000, 8_000)
"""Characters; the time of a linear pattern grows fourfold, that of a quadratic one sixteenfold."""
GROWTH = 9.0
NOTICED = 0.004
"""Seconds that the longer text must take, before growth means something."""
SEPARATE = ("", " ", "\n", "\r\n", "=", "\x00")
"""What comes between two repetitions."""
METHODS = {
    "match": lambda pattern, text: pattern.match(text),
    "fullmatch": lambda pattern, text: pattern.fullmatch(text),
    "search": lambda pattern, text: pattern.search(text),
    "finditer": lambda pattern, text: list(pattern.finditer(text)),
    "findall": lambda pattern, text: pattern.findall(text),
    "sub": lambda pattern, text: pattern.sub("", text),
    "split": lambda pattern, text: pattern.split(text),
}
SHORT = {
    r"(?:\w+_)?cmd_?vel": "names of topics",
    r"(?:\w+[._])?(?:monitor": "names of parameters",
    r"nav2_\w+|": "names of packages",
    r"[<\[({].*[>\])}]": "values of less than 200 characters",
    r"([^/]+)\.(wants": "paths",
    r"(?:^|/)": "paths",
    r"(?:^|[/._-])compose": "paths",
    r"(?:^|(?=[/_.-]))": "paths",
    r"(?:[._-]launch": "paths",
    r"[._-]launch": "paths",
}
"""How patterns begin that meet short texts only, and which these are."""
DOCUMENTATION = ("bringup_lint.report.",)
"""Modules that read documentation of the project's own rules."""
LIMIT = 120
"""Seconds for all texts of one pattern, which take less than a few where nothing else runs."""
REPEATS = {"MAX_REPEAT", "MIN_REPEAT", "POSSESSIVE_REPEAT"}
OPTIONAL = tuple(getattr(codes, name) for name in sorted(REPEATS) if hasattr(codes, name))


def modules() -> Iterator[Any]:
    for info in pkgutil.walk_packages(bringup_lint.__path__, "bringup_lint."):
        if not info.name.endswith("__main__") and not info.name.startswith(DOCUMENTATION):
            yield importlib.import_module(info.name)


def of_rules() -> Iterator[dict[str, Any]]:
    """What the module of each rule holds."""
    for rule_id, path in Registry.of().paths.items():
        yield load(path, rule_id).meta.check.__globals__


class Use(NamedTuple):
    """A pattern, and the method by which it is asked."""

    pattern: re.Pattern[str]
    method: str


@functools.cache
def uses() -> dict[str, Use]:
    """The patterns of all modules and rules, each with the methods that its name is asked for anywhere."""
    found = {}
    for space in (*map(vars, modules()), *of_rules()):
        asked = methods(space["__file__"])
        for name, value in list(space.items()):
            pattern = compiled(value)
            if pattern is not None:
                for method in asked.get(name, ()):
                    found[f"{pattern.pattern!r} {pattern.flags} {method}"] = Use(pattern, method)
    return found


def compiled(value: object) -> re.Pattern[str] | None:
    """The pattern of text that a module holds, compiled or not yet."""
    if not isinstance(value, (re.Pattern, Uncompiled)) or not isinstance(value.pattern, str):
        return None
    return re.compile(value.pattern, value.flags)


@functools.cache
def methods(path: str) -> dict[str, set[str]]:
    """Name -> the methods of patterns that a file calls on it."""
    found: dict[str, set[str]] = {}
    for node in nodes(Path(path)):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.attr in METHODS:
            found.setdefault(node.value.id, set()).add(node.attr)
    return found


def words(parts: Any, most: int = 4) -> list[str]:
    """A few of the texts that a parsed pattern matches."""
    texts = [""]
    for code, argument in parts:
        choices = _choices(code, argument)
        texts = [text + choice for text in texts for choice in choices][:most]
    return texts


def _choices(code: Any, argument: Any) -> list[str]:
    if code is codes.LITERAL:
        return [chr(argument)]
    if code is codes.NOT_LITERAL:
        return ["x" if argument != ord("x") else "y"]
    if code is codes.ANY:
        return ["x"]
    if code is codes.IN:
        return [_member(argument)]
    if code is codes.BRANCH:
        return [text for branch in argument[1] for text in words(branch, 1)]
    if code is codes.SUBPATTERN:
        return words(argument[3])
    if code in OPTIONAL:
        low, _, inner = argument
        return [text * max(low, 1) for text in words(inner, 2)] + ([""] if low == 0 else [])
    return [""]


def _member(choices: Any) -> str:
    """A character that a class of characters has."""
    for code, argument in choices:
        if code is codes.LITERAL:
            return chr(argument)
        if code is codes.RANGE:
            return chr(argument[0])
        if code is codes.CATEGORY and "NOT" not in str(argument):
            return {"CATEGORY_SPACE": " ", "CATEGORY_DIGIT": "1", "CATEGORY_WORD": "a"}[str(argument)]
    return "x"


def repeats(parts: Any, before: str = "") -> Iterator[tuple[str, str]]:
    """For each repetition in a pattern: what comes before it, and a text that it takes."""
    for code, argument in parts:
        if code in OPTIONAL:
            for text in words(argument[2]):
                yield before, text
            yield from repeats(argument[2], before)
        elif code is codes.SUBPATTERN:
            yield from repeats(argument[3], before)
        elif code is codes.BRANCH:
            for branch in argument[1]:
                yield from repeats(branch, before)
        elif code in (codes.ASSERT, codes.ASSERT_NOT):
            yield from repeats(argument[1], before)
        before += next(iter(_choices(code, argument)), "")


def pumps(pattern: re.Pattern[str]) -> set[tuple[str, str]]:
    """What a text begins with, and what it repeats."""
    parsed = parser.parse(pattern.pattern, pattern.flags & ~re.DEBUG)
    whole = words(parsed)
    prefixes = {(before, text) for before, text in repeats(parsed) if text}
    pumped = {("", before + text) for before, text in prefixes} | {("", text) for text in whole if text}
    blanks = {(before, blank) for before, _ in prefixes for blank in (" ", "\n")}
    return prefixes | pumped | blanks


def seconds(use: Use, text: str) -> float:
    start = time.process_time()
    METHODS[use.method](use.pattern, text)
    return time.process_time() - start


def growth(use: Use, prefix: str, pump: str, between: str) -> float:
    """How much longer the longer text takes; 0 when nobody would notice."""
    short, long = (prefix + (pump + between) * (size // len(pump + between)) + "\x01" for size in SIZES)
    taken = seconds(use, long)
    if taken < NOTICED:
        return 0.0
    best = min(taken, seconds(use, long))
    return best / max(min(seconds(use, short) for _ in range(3)), NOTICED / 100)


def superlinear(use: Use) -> Iterator[str]:
    """The texts on which a pattern takes more than linear time, measured twice; at most one."""
    for prefix, pump in sorted(pumps(use.pattern)):
        for between in SEPARATE:
            if growth(use, prefix, pump, between) > GROWTH and growth(use, prefix, pump, between) > GROWTH:
                yield f"{prefix!r} + {pump + between!r} * n"
                return


def is_long(use: Use) -> bool:
    """Whether a pattern may meet a long text."""
    return not use.pattern.pattern.startswith(tuple(SHORT))


def test_exemptions_are_patterns_that_are_there() -> None:
    known = [use.pattern.pattern for use in uses().values()]
    assert [short for short in SHORT if not any(pattern.startswith(short) for pattern in known)] == []


@pytest.mark.slow
def test_no_pattern_takes_more_than_linear_time() -> None:
    signal.signal(signal.SIGALRM, _too_long)
    slow = {}
    for name, use in uses().items():
        signal.alarm(LIMIT)
        try:
            found = next(superlinear(use), None) if is_long(use) else None
        except TimeoutError:
            found = "takes forever"
        finally:
            signal.alarm(0)
        if found is not None:
            slow[name] = found
    assert slow == {}


def test_a_quadratic_pattern_is_noticed() -> None:
    assert list(superlinear(Use(re.compile(r"\{\{.*?\}\}"), "search")))
    assert not list(superlinear(Use(re.compile(r"\{\{[^{}]*\}\}"), "search")))


def _too_long(number: int, frame: FrameType | None) -> None:
    raise TimeoutError
