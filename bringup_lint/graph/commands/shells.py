"""Shells as programs: what they are told to read, and which files of people they read before."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.model.shell import Command
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

SHELLS = frozenset({"sh", "bash", "dash", "zsh", "ksh"})
SH_IS_BASH = regex(r"\bln\s[^\n;|]{0,40}\bbash\s+(?:/usr)?/bin/sh\b|\bdash/sh\s+(?:boolean\s+)?false\b")
"""Steps that put bash in the place of dash as /bin/sh."""
STRICT = (
    r"(?<![\w#-])(?<!#[ \t])set[ \t]+(?:[-+]\w{1,9}[ \t]+(?:[a-z]{5,12}[ \t]+)?){0,4}-(?:\w{0,8}e|o[ \t]+errexit)"
    r"|^#![^\n]{0,80}[ \t]-\w{0,8}e"
)
"""Part of a pattern (with re.M): the first failing command ends the script, by ``set -e`` or ``#!/bin/bash -e``."""
SHELL_SCRIPT = regex(r"(?:#jinja2:[^\n]*\n)?#!\s*\S*/(?:env\s+(?:-S\s+)?)?(sh|bash|dash|zsh|ksh)\b")
"""The first line of a shell script; in a template, what Ansible takes away may be above it."""
SCRIPT_DEPTH = 4
"""How many scripts that call each other are followed."""

_VALUED = regex(r"[-+][A-Za-z]*[oO]|--rcfile|--init-file")
"""Options of shells that take a value."""
_PROFILE = regex(r"(?:^|/)(?:\.bashrc|\.bash_profile|\.profile|\.zshrc|bash\.bashrc|profile)$", hints="rc profile")
_LOGIN = regex(r"-[a-z]*[li][a-z]*")


class ShellInput(NamedTuple):
    """What a shell reads: the text after ``-c``, or a script."""

    text: Located | None
    script: Located | None
    arguments: tuple[Located, ...]
    """``$1`` and so on."""


def shell_input(words: tuple[Located, ...]) -> ShellInput | None:
    """What a shell with these words after its name reads; None when it reads its standard input."""
    at = 0
    while at < len(words):
        word = words[at]
        if _VALUED.fullmatch(word):
            at += 2
        elif is_command_option(word) and at + 1 < len(words):
            return ShellInput(words[at + 1], None, words[at + 3 :])
        elif word.startswith(("-", "+")):
            at += 1
        else:
            return ShellInput(None, word, words[at + 1 :])
    return None


def is_command_option(word: str) -> bool:
    """Whether it is ``-c``, alone or among other letters."""
    return word.startswith("-") and not word.startswith("--") and "c" in word


def profiles(command: Command) -> Iterator[Located]:
    """The words by which a command reads what is meant for people: a sourced ``.bashrc``, ``bash -l``, ``bash -i``."""
    words = unwrapped(command.words)
    name = program_name(words[0]) if words else ""
    if name in ("source", ".") and len(words) > 1 and _PROFILE.search(words[1]):
        yield words[1]
    if name not in SHELLS:
        return
    for word in words[1:]:
        if not word.startswith("-"):
            return
        if word == "--login" or _LOGIN.fullmatch(word):
            yield word
        if is_command_option(word):
            return
