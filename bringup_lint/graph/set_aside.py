"""Files that a tree keeps and uses no more: a unit that nothing installs while others beside it are, a script of an
image that nothing runs, a Dockerfile that nothing builds, a role that no play takes, the copy of a file in a folder of
documentation, and what a folder of an older version or an archive holds. What is found there is information.

Only what is plain counts: a folder that is taken as a whole, a name that is put together, and a page that names the
file all use it."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.graph.containers.compose import Compose
from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.graph.purpose import Purpose
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
_REMARK = regex(r"(?m)^[ \t]*(?:#(?!!)|//|\*|<!--)[^\n]*|^[^\n\w]{0,40}[├└│][^\n]*")
"""Comments, and drawings of folders."""
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
_SUFFIX = regex(r"[\]}\"'%)*s]\.(?:service|timer|socket|path|target)\b")
"""Of a name that is put together from its stem."""
_WORD = regex(r"[\w@](?:[\w.@-]*[\w@-])?")
_PLACE = regex(r"/systemd/(?:system|user)/[^/]+$")
"""A folder from which systemd loads units: such a tree is copied as a whole."""
_FEWEST = 2
"""Files beside one that are used, at least: of two, each may be for another machine."""
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
        if self._files.purpose(source) is Purpose.ARCHIVE:
            return True
        if len(self._files.tree.paths) > _MOST:
            return False
        role = _ROLE.match(self._path(source.absolute))
        if role is not None and self._is_idle_role((role["roles"], role["name"])):
            return True
        return self._is_copied_page(source) or self._is_idle(source)

    def _is_idle(self, source: Source) -> bool:
        if source.kind == "dockerfile":
            return self._is_left_over(source)
        if source.kind == "systemd-unit":
            return self._is_idle_unit(source)
        return source.kind == "shell-script" and self._is_idle_script(source)

    def _is_copied_page(self, source: Source) -> bool:
        """Whether a file of the documentation has the name of one outside of it, which is the one that is used."""
        path = self._path(source.absolute)
        if not _DOCUMENTATION.search(path):
            return False
        others = (each for each in self._files.of_kind(source.kind) if each.basename == source.basename)
        used = (each for each in others if not _DOCUMENTATION.search(self._path(each.absolute)))
        if not any(_is_copy(source.text, each.text) for each in used):
            return False
        place = "/".join(path.split("/")[-2:])
        return not any(place in each.text for each in self._saying(source.basename, source))

    @memo
    def _is_left_over(self, source: Source) -> bool:
        """Whether nothing builds a Dockerfile, and another one is built in its place. That of the top, people build."""
        from bringup_lint.graph.containers.questions.image_use import is_left_over

        if self._path(source.absolute) == "Dockerfile":
            return False
        compose = self._compose()
        return any(is_left_over(compose, file) for file in compose.images.dockerfiles if file.source is source)

    @memo
    def _is_idle_role(self, role: tuple[str, str]) -> bool:
        """Whether no play and no other role names a role, while others of its folder are named."""
        folder, name = role
        taken = self._taken_roles
        if any("{{" in each for each in taken) or name in taken:
            return False
        beside = {
            match["name"] for each in self._texts if (match := _ROLE.match(each.path)) and match["roles"] == folder
        }
        if len(beside & taken) < _FEWEST:
            return False
        others = (each.text for each in self._by_word.get(name, ()) if not each.path.startswith(f"{folder}/{name}/"))
        return not any(f"roles/{name}" in text for text in others)

    @cached_property
    def _taken_roles(self) -> frozenset[str]:
        """The names of roles in plays, tasks and the metadata of roles."""
        from bringup_lint.graph.installed.ansible.roles import Roles
        from bringup_lint.graph.installed.ansible.roles import named_roles

        sources = self._files.of_kind("ansible")
        named = {str(name).rpartition("/")[2] for source in sources for name in named_roles(source)}
        return frozenset(named | set(Roles(self._files).needed))

    @memo
    def _is_idle_unit(self, source: Source) -> bool:
        """Whether nothing installs, links or starts a unit, while others beside it are, each by its name."""
        if not _UNIT.search(final_name(source.basename)) or _PLACE.search(source.absolute):
            return False
        beside = [each for each in self._files.beside(source) if each.kind == source.kind and each.origin is None]
        if sum(map(self._is_brought, beside)) < _FEWEST or self._uses(source):
            return False
        return not self._is_taken_whole(source, [final_name(each.basename) for each in beside])

    def _is_brought(self, unit: Source) -> bool:
        """Whether a line installs or starts a unit by its name."""
        name = final_name(unit.basename)
        line = re.compile(rf"{_BRINGS}[^\n]*(?<![\w.-]){re.escape(name)}(?![\w-])")
        return any(line.search(each.text) for each in self._saying(name, unit))

    @memo
    def _uses(self, unit: Source) -> bool:
        """Whether anything of the tree may install or start a unit, or pull it in."""
        name = final_name(unit.basename)
        stem = name.rpartition(".")[0].rstrip("@")
        asked = re.compile(rf"\bsystemctl\b[^\n]*(?<![\w.-]){re.escape(stem)}(?![\w-])")
        if next(self._saying(name, unit), None) is not None:
            return True
        return any(asked.search(each.text) or _SUFFIX.search(each.text) for each in self._saying(stem, unit))

    def _is_taken_whole(self, source: Source, names: Iterable[str]) -> bool:
        """Whether a line takes the whole folder of a file, and not one of these names of it."""
        folder = os.path.basename(os.path.dirname(source.absolute))
        place = re.compile(
            rf"(?<![\w.-]){re.escape(folder)}(?:/?[\"']?(?:[\s,)\]}}:]|$)|/[\"']?(?:\*|\$|\{{|\.(?![\w.])))"
        )
        whole = regex(_WHOLE)
        here = os.path.dirname(self._path(source.absolute))
        if any(_EVERY_UNIT.search(each.text) for each in self._by_folder.get(here, ())):
            return True
        for each in self._saying(folder, source):
            lines = (line for line in each.text.splitlines() if folder in line and place.search(line))
            if any(whole.search(line) and not any(name in line for name in names) for line in lines):
                return True
        return False

    @memo
    def _is_idle_script(self, source: Source) -> bool:
        """Whether nothing names a script that installs something, while a Dockerfile puts others beside it into its
        image, each by its name. Those in the folder of the Dockerfile itself are for people."""
        around = self._files.beside(source)
        if not _INSTALLS.match(source.basename) or any(each.kind == "dockerfile" for each in around):
            return False
        beside = {each.basename for each in around if each.kind == source.kind}
        steps = [step for each in self._files.of_kind("dockerfile") for step in _IN_IMAGE.findall(each.text)]
        used = [name for name in beside if any(name in step for step in steps)]
        if len(used) < _FEWEST:
            return False
        return next(self._saying(source.basename, source), None) is None

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
        return [_Text(self._path(path), _REMARK.sub("", text)) for path, text in texts.items()]


def _is_copy(text: str, other: str) -> bool:
    """Whether most lines of a text are those of another one."""
    lines, others = set(text.split("\n")), set(other.split("\n"))
    return len(lines & others) * 2 > len(lines)
