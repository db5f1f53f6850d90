"""What launch's grammar of substitutions takes: stricter than the reader, which recovers.

The terminals are those of ``grammar.lark`` in ros2/launch: one blank between arguments, no sign in an unquoted argument
that is not escaped, quotes only around a whole argument.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

LONGEST = 20_000
"""Code points of a text that is checked."""
DEPTH = 40
_TEXT = {
    "": regex(r"(?:[^$]|\$(?!\()|(?<=\\)\$)+"),
    "'": regex(r"(?:\\'|[^'\\$]|\$(?!\()|(?<=\\)\$|\\)+"),
    '"': regex(r'(?:\\"|[^"\\$]|\$(?!\()|(?<=\\)\$|\\)+'),
}
_WORD = {
    "": regex(r"""(?:\\"|\\'|[^ '\\"$()]|(?<=\\)[()]|\$(?!\()|(?<=\\)\$|\\)+"""),
    "'": regex(r"(?:\\'|[^ '\\$()]|(?<=\\)[()]|\$(?!\()|(?<=\\)\$|\\)+"),
    '"': regex(r'(?:\\"|[^ "\\$()]|(?<=\\)[()]|\$(?!\()|(?<=\\)\$|\\)+'),
}
_NAME = regex(r"\$\(([A-Za-z][\w-]*)", re.ASCII)


class Used(NamedTuple):
    """A substitution: where its name is in the text, and how many arguments it gets."""

    start: int
    end: int
    arguments: int


class Refused(Exception):
    """The grammar does not take the text at a place."""

    def __init__(self, at: int, why: str) -> None:
        super().__init__(why)
        self.at = at
        self.why = why


@dataclass(slots=True)
class Template:
    used: list[Used] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    """The runs of text between the substitutions."""


def template(text: str) -> Template:
    """The parts of a text; raises ``Refused``."""
    result = Template()
    if len(text) <= LONGEST:
        _fragments(text, 0, "", result, 0)
    return result


def _fragments(text: str, at: int, quote: str, result: Template, depth: int) -> int:
    """Text with substitutions, up to the end or the closing quote."""
    while at < len(text) and not (quote and text[at] == quote):
        plain = _TEXT[quote].match(text, at)
        if plain is not None:
            if not depth:
                result.texts.append(plain[0])
            at = plain.end()
        else:
            at = _substitution(text, at, quote, result, depth)
    return at


def _substitution(text: str, at: int, quote: str, result: Template, depth: int) -> int:
    name = _NAME.match(text, at)
    if name is None or depth > DEPTH:
        raise Refused(at, "a substitution needs a name after $(")
    where = len(result.used)
    result.used.append(Used(name.start(1), name.end(1), 0))
    at = name.end()
    count = 0
    while text[at : at + 1] == " ":
        at = _argument(text, at + 1, quote, result, depth + 1)
        count += 1
    result.used[where] = Used(name.start(1), name.end(1), count)
    if text[at : at + 1] != ")":
        raise Refused(at, _why(text, at, quote))
    return at + 1


def _argument(text: str, at: int, quote: str, result: Template, depth: int) -> int:
    opening = text[at : at + 1]
    if not quote and opening and opening in "'\"":
        at = _fragments(text, at + 1, opening, result, depth)
        if text[at : at + 1] != opening:
            raise Refused(at, f"{opening} is not closed")
        return at + 1
    start = at
    while at < len(text):
        word = _WORD[quote].match(text, at)
        if word is not None:
            at = word.end()
        elif text.startswith("$(", at):
            at = _substitution(text, at, quote, result, depth)
        else:
            break
    if at == start:
        raise Refused(at, _why(text, at, quote))
    return at


def _why(text: str, at: int, quote: str) -> str:
    sign = text[at : at + 1]
    if not sign or sign == quote:
        return "the substitution is not closed"
    if sign in " )":
        return "only one blank is allowed between the parts of a substitution"
    if sign in "'\"":
        return "a quote inside an argument: quote the whole argument"
    return f"{sign!r} is not allowed here: quote the argument"


def unbalanced(texts: list[str]) -> Iterator[str]:
    """The texts of a command that a shell could not split: each run is split alone."""
    import shlex

    for text in texts:
        try:
            shlex.split(re.sub(r"\\(.)", r"\1", text))
        except ValueError as error:
            yield str(error)
