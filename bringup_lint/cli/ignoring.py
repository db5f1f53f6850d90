"""``--add-ignores``: comments that silence what is there, and entries of the configuration where a format has none."""

from __future__ import annotations

import json
import os
from collections import defaultdict
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from bringup_lint.cli.reporting import known_to
from bringup_lint.cli.streams import complain
from bringup_lint.cli.streams import say
from bringup_lint.config import FILE_NAME
from bringup_lint.config import Config
from bringup_lint.discover.gitignore import escaped
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.fix import Changes
from bringup_lint.fix import save
from bringup_lint.fix import writable
from bringup_lint.plural import counted
from bringup_lint.source import Source
from bringup_lint.suppress.placing import comments
from bringup_lint.toml import holds
from bringup_lint.toml import quoted
from bringup_lint.toml import read_toml
from bringup_lint.writing import NotWritten
from bringup_lint.writing import correct
from bringup_lint.writing import create

if TYPE_CHECKING:
    from bringup_lint.engine import Outcome
    from bringup_lint.robot import Robot

Checked = Callable[[], "tuple[Robot, Outcome]"]
Places = dict[Source, list[Finding]]
_TABLE = "per-file-ignores"


def add_ignores(robot: Robot, outcome: Outcome, checked: Checked, config: Config, reason: str) -> int:
    """Write the suppressions and say where; the exit code: 2 when something could not be written."""
    if outcome.failures:
        complain("--add-ignores: a rule or parser failed inside, so nothing was written")
        return 3
    places = _by_source(_new(robot, outcome, config))
    changes = _commented(places, reason, checked)
    commented = {change.source for change in changes}
    failures = save(changes)
    unwritten = {failure.path for failure in failures}
    written = [change.source for change in changes if Path(change.source.name) not in unwritten]
    left = {source: found for source, found in places.items() if source not in commented}
    _tell(written, places, "by comments")
    failures += _configured(left, config, reason)
    for failure in failures:
        complain(f"not written: {failure}")
    return 2 if failures else 0


def _new(robot: Robot, outcome: Outcome, config: Config) -> Iterator[Finding]:
    """The findings that nothing silences, and those on copies of their lines."""
    from bringup_lint.finding.presented import presented

    known, cwd = known_to(config), os.getcwd()
    shown = presented(outcome.findings, robot.tree.root or cwd, cwd).findings
    for found, named in zip(outcome.findings, shown):
        if found.suppression is None and named.fingerprint not in known:
            yield from (found, *found.copies)


def _by_source(findings: Iterable[Finding]) -> Places:
    """The findings of each file, also where the file was read as two kinds."""
    places: Places = defaultdict(list)
    first: dict[str, Source] = {}
    for found in findings:
        places[first.setdefault(found.source.name, found.source)].append(found)
    return places


def _commented(places: Places, reason: str, checked: Checked) -> list[Changes]:
    """The files with their comments: those in which the comments silence everything."""
    from bringup_lint.discover.reading import proposed

    changes = [Changes(source, _edits(source, found, reason)) for source, found in places.items()]
    changes = [change for change in changes if change.edits]
    texts = {os.path.abspath(change.source.name): change.new_text().encode("utf-8") for change in changes}
    with proposed(texts):
        _, outcome = checked()
    loud = {found.source.name for found in outcome.findings if found.suppression is None}
    return [change for change in changes if change.source.name not in loud]


def _edits(source: Source, findings: list[Finding], reason: str) -> list[Edit]:
    if not writable(source) or source.origin is not None:
        return []
    return comments(source, ((found.span, found.rule) for found in findings), reason)


def _tell(sources: Iterable[Source], places: Places, how: str) -> None:
    sources = list(sources)
    if sources:
        findings = [found for source in sources for found in places[source]]
        copies = _on_copies(places)
        again = sum(id(found) in copies for found in findings)
        also = f" ({again} of them on copies of lines, which a report counts once)" if again else ""
        say(f"Suppressed {counted(len(findings), 'finding')}{also} in {counted(len(sources), 'file')} {how}.")


def _on_copies(places: Places) -> set[int]:
    return {id(copy) for findings in places.values() for found in findings for copy in found.copies}


def _configured(places: Places, config: Config, reason: str) -> tuple[NotWritten, ...]:
    """Write entries of ``[per-file-ignores]`` for files; why that could not be done."""
    if not places:
        return ()
    path = Path(os.path.relpath(config.path or FILE_NAME))
    entries = {
        f"/{escaped(os.path.relpath(source.name, config.folder))}": {found.rule for found in findings}
        for source, findings in places.items()
    }
    try:
        _write_entries(path, config, entries, reason)
    except NotWritten as failure:
        return (failure,)
    _tell(places, places, f"by [{_TABLE}] of {path}")
    return ()


def _write_entries(path: Path, config: Config, entries: dict[str, set[str]], reason: str) -> None:
    if outside := [pattern for pattern in entries if pattern.startswith("/../")]:
        raise NotWritten(path, f"{outside[0][1:]} is not below its folder")
    if not all(map(holds, entries)):
        raise NotWritten(path, f"TOML cannot hold a name that is not UTF-8, for [{_TABLE}]")
    lines = [f"{quoted(pattern)} = {json.dumps(sorted(entries[pattern]))}" for pattern in entries]
    text = with_entries(config.text, [f"# {reason}", *sorted(lines)], inside=path.name == "pyproject.toml")
    try:
        read_toml(text)
    except ValueError as error:
        raise NotWritten(path, f"add to [{_TABLE}] yourself: {'; '.join(lines)}") from error
    if config.path is None:
        create(path, text.encode("utf-8"))
    else:
        correct(path, config.text.encode("utf-8"), text.encode("utf-8"))


def with_entries(text: str, lines: list[str], *, inside: bool) -> str:
    """A configuration with further lines in its table of files; ``inside`` a ``pyproject.toml``."""
    header = f"[tool.bringup-lint.{_TABLE}]" if inside else f"[{_TABLE}]"
    before = text.split("\n")
    at = next((number for number, line in enumerate(before) if line.strip() == header), None)
    if at is None:
        return f"{text.rstrip()}\n\n".lstrip("\n") + "\n".join([header, *lines]) + "\n"
    return "\n".join([*before[: at + 1], *lines, *before[at + 1 :]])
