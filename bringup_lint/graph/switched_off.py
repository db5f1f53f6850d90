"""What a tree explicitly does not start: programs that only launch actions name which the code makes and never adds,
or that only a comment starts or builds, and the files that only these are given. What is found there is information.

Words decide, as for what leads to a copy: a program that any other file or page starts is not switched off, and
neither is one that nothing starts and nothing switched off."""

from __future__ import annotations

import os
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.files import Files
from bringup_lint.graph.words import named
from bringup_lint.graph.words import words
from bringup_lint.model.launch import LaunchFile
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers import launch_python
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_BUILDING = ("ros-package", "cmake", "setup-py", "setup-cfg")
"""Kinds that name every program, started or not."""
_PROGRAMS = ("python-node", "cpp-node", "cpp-driver")
_GIVEN = ("params", *LAUNCH)
"""Kinds of the files that a launch file names."""
_TOKEN = regex(
    r'(?P<long>"""[\s\S]*?"""|\'\'\'[\s\S]*?\'\'\')|(?P<text>"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\')|#[^\n]*'
)
"""Texts and comments of Python."""
_REMARK = {"launch-xml": regex(r"<!--[\s\S]*?(?:-->|\Z)"), "launch-yaml": regex(r"(?m)(?:^|[ \t])#[^\n]*")}
_OTHER_REMARK = regex(r"(?m)^[ \t]*(?:#|//)[^\n]*")
_QUOTED = regex(r"[\"']([^\"'\n]{2,200})[\"']")
_STARTS = regex(r"\b(?:executable|node_executable|exec|type)\s{0,4}=\s{0,4}[\"']([\w.-]{2,100})[\"']")
_LOADS = regex(r"\bplugin\s{0,4}=\s{0,4}[\"'](?:\w+::){1,8}(\w+)[\"']")
_CODE = regex(r"\b(?:Node|IncludeLaunchDescription|add_action)\s{0,4}\(")
_PROSE = regex(r"(?<![A-Za-z])[A-Za-z]{2,20} {1,4}[A-Za-z]{2,20} {1,4}[A-Za-z]{2}")
"""Of a comment that says something: code hardly has three words in a row."""
_AFFIX = 4
"""Letters of the fixed part of a computed name, at least."""
_COMMAND = regex(r"\bros2[ \t]|\brosrun\b")
"""Of a comment that says how a person starts something."""
_TYPED = regex(r"\b(?:ros2|python3?|bash|source|sudo|systemctl|docker|just|make|tmux|rosrun|roslaunch)\b|\./")
"""Of a line of a page that has a command."""
_PAGE = regex(r"(?i)\.(?:md|rst|txt|adoc|html|ipynb)$")
_OTHERS = regex(
    r"(?i)(?:\.(?:mk|just|kdl|desktop|j2|jinja2?|in|ya?ml|json|toml|xml|cfg|ini|conf|sh|bash|zsh|bats|plist|lua|ps1"
    r"|py|js|ts|tsx|vue|php|rb|go|rs)|/[\w-]+)$"
)
"""Files that may start programs, of whatever kind."""
_SIZE = 200_000
"""How much is read of a page."""
_RUNS = regex(r"\b(?:subprocess|LaunchService|ament_index\w*|popen|execvp?e?|system)\b|\bros2[ \t]", hints="")
"""Of a program that may start others."""
_SUFFIX = regex(r"[\"'}+]\.(?:ya?ml|launch|xml|py)\b|%s|\$\(")
"""Of a name that is put together from its stem."""
_ENTRY = regex(r"(?m)^[ \t]*([\w.-]+)[ \t]*=[ \t]*([\w.]+)[ \t]*:[ \t]*\w")
_QUOTED_ENTRY = regex(r"[\"'][ \t]*([\w.-]+)[ \t]*=[ \t]*([\w.]+)[ \t]*:[ \t]*\w")
_IMPORT = regex(r"(?m)^[ \t]*(?:from|import)\b[^\n#(]*(?:\([^()]*\))?")
_BUILT = regex(r"\badd_(executable|library)[ \t]*\(\s*([\w.-]+)\s([^()]*)\)")
_SOURCE = regex(r"(?<![\w.-])([\w.-]{1,120}\.c(?:pp|c|xx))\b")
_GATHERS = regex(
    r"(?i)\bGLOB(?:_RECURSE)?\b|\baux_source_directory\b|\}[\w.-]{0,80}\.c(?:pp|c|xx)\b"
    r"|\bament_auto_add_\w{1,20}\s{0,4}\([^()]{0,200}\bDIRECTORY\b"
)
"""Commands of CMake that may build files which they do not name."""
_REMARKS = regex(r"(?m)^[ \t]*#+[ \t]*([^\n]*)")
_PLUGIN = regex(r"\bPLUGIN\s+\"?(?:\w+::)*(\w+)\"?(?:\s+EXECUTABLE\s+\"?([\w.-]+))?")
_REGISTERED = regex(r"\bRCLCPP_COMPONENTS_REGISTER_NODE\s*\(\s*(?:\w*::)*(\w+)", hints="RCLCPP_COMPONENTS")
_ROUNDS = 4
"""How often what a file that is switched off names is taken away from what is live."""


