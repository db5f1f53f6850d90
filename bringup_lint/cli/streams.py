"""Standard output and standard error: whatever they are, nothing fails, and no file drives a terminal."""

from __future__ import annotations

import codecs
import contextlib
import errno
import os
import sys
from collections.abc import Iterable

_PLAIN = str.maketrans(
    {
        "…": "...",
        "×": "x",
        "→": "->",
        "←": "<-",
        "≥": ">=",
        "≤": "<=",
        "–": "-",
        "—": "-",
        "·": "-",
        "µ": "u",
        "“": '"',
        "”": '"',
        "‘": "'",
        "’": "'",
        "│": "|",
        "─": "-",
    }
)
_HANDLER = "bringup-lint-plain"
_OF_STREAMS = frozenset((errno.EPIPE, errno.ENOSPC, errno.EBADF, errno.EIO, errno.EFBIG))


def prepare() -> None:
    """Let standard output take every character: what its encoding lacks is written in ASCII."""
    codecs.register_error(_HANDLER, _in_ascii)
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors=_HANDLER)


said: list[str] = []
"""The lines on standard error so far."""
written: list[str] = []
"""The reports on standard output so far."""


def complain(message: object) -> None:
    """A line on standard error that names the program, and holds no secret of what it quotes."""
    say(f"bringup-lint: {_masked(str(message))}")


def _masked(message: str) -> str:
    from bringup_lint.finding.redact import mask_of
    from bringup_lint.source import Source

    source = Source("message", message)
    mask = mask_of((), (source,))
    return mask.source(source).text if mask else message


def say(message: object) -> None:
    """A line on standard error, without control characters of the tree."""
    line = plain(str(message)) + "\n"
    said.append(line)
    repeat(line)


def repeat(lines: str) -> None:
    """Text as it is, on standard error: what was said before."""
    if sys.stderr is not None:
        with contextlib.suppress(OSError, ValueError):
            sys.stderr.write(lines)
            sys.stderr.flush()


def put(text: str) -> None:
    """Write a report to standard output. Raises NotWritten."""
    written.append(text)
    put_all([text])


def put_all(pieces: Iterable[str]) -> None:
    """Write the pieces of a report to standard output. Raises NotWritten."""
    if sys.stdout is None:
        raise _not_written("it is closed")
    try:
        sys.stdout.writelines(pieces)
        sys.stdout.flush()
    except BrokenPipeError:
        _let_go()
    except OSError as error:
        _let_go()
        raise _not_written(error) from error


def lost(error: OSError) -> int:
    """The exit code where standard output takes nothing more: nobody reads on, or a line says why."""
    _let_go()
    if isinstance(error, BrokenPipeError):
        return 0
    complain(_not_written(error))
    return 2


def is_of_stream(error: OSError) -> bool:
    """Whether an error is of a stream, which has no name, and not of a file."""
    return error.filename is None and error.errno in _OF_STREAMS


def _not_written(why: str | Exception) -> Exception:
    from pathlib import Path

    from bringup_lint.writing import NotWritten

    return NotWritten(Path("standard output"), why)


def _let_go() -> None:
    """Nobody reads on: what is left in the buffer must not fail once more at the end."""
    with contextlib.suppress(OSError, ValueError):
        nothing = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nothing, sys.stdout.fileno())
        os.close(nothing)


def overwrite(line: str) -> None:
    """A line on the terminal in place of the one before it; an empty one takes that away."""
    repeat(f"\r{plain(line)}\x1b[K")


def plain(message: str) -> str:
    """The text with signs for control characters."""
    from bringup_lint.report.columns import printable

    return "\n".join(map(printable, message.split("\n")))


def _in_ascii(error: UnicodeError) -> tuple[str, int]:
    """What looks alike, else the escape that JSON and Python know."""
    assert isinstance(error, UnicodeEncodeError)
    text = error.object[error.start : error.end].translate(_PLAIN)
    return "".join(char if char.isascii() else _escaped(char) for char in text), error.end


def _escaped(char: str) -> str:
    units = char.encode("utf-16-be", "surrogatepass").hex()
    return "".join(f"\\u{units[at : at + 4]}" for at in range(0, len(units), 4))
