"""What the real tools answered, kept as data, so that our code is proved where a tool is absent.

A record is a file of ``answers/<tool>/``: the tool with its version, and pairs of a question and its answer, one in a
line. Questions and answers are anything that JSON knows; an answer names no temporary folder.
"""

from __future__ import annotations

import gzip
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any
from typing import NamedTuple

import pytest

FOLDER = Path(__file__).parent / "answers"
READABLE = 50_000
"""Bytes above which a record is compressed."""

Question = Any
Answer = Any


class Answers(NamedTuple):
    """What a test judges: the answers of one tool, recorded or just given."""

    tool: str
    """Name and version, such as ``logrotate 3.21.0``."""
    pairs: list[tuple[Question, Answer]]

    @property
    def version(self) -> str:
        return self.tool.partition(" ")[2]


class Oracle(NamedTuple):
    """The fixture ``answers``: asks the tool that is installed, or the record of an earlier answer."""

    real: bool
    update: bool

    def of(
        self,
        name: str,
        tool: str,
        questions: list[Question],
        ask: Callable[[list[Question]], list[Answer]],
    ) -> Answers:
        """The answers to the questions and to those of the record ``name``.

        ``tool`` is empty, or a name without a version, where the tool is absent. The record is compared with what the
        tool says now where their versions agree, but for the hundredth that may depend on the machine, and rewritten
        with ``--update-expected``.
        """
        if not self.real:
            return read(name)
        if not tool.partition(" ")[2]:
            pytest.skip(f"needs {tool or name.partition('/')[0]}")
        known = read(name) if not self.update and _file(name).exists() else Answers(tool, [])
        asked = {_key(question): question for question in [*questions, *(question for question, _ in known.pairs)]}
        given = Answers(tool, list(zip(asked.values(), _plain(ask(list(asked.values()))), strict=True)))
        if self.update:
            write(name, given)
        elif known.tool == tool:
            _compare(known, given)
        return given


def _compare(known: Answers, given: Answers) -> None:
    now = {_key(question): answer for question, answer in given.pairs}
    changed = [(question, now[_key(question)], then) for question, then in known.pairs if now[_key(question)] != then]
    few = len(known.pairs) // 100
    assert len(changed) <= few, f"{known.tool}: {len(changed)} answers differ from the record, the first: {changed[0]}"


def read(name: str) -> Answers:
    file = _file(name)
    data = gzip.decompress(file.read_bytes()) if file.suffix == ".gz" else file.read_bytes()
    record = json.loads(data)
    return Answers(record["tool"], [(question, answer) for question, answer in record["answers"]])


def write(name: str, answers: Answers) -> None:
    _file(name).unlink(missing_ok=True)
    lines = ",\n".join(json.dumps(pair, sort_keys=True) for pair in answers.pairs)
    data = f'{{"tool": {json.dumps(answers.tool)}, "answers": [\n{lines}\n]}}\n'.encode()
    file = FOLDER / f"{name}.json"
    file.parent.mkdir(parents=True, exist_ok=True)
    if len(data) > READABLE:
        file.with_name(f"{file.name}.gz").write_bytes(gzip.compress(data, mtime=0))
    else:
        file.write_bytes(data)


def _file(name: str) -> Path:
    plain = FOLDER / f"{name}.json"
    return plain if plain.exists() else plain.with_name(f"{plain.name}.gz")


def _plain(answers: list[Answer]) -> list[Answer]:
    """As they come back from a record: tuples are lists."""
    return json.loads(json.dumps(answers))


def _key(question: Question) -> str:
    return json.dumps(question, sort_keys=True)