class _Text(NamedTuple):
    """What is live of a file, and what of it is switched off."""

    live: str
    off: str


class SwitchedOff:
    """Asked for a source: whether it is only of what the tree switches off."""

    def __init__(self, files: Files) -> None:
        self._files = files

    def has(self, source: Source) -> bool:
        if source.kind not in (*_GIVEN, *_PROGRAMS) or self._files.is_configured(source):
            return False
        return source.absolute in self._programs if source.kind in _PROGRAMS else source in self._given

    @cached_property
    def _texts(self) -> dict[Source, _Text]:
        """What launch files say."""
        sources = self._files.of_kind("launch-python")
        idle = {file.source: file for file in self._files.parsed(launch_python.parse, sources)}
        found = {source: _python(source, idle[source]) for source in sources if source in idle}
        for source in self._files.of_kind("launch-xml", "launch-yaml"):
            remarks = _REMARK[source.kind]
            off = [each[0] for each in remarks.finditer(source.text) if _is_code(each[0])]
            found[source] = _Text(remarks.sub("", source.text), "\n".join(off))
        return found

    @cached_property
    def _evidence(self) -> frozenset[str]:
        """The words of what is switched off: programs, classes of components, and texts in quotes."""
        return frozenset(word for text in self._texts.values() for word in _switched(text.off))

    @cached_property
    def _given(self) -> frozenset[Source]:
        """The parameter and launch files that only what is switched off names."""
        off: frozenset[Source] = frozenset()
        evidence = set(self._evidence)
        for _ in range(_ROUNDS):
            candidates = [each for each in self._files.of_kind(*_GIVEN) if each.basename in evidence]
            new = frozenset(self._unnamed(candidates, off)) if candidates else off
            if new == off:
                break
            off = new
            evidence |= {word for each in off for word in _switched(each.text)}
        return off

    def _unnamed(self, candidates: list[Source], off: frozenset[Source]) -> Iterator[Source]:
        """Those that no live text names, but for their own and those of what is switched off itself."""
        left = {source.basename: source for source in candidates}
        names = left.keys() - {source.basename for source in candidates if left[source.basename] is not source}
        for source, text in self._live_texts(_BUILDING):
            if not names:
                return
            if source not in off:
                here = words(text)
                parts = _SUFFIX.search(text)
                stems = {name for name in names if name.partition(".")[0] in here} if parts else set()
                names -= {name for name in {*named(names, here), *stems} if left[name] is not source}
        yield from (left[name] for name in names)

    def _live_texts(self, without: Iterable[str]) -> Iterator[tuple[Source | None, str]]:
        """What files and pages say that is not put away."""
        for source in self._files.sources:
            if source.kind not in without:
                yield source, self._live(source)
        known = {source.absolute for source in self._files.sources}
        tree = self._files.tree
        for path in tree.like(_OTHERS):
            if path not in known:
                yield None, tree.head(path, _SIZE)
        for path in tree.like(_PAGE):
            if path not in known:
                lines = tree.head(path, _SIZE).replace("\\\n", " ").splitlines()
                yield None, "\n".join(line for line in lines if _TYPED.search(line))

    def _live(self, source: Source) -> str:
        text = self._texts.get(source)
        return text.live if text is not None else _OTHER_REMARK.sub("", source.text)

    @cached_property
    def _started(self) -> frozenset[str]:
        """Every word of what may start a program, and the last part of each module."""
        found: set[str] = set()
        for source, text in self._live_texts((*_BUILDING, "params", "urdf")):
            if source in self._given:
                continue
            if source is None or source.kind not in _PROGRAMS or _RUNS.search(text):
                here = words(text)
                found |= here
                found.update(word.rpartition(".")[2] for word in here if "." in word)
        return frozenset(found)

    def _may_start(self, names: Iterable[str]) -> Iterator[str]:
        """The names that launch files may put together from a fixed part and one that they compute."""
        found = {word for text in self._texts.values() for word in words(text.live) if len(word) >= _AFFIX}
        starts = tuple(word for word in found if word.endswith(("_", "-")))
        ends = tuple(word for word in found if word.startswith("_"))
        yield from (name for name in names if name.startswith(starts) or name.endswith(ends))

    @cached_property
    def _off(self) -> frozenset[str]:
        """The programs and the classes of components that are switched off, and that nothing starts."""
        texts = (*(text.off for text in self._texts.values()), *(source.text for source in self._given))
        names = {name for text in texts for name in (*_STARTS.findall(text), *_LOADS.findall(text))}
        left = names - self._started if names else names
        return frozenset(left.difference(self._may_start(left))) if left else frozenset()

    @cached_property
    def _programs(self) -> frozenset[str]:
        """The absolute paths of the sources that are only of such programs, or whose build is put into comments."""
        return frozenset((*self._scripts(), *self._built(), *self._components()))

    def _scripts(self) -> Iterator[str]:
        """The modules whose console scripts are all switched off, and that nothing imports."""
        starts: dict[str, set[str]] = {}
        put_away: set[str] = set()
        for setup in self._files.of_kind("setup-py", "setup-cfg"):
            for path, name in _entries(setup, setup.uncommented):
                starts.setdefault(path, set()).add(name)
            put_away.update(path for path, _ in _entries(setup, _remarks(setup)))
        for source in self._files.of_kind("python-node"):
            stem = source.basename.removesuffix(".py")
            names = starts.get(source.absolute, {source.basename})
            is_left_out = source.absolute in put_away - starts.keys() and self._started.isdisjoint(
                (stem, source.basename)
            )
            if (is_left_out or names <= self._off) and stem not in self._imported:
                yield source.absolute

    @cached_property
    def _imported(self) -> frozenset[str]:
        """Every word of the imports of Python files."""
        texts = (source.uncommented for source in self._files.of_kind("python-node", "launch-python", "setup-py"))
        return frozenset(
            word for text in texts for line in _IMPORT.findall(text) for word in words(line.replace(".", " "))
        )

    def _built(self) -> Iterator[str]:
        """The C++ sources of which CMake builds only programs that are switched off, or that only comments build."""
        builds = self._files.of_kind("cmake")
        targets: dict[str, set[str]] = {}
        """Basename of a source -> the programs of it; a library has no name here."""
        put_away: set[str] = set()
        for build in builds:
            for what, name, rest in _BUILT.findall(build.uncommented):
                for source in _SOURCE.findall(rest):
                    targets.setdefault(source, set()).add(name if what == "executable" else "")
            put_away.update(name for _, _, rest in _BUILT.findall(_remarks(build)) for name in _SOURCE.findall(rest))
        if put_away:
            put_away -= {name for build in builds for name in _SOURCE.findall(build.uncommented)}
            put_away = set() if any(_GATHERS.search(build.uncommented) for build in builds) else put_away
        for source in self._files.of_kind("cpp-node", "cpp-driver"):
            names = targets.get(source.basename, set())
            is_off = bool(names) and names <= self._off
            if (is_off or source.basename in put_away) and self._is_single(source):
                yield source.absolute

    def _is_single(self, source: Source) -> bool:
        return sum(1 for _ in self._files.tree.named(source.basename)) == 1

    def _components(self) -> Iterator[str]:
        """The C++ sources whose components are all switched off, with the programs that CMake makes of them."""
        alone: dict[str, str] = {}
        for build in self._files.of_kind("cmake"):
            alone.update(_PLUGIN.findall(build.uncommented))
        for source in self._files.of_kind("cpp-node", "cpp-driver"):
            names = set(_REGISTERED.findall(source.text)) if self._off else set()
            if names and names <= self._off and all(alone.get(name, "") not in self._started for name in names):
                yield source.absolute


