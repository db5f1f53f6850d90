"""The ssh commands of scripts: where they log in, and the ports that they forward."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.parsers.arithmetic import evaluate
from bringup_lint.parsers.shell import shell_commands
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_LOGIN = regex(r"([A-Za-z_][\w.-]*)@([\w.-]+|\[[\w:.]+\])(?::.*)?")
_FORGES = regex(r"git(?:hub|lab)?\b|bitbucket")
_FORWARD = regex(r"(?:[^:]*:)?(?P<port>[^:]+):(?P<host>[^:]+):(?P<remote>[^:]+)\Z")
Forward = tuple[Source, int, Located]


def ssh_logins(files: Files) -> Iterator[tuple[str, Located, str | None]]:
    """``ssh USER@HOST`` and scp in scripts: the user, the word, and the port when it is known."""
    for source in files.of_kind("shell-script"):
        if "@" not in source.text or not source.judged:
            continue
        for command in shell_commands(source):
            if command.name not in ("ssh", "scp", "sftp", "autossh", "ssh-copy-id"):
                continue
            for word in command.words[1:]:
                found = _LOGIN.fullmatch(word)
                if found and not _FORGES.search(found[2]):
                    yield found[1], word, _port(command.words)
                    break


def _port(words: tuple[Located, ...]) -> str | None:
    """The port of a command line; None when options or variables may set another."""
    for at, word in enumerate(words):
        if word[:2] in ("-p", "-P") and len(word) > 2:
            return str(word[2:])
        if word in ("-p", "-P"):
            return str(words[at + 1]) if at + 1 < len(words) else None
        if word[:2] in ("-o", "-F") or "$" in word:
            return None
    return "22"


def ssh_forwards(files: Files) -> Iterator[Forward]:
    """The ports at the far end of ``ssh -L`` and ``-R`` in scripts, each with the word that says so."""
    for source in files.of_kind("shell-script"):
        if "ssh" not in source.text:
            continue
        variables: dict[str, str] = {}
        for command in shell_commands(source):
            for assignment in command.assignments:
                name, _, value = assignment.partition("=")
                number = evaluate(value, variables)
                variables[name] = str(number) if number is not None else value
            if command.name in ("ssh", "autossh"):
                yield from _forwards(source, command.words, variables)


def _forwards(source: Source, words: tuple[Located, ...], variables: dict[str, str]) -> Iterator[Forward]:
    for at, word in enumerate(words):
        text = words[at + 1] if word in ("-L", "-R") and at + 1 < len(words) else None
        if word[:2] in ("-L", "-R") and len(word) > 2:
            text = word.part(2, len(word))
        match = _FORWARD.match(text) if text is not None else None
        port = evaluate(match["remote"], variables) if match else None
        if text is not None and port is not None:
            yield source, port, text
