"""Code actions: a quick fix for each finding that has one, and all safe fixes of a file at once."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from lsprotocol.types import CodeAction
from lsprotocol.types import CodeActionKind
from lsprotocol.types import CodeActionParams
from pygls.uris import to_fs_path

from bringup_lint.finding import Applicability
from bringup_lint.fix import planned
from bringup_lint.server.analysis import Analysis
from bringup_lint.server.analysis import Found
from bringup_lint.server.diagnostics import diagnostic
from bringup_lint.server.edits import workspace_edit

FIX_ALL = "source.fixAll.bringup-lint"


def code_actions(analysis: Analysis, params: CodeActionParams) -> list[CodeAction]:
    """What can be done about the findings in a range, and about all of the file."""
    path = to_fs_path(params.text_document.uri) or ""
    source = analysis.source(path)
    if source is None:
        return []
    positions = analysis.positions(source)
    start, end = positions.offset(params.range.start), positions.offset(params.range.end)
    actions: list[CodeAction] = []
    if _wanted(CodeActionKind.QuickFix, params):
        for found in analysis.touching(path, start, end):
            actions += _quick_fix(analysis, found)
    if _wanted(FIX_ALL, params):
        actions += _fix_all(analysis, analysis.by_path.get(path, ()))
    return actions


def _wanted(kind: str, params: CodeActionParams) -> bool:
    """Whether an editor asks for a kind of action: for all kinds, for this one, or for one above it."""
    only = params.context.only
    return not only or any(kind == each or kind.startswith(f"{each}.") for each in map(str, map(_value, only)))


def _value(kind: CodeActionKind | str) -> str:
    return kind.value if isinstance(kind, CodeActionKind) else kind


def _quick_fix(analysis: Analysis, found: Found) -> Iterator[CodeAction]:
    finding, shown = found
    plan = planned([finding], unsafe=True)
    if not plan.changes or finding.fix is None or shown.fix is None:
        return
    safe = finding.fix.applicability is Applicability.SAFE
    yield CodeAction(
        title=shown.fix.title if safe else f"{shown.fix.title} (changes what the robot does)",
        kind=CodeActionKind.QuickFix,
        diagnostics=[diagnostic(analysis, found)],
        is_preferred=safe,
        edit=workspace_edit(analysis, plan.changes.values()),
    )


def _fix_all(analysis: Analysis, found: Iterable[Found]) -> Iterator[CodeAction]:
    """The safe fixes that can be applied together; others of them may follow with the next save."""
    plan = planned(each.finding for each in found)
    if plan.changes:
        yield CodeAction(
            title="Fix all that is safe to fix (bringup-lint)",
            kind=FIX_ALL,
            edit=workspace_edit(analysis, plan.changes.values()),
        )
