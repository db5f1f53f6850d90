"""Dockerfiles: instructions, continued lines, here-documents and stages (docs.docker.com/reference/dockerfile)."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from functools import cached_property
from functools import partial

from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.model.dockerfile import Instruction
from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.shell import Block
from bringup_lint.model.shell import Command
from bringup_lint.parsers.shell import blocks
from bringup_lint.parsers.shell import flatten
from bringup_lint.parsers.systemd_values import split_words
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

INSTRUCTIONS = frozenset(
    {
        "ADD",
        "ARG",
        "CMD",
        "COPY",
        "ENTRYPOINT",
        "ENV",
        "EXPOSE",
        "FROM",
        "HEALTHCHECK",
        "LABEL",
        "MAINTAINER",
        "ONBUILD",
        "RUN",
        "SHELL",
        "STOPSIGNAL",
        "USER",
        "VOLUME",
        "WORKDIR",
    }
)
_DIRECTIVE = regex(r"#\s*(\w+)\s*=\s*(\S(?:.*\S)?)\s*$")
_KEYWORD = regex(r"\s*([A-Za-z]+)(?:\s+|$)")
_FLAG = regex(r"--[a-z][\w-]*(?:=(?:\"[^\"]*\"|\S*))?(?:\s+|$)")
_HEREDOC = regex(r"(?<![<\w$(])<<(?P<dash>-?)(?P<quote>[\"']?)(?P<word>\w+)(?P=quote)")


LAYERS = 127
"""Stages that build on one another: Docker mounts no image of more layers, and fails with "max depth exceeded"."""
STAGES = 1_000


def parse(source: Source) -> Dockerfile:
    """Read a Dockerfile. Problems: ``unknown-instruction``, ``no-stage``, ``unterminated-heredoc``, and ``too-large``
    from where it has more stages than an image can have."""
    file = Dockerfile(source)
    for instruction in _instructions(file):
        if instruction.name == "FROM":
            if file.stages and _is_too_large(file):
                file.problems.append(Problem("too-large", instruction.keyword))
                break
            _add_stage(file, instruction)
        elif file.stages:
            file.stages[-1].instructions.append(instruction)
        elif instruction.name == "ARG":
            name, equals, _ = instruction.value.partition("=")
            text = instruction.value
            file.arguments[name.strip()] = _unquoted(text.part(len(name) + 1, len(text))) if equals else None
        else:
            file.problems.append(Problem("no-stage", instruction.keyword))
    return file


def _is_too_large(file: Dockerfile) -> bool:
    return len(file.stages) >= STAGES or sum(1 for _ in file.stages[-1].chain) > LAYERS


def _add_stage(file: Dockerfile, instruction: Instruction) -> None:
    words = list(instruction.value.words())
    if not words:
        file.problems.append(Problem("no-image", instruction.keyword))
        return
    name = words[2] if len(words) > 2 and words[1].lower() == "as" else None
    stage = Stage(instruction, words[0], name)
    stage.arguments = file.arguments
    stage.resolved = file.expand(words[0])
    stage.base = file.stage(stage.resolved)
    if "$" in stage.resolved:
        stage.earlier = tuple(file.stages)
    file.add(stage)


def _unquoted(text: Located) -> Located:
    text = text.strip_located()
    if len(text) > 1 and text[0] == text[-1] and text[0] in "\"'":
        return text.part(1, len(text) - 1)
    return text


def _instructions(file: Dockerfile) -> Iterator[Instruction]:
    source = file.source
    lines = _lines(source)
    ends = _Delimiters(source, lines)
    escape = _escape(source)
    at = 0
    while at < len(lines):
        start, end = lines[at]
        text = source.text[start:end]
        at += 1
        if not text.strip() or text.lstrip().startswith("#"):
            continue
        chunks = []
        while True:
            body = source.text[start:end].rstrip()
            continued = body.endswith(escape)
            chunks.append((start, start + len(body) - (1 if continued else 0)))
            if not continued or at >= len(lines):
                break
            at = _next_line(source, lines, at)
            if at >= len(lines):
                break
            start, end = lines[at]
            at += 1
        whole = _joined(source, chunks)
        instruction = _instruction(file, whole)
        if instruction is None:
            continue
        if instruction.name in ("RUN", "COPY", "ADD"):
            at = _heredocs(file, instruction, ends, at)
        yield instruction


def _lines(source: Source) -> list[tuple[int, int]]:
    """Start and end of every line, without its line end."""
    starts = source.line_starts
    ends = [*starts[1:], len(source.text) + 1]
    return [(start, end - 1) for start, end in zip(starts, ends, strict=True)]


def _escape(source: Source) -> str:
    """The continuation character, which a directive at the very top may change."""
    for line in source.text.splitlines():
        directive = _DIRECTIVE.match(line.strip())
        if directive is None:
            return "\\"
        if directive[1].lower() == "escape" and directive[2] in ("\\", "`"):
            return directive[2]
    return "\\"


def _next_line(source: Source, lines: list[tuple[int, int]], at: int) -> int:
    """Pass over the comments and empty lines between continued lines."""
    while at < len(lines):
        text = source.text[slice(*lines[at])].strip()
        if text and not text.startswith("#"):
            break
        at += 1
    return at


def _joined(source: Source, chunks: list[tuple[int, int]]) -> Located:
    text = "".join(source.text[start:end] for start, end in chunks)
    pieces, inner = [], 0
    for start, end in chunks:
        pieces.append((inner, start))
        inner += end - start
    span = Span(source, chunks[0][0], max(chunks[0][0], chunks[-1][1]))
    return Located(text, span, tuple(pieces) if len(pieces) > 1 else None)


def _instruction(file: Dockerfile, whole: Located) -> Instruction | None:
    match = _KEYWORD.match(whole)
    name = match[1].upper() if match else ""
    if match is None or name not in INSTRUCTIONS:
        file.problems.append(Problem("unknown-instruction", whole.part(0, min(len(whole), 40)).strip_located()))
        return None
    keyword, at = whole.part(match.start(1), match.end(1)), match.end()
    if name == "ONBUILD":
        inner = _instruction(file, whole.part(at, len(whole)))
        return None if inner is None else Instruction("ONBUILD", keyword, whole.part(at, len(whole)))
    flags = []
    while flag := _FLAG.match(whole, at):
        flags.append(whole.part(at, flag.end()).strip_located())
        at = flag.end()
    return Instruction(name, keyword, whole.part(at, len(whole)).strip_located(), tuple(flags))


class _Delimiters:
    """The lines of a file by their text, so that the end of each here-document is looked up, and not searched for."""

    def __init__(self, source: Source, lines: list[tuple[int, int]]) -> None:
        self.source = source
        self.lines = lines

    @cached_property
    def _by_text(self) -> tuple[dict[str, list[int]], dict[str, list[int]]]:
        """Text -> the numbers of its lines; and the same without the tabs before it."""
        whole: dict[str, list[int]] = {}
        stripped: dict[str, list[int]] = {}
        for number, line in enumerate(self.lines):
            text = self.source.text[slice(*line)].rstrip("\r")
            whole.setdefault(text, []).append(number)
            stripped.setdefault(text.lstrip("\t"), []).append(number)
        return whole, stripped

    def next(self, word: str, at: int, *, tabs: bool) -> int | None:
        """The first line from one on that is the word, with ``tabs`` also behind tabs."""
        known = self._by_text[tabs].get(word, [])
        index = bisect_left(known, at)
        return known[index] if index < len(known) else None


def _heredocs(file: Dockerfile, instruction: Instruction, ends: _Delimiters, at: int) -> int:
    """Take the lines of the here-documents that the instruction opens; returns the line behind them."""
    for opening in _HEREDOC.finditer(instruction.value):
        end = ends.next(opening["word"], at, tabs=bool(opening["dash"]))
        if end is None:
            file.problems.append(Problem("unterminated-heredoc", instruction.value, opening["word"]))
            return at
        start = ends.lines[at][0]
        instruction.heredocs.append(file.source.located(start, max(start, ends.lines[end][0])))
        at = end + 1
    return at


def assignments(instruction: Instruction) -> Iterator[tuple[str, Located]]:
    """What ENV or ARG sets: ``NAME=value ...``, or the old ``ENV NAME value``."""
    line = instruction.value
    first = next(line.words(), None)
    if instruction.name == "ENV" and first is not None and "=" not in first:
        yield str(first), line.part(len(first), len(line)).strip_located()
        return
    for word in split_words(line).words:
        name, equals, _ = word.partition("=")
        if equals:
            yield name, word.part(len(name) + 1, len(word))


def environment_of(stage: Stage) -> Iterator[tuple[str, Located]]:
    """What ENV sets in a stage and those that it builds on, the nearest first."""
    return (pair for one in stage.chain for each in one.all("ENV") for pair in assignments(each))


def commands_of(stage: Stage) -> Iterator[Command]:
    """The shell commands of a Dockerfile stage's RUN instructions, in order."""
    for instruction in stage.all("RUN"):
        yield from commands_of_run(instruction)


def commands_of_run(instruction: Instruction) -> Iterator[Command]:
    """The shell commands of one RUN instruction."""
    for statements in blocks_of_run(instruction):
        yield from flatten(statements)


def blocks_of_run(instruction: Instruction) -> Iterator[tuple[Block, ...]]:
    """The statements of each script of one RUN instruction, read once for all rules."""
    for script in instruction.scripts:
        key = (blocks, script.span.start, script.span.end)
        yield script.span.source.once(key, partial(blocks, script))
