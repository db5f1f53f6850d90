"""The language of CMake: loops, functions, macros and included files (cmake-language(7)). Both branches of a condition
are read, each as one that may not happen."""

from __future__ import annotations

import posixpath
from collections.abc import Callable
from collections.abc import Iterable
from functools import cache

from bringup_lint import facts
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cmake_commands import Command
from bringup_lint.parsers.cmake_commands import commands
from bringup_lint.parsers.cmake_functions import DEEPEST
from bringup_lint.parsers.cmake_functions import Definition
from bringup_lint.parsers.cmake_functions import bound
from bringup_lint.parsers.cmake_functions import defined
from bringup_lint.parsers.cmake_functions import is_quoted
from bringup_lint.parsers.cmake_functions import parsed
from bringup_lint.parsers.cmake_values import matching
from bringup_lint.parsers.cmake_values import numbers
from bringup_lint.parsers.cmake_variables import Variables
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source


@cache
def named_for(use: str) -> frozenset[str]:
    """The names of the table ``ros/cmake`` for one use: ``command``, ``module`` or ``install``."""
    return frozenset(name for each, name in facts.rows("ros/cmake")[1] if each == use)


_HARMLESS = regex(
    r"^(?:check_|find_|target_|get_|set_|enable_|export_|qt\d?_(?:wrap|add_resources|use|generate_moc)|ament_(?:lint|clang)_|try_)"
    r"|_tests?$|_test_|^g?test_|_coverage$|_warnings$|_options$|_flags?$|_docs$|_dependencies$"
)
"""Names of commands that neither install nor make a program: they look for something, set something, or test."""
_MAKING = regex(
    r"install|^add_(?:executable|library|subdirectory)$|^ament_(?:auto_|python_)|^rclcpp_components_|^include$|_package$"
)
"""Commands for whose sake a function matters."""
LOOPED = 2_000
"""Commands that the loops and calls of one file run."""
INCLUDED = 50
"""Files that one file includes."""
MOST_INCLUDED = 20_000
"""Commands of all of them."""
LISTED = 50
"""Folders that the patterns of one file look through."""
_ENDS = frozenset("endif endforeach endfunction endmacro endwhile foreach function macro while".split())


def _ends(given: list[Command]) -> dict[int, int]:
    """The places of the loops, functions and macros that have an end, each with that of its end."""
    found: dict[int, int] = {}
    open_at: dict[str, list[int]] = {"foreach": [], "function": [], "macro": []}
    for at, command in enumerate(given):
        if command.name in open_at:
            open_at[command.name].append(at)
        elif places := open_at.get(command.name.removeprefix("end")):
            found[places.pop()] = at
    return found


class Around(NamedTuple):
    """What lies around a file, by paths from its folder."""

    file: Callable[[str], Source | None]
    below: Callable[[str], Iterable[str]]
    """The files in a folder and in those below it."""


ALONE = Around(lambda path: None, lambda folder: ())


