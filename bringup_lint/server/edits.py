"""Changes of files as edits of the protocol."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import takewhile

from lsprotocol.types import OptionalVersionedTextDocumentIdentifier
from lsprotocol.types import TextDocumentEdit
from lsprotocol.types import TextEdit
from lsprotocol.types import WorkspaceEdit

from bringup_lint.fix import Changes
from bringup_lint.fix import rewritten
from bringup_lint.server.analysis import Analysis


def workspace_edit(analysis: Analysis, changes: Iterable[Changes]) -> WorkspaceEdit:
    """The changes of files, each for the version of the document that was judged."""
    documents = []
    for change in changes:
        uri = analysis.uri(change.source)
        identifier = OptionalVersionedTextDocumentIdentifier(uri=uri, version=analysis.version(change.source))
        documents.append(TextDocumentEdit(text_document=identifier, edits=text_edits(analysis, change)))
    return WorkspaceEdit(document_changes=documents)


def text_edits(analysis: Analysis, change: Changes) -> list[TextEdit]:
    """The edits of one file, in the order of their places, with the line ends of the file."""
    source = change.source
    if change.text is not None:
        return [_difference(analysis, change)]
    crlf = source.text.count("\r\n") * 2 > source.text.count("\n")
    return [
        TextEdit(analysis.range(edit.span), rewritten("\r\n" if crlf else "", [edit._replace(span=source.span(0, 0))]))
        for edit in sorted(change.edits, key=lambda edit: (edit.span.start, edit.span.end))
    ]


def _difference(analysis: Analysis, change: Changes) -> TextEdit:
    """The stretch in which two texts differ."""
    old, new = change.source.text, change.new_text()
    start = _common(old, new)
    end = _common(old[start:][::-1], new[start:][::-1])
    span = change.source.span(start, len(old) - end)
    return TextEdit(analysis.range(span), new[start : len(new) - end])


def _common(one: str, other: str) -> int:
    """How many characters two texts begin with together."""
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(one, other)))
