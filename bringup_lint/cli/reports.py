"""The reports of a run: their formats, and where they go."""

from __future__ import annotations

from collections.abc import Iterable

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path


class Output(NamedTuple):
    """One report: its format, and the file it goes to (None: standard output)."""

    format: str
    file: Path | None


def write(text: str, file: Path | None) -> None:
    """Write a report whole, or not at all. Raises NotWritten."""
    from bringup_lint.cli.streams import put
    from bringup_lint.writing import replace

    if file is None:
        put(text)
        return
    replace(file, text.encode("utf-8", "replace"))


def write_pieces(pieces: Iterable[str], file: Path | None) -> None:
    """Write a report that need not fit into memory. Raises NotWritten."""
    from bringup_lint.cli.streams import put_all
    from bringup_lint.writing import replace

    if file is None:
        put_all(pieces)
        return
    replace(file, (piece.encode("utf-8", "replace") for piece in pieces))
