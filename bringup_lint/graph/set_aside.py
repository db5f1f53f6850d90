"""Files that a tree keeps and uses no more: a unit that nothing installs while others beside it are, a script of an
image that nothing runs, a Dockerfile that nothing builds, a role that no play takes, the copy of a file in a folder of
documentation, and what a folder of an older version or an archive holds. What is found there is information.

Only what is plain counts: a folder that is taken as a whole, a name that is put together, and a page that names the
file all use it."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections import defaultdict
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.graph.containers.compose import Compose
from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.purpose import by_path
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.templates import final_name

_UNIT = regex(r"\.(?:service|timer|socket|path|target)$")
_ROLE = regex(r"(?P<roles>(?:^|.*/)roles)/(?P<name>[\w.-]+)/(?=[^/]+/)")
_DOCUMENTATION = regex(r"(?i)(?:^|/)(?:docs?|documentations?)/")
_USERS = regex(
    r"(?i)(?:\.(?:mk|just|kdl|desktop|j2|jinja2?|in|ya?ml|json|toml|xml|cfg|ini|conf|sh|bash|zsh|bats|plist|lua|ps1"
    r"|py|m?js|ts|tsx|php|rb|go|rs|c|cc|cpp|hpp|h|cmake|nix|bb|bbappend|spec|install|postinst|preinst|m4|rules|md|rst|txt"
    r"|adoc|html|ipynb|service|target|timer)|/[\w-]+)$"
)
"""Files that may use others, or say to people how to."""
_REMARK = regex(r"(?m)^[ \t]*(?:#(?!!)|//|\*(?=[ \t/*])|<!--)[^\n]*")
_DRAWING = regex(r"(?m)^[^\n\w]{0,40}[├└│][^\n]*")
"""Of folders."""
_PAGE = regex(r"(?i)\.(?:md|rst|txt|adoc)$")
"""Texts for people, in which a heading and an item of a list are no comments."""
_SIZE = 200_000
"""How much is read of a file."""
_MOST = 20_000
"""Files of a tree that is looked through."""
_BRINGS = (
    r"\b(?:cp|ln|mv|install|rsync|scp|link\w{0,20}|symlink\w{0,20}|copy|COPY|ADD|src|put|enabled?|start|restart"
    r"|PROGRAMS|FILES|template|tee)\b"
)
_WHOLE = r"\b(?:cp|ln|mv|install|rsync|scp|copy|COPY|ADD|src|DIRECTORY|glob|iglob|listdir|iterdir|for|find|tar)\b"
_EVERY_UNIT = regex(r"\*\.(?:service|timer|socket|path|target|\{|\$)")
_STARTS = regex(r"\bsystemctl\b|\bdh_installsystemd\b[^\n]*--name\b", hints="systemctl dh_installsystemd")
_MATCHED = regex(r"(?<![\w-])([\w-]{1,80})@?\.[*{]")
"""The stem of a name whose ending is a pattern."""
_STARTS_ANY = regex(r"\bsystemctl\b[^\n]*\$")
"""Starts a unit whose name a variable has."""
_SUFFIX = regex(r"[\]}\"'%)*s]\.(?:service|timer|socket|path|target)\b")
"""Of a name that is put together from its stem."""
_WORD = regex(r"[\w@](?:[\w.@-]*[\w@-])?")
_PLACE = regex(r"/systemd/(?:system|user)/[^/]+$")
"""A folder from which systemd loads units: such a tree is copied as a whole."""
_OF_UNIT = regex(r"\.(?:service|timer|socket|path|target)\b")
_ALIKE = 50
"""Files of one name with which a page is compared."""
_FEWEST = 2
"""Files beside one that are used, at least: of two, each may be for another machine."""
_IMAGES = ("Dockerfile", "Containerfile")
_PUT_TOGETHER = regex(
    r"(?:Docker|Container)file[._-](?:[\"']?[ \t]*[$*{%+])|[$*}%][\w}]{0,40}[\"']?[._-](?:Docker|Container)file\b"
)
"""The name of a Dockerfile of which a variable or a pattern has a part."""
_INSTALLS = regex(r"(?:install|setup|build)[-_]")
_IN_IMAGE = regex(r"^[ \t]*(?:COPY|ADD|RUN)\b(?:[^\n]*\\\n)*[^\n]*", re.M)


class _Text(NamedTuple):
    path: str
    text: str


class SetAside:
    """Asked for a source: whether the tree keeps it and does not use it."""

    def __init__(self, files: Files, compose: Callable[[], Compose]) -> None:
        self._files = files
        self._compose = compose

    def has(self, source: Source) -> bool:
        if self._files.tree.root is not None or source.origin is not None or self._files.is_configured(source):
            return False
        if len(self._files.tree.paths) > _MOST:
            return self._files.purpose(source) is Purpose.ARCHIVE
        if self._files.purpose(source) is Purpose.ARCHIVE:
            return not self._is_taken_from_archive(source)
        role = _ROLE.match(self._path(source.absolute))
        if role is not None and self._is_idle_role((role["roles"], role["name"])):
            return True
        return self._is_copied_page(source) or self._is_idle(source)

    @memo
    def _is_taken_from_archive(self, source: Source) -> bool:
        """Whether something that is no page, and outside of the folder, has a file by its path."""
        place = "/".join(self._path(source.absolute).split("/")[-2:])
        return any(
            place in each.text and not _PAGE.search(each.path) and by_path(each.path) is not Purpose.ARCHIVE
            for each in self._saying(source.basename, source)
        )

    def _is_idle(self, source: Source) -> bool:
        if source.kind == "dockerfile":
            return self._is_left_over(source)
        if source.kind == "systemd-unit":
            return self._is_idle_unit(source)
        return source.kind == "shell-script" and self._is_idle_script(source)

    @memo
    def _is_copied_page(self, source: Source) -> bool:
        """Whether a file of the documentation has the name of one outside of it, which is the one that is used."""
        path = self._path(source.absolute)
        if not _DOCUMENTATION.search(path):
            return False
        used = self._outside_of_documentation.get((source.kind, source.basename), ())
        if not any(_is_copy(source.text, each.text) for each in used[:_ALIKE]):
            return False
        place = "/".join(path.split("/")[-2:])
        return not any(place in each.text for each in self._saying(source.basename, source))

    @cached_property
    def _outside_of_documentation(self) -> dict[tuple[str, str], list[Source]]:
        found: dict[tuple[str, str], list[Source]] = {}
        for each in self._files.sources:
            if not _DOCUMENTATION.search(self._path(each.absolute)):
                found.setdefault((each.kind, each.basename), []).append(each)
        return found

    @memo
    def _is_left_over(self, source: Source) -> bool:
        """Whether nothing builds a Dockerfile, and another one is built in its place. That of the top, people build."""
        from bringup_lint.graph.containers.questions.image_use import is_left_over

        path = self._path(source.absolute)
        if path == "Dockerfile" or self._is_built(source, path):
            return False
        compose = self._compose()
        return any(is_left_over(compose, file) for file in compose.images.dockerfiles if file.source is source)

    def _is_built(self, source: Source, path: str) -> bool:
        """Whether a page, a script or a setting names a Dockerfile, or puts its name together."""
        folder, name = os.path.basename(os.path.dirname(path)), source.basename
        if name not in _IMAGES:
            return self._names_are_put_together or next(self._saying(name, source), None) is not None
        built = re.compile(
            rf"\b(?:docker|podman)\b[^\n]*\bbuild\b[^\n]*[\s/\"']{re.escape(folder)}(?:[/\s\"',]|$)|[$}}*]/{name}\b",
            re.M,
        )
        return any(built.search(each.text) for each in self._saying(folder, source))

    @cached_property
    def _names_are_put_together(self) -> bool:
        return any(_PUT_TOGETHER.search(each.text) for each in self._texts)

    @memo
    def _is_idle_role(self, role: tuple[str, str]) -> bool:
        """Whether no play and no other role names a role, while others of its folder are named."""
        folder, name = role
        taken = self._taken_roles
        if name in taken or len(self._roles[folder] & taken) < _FEWEST or any("{{" in each for each in taken):
            return False
        others = (each.text for each in self._by_word.get(name, ()) if not each.path.startswith(f"{folder}/{name}/"))
        used = re.compile(rf"roles/{re.escape(name)}(?![\w-])|_role\b[^\n]*\bname={re.escape(name)}(?![\w-])")
        return not any(used.search(text) for text in others)

    @cached_property
    def _roles(self) -> defaultdict[str, set[str]]:
        """The folders of roles, each with the names of those in it."""
        found: defaultdict[str, set[str]] = defaultdict(set)
        for match in (match for each in self._texts if (match := _ROLE.match(each.path))):
            found[match["roles"]].add(match["name"])
        return found

    @cached_property
    def _taken_roles(self) -> frozenset[str]:
        """The names of roles in plays, tasks and the metadata of roles."""
        from bringup_lint.graph.installed.ansible.roles import Roles
        from bringup_lint.graph.installed.ansible.roles import named_roles

        sources = self._files.of_kind("ansible")
        named = {str(name).rpartition("/")[2] for source in sources for name in named_roles(source)}
        of_collections = {name.rpartition(".")[2] for name in named if name.count(".") > 1}
        return frozenset(named | of_collections | set(Roles(self._files).needed))

    @memo
    def _is_idle_unit(self, source: Source) -> bool:
        """Whether nothing installs, links or starts a unit, while others beside it are, each by its name."""
        if not _UNIT.search(final_name(source.basename)) or _PLACE.search(source.absolute):
            return False
        folder = os.path.dirname(self._path(source.absolute))
        if self._brought_units[folder] < _FEWEST or self._uses(source):
            return False
        own = self._path(source.absolute)
        return not any(path != own for path in self._taking(folder))

    def _is_brought(self, unit: Source) -> bool:
        """Whether a line installs or starts a unit by its name."""
        own = self._path(unit.absolute)
        return any(path != own for path in self._bringing.get(final_name(unit.basename), ()))

    @cached_property
    def _units(self) -> defaultdict[str, list[Source]]:
        """The units of each folder."""
        found: defaultdict[str, list[Source]] = defaultdict(list)
        for each in self._files.of_kind("systemd-unit"):
            if each.origin is None:
                found[os.path.dirname(self._path(each.absolute))].append(each)
        return found

    @cached_property
    def _brought_units(self) -> Counter[str]:
        """How many units of each folder a line installs or starts by their names."""
        return Counter({folder: sum(map(self._is_brought, units)) for folder, units in self._units.items()})

    @cached_property
    def _bringing(self) -> dict[str, set[str]]:
        """The names of units in lines that install or start something, each with the files that have them."""
        return self._behind(regex(_BRINGS), _OF_UNIT)

    @cached_property
    def _asking(self) -> dict[str, set[str]]:
        """The words of lines that start units, each with the files that have them."""
        return self._behind(_STARTS, regex(""))

    def _behind(self, pattern: re.Pattern[str], lines: re.Pattern[str]) -> dict[str, set[str]]:
        """The words that follow a pattern in lines, with and without the ending, each with the files that have them."""
        found: dict[str, set[str]] = {}
        for each in (one for one in self._texts if pattern.search(one.text)):
            for line in filter(lines.search, each.text.splitlines()):
                match = pattern.search(line)
                if match is None:
                    continue
                for word in _WORD.findall(line, match.end()):
                    for part in (word, word.rpartition(".")[0], word.partition("@")[0]):
                        found.setdefault(part, set()).add(each.path)
        return found

    @memo
    def _uses(self, unit: Source) -> bool:
        """Whether anything of the tree may install or start a unit, or pull it in."""
        name, own = final_name(unit.basename), self._path(unit.absolute)
        stem = name.rpartition(".")[0].rstrip("@")
        if next(self._saying(name, unit), None) is not None or stem in self._matched:
            return True
        if any(path != own for path in self._asking.get(stem, ())) or ("@" in name and stem in self._instances):
            return True
        return any(each.path in self._putting_together for each in self._saying(stem, unit))

    @cached_property
    def _putting_together(self) -> frozenset[str]:
        """The files that put the name of a unit together from its stem."""
        return frozenset(
            each.path for each in self._texts if _SUFFIX.search(each.text) or _STARTS_ANY.search(each.text)
        )

    @cached_property
    def _matched(self) -> frozenset[str]:
        """The stems of names of which a pattern has the ending."""
        return frozenset(stem for each in self._texts for stem in _MATCHED.findall(each.text))

    @cached_property
    def _instances(self) -> frozenset[str]:
        """The stems of templates of which an instance is named."""
        parts = (word.partition("@") for word in self._by_word)
        return frozenset(stem for stem, _, name in parts if name and not name.startswith("."))

    @memo
    def _taking(self, here: str) -> list[str]:
        """The files with a line that takes a whole folder of units, and not one of their names."""
        names = {final_name(each.basename) for each in self._units[here]}
        folder = os.path.basename(here) or os.path.basename(self._top.rstrip("/"))
        place = re.compile(
            rf"(?<![\w.-]){re.escape(folder)}(?:/?[\"']?(?:[\s,)\]}}:]|$)|/[\"']?(?:\*|\$|\{{|\.(?![\w.])))"
        )
        whole = regex(_WHOLE)
        found = [each.path for each in self._by_folder.get(here, ()) if _EVERY_UNIT.search(each.text)]
        for each in self._by_word.get(folder, ()):
            lines = (line for line in each.text.splitlines() if folder in line and place.search(line))
            if _EVERY_UNIT.search(each.text) or any(
                whole.search(line) and names.isdisjoint(map(final_name, _WORD.findall(line))) for line in lines
            ):
                found.append(each.path)
        return found

    @memo
    def _is_idle_script(self, source: Source) -> bool:
        """Whether nothing names a script that installs something, while a Dockerfile puts others beside it into its
        image, each by its name. Those in the folder of the Dockerfile itself are for people."""
        if not _INSTALLS.match(source.basename):
            return False
        folder = os.path.dirname(source.absolute)
        if folder in self._with_dockerfile or self._scripts_in_image[folder] < _FEWEST:
            return False
        return next(self._saying(source.basename, source), None) is None

    @cached_property
    def _with_dockerfile(self) -> frozenset[str]:
        return frozenset(os.path.dirname(each.absolute) for each in self._files.of_kind("dockerfile"))

    @cached_property
    def _scripts_in_image(self) -> Counter[str]:
        """How many scripts of each folder steps of images name."""
        steps = (step for each in self._files.of_kind("dockerfile") for step in _IN_IMAGE.findall(each.text))
        named = {word for step in steps for word in _WORD.findall(step)}
        scripts = (each for each in self._files.of_kind("shell-script") if each.basename in named)
        return Counter(os.path.dirname(path) for path in {each.absolute for each in scripts})

    def _saying(self, word: str, source: Source) -> Iterator[_Text]:
        """The texts that have a word, but for the file itself."""
        own = self._path(source.absolute)
        return (each for each in self._by_word.get(word, ()) if each.path != own)

    @cached_property
    def _by_word(self) -> dict[str, list[_Text]]:
        found: dict[str, list[_Text]] = {}
        for each in self._texts:
            for word in set(_WORD.findall(each.text)):
                found.setdefault(word, []).append(each)
        return found

    @cached_property
    def _by_folder(self) -> dict[str, list[_Text]]:
        found: dict[str, list[_Text]] = {}
        for each in self._texts:
            found.setdefault(os.path.dirname(each.path), []).append(each)
        return found

    def _path(self, absolute: str) -> str:
        return absolute.removeprefix(self._top)

    @cached_property
    def _top(self) -> str:
        return f"{os.path.commonpath(self._files.tree.paths)}/"

    @cached_property
    def _texts(self) -> list[_Text]:
        """What files say that may use others, but for their comments."""
        tree = self._files.tree
        known = {source.absolute: source for source in self._files.sources if source.origin is None}
        texts = {path: source.text for path, source in known.items()}
        texts.update({path: tree.head(path, _SIZE) for path in tree.like(_USERS) if path not in known})
        return [_Text(self._path(path), _said(path, text)) for path, text in texts.items()]


def _said(path: str, text: str) -> str:
    """A text without comments and drawings of folders."""
    text = _DRAWING.sub("", text)
    return text if _PAGE.search(path) else _REMARK.sub("", text)


def _is_copy(text: str, other: str) -> bool:
    """Whether most lines of a text are those of another one."""
    lines, others = set(text.split("\n")), set(other.split("\n"))
    return len(lines & others) * 2 > len(lines)
