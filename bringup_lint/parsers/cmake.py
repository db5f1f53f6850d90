"""CMakeLists.txt of a ROS package: what it installs, builds and registers. A reader of commands, not a CMake."""

from __future__ import annotations

import itertools

from bringup_lint.endings import CPP_SOURCES
from bringup_lint.model.package import Build
from bringup_lint.model.package import Install
from bringup_lint.parsers.cmake_commands import Command
from bringup_lint.parsers.cmake_commands import commands
from bringup_lint.parsers.cmake_language import ALONE
from bringup_lint.parsers.cmake_language import Around
from bringup_lint.parsers.cmake_language import Language
from bringup_lint.parsers.cmake_language import named_for
from bringup_lint.source import Located
from bringup_lint.source import Source


class Reader(Language):
    """Writes what the commands of one file do into its ``Build``."""

    def __init__(self, build: Build, variables: dict[str, str], around: Around) -> None:
        super().__init__(variables, around)
        self.build = build
        self.automatic: list[str] = []
        """The libraries of ``ament_auto_add_library``."""
        self.sure = False
        """The installation that is read happens in any case."""

    def read(self) -> None:
        self.run(list(commands(self.build.source)))
        self.rename()

    def open(self) -> None:
        """Something is built or installed that is not known."""
        self.build.installs_known = self.build.executables_known = self.build.plugins_known = False

    def do_add_subdirectory(self, command: Command) -> None:
        words = self.words(command.arguments[:1])
        if words and words[0] is not None:
            self.build.subdirectories.append(str(words[0]))
        else:
            self.open()

    def do_ament_auto_add_executable(self, command: Command) -> None:
        """It links the libraries that ``ament_auto_add_library`` has made before (ament_cmake_auto)."""
        self.executable(command.arguments[:1])
        self.target(command)
        for name in self.words(command.arguments[:1]):
            if name is not None and "NO_TARGET_LINK_LIBRARIES" not in command.arguments:
                self.build.links.setdefault(str(name), []).extend(self.automatic)

    def target(self, command: Command) -> None:
        """``add_executable(name source ...)``, ``add_library(name SHARED source ...)``."""
        given = self.words(command.arguments)
        words = [word for word in given if word is not None]
        self.build.names_computed |= given[:1] == [None]
        if words and given[0] is not None:
            files = [str(word) for word in words[1:] if word.endswith(CPP_SOURCES)]
            inside = [self.sources_in(folder) for key, folder in itertools.pairwise(words) if key == "DIRECTORY"]
            files += [path for paths in inside for path in paths]
            self.build.targets.setdefault(str(words[0]), []).extend(files)
            if None in given or not all(inside) or "GLOB" in words:
                self.build.open_targets.add(str(words[0]))

    def sources_in(self, folder: str) -> list[str]:
        """What ``aux_source_directory`` finds in a folder, which ``DIRECTORY`` of ament_cmake_auto asks."""
        return [path for path in self.globbed(f"{folder}/*", False) if path.endswith(CPP_SOURCES)]

    do_target_sources = target

    def do_add_library(self, command: Command) -> None:
        names = [word for word in self.words(command.arguments[:1]) if word is not None]
        if not {"IMPORTED", "ALIAS"} & set(command.arguments):
            self.build.libraries.update((str(name), name) for name in names)
        self.target(command)

    def do_ament_auto_add_library(self, command: Command) -> None:
        self.do_add_library(command)
        self.automatic += [str(name) for name in self.words(command.arguments[:1]) if name is not None]

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
                self.build.links[str(name)] = self.build.links.get(target, [])
                if target in self.build.open_targets:
                    self.build.open_targets.add(str(name))
            if self.build.built.pop(target, None) is not None:
                self.build.built[str(name)] = name

    def do_target_link_libraries(self, command: Command) -> None:
        words = [str(word) for word in self.words(command.arguments) if word is not None]
        if words:
            self.build.links.setdefault(words[0], []).extend(words[1:])

    def do_rclcpp_components_register_node(self, command: Command) -> None:
        words = command.arguments
        named: dict[str, list[str] | None] = {}
        for key, value in itertools.pairwise(words):
            if key == "PLUGIN":
                self.plugin(value)
            elif key == "EXECUTABLE":
                self.executable([value])
            if key in ("PLUGIN", "EXECUTABLE"):
                self.component(value, words[0])
                named[str(key)] = self.known([value])
        match named.get("EXECUTABLE"), named.get("PLUGIN"):
            case [executable], [plugin]:
                self.build.main_plugins[executable] = plugin

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
            (options if options or argument in named_for("install") else sources).append(argument)
        destination = self.destination(options)
        self.sure = not (command.conditional or self.skips or self.returns)
        self.sure &= not {"OPTIONAL", "EXCLUDE_FROM_ALL"} & set(command.arguments)
        if kind in ("SCRIPT", "CODE"):
            self.build.installs_known = False
        elif kind not in ("TARGETS", "PROGRAMS", "FILES", "DIRECTORY"):
            return
        elif destination is None:
            if kind == "TARGETS" and not self.destinations(options):
                self.elsewhere(sources, unplaced=True, where=options[0] if options == ["DESTINATION"] else None)
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
        self.elsewhere(sources, unplaced=self.destinations(options).keys().isdisjoint(("RUNTIME", "")))

    def elsewhere(self, sources: list[Located], *, unplaced: bool, where: Located | None = None) -> None:
        """``where``: a word that says the place better than the name of the target does. A variable among the words may
        hold the folder too."""
        given = self.words(sources)
        words = [word for word in given if word is not None]
        found = {str(word): Located(word, where.span) if where is not None else word for word in words}
        self.build.elsewhere.update(found)
        if unplaced and self.sure and None not in given and named_for("install").isdisjoint(words):
            self.build.unplaced.update(found)

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
        found = self.destinations(options)
        chosen = found.get("RUNTIME") or found.get("") or (next(iter(found.values())) if found else None)
        expanded = None if chosen is None else self.expand(chosen)
        if expanded is None:
            return None
        text = expanded.strip("/")
        return "" if text.startswith("..") else text

    def destinations(self, options: list[Located]) -> dict[str, Located]:
        """What each kind of targets is installed into, and under the empty text what all are."""
        found: dict[str, Located] = {}
        current = ""
        for before, after in zip([Located("", self.build.source.whole), *options], options):
            if before in ("RUNTIME", "LIBRARY", "ARCHIVE", "INCLUDES"):
                current = str(before)
            if before == "DESTINATION":
                found[current] = after
        return found

    def install(self, destination: str, source: Located, tree: bool, filtered: bool = False, renamed: str = "") -> None:
        for word in self.words([source]):
            if word is None:
                self.build.installs_known = False
            else:
                place = Install(destination, str(word), tree, source.span, filtered, renamed, self.sure)
                self.build.installs.append(place)


def parse(source: Source, name: str | None = None, around: Around = ALONE) -> Build:
    """What the file of a package installs, builds and registers."""
    build = Build(source)
    known = {"CMAKE_CURRENT_SOURCE_DIR": ".", "CMAKE_SOURCE_DIR": ".", "PROJECT_SOURCE_DIR": "."}
    known |= {"CMAKE_INSTALL_LIBDIR": "lib", "CMAKE_INSTALL_DATADIR": "share", "CMAKE_INSTALL_PREFIX": ""}
    known |= {"CMAKE_CURRENT_LIST_DIR": "."}
    reader = Reader(build, known, around)
    if name:
        reader.variables["PROJECT_NAME"] = name
    reader.read()
    return build
