"""Baselines: findings that are known and are not reported again."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.finding import Finding
from bringup_lint.finding.uri import below_root
from bringup_lint.named_tuple import NamedTuple

VERSION = 1


class BaselineError(ValueError):
    """The baseline file is not one, or comes from a newer version."""


class Entry(NamedTuple):
    """A finding in a baseline; it holds no line number, and no secret."""

    path: str
    """Relative to the root of the tree."""
    rule: str
    message: str
    fingerprint: str


class Sifted(NamedTuple):
    """Findings compared with a baseline."""

    new: tuple[Finding, ...]
    known: tuple[Finding, ...]
    gone: tuple[Entry, ...]
    """The entries of the baseline that no finding matches any more."""


def entries_of(findings: Iterable[Finding], root: str, cwd: str = "") -> Iterator[Entry]:
    """The entries for presented findings; there is none for a suppressed one."""
    for finding in findings:
        if finding.suppression is None:
            yield Entry(
                path_of(finding.source.name, root, cwd), finding.rule, _text(finding.message), finding.fingerprint
            )


def path_of(name: str, root: str, cwd: str = "") -> str:
    """The path by which an entry names a file."""
    return _text(below_root(name, root, cwd))


def written(entries: Iterable[Entry]) -> str:
    """The text of a baseline file."""
    import json

    findings = [entry._asdict() for entry in sorted(entries)]
    return json.dumps({"version": VERSION, "findings": findings}, indent=2) + "\n"


def read(text: str) -> tuple[Entry, ...]:
    """The entries of a baseline file.

    Raises BaselineError with one clear line when the text is not a baseline of a known version.
    """
    import json

    try:
        content = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise BaselineError(f"not a baseline: {error}") from error
    if not isinstance(content, dict) or "version" not in content:
        raise BaselineError("not a baseline: it has no version")
    if content["version"] != VERSION:
        raise BaselineError(f"baseline of version {content['version']}; this program reads {VERSION}")
    try:
        return tuple(_entry(item) for item in content["findings"])
    except (AttributeError, KeyError, TypeError) as error:
        raise BaselineError("not a baseline: findings without fingerprints") from error


def sift(findings: Iterable[Finding], known: Iterable[Entry]) -> Sifted:
    """Split presented findings into new ones and those that the baseline knows."""
    findings, known = tuple(findings), tuple(known)
    fingerprints = {entry.fingerprint for entry in known}
    new = tuple(finding for finding in findings if finding.fingerprint not in fingerprints)
    old = tuple(finding for finding in findings if finding.fingerprint in fingerprints)
    found = {finding.fingerprint for finding in findings}
    return Sifted(new, old, tuple(entry for entry in known if entry.fingerprint not in found))


def _entry(item: dict[str, object]) -> Entry:
    path, rule, message = (str(item.get(key, "")) for key in ("path", "rule", "message"))
    return Entry(path, rule, message, str(item["fingerprint"]))


def _text(text: str) -> str:
    return text.encode("utf-8", "replace").decode()
