"""Changes to unit files that several rules offer: take a line out, move it to another section, lift a comment."""

from __future__ import annotations

from bringup_lint.finding import Edit
from bringup_lint.model.unit import Assignment
from bringup_lint.model.unit import UnitFile
from bringup_lint.source import Located
from bringup_lint.source import Span


def whole_lines(span: Span) -> Span:
    """The lines that a span is on, the last line end included."""
    text = span.source.text
    start = text.rfind("\n", 0, span.start) + 1
    end = text.find("\n", max(span.end - 1, span.start))
    return Span(span.source, start, len(text) if end == -1 else end + 1)


def delete_lines(assignment: Assignment) -> Edit:
    return Edit(whole_lines(assignment.span), "")


def move_lines(file: UnitFile, assignment: Assignment, section: str, text: str | None = None) -> tuple[Edit, ...]:
    """Take an assignment out and put it (or ``text``) at the end of a section, which is made where it is missing."""
    lines = whole_lines(assignment.span)
    moved = (text + "\n") if text is not None else lines.text if lines.text.endswith("\n") else lines.text + "\n"
    source = file.source
    homes = [found for found in file.sections if found.name == section]
    if homes:
        at = homes[-1].end
        lead = "" if at == 0 or source.text[at - 1] == "\n" else "\n"
        return (Edit(lines, ""), Edit(source.span(at, at), lead + moved))
    if section == "Install":
        end = len(source.text)
        lead = "" if source.text.endswith("\n") and lines.end < end else "\n"
        if lines.end == end:
            return (Edit(lines, f"\n[Install]\n{moved}"),)
        return (Edit(lines, ""), Edit(source.span(end, end), f"{lead}\n[Install]\n{moved}"))
    at = whole_lines(file.sections[0].header).start
    return (Edit(source.span(at, at), f"[{section}]\n{moved}\n"), Edit(lines, ""))


def lift_comment(assignment: Assignment, comment: Located) -> tuple[Edit, ...]:
    """Put what was meant as a comment on a line of its own above the assignment."""
    source = assignment.span.source
    start = whole_lines(assignment.span).start
    kept = len(assignment.value) - len(comment)
    before = assignment.value.part(0, kept).rstrip()
    cut = assignment.value.origin(len(before)) if before else comment.span.start
    text = comment if comment.startswith("#") else f"# {comment.lstrip('; ')}"
    return (
        Edit(source.span(start, start), f"{text}\n"),
        Edit(source.span(cut, comment.span.end), ""),
    )
