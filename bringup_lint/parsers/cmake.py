"""CMakeLists.txt of a ROS package: what it installs, builds and registers. A reader of commands, not a CMake."""

from __future__ import annotations

import itertools
import re
from functools import cache

from bringup_lint import facts
from bringup_lint.endings import CPP_SOURCES
from bringup_lint.model.package import Build
from bringup_lint.model.package import Install
from bringup_lint.parsers.cmake_commands import Command
from bringup_lint.parsers.cmake_commands import commands
from bringup_lint.parsers.cmake_values import element
from bringup_lint.parsers.cmake_values import number
from bringup_lint.parsers.cmake_values import numbers
from bringup_lint.parsers.cmake_values import part_of_path
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_VARIABLE = regex(r"\$\{(\w+)\}")


@cache
def _names(use: str) -> frozenset[str]:
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
"""Commands that the loops of one file run."""
LONGEST = 20_000
"""Characters of a value."""


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


class Reader:
    """Follows the commands of one file with its includes, and writes into its ``Build``."""

    def __init__(self, build: Build, variables: dict[str, str]) -> None:
        self.build = build
        self.variables = variables
        self.unknown: set[str] = set()
        """What was given a value that is not known."""
        self.harmless: set[str] = set()
        """Functions of the file that neither install nor make anything."""
        self.looped = 0
        self.skips = self.returns = False
        """A command before may have left the turn of the loop, or the file."""
        self.sure = False
        """The installation that is read happens in any case."""

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
        return None if missing or "$" in expanded else Located(expanded, text.span)

    def words(self, arguments: list[Located]) -> list[Located | None]:
        """The arguments with variables filled in, lists taken apart."""
        result: list[Located | None] = []
        for argument in arguments:
            expanded = self.expand(argument)
            if expanded is None:
                result.append(None)
            else:
                result.extend(Located(part, argument.span) for part in expanded.split(";") if part)
        return result

    def read(self) -> None:
        self.run(list(commands(self.build.source)))
        self.rename()

    def run(self, given: list[Command]) -> None:
        at, ends = 0, _ends(given)
        while at < len(given):
            command, end = given[at], ends.get(at)
            if command.name == "foreach":
                end = len(given) if end is None else end
                self.loop(command, given[at + 1 : end])
                at = end
            elif command.name in ("function", "macro") and end is not None and self.is_harmless(given, at, end):
                at = end
            else:
                self.one(command)
            at += 1

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
        return any(command.name in names for names in (_names("command"), _ENDS, self.harmless))

    def one(self, command: Command) -> None:
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

    def open(self) -> None:
        """Something is built or installed that is not known."""
        self.build.installs_known = self.build.executables_known = self.build.plugins_known = False

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

    def do_project(self, command: Command) -> None:
        if command.arguments:
            name = self.expand(command.arguments[0])
            for variable in ("PROJECT_NAME", "CMAKE_PROJECT_NAME"):
                self.give(variable, None if name is None else str(name))

    def do_set(self, command: Command) -> None:
        if not command.arguments:
            return
        words = self.words([word for word in command.arguments[1:] if word not in ("PARENT_SCOPE", "CACHE", "FORCE")])
        name = str(command.arguments[0])
        known = [word for word in words if word is not None]
        self.compute(command, name, None if len(known) < len(words) else ";".join(known))

    def do_unset(self, command: Command) -> None:
        if command.arguments:
            self.compute(command, str(command.arguments[0]), "")

    def do_return(self, command: Command) -> None:
        self.returns = True

    def do_continue(self, command: Command) -> None:
        self.skips = True

    do_break = do_continue

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

    def do_file(self, command: Command) -> None:
        if len(command.arguments) > 1 and str(command.arguments[0]).upper() in ("GLOB", "GLOB_RECURSE"):
            self.give(str(command.arguments[1]), None)

    def do_include(self, command: Command) -> None:
        """A module of CMake changes nothing; a file of the package may install anything."""
        if not command.arguments or command.arguments[0] not in _names("module"):
            self.open()

    def do_add_subdirectory(self, command: Command) -> None:
        words = self.words(command.arguments[:1])
        if words and words[0] is not None:
            self.build.subdirectories.append(str(words[0]))
        else:
            self.open()

    def do_ament_auto_add_executable(self, command: Command) -> None:
        self.executable(command.arguments[:1])
        self.target(command)

    def target(self, command: Command) -> None:
        """``add_executable(name source ...)``, ``add_library(name SHARED source ...)``."""
        given = self.words(command.arguments)
        words = [word for word in given if word is not None]
        self.build.names_computed |= given[:1] == [None]
        if words and given[0] is not None:
            files = [str(word) for word in words[1:] if word.endswith(CPP_SOURCES)]
            self.build.targets.setdefault(str(words[0]), []).extend(files)
            if None in given or {"DIRECTORY", "GLOB"} & set(words):
                self.build.open_targets.add(str(words[0]))

    do_target_sources = target

    def do_add_library(self, command: Command) -> None:
        names = [word for word in self.words(command.arguments[:1]) if word is not None]
        if not {"IMPORTED", "ALIAS"} & set(command.arguments):
            self.build.libraries.update((str(name), name) for name in names)
        self.target(command)

    do_ament_auto_add_library = do_add_library

    def do_add_executable(self, command: Command) -> None:
        names = [word for word in self.words(command.arguments[:1]) if word is not None]
        if not {"IMPORTED", "ALIAS"} & set(command.arguments):
            self.build.built.update((str(name), name) for name in names)
        self.target(command)

    def do_set_target_properties(self, command: Command) -> None:
        """``set_target_properties(target ... PROPERTIES OUTPUT_NAME name)``."""
        at = next((at for at, word in enumerate(command.arguments) if word == "PROPERTIES"), len(command.arguments))
        for key, value in itertools.pairwise(command.arguments[at:]):
            if key == "OUTPUT_NAME":
                self.output_name(command.arguments[:at], value)

    def do_set_property(self, command: Command) -> None:
        """``set_property(TARGET target ... PROPERTY OUTPUT_NAME name)``."""
        words = command.arguments
        if len(words) > 4 and words[0] == "TARGET" and words[-3] == "PROPERTY" and words[-2] == "OUTPUT_NAME":
            self.output_name(words[1:-3], words[-1])

    def output_name(self, targets: list[Located], name: Located) -> None:
        names, known = self.words([name]), self.words(targets)
        if len(names) != 1 or names[0] is None or None in known:
            self.build.executables_known = False
            return
        self.build.output_names |= {str(target): names[0] for target in known}

    def rename(self) -> None:
        """Give the installed targets the names of their files."""
        for target, name in self.build.output_names.items():
            if self.build.executables.pop(target, None) is not None:
                self.build.executables[str(name)] = name
                self.build.targets[str(name)] = self.build.targets.get(target, [])
            if self.build.built.pop(target, None) is not None:
                self.build.built[str(name)] = name

    def do_target_link_libraries(self, command: Command) -> None:
        words = [str(word) for word in self.words(command.arguments) if word is not None]
        if words:
            self.build.links.setdefault(words[0], []).extend(words[1:])

    def do_rclcpp_components_register_node(self, command: Command) -> None:
        words = command.arguments
        for key, value in itertools.pairwise(words):
            if key == "PLUGIN":
                self.plugin(value)
            elif key == "EXECUTABLE":
                self.executable([value])
            if key in ("PLUGIN", "EXECUTABLE"):
                self.component(value, words[0])

    def do_rclcpp_components_register_nodes(self, command: Command) -> None:
        for value in command.arguments[1:]:
            self.plugin(value)
            self.component(value, command.arguments[0])

    def component(self, name: Located, library: Located) -> None:
        names, libraries = self.words([name]), self.words([library])
        if len(names) == len(libraries) == 1 and None not in (*names, *libraries):
            self.build.components[str(names[0])] = str(libraries[0])

    def do_rosidl_generate_interfaces(self, command: Command) -> None:
        given = self.words(command.arguments[1:])
        words = [word for word in given if word is not None]
        self.build.interfaces = words if len(words) == len(given) else None

    def plugin(self, value: Located) -> None:
        for word in self.words([value]):
            if word is None:
                self.build.plugins_known = False
            else:
                self.build.plugins.append(word)

    def executable(self, arguments: list[Located]) -> None:
        for word in self.words(arguments):
            if word is None:
                self.build.executables_known = False
            elif str(word):
                self.build.executables[str(word)] = word

    def do_ament_auto_package(self, command: Command) -> None:
        shared = False
        self.sure = False
        for argument in command.arguments:
            if argument.isupper():
                shared = argument == "INSTALL_TO_SHARE"
            elif shared:
                self.install(f"share/{self.variables.get('PROJECT_NAME', '')}", argument, True)

    def do_ament_python_install_package(self, command: Command) -> None:
        """The scripts of a setup.cfg beside it, if there is one."""
        if "SCRIPTS_DESTINATION" in command.arguments:
            self.open()
        self.build.installs_python = True

    do_ament_python_install_module = do_ament_python_install_package

    def do_install(self, command: Command) -> None:
        if not command.arguments:
            return
        kind = str(command.arguments[0]).upper()
        sources: list[Located] = []
        options: list[Located] = []
        for argument in command.arguments[1:]:
            (options if options or argument in _names("install") else sources).append(argument)
        destination = self.destination(options)
        self.sure = not (command.conditional or self.skips or self.returns)
        self.sure &= not {"OPTIONAL", "EXCLUDE_FROM_ALL"} & set(command.arguments)
        if kind in ("SCRIPT", "CODE"):
            self.build.installs_known = False
        elif kind not in ("TARGETS", "PROGRAMS", "FILES", "DIRECTORY"):
            return
        elif destination is None:
            runtime = kind != "TARGETS" or any(option == "RUNTIME" for option in options) or not options
            self.build.installs_known = False
            if runtime:
                self.build.executables_known = self.build.executables_known and kind == "TARGETS" and not options
        elif kind == "TARGETS":
            self.targets(destination, sources, options)
        elif kind in ("PROGRAMS", "FILES"):
            self.files(kind, destination, sources, options)
        else:
            filtered = any(option in ("FILES_MATCHING", "PATTERN", "REGEX", "EXCLUDE") for option in options)
            for source in sources:
                self.install(destination, source, True, filtered)
            if destination.startswith("lib/") and filtered:
                self.build.executables_known = False

    def targets(self, destination: str, sources: list[Located], options: list[Located]) -> None:
        if destination.startswith("lib/"):
            self.executable(sources)
            self.build.programs_at = self.build.programs_at or next(iter(sources), None)
            return
        self.build.elsewhere.update((str(word), word) for word in self.words(sources) if word is not None)

    def files(self, kind: str, destination: str, sources: list[Located], options: list[Located]) -> None:
        renamed = [after for before, after in itertools.pairwise(options) if before == "RENAME"]
        name = self.expand(renamed[0]) if renamed else None
        for source in sources:
            self.install(destination, source, False, bool(renamed), str(name or ""))
        if destination.startswith("lib/") and kind in ("PROGRAMS", "FILES"):
            for word in self.words(renamed or sources):
                if word is None:
                    self.build.executables_known = False
                else:
                    self.program(kind, word, "PERMISSIONS" in options)

    def program(self, kind: str, word: Located, has_mode: bool) -> None:
        name = word.rpartition("/")[2]
        if kind == "FILES" and not has_mode and name not in self.build.executables:
            self.build.without_mode[name] = word
        elif kind == "PROGRAMS" or has_mode:
            self.build.without_mode.pop(name, None)
        self.build.executables[name] = Located(name, word.span)

    def destination(self, options: list[Located]) -> str | None:
        """The destination of programs, else the only one."""
        found: dict[str, Located] = {}
        current = ""
        for before, after in zip([Located("", self.build.source.whole), *options], options):
            if before in ("RUNTIME", "LIBRARY", "ARCHIVE", "INCLUDES"):
                current = str(before)
            if before == "DESTINATION":
                found[current] = after
        chosen = found.get("RUNTIME") or found.get("") or (next(iter(found.values())) if found else None)
        expanded = None if chosen is None else self.expand(chosen)
        if expanded is None:
            return None
        text = expanded.strip("/")
        return "" if text.startswith("..") else text

    def install(self, destination: str, source: Located, tree: bool, filtered: bool = False, renamed: str = "") -> None:
        for word in self.words([source]):
            if word is None:
                self.build.installs_known = False
            else:
                place = Install(destination, str(word), tree, source.span, filtered, renamed, self.sure)
                self.build.installs.append(place)


_ENDS = frozenset("endif endforeach endfunction endmacro endwhile foreach function macro while".split())


def parse(source: Source, name: str | None = None, variables: dict[str, str] | None = None) -> Build:
    """What the file installs; ``variables`` are those of the folder above."""
    build = Build(source)
    known = {"CMAKE_CURRENT_SOURCE_DIR": ".", "CMAKE_SOURCE_DIR": ".", "PROJECT_SOURCE_DIR": "."}
    known |= {"CMAKE_INSTALL_LIBDIR": "lib", "CMAKE_INSTALL_DATADIR": "share", "CMAKE_INSTALL_PREFIX": ""}
    reader = Reader(build, known | (variables or {}))
    if name:
        reader.variables["PROJECT_NAME"] = name
    reader.read()
    return build
