"""The ROS 2 programs that scripts start in terminals (tmux, screen, windows), or give a short name or an icon."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.graph.commands.ros_command import Ros
from bringup_lint.graph.commands.ros_command import ros_command
from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.shells import shell_input
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.model.shell import Command
from bringup_lint.parsers.shell import commands
from bringup_lint.pattern import regex
from bringup_lint.source import Located

TERMINALS = frozenset(
    "tmux screen byobu gnome-terminal xterm uxterm terminator lxterminal konsole xfce4-terminal mate-terminal "
    "x-terminal-emulator kitty alacritty tilix qterminal rxvt urxvt st foot".split()
)
_OWN = regex(r"tmux|screen|terminal|pane|window")
"""In the name of a script's function that opens one, or types into it."""
_STARTS = regex(r"\bros2[ \t]+(?:launch|run)[ \t]")
_DESKTOP = regex(r"^Exec=(?P<command>[^\n]+)$", re.M, "Exec=")
"""The command of a desktop entry that a script writes."""
_DEPTH = 3


def typed(command: Command) -> Iterator[Ros]:
    """The programs that a command hands to a terminal, or to a name."""
    words = unwrapped(command.words)
    name = program_name(words[0]) if words else ""
    if name == "alias":
        yield from (ros for word in words[1:] for ros in _of_text(word.part(word.find("=") + 1, len(word)), 0))
    elif name in TERMINALS or _OWN.search(name):
        yield from _behind(words[1:], 0)
    for redirect in command.redirects:
        if redirect.document is not None:
            yield from _on_desktop(redirect.document.text)


def _on_desktop(text: Located) -> Iterator[Ros]:
    for match in _DESKTOP.finditer(text):
        for command in commands(text.part(*match.span("command"))):
            found = ros_command(command)
            yield from (found,) if found is not None else _behind(command.words, 0)


def _behind(words: tuple[Located, ...], depth: int) -> Iterator[Ros]:
    """What one of the words begins: a command of the words from there on, or of its own text."""
    for at, word in enumerate(words):
        name = program_name(word)
        if name == "ros2":
            found = ros_command(Command(words[at:]))
            yield from (found,) if found is not None else ()
            return
        if name in SHELLS:
            read = shell_input(words[at + 1 :])
            if read is not None and read.text is not None:
                yield from _of_text(read.text, depth)
            return
        yield from _of_text(word, depth)


def _of_text(text: Located, depth: int) -> Iterator[Ros]:
    """The programs of a text; none where it ends in a key that is written as an escape."""
    if depth >= _DEPTH or not _STARTS.search(text) or "\\" in text:
        return
    for command in commands(text):
        found = ros_command(command)
        if found is not None:
            yield found
        elif (words := unwrapped(command.words)) and program_name(words[0]) in SHELLS:
            yield from _behind(words, depth + 1)
            given = (each.target for each in command.redirects if each.operator == "<<<" and each.target is not None)
            yield from (ros for each in given for ros in _of_text(each, depth + 1))
