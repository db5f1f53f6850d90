"""``sed -i`` of scripts and Dockerfiles on files of the tree that lack what it looks for."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.installed.paths import in_tree
from bringup_lint.graph.installed.script import Written
from bringup_lint.graph.runners.containers import copied
from bringup_lint.graph.runners.containers import in_image
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.dockerfile import commands_of_run
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.installed.scripts import Scripts
    from bringup_lint.model.dockerfile import Dockerfile
    from bringup_lint.model.dockerfile import Stage
    from bringup_lint.model.shell import Command

_REPLACES = regex(
    r"s(?P<mark>[|/#,:;!@])(?P<old>(?:\\.|(?!(?P=mark))[^\\\n])+)(?P=mark)(?P<new>(?:\\.|(?!(?P=mark))[^\\\n])*)(?P=mark)[gIi0-9]*"
)
_IN_PLACE = regex(r"-[nErsz]*i.*|--in-place.*")
_LEAST = 3
_LONGEST = 300
"""Characters of a text that is looked for."""
_SIMPLE = regex(r"[\w \-@%<>:/=,_\"';!#&~]")
_FETCHES = regex(
    r"\b(?:curl|wget|clone|scp|rsync|unzip|tar|git|popd|pushd|mktemp)\b|^[ \t]*cd[ \t]+(?!.*dirname)", re.M
)
"""What says that a script may work on files that are not those of the tree, or elsewhere."""


class LostEdit(NamedTuple):
    old: Located
    """What is looked for."""
    file: Source


def lost_edits(files: Files, scripts: Scripts, dockerfiles: Iterable[Dockerfile]) -> Iterator[LostEdit]:
    """The replacements in files of the tree that find nothing there, though nothing else changes these files first."""
    written: dict[Source, frozenset[str]] = {}
    for source, run in scripts.run("sed"):
        if source.origin is None and run.certain:
            for old, new, paths in _replacements(run.words[1:]):
                for path in paths:
                    file = _named(files, source, run.text(path))
                    if source not in written:
                        written[source] = _written(scripts, source)
                    if file is None or file.basename in written[source] or source.text.count(str(old)) > 1:
                        continue
                    if _lacks(file, old, run.text(new)):
                        yield LostEdit(old, file)
    for dockerfile in dockerfiles:
        if dockerfile.source.judged:
            for stage in dockerfile.stages:
                yield from _of_stage(files, stage)


def _of_stage(files: Files, stage: Stage) -> Iterator[LostEdit]:
    commands = [command for each in stage.all("RUN") for command in commands_of_run(each)]
    edits = [
        (old, new, str(path))
        for words in map(unwrapped, (command.words for command in commands))
        if words and words[0] == "sed"
        for old, new, paths in _replacements(words[1:])
        for path in paths
        if "$" not in path
    ]
    places = {path: in_image(stage, path) for path in dict.fromkeys(path for _, _, path in edits)}
    copies = {path: copied(files, stage, place) for path, place in places.items() if place}
    names = {file.basename for file in copies.values() if file is not None}
    known = {name: _known(commands, name) for name in names}
    for old, new, path in edits:
        file = copies.get(path)
        if file is not None and (text := known[file.basename]) is not None:
            if text.count(old) < 2 and _lacks(file, old, new):
                yield LostEdit(old, file)


def _known(commands: Iterable[Command], name: str) -> str | None:
    """What the commands that name a file hold, a line for each; None when one of them writes what is not known. A text
    that is there twice is known to another command, too."""
    lines = []
    for command in commands:
        if any(each.writes and each.target is not None and name in each.target for each in command.redirects):
            return None
        if any(name in word for word in command.words):
            lines.append(" ".join(command.words))
    return "\n".join(lines)


def _replacements(words: Iterable[Located]) -> Iterator[tuple[Located, Located, list[Located]]]:
    """The texts that ``sed -i`` looks for, each with what it puts there, and the files that it changes."""
    plain: list[Located] = []
    scripts: list[Located] = []
    is_in_place = False
    rest = iter(words)
    for word in rest:
        if word in ("-e", "--expression"):
            scripts += [each for each in [next(rest, None)] if each is not None]
        elif word.startswith("-"):
            is_in_place |= _IN_PLACE.fullmatch(word) is not None
        else:
            plain.append(word)
    if not is_in_place:
        return
    if not scripts:
        scripts, plain = plain[:1], plain[1:]
    for script in scripts:
        found = _REPLACES.fullmatch(script)
        if found is not None:
            yield script.part(*found.span("old")), script.part(*found.span("new")), plain


def _named(files: Files, script: Source, path: str) -> Source | None:
    """The file of the tree that a path in a script means."""
    if path.startswith("/"):
        file = _in_overlay(files, script, path) or files.find(path, script)
        return file if file is not None and file.origin is None and not file.template else None
    if script.matches(_FETCHES) or "*" in path:
        return None
    found = list(in_tree(files.tree, path, script))
    return files.tree.at(found[0]) if len(found) == 1 else None


def _in_overlay(files: Files, script: Source, path: str) -> Source | None:
    """The file at a path of the same overlay: of the folder that holds the script where it will be on the robot."""
    place = files.tree.robot_path(script.absolute) or ""
    beside = script.absolute.removesuffix(place) + path
    return files.tree.at(beside) if place and script.absolute.endswith(place) and files.tree.is_file(beside) else None


def _written(scripts: Scripts, script: Source) -> frozenset[str]:
    """The names of the files that the script writes."""
    return frozenset(posixpath.basename(did.path) for did in scripts.done(script) if isinstance(did, Written))


def _lacks(file: Source, old: str, new: str) -> bool:
    """Whether a file has no line that a replacement is for, and none as it is afterwards."""
    pattern = _pattern(old)
    if pattern is None or not file.text or re.search(pattern, file.text, re.M):
        return False
    done = re.sub(r"\\(\W)", r"\1", new)
    return _is_short(done) or re.search(rf"(?:\b|(?=\W)){re.escape(done)}(?:\b|(?<=\W))", file.text) is None


def _is_short(text: str) -> bool:
    """Whether a text has too few letters to say that it is found."""
    return len(re.sub(r"\W", "", text)) < _LEAST


def _pattern(old: str) -> str | None:
    """The expression of Python for one of sed that holds little more than plain text. At the start or the end
    a ``.*`` says nothing; with one between, it could take long on long lines."""
    bare = (old.removeprefix("^") if old.startswith("^.*") else old).removeprefix(".*")
    bare = bare if bare.endswith("\\.*") else bare.removesuffix(".*")
    parts: list[str] = []
    for token in re.findall(r"\\.|\.\*|.", bare):
        if _SIMPLE.fullmatch(token):
            parts.append(re.escape(token))
        elif re.fullmatch(r"\\[./|#,:;!@\"'-]", token):
            parts.append(re.escape(token[1:]))
        elif token == "." or (token == "^" and not parts):
            parts.append(token)
        else:
            return None
    return None if _is_short(old) or len(parts) > _LONGEST else "".join(parts)
