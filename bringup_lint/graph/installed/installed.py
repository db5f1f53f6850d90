"""The files that scripts write or copy to the robot, joined to the tree as what they become there."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from bringup_lint.discover.kinds import HEAD_SIZE
from bringup_lint.discover.kinds import kind_of
from bringup_lint.discover.tree import display_name
from bringup_lint.graph.files import Files
from bringup_lint.graph.installed.paths import destination
from bringup_lint.graph.installed.paths import in_tree
from bringup_lint.graph.installed.paths import robot_path
from bringup_lint.graph.installed.paths import role_of
from bringup_lint.graph.installed.provisioning import KINDS as PROVISIONING
from bringup_lint.graph.installed.provisioning import copies as copies_of
from bringup_lint.graph.installed.provisioning import written
from bringup_lint.graph.installed.script import Run
from bringup_lint.graph.installed.script import Written
from bringup_lint.graph.installed.scripts import KINDS
from bringup_lint.graph.installed.scripts import Scripts
from bringup_lint.graph.installed.text import Text
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.ansible import puts
from bringup_lint.pattern import regex
from bringup_lint.source import Origin
from bringup_lint.source import Source
from bringup_lint.templates import template_language

MOST_SCRIPTS = 500
MOST_FILES = 200
"""Files that one script may write."""
_MARKS = regex(r"/etc/|/systemd|/udev|/usr/l|\.config/|/opt/|sysctl|\.rules|\.service|<policy ")
"""What a script says that installs something."""
_ANYWHERE = frozenset({"sros2-policy"})
"""Kinds of files that count wherever a script writes them."""
_BY_LINE = frozenset({"sysctl", "udev-rules", "sudoers", "env-file", "limits-conf"})
"""Kinds of which every line speaks for itself, so that lines added to a file can be judged."""
_EXPANDING = frozenset({"shell-script", "env-file"})
"""Kinds that know variables themselves: what is not known in them cannot be told from what is wrong."""
_NOT_JOINED = regex(r"launch|python|params|package|cmake|authorized-keys|ssh-")
_COPIES = frozenset({"cp", "install", "ln", "mv", "rsync"})
_OF_SYSTEM = regex(r"/(?:etc|usr|lib|opt|srv|home|boot)/")
"""Where a script puts what the robot uses."""
_VALUED = {"install": ("-o", "-g", "-m", "-S"), "rsync": ("-e",), "cp": ("-S",), "mv": ("-S",), "ln": ("-S",)}


class Copy(NamedTuple):
    source: str
    target: str
    several: bool
    moves: bool


def join_installed(files: Files, scripts: Scripts) -> None:
    """Take in what the scripts of a repository write, and note where the files that they copy are on the robot. A root
    file system has the files themselves."""
    if files.tree.root is not None:
        return
    installing = [source for source in files.of_kind(*KINDS) if source.matches(_MARKS)][:MOST_SCRIPTS]
    known = {source.robot_path for source in files.sources}
    placed: dict[str, set[str]] = {}
    provisioning = [source for source in files.of_kind(*PROVISIONING) if source.matches(_MARKS)][:MOST_SCRIPTS]
    for script in (*installing, *provisioning):
        try:
            made, copies = _read(files, script, scripts) if script.kind in KINDS else _provisioned(files, script)
        except Exception as error:
            files.failures.append((script, error))
            continue
        files.installed.update(place for _, place in copies)
        for source in made:
            if source.robot_path is None or source.robot_path not in known:
                files.join(source)
        for path, place in copies:
            placed.setdefault(path, set()).add(place)
    _place(files, {path: next(iter(places)) for path, places in placed.items() if len(places) == 1})


def _read(files: Files, script: Source, scripts: Scripts) -> tuple[list[Source], list[tuple[str, str]]]:
    """The files that a script writes, and the paths of the tree that it copies, with their paths on the robot."""
    texts: dict[str, list[Written]] = {}
    copies: list[tuple[str, str]] = []
    for did in scripts.done(script):
        if isinstance(did, Written):
            if not did.refused:
                _write(texts, did)
        elif did.name in _COPIES:
            for copy in _copied(did):
                _copy(files, script, texts, copies, copy)
        elif did.name == "sed":
            _edit(texts, did)
    sources = [_source(files, script, path, written) for path, written in list(texts.items())[:MOST_FILES]]
    return [source for source in sources if source is not None], copies


def _provisioned(files: Files, source: Source) -> tuple[list[Source], list[tuple[str, str]]]:
    """The same for Ansible's tasks and cloud-init's user data."""
    texts: dict[str, list[Written]] = {}
    copies: list[tuple[str, str]] = []
    for put in next(iter(files.parsed(lambda each: list(puts(each)), [source])), []):
        did = written(put)
        if did is not None:
            _write(texts, did)
        copies += copies_of(put, files.tree, source)
    sources = [_source(files, source, path, found) for path, found in list(texts.items())[:MOST_FILES]]
    return [each for each in sources if each is not None], copies


def _write(texts: dict[str, list[Written]], did: Written) -> None:
    path = robot_path(did.path) or did.path
    if did.appends:
        texts.setdefault(path, []).append(did)
    elif path in texts and not did.certain:
        texts[path].append(did._replace(text=None))
    else:
        texts[path] = [did]


def _copied(run: Run) -> Iterator[Copy]:
    words = [run.text(word) for word in run.words[1:]]
    valued = _VALUED[run.name]
    plain = [
        word for at, word in enumerate(words) if not word.startswith("-") and (at == 0 or words[at - 1] not in valued)
    ]
    if run.name == "install" and any(re.fullmatch(r"-[a-zA-Z]*d[a-zA-Z]*", word) for word in words):
        return
    for each in plain[:-1]:
        yield Copy(each, plain[-1], len(plain) > 2 or "*" in each, run.name == "mv")


def _copy(
    files: Files, script: Source, texts: dict[str, list[Written]], copies: list[tuple[str, str]], copy: Copy
) -> None:
    own = robot_path(copy.source) or copy.source
    if own in texts:
        target = destination(copy.target, posixpath.basename(own), several=copy.several)
        if target is not None:
            texts[target] = texts[own]
        if copy.moves:
            del texts[own]
        return
    for path in in_tree(files.tree, copy.source, script):
        target = destination(copy.target, posixpath.basename(path), several=copy.several)
        if target is not None:
            copies.append((path, target))


def _edit(texts: dict[str, list[Written]], run: Run) -> None:
    """A file that sed changes afterwards is not what was written."""
    for word in run.words[1:]:
        path = run.text(word)
        path = robot_path(path) or path
        if path in texts:
            texts[path].append(texts[path][-1]._replace(text=None))


def _source(files: Files, script: Source, path: str, written: list[Written]) -> Source | None:
    if any(each.text is None for each in written):
        return None
    text = Text()
    for each in written:
        text.extend(each.text or Text())
    whole = str(text)
    is_nameless = path.endswith("}}") and whole.startswith("<")
    path = f"{path}.xml" if is_nameless else path
    kind = kind_of(path.lstrip("/"), lambda: whole[:HEAD_SIZE])
    if not kind or _NOT_JOINED.search(kind) or (written[0].appends and kind not in _BY_LINE):
        return None
    is_placed = path.startswith("/")
    if not is_placed and (kind not in _ANYWHERE or any(True for _ in files.tree.named(posixpath.basename(path)))):
        return None
    origin = Origin(
        written[0].where.span,
        text.pieces,
        certain=all(each.certain for each in written),
        verbatim=text.verbatim,
    )
    name = f"{script.name}:{path}"
    template = template_language(name, whole)
    if template and kind in _EXPANDING:
        files.tree.written.add(path)
        return None
    return Source(name, whole, kind, path if is_placed else None, script.judged, template, origin=origin)


def _place(files: Files, placed: dict[str, str]) -> None:
    """Note where files of the tree are on the robot; not where two files would be at one place."""
    rivals: dict[str, list[str]] = {}
    for path, place in placed.items():
        rivals.setdefault(place, []).append(path)
    by_name = {source.name: source for source in files.sources}
    for path, place in placed.items():
        source = by_name.get(display_name(path))
        if len(rivals[place]) > 1 and not (_is_unit(place) and _each_of_its_role(rivals[place])):
            continue
        if source is None:
            _claim(files, path, place)
        elif source.robot_path is None or (source.robot_path != place and _is_used_at(place, source)):
            files.tree.place(source, place)


def _is_used_at(place: str, source: Source) -> bool:
    """Whether a file means at a place what it means in the tree, so that it is no copy that is kept aside."""
    return bool(_OF_SYSTEM.match(place)) and kind_of(place.lstrip("/"), lambda: source.text[:HEAD_SIZE]) == source.kind


def _is_unit(place: str) -> bool:
    """Whether a file is of a kind that the folder it comes from keeps apart, not its place alone."""
    return kind_of(place.lstrip("/"), str) == "systemd-unit"


def _each_of_its_role(paths: list[str]) -> bool:
    """Whether every file belongs to another Ansible role: a robot gets one of them."""
    roles = {role_of(path) for path in paths} - {""}
    return len(roles) == len(paths)


def _claim(files: Files, path: str, place: str) -> None:
    """A file that only its place on the robot makes one of a kind."""
    kind = kind_of(place.lstrip("/"), lambda: files.tree.head(path, HEAD_SIZE))
    if not kind or _NOT_JOINED.search(kind) or kind == "shell-script":
        return
    source = files.tree.read(path, kind)
    if source is not None:
        source.robot_path = place
        files.join(source)
