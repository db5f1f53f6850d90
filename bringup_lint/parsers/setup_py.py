"""setup.py and setup.cfg of a Python package: data files and console scripts, read without running anything."""

from __future__ import annotations

import configparser
import re
from typing import Any

from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import Value
from bringup_lint.model.package import Build
from bringup_lint.model.package import Install
from bringup_lint.model.package import Packages
from bringup_lint.model.python import syntax_of
from bringup_lint.parsers.launch_python import budget
from bringup_lint.parsers.launch_python.calls import call
from bringup_lint.parsers.launch_python.expressions import condition
from bringup_lint.parsers.launch_python.expressions import evaluate
from bringup_lint.parsers.launch_python.objects import Frame
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.state import Evaluator
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.statements import run
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

_SETUP = ("setuptools.setup", "distutils.core.setup", "setup")
_FIND = ("setuptools.find_packages", "find_packages")
_GLOB = ("glob.glob", "glob.iglob", "glob")
_ELSEWHERE = frozenset(("package_dir", "py_modules", "cmdclass", "package_data", "include_package_data"))
"""Keywords of ``setup()`` by which modules come from other places, too."""
_FOLDER = regex(r"^[ \t]*install[_-]scripts[ \t]*[=:][ \t]*([^\s#;]+)", re.M)
_SCRIPT = regex(r"^[^\S\n]*([\w.-]+)[ \t]*=[ \t]*([\w.]*(?::[\w.]*)?)", re.M)


def parse(source: Source) -> Build:
    """What ``setup()`` is called with; unknown parts make the build not fully known."""
    build = Build(source)
    text = source.text
    tree = syntax_of(text)
    if tree is None:
        return _unknown(build)
    found: list[dict[str, Any]] = []

    def called(
        state: State, function: Any, positional: list[Any], keywords: dict[str, Any], more: bool, span: Span
    ) -> Any:
        if isinstance(function, Symbol) and function.name in _SETUP:
            found.append(keywords)
            return Unknown("setup", span)
        if isinstance(function, Symbol) and function.name in _GLOB and positional:
            return Sequence([((), Operation("glob", (positional[0],), span))], span, state.guards)
        if isinstance(function, Symbol) and function.name in _FIND and not positional and "where" not in keywords:
            return Operation("find_packages", (), span)
        return call(state, function, positional, keywords, more, span)

    state = State(
        LaunchFile(source, "python"), Positions(source, 0), Frame({}), Evaluator(evaluate, condition, called, run)
    )
    try:
        run(state, tree.body)
    except (budget.Exhausted, RecursionError):
        return _unknown(build)
    if len(found) != 1:
        return _unknown(build)
    _data_files(build, found[0].get("data_files"))
    _scripts(build, found[0].get("entry_points"))
    listed = _packages(found[0].get("packages"))
    if not _ELSEWHERE & set(found[0]):
        build.python_packages = listed
    folders = _folders(found[0].get("package_dir"))
    if folders is not None:
        build.listed_packages, build.package_folders = listed, folders
    build.scripts_folder_known = not {"options", "cmdclass"} & set(found[0])
    if "scripts" in found[0]:
        _plain_scripts(build, found[0]["scripts"])
    return build


def _packages(thing: Any) -> Packages | None:
    """``packages``: a list of names, for which setuptools also takes paths, or what ``find_packages`` finds."""
    if isinstance(thing, Operation) and thing.name == "find_packages":
        return Packages(thing.span, None)
    items = thing.plain() if isinstance(thing, Sequence) else None
    names = [path_text(item) for item in items or ()]
    known = tuple(name.replace("/", ".") for name in names if name is not None)
    return Packages(items[0].span, known) if items and len(known) == len(names) else None


def _folders(thing: Any) -> dict[str, Located] | None:
    """``package_dir``; None when a part of it is not known."""
    if thing is None:
        return {}
    if not isinstance(thing, Mapping) or thing.open or thing.others:
        return None
    found = {str(name): path_text(folder) for name, (_, folder) in thing.entries.items()}
    places = {str(name): folder.span for name, (_, folder) in thing.entries.items() if isinstance(folder, Literal)}
    known = {name: Located(path, places[name]) for name, path in found.items() if path is not None and name in places}
    return known if len(known) == len(found) else None


def _plain_scripts(build: Build, thing: Any) -> None:
    """``scripts=[...]``: files that are installed beside the console scripts, under their own names."""
    items = thing.plain() if isinstance(thing, Sequence) else None
    build.executables_known = build.executables_known and items is not None
    for item in items or ():
        path = path_text(item)
        if path is None:
            build.executables_known = False
        else:
            name = path.rpartition("/")[2]
            build.executables.setdefault(name, Located(name, item.span))