class Language(Variables):
    """Follows the commands of one file with its includes."""

    def __init__(self, variables: dict[str, str], around: Around) -> None:
        super().__init__(variables)
        self.around = around
        self.included = self.commands_included = 0
        self.harmless: set[str] = set()
        """Functions of the file that neither install nor make anything."""
        self.functions: dict[str, Definition] = {}
        """The others."""
        self.calls = 0
        self.looped = 0
        self.looked_through = 0

    def open(self) -> None:
        """Something happens that is not known."""

    def run(self, given: list[Command]) -> None:
        at, ends = 0, _ends(given)
        while at < len(given):
            command, end = given[at], ends.get(at)
            if command.name == "foreach":
                end = len(given) if end is None else end
                self.loop(command, given[at + 1 : end])
                at = end
            elif command.name in ("function", "macro") and end is not None:
                self.define(given, at, end)
                at = end
            else:
                self.one(command)
            at += 1

    def define(self, given: list[Command], at: int, end: int) -> None:
        """Keep a function for its calls; one that neither installs nor makes anything need not be run."""
        if self.is_harmless(given, at, end):
            return
        found = defined(given, at, end)
        if found is None:
            self.open()
        else:
            name = self.expand(given[at].arguments[0]) or given[at].arguments[0]
            self.functions[str(name).lower()] = found

    def is_harmless(self, given: list[Command], at: int, end: int) -> bool:
        """Whether a function neither installs nor makes anything; keeps its name then. One that holds one is not."""
        names = given[at].arguments[:1]
        # What a macro sets stays set, and what it returns from is the file.
        leaves = ("set", "list", "return") if given[at].name == "macro" else ()
        for place in range(at + 1, end):
            each = given[place]
            if each.name in ("function", "macro", *leaves) or "PARENT_SCOPE" in each.arguments:
                return False
            if _MAKING.search(each.name) or not (self.is_known(each) or _HARMLESS.search(each.name)):
                return False
        self.harmless.update(str(name).lower() for name in names)
        return bool(names)

    def is_known(self, command: Command) -> bool:
        """Whether a command neither installs nor makes anything that is not read."""
        return any(command.name in names for names in (named_for("command"), _ENDS, self.harmless))

    def call(self, command: Command, definition: Definition) -> None:
        """Run a function or macro with the arguments of a call."""
        self.looped += len(definition.body)
        if self.calls >= DEEPEST or self.looped > LOOPED:
            self.open()
            return
        words: list[Located | None] = []
        for argument in command.arguments:
            words += [self.expand(argument)] if is_quoted(argument) else self.words([argument])
        variables, unknown, state = dict(self.variables), set(self.unknown), (self.returns, self.skips)
        values = bound(definition.parameters, words)
        for name, value in values.items():
            self.give(name, value)
        self.calls += 1
        self.exported.append({})
        self.run(definition.called(command))
        self.calls -= 1
        exported = self.exported.pop()
        if definition.is_macro:
            exported = {**{name: variables.get(name) for name in values}, **exported}
        else:
            self.variables, self.unknown = variables, unknown
        for name, value in exported.items():
            self.give(name, value)
        self.returns, self.skips = state

    def one(self, command: Command) -> None:
        definition = self.functions.get(command.name)
        if definition is not None:
            self.call(command, definition)
            return
        handler = getattr(self, f"do_{command.name}", None)
        if handler is not None:
            handler(command)
        if command.name in ("function", "macro", "while"):
            self.open()
        elif not self.is_known(command):
            if _HARMLESS.search(command.name):
                self.do_string(command)
            else:
                self.open()

    def loop(self, command: Command, body: list[Command]) -> None:
        """The body for each item; once, with an item that is not known, when these are not known, or too many."""
        items, skips = self.items(command.arguments), self.skips
        self.looped += len(items) * len(body)
        if not command.arguments or self.looped > LOOPED or None in items:
            self.open()
            items = [None]
        else:
            body = [Command(each.name, each.arguments, each.depth - 1) for each in body]
        for item in items:
            if command.arguments:
                self.give(str(command.arguments[0]), None if item is None else str(item))
            self.run(body)
        self.skips = skips

    def items(self, arguments: list[Located]) -> list[Located | None]:
        """What ``foreach(variable ...)`` goes through."""
        if "ZIP_LISTS" in arguments:
            return [None]
        if "RANGE" in arguments[:2]:
            bounds = self.known(arguments[2:])
            counted = None if bounds is None else numbers(bounds)
            return [None] if counted is None else [Located(each, arguments[1].span) for each in counted]
        found: list[Located | None] = []
        lists = False
        for argument in arguments[1:]:
            if argument in ("IN", "LISTS", "ITEMS"):
                lists = argument == "LISTS"
            elif not lists:
                found += self.words([argument])
            elif argument in self.variables:
                found += self.words([Located(self.variables[str(argument)], argument.span)])
            else:
                found.append(None)
        return found

    def do_return(self, command: Command) -> None:
        self.returns = True

    def do_continue(self, command: Command) -> None:
        self.skips = True

    do_break = do_continue

    def do_include(self, command: Command) -> None:
        """A module of CMake changes nothing; a file of the package is read here; others may install anything."""
        name = self.expand(command.arguments[0]) if command.arguments else None
        if name is not None and name in named_for("module"):
            return
        self.included += 1
        source = self.module(str(name)) if name is not None and self.included <= INCLUDED else None
        given = [] if source is None else source.once(commands, lambda: list(commands(source)))
        self.commands_included += len(given)
        if source is None or self.commands_included > MOST_INCLUDED:
            self.open()
            return
        folder = self.variables.get("CMAKE_CURRENT_LIST_DIR")
        self.give("CMAKE_CURRENT_LIST_DIR", posixpath.dirname(name or ""))
        self.run([Command(each.name, each.arguments, each.depth + command.depth) for each in given])
        self.give("CMAKE_CURRENT_LIST_DIR", folder)

    def module(self, name: str) -> Source | None:
        """A file by its path, or by its name without the ending in one of the folders of modules."""
        folders = self.variables.get("CMAKE_MODULE_PATH", "").split(";")
        paths = (posixpath.join(folder, f"{name}.cmake") for folder in folders)
        return next((found for path in (name, *paths) if (found := self.around.file(path)) is not None), None)

    def do_cmake_parse_arguments(self, command: Command) -> None:
        words = list(command.arguments)
        given = self.known(words[4:])
        if words[:1] == ["PARSE_ARGV"]:
            first, words = words[1:2], words[2:]
            values = self.variables.get("ARGV")
            skipped = int(first[0]) if first and first[0].isdecimal() and len(first[0]) < 4 else None
            given = None if values is None or skipped is None else values.split(";")[skipped:]
        keys = [self.known([word]) for word in words[:4]]
        if len(keys) < 4 or None in keys:
            self.open()
            return
        (prefix, *_), options, single, several = ((key or [""]) for key in keys)
        for name, value in parsed(prefix, options, single, several, given).items():
            self.compute(command, name, value)

    def do_file(self, command: Command) -> None:
        """``file(GLOB variable [options] pattern...)``; the files that a build makes are not there, and not meant."""
        words = [word for word in command.arguments if word != "CONFIGURE_DEPENDS"]
        action = str(words[0]).upper() if words else ""
        if len(words) < 2 or action not in ("GLOB", "GLOB_RECURSE"):
            return
        patterns = self.known(words[2:])
        if patterns is None or {"RELATIVE", "LIST_DIRECTORIES", "FOLLOW_SYMLINKS"} & set(patterns):
            self.give(str(words[1]), None)
            return
        found = [path for pattern in patterns for path in self.globbed(pattern, action == "GLOB_RECURSE")]
        self.compute(command, str(words[1]), ";".join(found) if found else None)

    def globbed(self, pattern: str, deep: bool) -> list[str]:
        if self.looked_through >= LISTED:
            return []
        self.looked_through += 1
        folder = posixpath.dirname(pattern.partition("*")[0].partition("[")[0].partition("?")[0])
        return matching(self.around.below(folder or "."), pattern, deep)
