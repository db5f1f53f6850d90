"""The ``$(name argument ...)`` grammar of XML and YAML launch files."""

from __future__ import annotations

import re

from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Command
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import PackagePrefix
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import Value
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Span

DEPTH = 12
_NAME = regex(r"\$\(\s*([A-Za-z][\w-]*)")
_PLAIN = regex(r"[^$\\]+")
_WORD = regex(r"[^\s'\"\\$()]+")
_BLANK = regex(r"\s+")
ROS1 = frozenset(("arg", "find", "optenv"))


class Reader:
    """Reads one text. ``file`` collects what is read of launch configurations, and ROS 1 names."""

    def __init__(self, text: Located, file: LaunchFile) -> None:
        self.text = text
        self.file = file
        self.depth = 0

    def template(self, at: int, end: int, quote: str = "") -> tuple[Value, int]:
        """Text with substitutions in it, up to ``end`` or the closing quote."""
        parts: list[Value] = []
        start = at
        while at < end and self.text[at] != quote:
            match = _NAME.match(self.text, at) if self.text[at] == "$" else None
            if match is not None:
                self.literal(parts, start, at)
                value, at = self.substitution(match, end)
                parts.append(value)
                start = at
            elif self.text[at] == "\\":
                at += 2
            else:
                plain = None if quote else _PLAIN.match(self.text, at, end)
                at = plain.end() if plain else at + 1
        at = min(at, end)
        self.literal(parts, start, at)
        return self.joined(parts, at), at

    def literal(self, parts: list[Value], start: int, end: int) -> None:
        if end > start:
            part = self.text.part(start, end)
            if "\\" in part:
                part = Located(re.sub(r"\\(.)", r"\1", part, flags=re.S), part.span)
            parts.append(Literal(part, part.span))

    def joined(self, parts: list[Value], at: int) -> Value:
        if not parts:
            empty = self.text.part(at, at)
            return Literal(empty, empty.span)
        if len(parts) == 1:
            return parts[0]
        return Concat(tuple(parts), Span(parts[0].span.source, parts[0].span.start, parts[-1].span.end))

    def substitution(self, match: re.Match, end: int) -> tuple[Value, int]:
        at = match.end()
        name = match[1]
        place = self.text.part(match.start(1), match.end(1))
        arguments: list[Value] = []
        self.depth += 1
        while at < end and self.text[at] != ")":
            blank = _BLANK.match(self.text, at, end)
            if blank:
                at = blank.end()
                continue
            value, at = self.argument(at, end)
            arguments.append(value)
        self.depth -= 1
        closed = at < end
        at = min(at + 1, end)
        span = self.text.part(match.start(), at).span
        if not closed:
            return Unknown("unclosed substitution", span), at
        if self.depth > DEPTH:
            return Unknown("nested too deeply", span), at
        return build(self.file, name, place, arguments, span), at

    def argument(self, at: int, end: int) -> tuple[Value, int]:
        if self.text[at] in "'\"":
            value, after = self.template(at + 1, end, self.text[at])
            if after < end:
                after += 1
                if after >= end or self.text[after] in " \t\n)":
                    return value, after
        return self.word(at, end)

    def word(self, at: int, end: int) -> tuple[Value, int]:
        parts: list[Value] = []
        start = at
        while at < end:
            char = self.text[at]
            match = _NAME.match(self.text, at) if char == "$" and self.depth <= DEPTH else None
            if match is not None:
                self.literal(parts, start, at)
                value, at = self.substitution(match, end)
                parts.append(value)
                start = at
            elif char == "\\":
                at += 2
            elif char.isspace() or char == ")":
                break
            else:
                plain = _WORD.match(self.text, at, end)
                at = plain.end() if plain else at + 1
        at = min(at, end)
        self.literal(parts, start, at)
        return self.joined(parts, at), at


def read(text: Located, file: LaunchFile) -> Value:
    """The value of an attribute."""
    if "$" not in text and "\\" not in text:
        return Literal(text, text.span)
    return Reader(text, file).template(0, len(text))[0]


def build(file: LaunchFile, name: str, place: Located, arguments: list[Value], span: Span) -> Value:
    """The value that a substitution stands for."""
    first = arguments[0] if arguments else None
    if name in ROS1:
        file.ros1.append(place)
        return Unknown(f"ROS 1 substitution {name}", span)
    if name in ("dirname", "filename"):
        return FileDir(span, name == "filename")
    if first is None:
        return Unknown(f"substitution {name}", span)
    if name in ("var", "env"):
        return _named(file, name, arguments, span)
    if name in ("find-pkg-share", "find-pkg-prefix"):
        return (PackageShare if name == "find-pkg-share" else PackagePrefix)(first, span)
    if name == "exec-in-pkg" and len(arguments) == 2:
        lib = Literal(Located("lib", span), span)
        return PathJoin((PackagePrefix(arguments[1], span), lib, arguments[1], first), span)
    if name == "find-exec":
        return first
    if name == "command":
        return Command(first, span)
    if name == "eval":
        return Operation("python", (_spaced(arguments, span),), span)
    if name in _OPERATIONS:
        return Operation(_OPERATIONS[name], tuple(arguments), span)
    if name == "if" and len(arguments) in (2, 3):
        empty = Literal(Located("", span), span)
        return Operation("if", (*arguments, empty)[:3], span)
    return Unknown(f"substitution {name}", span)


_OPERATIONS = {
    "not": "not",
    "and": "and",
    "all": "and",
    "or": "or",
    "any": "or",
    "equals": "equals",
    "not-equals": "not-equals",
}


def _named(file: LaunchFile, name: str, arguments: list[Value], span: Span) -> Value:
    first, default = arguments[0], arguments[1] if len(arguments) > 1 else None
    if not isinstance(first, Literal) or not isinstance(first.value, Located):
        file.reads_all = file.reads_all or name == "var"
        return Unknown("name of a launch configuration" if name == "var" else "environment", span)
    if name == "env":
        return Env(first.value, default, span, scoped=True)
    result = Argument(first.value, default, span)
    file.reads.append(result)
    return result


def _spaced(arguments: list[Value], span: Span) -> Value:
    """Arguments of ``eval``: one quoted text, or words."""
    if len(arguments) == 1:
        return arguments[0]
    parts: list[Value] = []
    for argument in arguments:
        if parts:
            parts.append(Literal(Located(" ", argument.span), argument.span))
        parts.extend(argument.parts if isinstance(argument, Concat) else (argument,))
    return Concat(tuple(parts), span)
