"""The answer to a command line: found again, or kept.

An entry is a list of texts between NULs, which no path and no report holds. To load a reader of JSON, with its
patterns, would take longer than to look at all files of a robot.

An entry holds what the run said, which is masked as every report is, and everything that it looked at. It is data that
is read strictly, and sealed with a key that only this folder has: what is damaged, or comes from elsewhere, is no
answer.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.cache.folder import Folder
from bringup_lint.cache.folder import opened
from bringup_lint.cache.program import program
from bringup_lint.digest import blake2b
from bringup_lint.discover.record import Record
from bringup_lint.discover.record import stamp_of

TYPE_CHECKING = False  # an answer is given before typing is loaded
if TYPE_CHECKING:
    from bringup_lint.type_names import Any

_FORMAT = b"bringup-lint answer 2\n"
_SEAL = 32
_END = "\0"
_ENCODING = ("utf-8", "surrogateescape")
"""Names of files may hold bytes that are no text."""
_PARTS = 4
"""Of a look."""
_TEXTS = ("name", "program", "text", "said")


class Answer:
    """What a run said, and how it ended."""

    def __init__(self, text: str, said: str, code: int):
        self.text = text
        """On standard output."""
        self.said = said
        """On standard error, with its line ends."""
        self.code = code


class Question:
    """A command line, with all of its surroundings that no file tells."""

    def __init__(self, words: Iterable[str], *, by_content: bool = False):
        """``words`` are everything that decides over the answer and does not lie on the disk."""
        self.by_content = by_content
        asked = os.fsencode(_END.join([str(by_content), *words]))
        self._name = blake2b(asked, digest_size=16).hexdigest()
        self._program = ""

    def answer(self) -> Answer | None:
        """The answer of an earlier run, if that would be the answer now."""
        with opened(create=False) as folder:
            return self._found(folder) if folder else None

    def _found(self, folder: Folder) -> Answer | None:
        data, key = folder.read(self._name), folder.key()
        entry = data and key and _unsealed(data, key)
        if not entry or entry["name"] != self._name or entry["program"] != self.started():
            return None
        seen = entry["seen"]
        now = list(self._as_before(seen))
        if len(now) < len(seen):
            return None
        if now != seen and key:
            folder.write(self._name, _sealed({**entry, "seen": now}, key))
        return Answer(entry["text"], entry["said"], entry["code"])

    def keep(self, answer: Answer, record: Record) -> None:
        """Keep the answer of this run, which looked at what is recorded."""
        if not record.is_whole or not _is_text(answer) or program(by_content=self.by_content) != self.started():
            return
        with opened(create=True) as folder:
            if folder and (key := folder.key()):
                entry = {"name": self._name, "program": self._program, "seen": list(record), **vars(answer)}
                folder.write(self._name, _sealed(entry, key))
                folder.tidy()

    def started(self) -> str:
        """The program that answers, as it is when that is first asked: before it loads the rules."""
        self._program = self._program or program(by_content=self.by_content)
        return self._program

    def _as_before(self, seen: Iterable[list[str]]) -> Iterator[list[str]]:
        """The looks with their stamps of now, up to the first that would show something else."""
        for look in seen:
            question, path, stamp, fact = look
            now = "" if self.by_content else stamp_of(question, path)
            if not now or now != stamp:
                from bringup_lint.discover.again import fact_now

                if fact_now(question, path) != fact:
                    return
                look = [question, path, now or stamp, fact]
            yield look


def _is_text(answer: Answer) -> bool:
    """Whether it can be written as it is: names of files may hold bytes that no encoding has."""
    try:
        (answer.text + answer.said).encode("utf-8")
    except UnicodeEncodeError:
        return False
    return _END not in answer.text + answer.said


def _sealed(entry: dict[str, Any], key: bytes) -> bytes:
    looks = (part for look in entry["seen"] for part in look)
    body = _END.join([*(entry[name] for name in _TEXTS), str(entry["code"]), *looks]).encode(*_ENCODING)
    return _FORMAT + blake2b(body, key=key, digest_size=_SEAL).digest() + body


def _unsealed(data: bytes, key: bytes) -> dict[str, Any] | None:
    """The entry; None for anything that this program did not write here."""
    start = len(_FORMAT) + _SEAL
    body = data[start:]
    if not data.startswith(_FORMAT) or blake2b(body, key=key, digest_size=_SEAL).digest() != data[len(_FORMAT) : start]:
        return None
    return _entry(body)


def _entry(body: bytes) -> dict[str, Any] | None:
    """What a body says; None where it lacks a part."""
    try:
        name, program, text, said, code, *looks = body.decode(*_ENCODING).split(_END)
    except ValueError:
        return None
    if code not in ("0", "1") or len(looks) % _PARTS:
        return None
    seen = [looks[at : at + _PARTS] for at in range(0, len(looks), _PARTS)]
    return {"name": name, "program": program, "text": text, "said": said, "code": int(code), "seen": seen}