def _remarks(build: Source) -> str:
    """The lines of a build description that are comments, without their signs."""
    return "\n".join(_REMARKS.findall(build.text))


def _entries(setup: Source, text: str) -> Iterator[tuple[str, str]]:
    """The absolute paths that the modules of console scripts may have, each with the script."""
    folder = os.path.dirname(setup.absolute)
    for name, module in (_QUOTED_ENTRY if setup.kind == "setup-py" else _ENTRY).findall(text):
        for inner in ("", "src"):
            yield os.path.normpath(os.path.join(folder, inner, *module.split(".")) + ".py"), name


def _python(source: Source, file: LaunchFile) -> _Text:
    """The texts of a Python launch file: those in values that nothing uses, and comments, are switched off."""
    live: list[str] = []
    off = [source.text[each.start : each.end] for each in file.idle]
    idle = iter(sorted((each.start, each.end) for each in file.idle))
    start, end = next(idle, (len(source.text), len(source.text)))
    for token in _TOKEN.finditer(source.text):
        while token.start() >= end and end < len(source.text):
            start, end = next(idle, (len(source.text), len(source.text)))
        if token.start() >= start:
            continue
        text = token[0] if token["long"] is None else token[0][3:-3]
        is_off = token["text"] is None and (_is_code(text) if token["long"] is None else _CODE.search(text))
        (off if is_off and not _COMMAND.search(text) else live).append(text)
    return _Text("\n".join(live), "\n".join(off))


def _is_code(remark: str) -> bool:
    """Whether a comment puts away code, and does not say something to people."""
    if remark.startswith("<!--"):
        return "<" in remark[1:] and _COMMAND.search(remark) is None
    code, _, _ = _QUOTED.sub('""', remark.strip().lstrip("#")).partition("#")
    return _PROSE.search(code) is None and _COMMAND.search(remark) is None


def _switched(text: str) -> Iterator[str]:
    """The words in the quotes of a text that is switched off."""
    for quoted in _QUOTED.findall(text):
        yield from words(quoted)