def _unknown(build: Build) -> Build:
    build.installs_known = build.executables_known = build.scripts_folder_known = False
    return build


def _data_files(build: Build, thing: Any) -> None:
    if thing is None:
        return
    entries = thing.plain() if isinstance(thing, Sequence) else None
    for entry in entries or ():
        pair = entry.plain() if isinstance(entry, Sequence) else None
        destination = path_text(pair[0]) if pair and len(pair) == 2 else None
        if pair is None or destination is None:
            build.installs_known = False
        else:
            _install(build, destination, pair[1])
    if entries is None:
        build.installs_known = False


def _install(build: Build, destination: str, files: Any) -> None:
    items = _flat(files)
    if items is None:
        build.installs_known = False
    for item in items or ():
        computed = isinstance(item, Operation)
        pattern = item.operands[0] if isinstance(item, Operation) and item.operands else item
        source = path_text(pattern)
        if source is None:
            build.installs_known = False
        else:
            build.installs.append(Install(destination, source, False, pattern.span, sure=not computed))


def _flat(thing: Any) -> list[Any] | None:
    """The items of a list with those of lists in it, or of the lists that a condition chooses from; None when these
    are not known."""
    if isinstance(thing, Sequence):
        parts = [_flat(item) if isinstance(item, Sequence) else [item] for _, item in thing.items]
        parts += [None] if thing.open else []
    elif isinstance(thing, Options):
        parts = [_flat(option) for _, option in thing.options]
    else:
        return None
    known = [part for part in parts if part is not None]
    return [item for part in known for item in part] if len(known) == len(parts) else None


def path_text(value: Any) -> str | None:
    """A path of literals; relative to this file."""
    if isinstance(value, Literal) and isinstance(value.value, str):
        return str(value.value)
    if isinstance(value, FileDir):
        return ""
    if isinstance(value, PathJoin):
        parts = _path_texts(value.parts)
        return None if parts is None else "/".join(part.strip("/") for part in parts if part)
    if isinstance(value, Concat):
        parts = _path_texts(value.parts)
        return None if parts is None else "".join(parts)
    return None


def _path_texts(values: tuple[Value, ...]) -> list[str] | None:
    """None when one of them is not known."""
    texts = [path_text(value) for value in values]
    known = [text for text in texts if text is not None]
    return known if len(known) == len(texts) else None


def _scripts(build: Build, thing: Any) -> None:
    if thing is None:
        return
    if not isinstance(thing, Mapping) or thing.open:
        build.executables_known = False
        return
    scripts = thing.entries.get("console_scripts")
    if scripts is None:
        return
    items = scripts[1].plain() if isinstance(scripts[1], Sequence) else None
    for item in items or ():
        if isinstance(item, Literal) and isinstance(item.value, Located):
            name = item.value.part(0, max(item.value.find("="), 0)).strip_located()
            build.executables[str(name)] = name
            build.entry_points[str(name)] = item.value.partition("=")[2].partition("[")[0].strip()
        else:
            build.executables_known = False
    if items is None:
        build.executables_known = False


def parse_cfg(source: Source) -> Build:
    """The ``console_scripts`` and ``data_files`` of a setup.cfg, with the place of the file only."""
    build = Build(source)
    parser = configparser.RawConfigParser(strict=False, interpolation=None)
    try:
        parser.read_string(source.text)
    except (configparser.Error, ValueError):
        return _unknown(build)
    build.scripts_folder = _scripts_folder(parser, source)
    scripts = parser.get("options.entry_points", "console_scripts", fallback="")
    for match in _SCRIPT.finditer(scripts):
        build.executables[match[1]] = Located(match[1], source.whole)
        build.entry_points[match[1]] = match[2]
    if parser.has_section("options.data_files"):
        for destination, files in parser.items("options.data_files"):
            for file in files.split():
                build.installs.append(Install(destination, file, False, source.whole))
    return build


def _scripts_folder(parser: configparser.RawConfigParser, source: Source) -> Located | None:
    """``install_scripts`` of ``[install]``; setuptools takes a hyphen for an underscore."""
    options = parser.items("install") if parser.has_section("install") else []
    value = next((value.strip() for name, value in options if name.replace("-", "_") == "install_scripts"), None)
    if value is None:
        return None
    written = next((match for match in _FOLDER.finditer(source.text) if match[1] == value), None)
    return Located(value, Span(source, *written.span(1)) if written else source.whole)
