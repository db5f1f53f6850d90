"""Standard output and standard error: whatever they are, nothing fails, and no file drives a terminal."""

from __future__ import annotations

import codecs
import sys

import click

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


def prepare() -> None:
    """Let standard output take every character: what its encoding lacks is written in ASCII."""
    codecs.register_error(_HANDLER, _in_ascii)
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors=_HANDLER)


def complain(message: object) -> None:
    """A line on standard error that names the program."""
    say(f"bringup-lint: {message}")


def say(message: object) -> None:
    """A line on standard error, without control characters of the tree."""
    click.echo(plain(str(message)), err=True)


def overwrite(line: str) -> None:
    """A line on the terminal in place of the one before it; an empty one takes that away."""
    click.echo(f"\r{plain(line)}\x1b[K", nl=False, err=True)


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
