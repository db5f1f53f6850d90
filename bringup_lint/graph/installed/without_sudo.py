"""What a script that is for a user does without sudo, and only root may do."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.graph.installed.script import Run
from bringup_lint.graph.installed.script import Written
from bringup_lint.graph.installed.scripts import Scripts
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_OF_ROOT = regex(r"/(?:etc|lib|boot|opt/ros|usr(?:/local)?/(?:s?bin|lib|share))/[^{}]*")
_TO_LAST = ("cp", "mv", "ln", "install")
_TO_ALL = ("tee", "mkdir", "touch", "rm", "rmdir", "chmod", "chown")
_FOR_ROOT = ("systemctl", "service", "usermod", "modprobe", "udevadm", "sysctl", "mount")
"""Programs that show as well that the script is for a user."""
_SERVICES = ("systemctl", "service")
_IN_PLACE = regex(r"-[a-zA-Z]*i[^\n]*|--in-place[^\n]*")
_GIVES_SCRIPT = regex(r"-[nrsuzE]*[ef]|--expression|--file")
_ASKS = regex(r"\b(?:if|elif|while|until)[ \t]+(?:![ \t]+)?\Z")
_PACKAGES = ("apt", "apt-get", "dpkg")
_CHANGES = ("install", "update", "upgrade", "full-upgrade", "dist-upgrade", "remove", "purge", "autoremove", "-i")
_MAY_BE_ROOT = regex(
    r"\bEUID\b|\bid[ \t]+-u\b|\bwhoami\b|\$\{?UID\b|\bSUDO_(?:USER|UID|GID)\b|\bsudo[ \t]+(?:-[isu]|su\b)"
    r"|^[ \t]*su\b|\blogname\b|\b(?:command -v|which|type)[ \t]+sudo\b"
    r"|\$\{?(?:USER|HOME)\}?[\"']?[ \t]*(?:==?|!=)[ \t]*[\"']?/?root",
    re.M,
)
"""The script asks who runs it, or becomes another user."""
_PAGE = regex(r"\.(?:md|rst|txt|mk)$|(?:^|/)(?:makefile|justfile)[^/]*$", re.I)
_MOST_OF_PAGE = 100_000
_GIVES = regex(r"\bsudo[ \t]+ch(?:own|mod)[ \t][^\n;&|]{0,200}?[ \t](?P<path>[\"']?/[^\s;&|]{2,200})")
_LEAST = 2
"""Commands with sudo that show that the script is for a user."""


class Unprivileged(NamedTuple):
    where: Located
    path: str
    """The file or folder; empty for the packages of the system."""


class ForUser(NamedTuple):
    source: Source
    with_sudo: Located
    """A command of the same kind that has sudo."""
    without: list[Unprivileged]


def without_sudo(scripts: Scripts) -> Iterator[ForUser]:
    """The scripts that use sudo for what only root may do, and forget it elsewhere."""
    for source in scripts.files.of_kind("shell-script"):
        if source.judged and "sudo " in source.text and not _MAY_BE_ROOT.search(source.uncommented):
            found = _forgotten(scripts, source)
            if found is not None and not _is_run_by_root(scripts, source):
                yield found


def _forgotten(scripts: Scripts, source: Source) -> ForUser | None:
    with_sudo: list[Located] = []
    without: list[Unprivileged] = []
    done = scripts.done(source)
    plain = any(isinstance(did, Run) and did.name in _SERVICES and not did.by_root for did in done)
    refused_elsewhere = {did.where.span for did in done if isinstance(did, Written) and did.refused}
    for did in done:
        if isinstance(did, Written):
            refused = not did.refused and did.by_shell and _OF_ROOT.match(did.path) is not None
            without += [Unprivileged(did.where, did.path)] if refused else []
            continue
        path = _changed(did)
        if did.by_root and (path is not None or did.name in _FOR_ROOT):
            with_sudo.append(did.words[0])
        elif path is None or _may_fail(did) or (did.name == "sed" and plain):
            continue
        elif refused_elsewhere.isdisjoint(word.span for word in did.words):
            without.append(Unprivileged(did.words[0], path))
    paths = {each.path for each in without if each.path}
    asked = [did for did in done if isinstance(did, Run) and did.by_root and did.name not in _FOR_ROOT]
    with_sudo += [
        did.words[0] for did in asked if _changed(did) is None and not paths.isdisjoint(map(did.text, did.words))
    ]
    given = _given_away(source) if without else ()
    without = [each for each in without if not each.path.startswith(given)]
    if len(with_sudo) < _LEAST or not without:
        return None
    return ForUser(source, with_sudo[0], without)


def _given_away(source: Source) -> tuple[str, ...]:
    """The files and folders that the script gives to its user."""
    return tuple({match["path"].strip("\"'").rstrip("/") for match in _GIVES.finditer(source.text)})


def _changed(run: Run) -> str | None:
    """The first path of the system that a command changes; empty for packages; None when it changes nothing there."""
    named = [word for word in run.words[1:] if not word.startswith("-")]
    if run.name in _PACKAGES:
        return "" if any(word in _CHANGES for word in run.words[1:]) else None
    if run.name == "sed":
        changed = _edited(run) if any(map(_IN_PLACE.fullmatch, run.words[1:])) else []
    else:
        changed = named[-1:] if run.name in _TO_LAST else named if run.name in _TO_ALL else []
    return next((path for path in map(run.text, changed) if _OF_ROOT.match(path)), None)


def _edited(run: Run) -> list[Located]:
    """The files of sed: all words that are neither an option nor a script."""
    words = run.words[1:]
    given = [index + 1 for index, word in enumerate(words) if _GIVES_SCRIPT.fullmatch(word)]
    found = [word for index, word in enumerate(words) if index not in given and not word.startswith("-")]
    has_script = bool(given) or any(word.startswith(("-e", "--expression=", "--file=")) for word in words)
    return found if has_script else found[1:]


def _may_fail(run: Run) -> bool:
    """Whether a failure is expected."""
    span = run.words[0].span
    is_asked = _ASKS.search(span.source.line_before(span.start)) is not None
    return is_asked or run.command.hides_errors or run.command.ends == "||"


def _is_run_by_root(scripts: Scripts, source: Source) -> bool:
    """Whether an image takes the script, or something of the tree starts it with sudo, or as a service."""
    if scripts.is_for_image(source) or scripts.starts_by_itself(source):
        return True
    started = re.compile(rf"\bsudo\b[^\n|;&]{{0,80}}(?<![\w-]){re.escape(source.basename)}\b")
    pages = scripts.files.tree.pages(_PAGE, _MOST_OF_PAGE)
    return any(started.search(each.text) for each in scripts.files.sources) or any(map(started.search, pages))
