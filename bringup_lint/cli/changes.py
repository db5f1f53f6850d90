"""``--since`` and ``--changed``: the findings that changed files have a part in."""

from __future__ import annotations

import os
from collections.abc import Callable

from bringup_lint.cli.streams import complain
from bringup_lint.config import ConfigError
from bringup_lint.dataclass import replace
from bringup_lint.discover import disk
from bringup_lint.finding.reach import reached
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.engine import Outcome

Limit = Callable[["Outcome"], "Outcome"]


def changes_limit(since: str | None, changed_files: tuple[str, ...] | None) -> Limit:
    """What leaves out the findings that no change has a part in: none since a revision, none of these files. Raises
    ConfigError for an unknown revision."""
    limits = []
    if since:
        limits.append(_since(since))
    if changed_files is not None:
        limits.append(_files(changed_files))

    def limit(outcome: Outcome) -> Outcome:
        for each in limits:
            outcome = each(outcome)
        return outcome

    return limit


def _since(revision: str) -> Limit:
    from bringup_lint.discover.git_changes import Changes
    from bringup_lint.discover.git_changes import UnknownRevision

    try:
        changes = Changes(os.getcwd(), revision)
    except UnknownRevision as error:
        raise ConfigError(f"--since: {error}") from error
    if changes.note:
        complain(f"--since: {changes.note}")
    return lambda outcome: _only(outcome, changes.touched, changes.gone)


def _files(paths: tuple[str, ...]) -> Limit:
    named = {os.path.abspath(path) for path in paths}
    gone = {os.path.basename(path) for path in named if not disk.lexists(path)}
    return lambda outcome: _only(outcome, lambda name: os.path.abspath(name) in named, frozenset(gone))


def _only(outcome: Outcome, touched: Callable[[str], bool], gone: frozenset[str]) -> Outcome:
    shown = tuple(reached(outcome.findings, touched, gone))
    count = sum(finding.suppression is None for finding in outcome.findings)
    left = count - sum(finding.suppression is None for finding in shown)
    return replace(outcome, findings=shown, elsewhere=outcome.elsewhere + left)
