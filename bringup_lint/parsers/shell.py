"""Shell scripts, as far as a linter needs them: words, quotes, operators, here-documents and compound commands
(POSIX.1-2017, chapter 2; bash(1)). Nothing is expanded; what cannot be read is passed over."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from bringup_lint.model.shell import Command
from bringup_lint.source import Located
from bringup_lint.source import Source

_OPENING = frozenset({"if", "while", "until", "for", "case", "select", "{", "then", "else", "elif", "do"})
_OPENS = frozenset({"if", "while", "until", "for", "case", "select", "{"})
_CLOSES = frozenset({"fi", "done", "esac", "}"})
_PREFIXES = _OPENING | {"!", "time"}
ASSIGNMENT = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\+?=")
_OPERATOR = re.compile(r"&&|\|\||;;&?|;&|\|&|&>>?|<<<|<<-?|<>|<&|>&|>>|>\||[;&|<>()\n]")
REDIRECTS = frozenset({"<", ">", ">>", "<&", ">&", "<>", ">|", "&>", "&>>", "<<<"})
_PLAIN = re.compile(r"[^ \t\r\n\\'\"`$;&|<>()#]+")


class Token(NamedTuple):
    text: Located
    operator: bool


def commands(script: Located) -> list[Command]:
    """The simple commands of a script, in the order in which they stand. Never raises."""
    found: list[Command] = []
    words: list[Located] = []
    assignments: list[Located] = []
    depth = 0
    skip_word = False
    for token in tokens(script):
        text = str(token.text)
        if not token.operator:
            if skip_word:
                skip_word = False
            elif not words and text in _CLOSES and token.text.span.text == text:
                depth = max(depth - 1, 0)
            elif not words and text in _PREFIXES and token.text.span.text == text:
                depth += text in _OPENS
            elif not words and ASSIGNMENT.match(text):
                assignments.append(token.text)
            else:
                words.append(token.text)
            continue
        if text in REDIRECTS:
            skip_word = True
            if words and words[-1].isdigit() and words[-1].span.end == token.text.span.start:
                words.pop()
            continue
        if text == "(" and words:
            words, assignments = [], []
            continue
        if words or assignments:
            found.append(Command(tuple(words), tuple(assignments), text if text not in "()" else ";", depth))
        words, assignments = [], []
        depth = depth + 1 if text == "(" else max(depth - (text == ")"), 0)
    if words or assignments:
        found.append(Command(tuple(words), tuple(assignments), "", depth))
    return found


def shell_commands(source: Source) -> list[Command]:
    """The simple commands of a whole script file."""
    return commands(source.located(0, len(source.text)))


def words(line: Located) -> Iterator[Located]:
    """The words of a command line; operators, which only a shell would read, are left out."""
    for command in commands(line):
        yield from command.assignments
        yield from command.words


def tokens(script: Located) -> Iterator[Token]:
    text = str(script)
    at, size = 0, len(text)
    heredocs: list[tuple[str, bool]] = []
    while at < size:
        char = text[at]
        if char in " \t\r":
            at += 1
        elif text.startswith("\\\n", at):
            at += 2
        elif char == "#":
            at = _line_end(text, at)
        elif operator := _OPERATOR.match(text, at):
            yield Token(script.part(at, operator.end()), True)
            at = operator.end()
            if operator[0] in ("<<", "<<-"):
                at, delimiter = _delimiter(text, at)
                heredocs.append((delimiter, operator[0] == "<<-"))
            elif char == "\n" and heredocs:
                at = _skip_heredocs(text, at, heredocs)
                heredocs = []
        else:
            end, word = _word(script, at)
            yield Token(word, False)
            at = end


def _word(script: Located, start: int) -> tuple[int, Located]:
    """The word at ``start``, its quotes removed, and where it ends."""
    text = str(script)
    size = len(text)
    at = start
    out: list[str] = []
    pieces: list[tuple[int, int]] = []
    length = 0

    def keep(begin: int, end: int) -> None:
        nonlocal length
        if end > begin:
            pieces.append((length, script.origin(begin)))
            out.append(text[begin:end])
            length += end - begin

    while at < size:
        plain = _PLAIN.match(text, at)
        if plain:
            keep(at, plain.end())
            at = plain.end()
            continue
        char = text[at]
        if char == "\\":
            if not text.startswith("\n", at + 1):
                keep(at + 1, at + 2)
            at += 2
        elif char == "'":
            end = _find(text, "'", at + 1)
            keep(at + 1, end)
            at = end + 1
        elif char == '"':
            end = _closing_quote(text, at + 1)
            keep(at + 1, end)
            at = end + 1
        elif char == "`":
            end = _find(text, "`", at + 1)
            keep(at, end + 1)
            at = end + 1
        elif char == "$":
            end = _expansion_end(text, at)
            keep(at, end)
            at = end
        elif char == "#":
            keep(at, at + 1)
            at += 1
        else:
            break
    at = min(at, size)
    place = script.part(start, at)
    return at, Located("".join(out), place.span, tuple(pieces) or None)


def _expansion_end(text: str, at: int) -> int:
    """Where the expansion that starts with ``$`` ends, brackets balanced."""
    opening = text[at + 1 : at + 2]
    closing = {"(": ")", "{": "}"}.get(opening)
    if closing is None:
        return at + 1
    depth = 0
    for end in range(at + 1, len(text)):
        depth += (text[end] == opening) - (text[end] == closing)
        if depth == 0:
            return end + 1
    return len(text)


def _closing_quote(text: str, at: int) -> int:
    while at < len(text) and text[at] != '"':
        at += 2 if text[at] == "\\" else 1
    return min(at, len(text))


def _find(text: str, what: str, at: int) -> int:
    found = text.find(what, at)
    return len(text) if found == -1 else found


def _line_end(text: str, at: int) -> int:
    return _find(text, "\n", at)


def _delimiter(text: str, at: int) -> tuple[int, str]:
    match = re.compile(r"[ \t]*(?:'([^'\n]*)'|\"([^\"\n]*)\"|\\?([^ \t\r\n;&|<>()]*))").match(text, at)
    return match.end(), next((group for group in match.groups() if group is not None), "")


def _skip_heredocs(text: str, at: int, heredocs: list[tuple[str, bool]]) -> int:
    for delimiter, tabs in heredocs:
        while at < len(text):
            end = _line_end(text, at)
            line = text[at:end].rstrip("\r")
            at = end + 1
            if (line.lstrip("\t") if tabs else line) == delimiter:
                break
    return at
