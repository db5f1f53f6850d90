"""The variables of CMake, and the commands that give them values (cmake-commands(7))."""

from __future__ import annotations

import re

from bringup_lint.parsers.cmake_commands import Command
from bringup_lint.parsers.cmake_values import element
from bringup_lint.parsers.cmake_values import number
from bringup_lint.parsers.cmake_values import part_of_path
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_VARIABLE = regex(r"\$\{(\w+)\}")
LONGEST = 20_000
"""Characters of a value."""


class Variables:
    """The values of variables, as far as they are known. A value that a call gives is ``Located`` where it is named."""

    def __init__(self, variables: dict[str, str]) -> None:
        self.variables = variables
        self.unknown: set[str] = set()
        """What was given a value that is not known."""
        self.exported: list[dict[str, str | None]] = []
        """What the functions that run now, the innermost last, set for their callers."""
        self.skips = self.returns = False
        """A command before may have left the turn of the loop, or the file."""

    def expand(self, text: Located) -> Located | None:
        """The text with known variables filled in; None when one is not known."""
        missing = False
        length = 0

        def known(match: re.Match) -> str:
            nonlocal missing, length
            value = self.variables.get(match[1], "")
            length += len(value)
            missing = missing or match[1] not in self.variables or length > LONGEST
            return "" if missing else value

        expanded = _VARIABLE.sub(known, text)
        if missing or "$" in expanded:
            return None
        alone = _VARIABLE.fullmatch(text)
        given = self.variables[alone[1]] if alone is not None else None
        return given if isinstance(given, Located) else Located(expanded, text.span)

    def words(self, arguments: list[Located]) -> list[Located | None]:
        """The arguments with variables filled in, lists taken apart."""
        result: list[Located | None] = []
        for argument in arguments:
            expanded = self.expand(argument)
            if expanded is None:
                result.append(None)
            else:
                result.extend(Located(part, expanded.span) for part in expanded.split(";") if part)
        return result

    def known(self, arguments: list[Located]) -> list[str] | None:
        """The arguments with variables filled in; None when one is not known."""
        words = [word for word in self.words(arguments) if word is not None]
        return None if len(words) < len(self.words(arguments)) else [str(word) for word in words]

    def give(self, name: str, value: str | None) -> None:
        """Give a variable a value, which is None when it is not known."""
        if value is None or len(value) > LONGEST:
            self.variables.pop(name, None)
            self.unknown.add(name)
        else:
            self.variables[name] = value
            self.unknown.discard(name)

    def compute(self, command: Command, name: str, value: str | None) -> None:
        """A command gives a variable a value; which one it has then is not known where the command may not run."""
        self.give(name, None if command.conditional or self.skips else value)

    def do_project(self, command: Command) -> None:
        if command.arguments:
            name = self.expand(command.arguments[0])
            for variable in ("PROJECT_NAME", "CMAKE_PROJECT_NAME"):
                self.give(variable, None if name is None else str(name))

    def do_set(self, command: Command) -> None:
        if not command.arguments:
            return
        words = self.words([word for word in command.arguments[1:] if word not in ("PARENT_SCOPE", "CACHE", "FORCE")])
        name = str(self.expand(command.arguments[0]) or command.arguments[0])
        known = [word for word in words if word is not None]
        value = None if len(known) < len(words) else ";".join(known)
        if "PARENT_SCOPE" in command.arguments and self.exported:
            self.exported[-1][name] = None if command.conditional or self.skips else value
        else:
            self.compute(command, name, value)

    def do_unset(self, command: Command) -> None:
        if command.arguments:
            self.compute(command, str(command.arguments[0]), "")

    def do_list(self, command: Command) -> None:
        if len(command.arguments) < 2:
            return
        action, name = str(command.arguments[0]).upper(), str(command.arguments[1])
        items = self.variables.get(name)
        split = items.split(";") if items else []
        match action, self.known(command.arguments[2:]):
            case "APPEND", [*words] if name not in self.unknown:
                self.compute(command, name, ";".join([*split, *words]))
            case "GET", [index, output]:
                self.compute(command, output, None if items is None else element(split, index))
            case "LENGTH", [output]:
                self.compute(command, output, None if items is None else str(len(split)))
            case "GET" | "LENGTH" | "JOIN" | "FIND" | "SUBLIST", _:
                self.compute(command, str(command.arguments[-1]), None)
            case _:
                self.compute(command, name, None)

    def do_math(self, command: Command) -> None:
        if len(command.arguments) > 2:
            expression = self.expand(command.arguments[2])
            self.compute(command, str(command.arguments[1]), None if expression is None else number(expression))

    def do_get_filename_component(self, command: Command) -> None:
        if len(command.arguments) > 2:
            path, part = self.expand(command.arguments[1]), str(command.arguments[2])
            self.compute(command, str(command.arguments[0]), None if path is None else part_of_path(path, part))

    def do_string(self, command: Command) -> None:
        """What it writes is the last word, or that of a form which may hold it anywhere: none of them is known."""
        for word in command.arguments:
            self.give(str(word), None)

    do_aux_source_directory = do_pkg_get_variable = do_cmake_host_system_information = do_string
