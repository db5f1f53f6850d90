"""Secrets that a file gives away by their forms, whether or not a rule has marked them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.endings import CPP
from bringup_lint.finding.secret_forms import FORMS
from bringup_lint.finding.secret_forms import NAME
from bringup_lint.finding.secret_forms import NAMES
from bringup_lint.finding.secret_forms import WORDS
from bringup_lint.finding.secret_forms import Form
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

MERE_NAME = regex(r"pass(?:word|wd|phrase|wort)|secret|token", re.IGNORECASE)
"""A value that only repeats its name tells nothing, and masking it everywhere would mask prose."""
_NO_SECRET = regex(
    r"\$[({a-z_]|\$\$?\{|\{\{|\{\w+\}$|@\w+@|%[a-z%]$|/(?:etc|run|var|home|opt|usr|srv|tmp|root|mnt|dev|proc)\b|[.~]{1,2}/"
    r"|[|>][-+\d]{0,2}$|file:|env:|pkcs11:|vault:|secret://|op://|!\w+$|<\w|\(|\["
    r"|\S+\.(?:pem|key|crt|p12|txt|env|ya?ml|json)$"
    r"|(?:true|false|yes|no|on|off|null|none|str|string|required|optional|prompt|ask|never|\d|\*+)$",
    re.IGNORECASE,
)
_SET = regex(r"(?:pass(?:word|wd|phrase|wort|code)?|pwd|psk|secret|token|credential|key\d?)[\"'\]]*[ \t]*[:=>]")
"""A name that means a secret, in small letters, before what each form without words has after it."""
_NAMED = regex(rf"(?={NAME})", re.IGNORECASE | re.VERBOSE)
_CODE = (".py", *CPP)
_MAPPED = regex(r"[:=][ \t]*[\"']?([^\s\"',]+)")
_BODY = r"[ \t]*(?:\#[^\n]*)?\n(?P<body>(?:(?P=indent)[ \t]+[^\n]*(?:\n|$))+)"
_PASSWORDS = regex(
    rf"^(?P<indent>[ \t]*)[\"']?[\w-]*(?:passwords|passphrases|tokens)[\"']?[ \t]*:{_BODY}",
    re.MULTILINE | re.IGNORECASE,
)
_SCALAR_KEY = rf"""["']?[\w.-]{{0,80}}?{NAME}["']?[ \t]*:[ \t]+[|>][-+\d]{{0,2}}"""
_BLOCK_SCALARS = tuple(
    regex(rf"^(?P<indent>[ \t]*){key}", re.MULTILINE | re.IGNORECASE | re.VERBOSE)
    for key in (
        _SCALAR_KEY + _BODY,
        rf"-[ \t]+{_SCALAR_KEY}" + _BODY.replace("[ \\t]+", "[ \\t]{3,}"),
    )
)
"""Blocks of lines below a key, and below the first key of an item, whose other keys have two columns more."""
_WHOLE_LINE = regex(r"^[ \t]*(\S[^\n]*)", re.MULTILINE)
_CHPASSWD = regex(rf"^(?P<indent>[ \t]*)list:[ \t]*[|>][-+]?{_BODY}", re.MULTILINE)
_LINE = regex(r"^[ \t]*(?:-[ \t]+)?[\w.-]+:(\S+)", re.MULTILINE)
_ENTRY = regex(r"^[ \t]*[\"']?[\w.@-]+[\"']?[ \t]*:[ \t]+[\"']?([^\s\"'#][^\n\"'#]*)", re.MULTILINE)


def given_away(source: Source) -> Iterator[Span]:
    """The values of passwords, keys and tokens; not variables, paths and words that merely stand for one."""
    last = 0
    stretches = source.kept(_stretches, lambda: tuple(_stretches(source)))
    for start, end in sorted((_stripped(source.text, *place) for place in stretches), key=_by_start):
        if end > max(last, start):
            last = end
            yield source.span(start, end)


def _by_start(place: tuple[int, int]) -> tuple[int, int]:
    return place[0], -place[1]


def _stripped(text: str, start: int, end: int) -> tuple[int, int]:
    """A stretch without the blanks around it, but for the first line end of a block."""
    value = text[start:end].rstrip()
    return start + len(value) - len(value.lstrip(" \t")), start + len(value)


def _stretches(source: Source) -> Iterator[tuple[int, int]]:
    text = source.text
    lowered = text.lower()
    code = source.name.endswith(_CODE)
    forms = [form for form in _possible(lowered) if form.in_code or not code]
    names = [each.start() for each in _NAMED.finditer(text)] if any(form.begins for form in forms) else []
    for form in forms:
        for match in _matches_at(form.pattern, text, names) if form.begins else form.pattern.finditer(text):
            value = match["secret"]
            if form.certain:
                yield match.span("secret")
            elif form.words[:1] == ("passwords",):
                yield from _inner(_MAPPED, text, *match.span("secret"))
            elif not _NO_SECRET.match(value.strip()):
                yield match.span("secret")
    if not code:
        yield from _blocks(text, lowered)


def _matches_at(pattern: re.Pattern[str], text: str, starts: list[int]) -> Iterator[re.Match[str]]:
    """What ``finditer`` gives of a pattern that begins at one of these places, in ascending order."""
    end = 0
    for start in starts:
        match = pattern.match(text, start) if start >= end else None
        if match is not None:
            end = match.end()
            yield match


def _possible(lowered: str) -> Iterator[Form]:
    """The forms whose words a text in small letters holds; each word is looked for once."""
    named = any(name in lowered for name in NAMES)
    is_set = named and _SET.search(lowered) is not None
    there = {word for word in WORDS if word in lowered}
    for form in FORMS:
        if (named or not form.named) and (is_set if not form.words else not there.isdisjoint(form.words)):
            yield form


def _blocks(text: str, lowered: str) -> Iterator[tuple[int, int]]:
    """The values below ``passwords:``, in blocks of lines, and in the list of cloud-init's ``chpasswd:``."""
    if any(word in lowered for word in ("passwords", "passphrases", "tokens")):
        for block in _PASSWORDS.finditer(text):
            yield from _inner(_ENTRY, text, *block.span("body"))
    if any(mark in lowered for mark in (": |", ": >")):
        for block in (found for pattern in _BLOCK_SCALARS for found in pattern.finditer(text)):
            yield from _inner(_WHOLE_LINE, text, *block.span("body"))
    if "chpasswd:" in lowered:
        for block in _CHPASSWD.finditer(text):
            yield from _inner(_LINE, text, *block.span("body"))


def _inner(pattern: re.Pattern[str], text: str, start: int, end: int) -> Iterator[tuple[int, int]]:
    """The values of a mapping."""
    for match in pattern.finditer(text, start, end):
        if not _NO_SECRET.match(match[1].strip()):
            yield match.span(1)
