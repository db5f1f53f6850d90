"""sshd_config(5), line by line as sshd reads it (servconf.c and argv_split() of OpenSSH 9.2)."""

from __future__ import annotations

import re
from functools import cache

from bringup_lint.model.schema import Item
from bringup_lint.model.sshd import Match
from bringup_lint.model.sshd import Option
from bringup_lint.model.sshd import SshdFile
from bringup_lint.parsers.sshd_values import judge
from bringup_lint.pattern import regex
from bringup_lint.schema.names import FOLDED
from bringup_lint.schema.names import find
from bringup_lint.schema.table import load
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

_KEYWORD = regex(r"[^ \t\r\n\"=]+")
_GAP = regex(r"[ \t\r]*=?[ \t\r]*")
_CRITERIA = frozenset({"user", "group", "host", "address", "localaddress", "localport", "rdomain"})
_BARE_CRITERIA = frozenset({"all", "invalid-user"})


@cache
def keywords() -> dict[str, Item]:
    """The keywords that sshd knows, in their usual spelling."""
    return load("host/sshd_options").top.children


def keyword_of(word: str) -> Item | None:
    """What sshd knows by a word, whatever its case."""
    return find(keywords(), word, FOLDED).item


def parse(source: Source) -> SshdFile:
    """Read a configuration file or drop-in. Never raises; codes: ``unknown-option``, ``no-argument``,
    ``invalid-quotes``, ``bad-value``, ``extra-arguments``, ``not-in-match``, ``bad-match``, ``duplicate-subsystem``,
    ``deprecated``."""
    file = SshdFile(source)
    match: Match | None = None
    for number, start in enumerate(source.line_starts, 1):
        text = source.line_text(number)
        line = source.located(start, start + len(text.rstrip(" \t\r\n\f")))
        found = _KEYWORD.search(line)
        if found is None or line[: found.start()].strip(" \t\r=") or found[0].startswith("#"):
            continue
        option = _option(file, line, found, match)
        if option is not None:
            file.options.append(option)
            if option.name == "Match":
                match = option.match
    return file


def _option(file: SshdFile, line: Located, found: re.Match[str], match: Match | None) -> Option | None:
    word, end = line.part(*found.span()), found.end()
    if line[end : end + 1] == '"':
        end = line.find('"', end + 1) + 1
        if not end:
            return None
        word = line.part(found.start(), end)
    rest_at = _GAP.match(line, end).end()  # type: ignore[union-attr]
    if rest_at >= len(line):
        file.problems.append(Problem("no-argument", word))
        return None
    known = keyword_of(word)
    words = split(line.part(rest_at, len(line)))
    if known is None:
        file.problems.append(Problem("unknown-option", word))
    if words is None:
        file.problems.append(Problem("invalid-quotes", line.part(rest_at, len(line))))
        return None
    name = (known.row["alias"] or known.name) if known else str(word)
    option = Option(word, name, tuple(words), match, line.span)
    if known is None:
        return option
    if match is not None and not match.always and known.row["scope"] != "match":
        file.problems.append(Problem("not-in-match", word, match.condition))
    elif known.type == "match":
        return option._replace(match=_match(file, word, words))
    else:
        _judge(file, option, known)
    return option


def _judge(file: SshdFile, option: Option, known: Item) -> None:
    if known.type in ("deprecated", "ignored"):
        if known.type == "deprecated":
            file.problems.append(Problem("deprecated", option.keyword))
        return
    taken, expected = judge(known.type, option.arguments)
    if expected:
        wrong = option.arguments[0] if option.arguments else option.keyword
        file.problems.append(Problem("bad-value", wrong, expected))
    elif known.type == "subsystem" and any(
        each.name == "Subsystem" and each.value == option.value for each in file.options
    ):
        file.problems.append(Problem("duplicate-subsystem", option.value))
    elif len(option.arguments) > taken:
        file.problems.append(Problem("extra-arguments", option.arguments[taken]))


def _match(file: SshdFile, keyword: Located, words: list[Located]) -> Match:
    flat = [part for word in words for part in ([word] if "=" not in word else word.split("=", 1))]
    condition = " ".join(words)
    if flat[:1] and flat[0].lower() == "all":
        if len(flat) > 1:
            file.problems.append(Problem("bad-match", keyword, condition))
        return Match(keyword, condition, len(flat) == 1)
    at = 0
    while at < len(flat):
        criterion = flat[at].lower()
        if criterion in _BARE_CRITERIA and criterion != "all":
            at += 1
        elif criterion in _CRITERIA and at + 1 < len(flat) and flat[at + 1]:
            at += 2
        else:
            file.problems.append(Problem("bad-match", keyword, condition))
            break
    return Match(keyword, condition, False)


def split(text: Located) -> list[Located] | None:
    """The arguments of a line, quotes removed, up to a comment; None when a quote is left open."""
    words: list[Located] = []
    at, size, raw = 0, len(text), str(text)
    while at < size:
        if raw[at] in " \t":
            at += 1
            continue
        if raw[at] == "#":
            break
        start, letters, quote = at, [], ""
        while at < size and (quote or raw[at] not in " \t"):
            char, following = raw[at], raw[at + 1 : at + 2]
            if char == "\\" and following and (following in "'\"\\" or (not quote and following == " ")):
                at += 1
                letters.append(following)
            elif not quote and char in "\"'":
                quote = char
            elif quote and char == quote:
                quote = ""
            else:
                letters.append(char)
            at += 1
        if quote:
            return None
        word = text.part(start, at)
        plain = "".join(letters)
        words.append(word if word == plain else Located(plain, word.span))
    return words
