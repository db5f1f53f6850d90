"""What the files of a tree install: scripts, images, lists of repositories, commands of the documentation."""

from __future__ import annotations

import os
import re
from functools import cached_property

from bringup_lint.discover.tree import Tree
from bringup_lint.pattern import regex

_TELLING = regex(
    r"(?:^|/)(?:[^/]*(?:dockerfile|containerfile)[^/]*|\.gitmodules|(?:make|just|earth|pip)file|setup\.py"
    r"|user-data|debian/control|(?:[^/]*[-_.])?packages"
    r"|[^/]+\.(?:sh|bash|zsh|fish|md|rst|txt|in|hcl|repos|rosinstall|ya?ml|j2|toml|nix|bb|bbappend|cfg|json|ipynb|html?))$",
    re.I,
)
_PAGE = regex(r"\.(?:md|rst|txt|html?)$", re.I)
_DOCUMENTATION = regex(r"\.(?:md|rst|html?|ipynb)$|(?:^|/)(?:readme|changelog|license|todo)[^/]*$", re.I)
_HISTORY = regex(r"(?:^|/)changelog[^/]*$", re.I)
_CMAKE = regex(r"(?:^|/)cmakelists\.txt$", re.I)
"""What installs nothing but what it fetches."""
_SETUP = regex(r"(?:^|/)setup\.(?:py|cfg)$")
_NO_INSTALLER = regex(r"(?:^|/)(?:setup\.py|setup\.cfg|(?!devcontainer\.)[^/]+\.json)$", re.I)
"""What installs nothing when colcon builds: it looks at ``install_requires`` of no package."""
_SETTINGS = regex(r"\.(?:ya?ml|j2|cfg|toml|sh|bash|zsh)$", re.I)
_INSTALLER = regex(
    r"\b(?:apt|pip3?|rosdep|conda|snap|vcs|git)\b|deps\b|pkgs|packages|dependencies|repositories|requires|install"
)
"""What a script or a file of settings has that installs something."""
_INSTALLS = regex(
    r"(?:\b(?:apt|apt-get|aptitude|pip3?|rosdep|conda|vcs|brew|yay|dnf|snap)\b|\bgit (?:clone|submodule)\b)"
    r"(?:\\\r?\n|[^\n`]){0,4000}"
)
"""A command of the documentation that installs, with the lines that it goes on in."""
_COMMENTS = regex(r"^[ \t]*#[^\n]*$", re.M)
_USES = regex(
    r"\bros2[\"', \t]{1,8}(?:run|launch)[\"', \t]{1,8}[\w.-]{1,100}"
    r"|--packages-[a-z-]{1,20}(?:[ \t]{1,4}\w{1,100}){0,40}",
    hints="ros2 --packages-",
)
"""A command that asks for a package instead of installing it."""
_MOST = 200_000
"""Characters of a file that are looked at."""
ADDRESS = regex(r"(?:https?://|git@|ssh://git@)[\w.-]{1,80}[/:]([\w./-]{1,160})", hints="http:// https:// git@")
ROSDEP = regex(r"\brosdep\s+install\b(?:\\\r?\n|[^\n`&;])*", hints="rosdep")
"""A command, with the lines that it goes on in."""
_LOCAL = regex(r"\bpip3?[ \t]{1,4}install(?:[ \t]{1,4}-[a-z-]{1,40}){0,10}[ \t]{1,4}[\"']?[./$]", hints="pip")
"""A command that installs Python packages of the tree, with what they require."""
_LIST = regex(r"\s(?:-r|--requirement)[ =]{0,4}[\"']?([\w./-]{1,200}\.txt)", hints="-r --requirement")
"""A file that names what pip installs."""
_PARAMETERS = "ros__parameters"


class Installers:
    def __init__(self, tree: Tree) -> None:
        self._tree = tree

    @cached_property
    def mentions_rosdep(self) -> bool:
        """Whether any file names rosdep, whose options are not known then."""
        return any("rosdep" in text for text in self._all)

    @cached_property
    def mentions_symlinks(self) -> bool:
        """Whether any file says that colcon makes links to the source."""
        return any("--symlink" in text for text in self._all)

    @cached_property
    def rosdep_commands(self) -> list[str]:
        """The commands of the documentation at the top of the tree that install with rosdep."""
        tops = [f"{top}/" for top in self._tree.tops]
        near = (path for path in self._tree.paths if _PAGE.search(path))
        shown = (path for path in near for top in tops if os.path.abspath(path).removeprefix(top).count("/") < 2)
        return [command for path in shown for command in ROSDEP.findall(self._tree.head(path, _MOST))]

    @cached_property
    def _all(self) -> list[str]:
        return [text for _, text in self._by_path]

    @cached_property
    def _by_path(self) -> list[tuple[str, str]]:
        texts = ((path, self._tree.head(path, _MOST)) for path in self._tree.paths if _TELLING.search(path))
        return [(path, text.lower()) for path, text in texts if _PARAMETERS not in text or _DOCUMENTATION.search(path)]

    @cached_property
    def texts(self) -> list[str]:
        """What installs: scripts, images and lists without their comments, and the commands of the documentation."""
        found = [text for path, whole in self._by_path for text in _installing_parts(path, whole)]
        if any(map(_LOCAL.search, found)):
            found += [text for path, text in self._by_path if _SETUP.search(path)]
        return found

    @cached_property
    def lists_elsewhere(self) -> bool:
        """Whether pip installs what a file names that is not in the tree."""
        lists = {path for text in self.texts for path in _LIST.findall(text)}
        return not all(map(self._has_list, lists))

    def _has_list(self, path: str) -> bool:
        folder, _, name = path.removeprefix("./").rpartition("/")
        near = folder.startswith(("/", "."))
        end = f"/{name}" if near or not folder else f"/{folder}/{name}"
        return any(each.endswith(end) for each in self._text_files.get(name, ()))

    @cached_property
    def _text_files(self) -> dict[str, list[str]]:
        """The paths of text files in small letters, by their names."""
        found: dict[str, list[str]] = {}
        for path in self._tree.paths:
            if path.lower().endswith(".txt"):
                found.setdefault(os.path.basename(path).lower(), []).append(f"/{path}".lower())
        return found

    @cached_property
    def told(self) -> list[str]:
        """All texts but those of the past, those of files that machines read without comments."""
        return [_without_comments(path, text) for path, text in self._by_path if not _HISTORY.search(path)]


def _installing_parts(path: str, text: str) -> list[str]:
    if _DOCUMENTATION.search(path):
        return _INSTALLS.findall(text)
    if _CMAKE.search(path):
        return [match[0] for match in ADDRESS.finditer(_COMMENTS.sub("", text))]
    if _NO_INSTALLER.search(path) or (_SETTINGS.search(path) and not _INSTALLER.search(text)):
        return []
    return [_USES.sub(" ", _COMMENTS.sub("", text))]


def _without_comments(path: str, text: str) -> str:
    return text if _DOCUMENTATION.search(path) else _COMMENTS.sub("", text)
