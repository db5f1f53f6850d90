"""The lines that no comment can come between: those of one scalar, string, tag, here-document or continued line.

What is written there belongs to a value, or ends it. Each file is read once, by the parser of its format where that
knows where values end. Lines are counted from 1.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable
from collections.abc import Iterator
from functools import lru_cache

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.yaml_kinds import YAML_KINDS
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.suppress.forms import CPP_KINDS
from bringup_lint.suppress.forms import PYTHON_KINDS
from bringup_lint.suppress.forms import SHELL_KINDS
from bringup_lint.suppress.forms import XML_KINDS
from bringup_lint.suppress.forms import starts_of

Lines = Iterator["tuple[int, int]"]
"""First and last lines."""

_MARKUP = (("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>"))
_TAG = regex(r"""<[^<>"']*(?:(?:"[^"]*"?|'[^']*'?)[^<>"']*)*>?[^<]*""")
_BLOCK_HEADER = regex(r"[|>][-+0-9]{0,2}[ \t]*(?:#.*)?$")
_CPP = regex(r'R"([^ ()\\\t\v\f\n"]{0,16})\(|(/\*)|//[^\n]*|"(?:[^"\\\n]|\\.)*"?', re.S)
_CMAKE = regex(r'#\[(=*)\[|#[^\n]*|\[(=*)\[|"(?:[^"\\]|\\.)*"?|\\.', re.S)


class Unbroken(NamedTuple):
    """Groups of lines in their order, none touching another."""

    firsts: list[int]
    lasts: list[int]

    def around(self, line: int) -> range:
        """The group that a line belongs to, or the line alone."""
        at = bisect_right(self.firsts, line) - 1
        if at < 0 or self.lasts[at] < line:
            return range(line, line + 1)
        return range(self.firsts[at], self.lasts[at] + 1)

    def takes_comment(self, line: int) -> bool:
        """Whether a comment can be written above a line."""
        return self.around(line).start == line


def unbroken(source: Source) -> Unbroken:
    return _unbroken(source.kind, source.text)


@lru_cache(maxsize=8)
def _unbroken(kind: str, text: str) -> Unbroken:
    source = Source("", text, kind)
    values = _grouped(_of_format(source))
    return _grouped((*zip(values.firsts, values.lasts), *_continued(source, values)))


def _grouped(stretches: Iterable[tuple[int, int]]) -> Unbroken:
    found = Unbroken([], [])
    for first, last in sorted(each for each in stretches if each[1] > each[0]):
        if found.lasts and first <= found.lasts[-1]:
            found.lasts[-1] = max(found.lasts[-1], last)
        else:
            found.firsts.append(first)
            found.lasts.append(last)
    return found


def _of_format(source: Source) -> Lines:
    if source.kind in XML_KINDS:
        return _of_offsets(source, _xml(source.text))
    if source.kind in YAML_KINDS:
        return _yaml(source)
    if source.kind in SHELL_KINDS:
        return _shell(source)
    if source.kind in PYTHON_KINDS:
        return _python(source.text)
    if source.kind == "env-file":
        return _of_offsets(source, _environment(source))
    if source.kind in CPP_KINDS:
        return _of_offsets(source, _cpp(source.text))
    if source.kind == "cmake":
        return _of_offsets(source, _cmake(source.text))
    return iter(())


def _of_offsets(source: Source, stretches: Iterable[tuple[int, int]]) -> Lines:
    for start, end in stretches:
        yield source.position(start).line, source.position(max(start, end - 1)).line


def _continued(source: Source, values: Unbroken) -> Lines:
    """The lines that backslashes join, with the comments between them; nothing inside of a value is a comment."""
    comment = starts_of(source)
    first = 0
    count = len(source.line_starts)
    for line in range(1, count + 1):
        text = source.line_text(line)
        if text.lstrip().startswith(comment) and values.takes_comment(line):
            continue
        if text.endswith("\\"):
            first = first or line
        elif first:
            yield first, line
            first = 0
    if first:
        yield first, count


def _xml(text: str) -> Iterator[tuple[int, int]]:
    """Comments, sections, instructions, and tags with the text after them."""
    at = text.find("<")
    while at >= 0:
        end = next((_past(text, closes, at) for opens, closes in _MARKUP if text.startswith(opens, at)), 0)
        if not end:
            tag = _TAG.match(text, at)
            end = at + len(tag[0].rstrip()) if tag else at + 1
        yield at, end
        at = text.find("<", end)


def _past(text: str, what: str, at: int) -> int:
    """Where something that is looked for ends; the end of the text where it is missing."""
    found = text.find(what, at)
    return len(text) if found < 0 else found + len(what)


def _yaml(source: Source) -> Lines:
    """Scalars that the parser sees, and what looks like a block scalar where it sees nothing."""
    from bringup_lint.model.yaml_node import Mapping
    from bringup_lint.model.yaml_node import Node
    from bringup_lint.model.yaml_node import Scalar
    from bringup_lint.model.yaml_node import Sequence
    from bringup_lint.parsers.yaml_nodes import parse

    file = parse(source, follow_aliases=False)
    waiting: list[Node] = [document.root for document in file.documents if document.root is not None]
    spans = []
    while waiting:
        node = waiting.pop()
        if isinstance(node, Scalar):
            spans.append((node.span.start, node.span.end))
        elif isinstance(node, Sequence):
            waiting += node.items
        elif isinstance(node, Mapping):
            waiting += [each for pair in node.pairs for each in pair]
    yield from _of_offsets(source, spans)
    if file.problems:
        yield from _indented(source)


def _indented(source: Source) -> Lines:
    """Block scalars by their indentation alone, for templates and for files that are not YAML."""
    first = last = indent = 0
    for line in range(1, len(source.line_starts) + 1):
        text = source.line_text(line)
        if first:
            if not text.strip():
                continue
            if len(text) - len(text.lstrip(" ")) > indent:
                last = line
                continue
            yield first, last
            first = 0
        if _opens_block(text):
            first = last = line
            indent = len(text) - len(text.lstrip(" "))
    if first:
        yield first, last


def _opens_block(text: str) -> bool:
    """Whether a line ends with the sign of a block scalar, after a key, a dash, a tag or an anchor."""
    header = _BLOCK_HEADER.search(text)
    before = text[: header.start()].rstrip() if header else ""
    return before.endswith((":", "-", "?")) or before.rpartition(" ")[2].startswith(("&", "!"))


def _shell(source: Source) -> Lines:
    """Words with line ends in them, and commands with their here-documents to the delimiter."""
    from bringup_lint.parsers.shell_tokens import tokens

    count = len(source.line_starts)
    for token in tokens(source.located(0, len(source.text))):
        span = token.text.span
        if token.document is not None:
            text = token.document.text.span
            yield span.line, min(count, source.position(text.end).line)
        elif not token.operator:
            yield span.line, source.position(max(span.start, span.end - 1)).line


def _python(text: str) -> Lines:
    """Strings that span several lines."""
    import ast

    from bringup_lint.model.python import syntax_of

    tree = syntax_of(text.removeprefix("\ufeff"))
    if tree is not None:
        parts = (node for node in ast.walk(tree) if isinstance(node, (ast.Constant, ast.JoinedStr)))
        yield from ((node.lineno, node.end_lineno or node.lineno) for node in parts)


def _environment(source: Source) -> Iterator[tuple[int, int]]:
    from bringup_lint.parsers.env_file import parse

    file = parse(source)
    yield from ((entry.span.start, entry.span.end) for entry in file.entries)
    yield from ((problem.span.start, problem.span.end) for problem in file.problems)


def _cpp(text: str) -> Iterator[tuple[int, int]]:
    """Raw strings and long comments."""
    at = 0
    while match := _CPP.search(text, at):
        at = match.end()
        if match[1] is not None:
            at = _past(text, f'){match[1]}"', at)
        elif match[2]:
            at = _past(text, "*/", at)
        yield match.start(), at


def _cmake(text: str) -> Iterator[tuple[int, int]]:
    """Quoted and bracketed arguments, and bracketed comments."""
    at = 0
    while match := _CMAKE.search(text, at):
        level = match[1] if match[1] is not None else match[2]
        at = match.end() if level is None else _past(text, f"]{level}]", match.end())
        yield match.start(), at
