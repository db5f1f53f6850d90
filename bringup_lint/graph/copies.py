"""The packages of others of which a tree carries copies, such as the driver of a sensor that is built from source.

Something has to show that others wrote a package: the folder that it lies in, a change log of releases, marks of a
repository of its own, or its name. And none of those who wrote the packages without such a mark may have a part in it:
a repository whose packages all have one is their home. Where that is not sure, a package counts as the tree's own.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.facts.ros import carried
from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.model.package import Manifest
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_FOR_OTHERS = regex(
    r"(?:^|/)(?:libs?|third[_-]?party|3rd[_-]?party|externals?|vendor(?:ed)?|upstream|submodules|deps|dependencies)/",
    re.IGNORECASE,
)
"""Folders that keep the packages of others."""
_CHANGE_LOGS = ("CHANGELOG.rst", "CHANGELOG.md")
_OF_REPOSITORY = (".git", ".github", ".gitlab-ci.yml", ".gitrepo", ".travis.yml")
"""What lies at the top of a repository, and in no folder below it."""
_PAGES = (("LICENSE", "LICENSE.txt", "LICENSE.md", "LICENCE"), ("README.md", "README.rst", "README"))
"""What the top of a repository has one of each, as packages may."""
_NOBODY = regex(
    r"todo|example|your|maintainer|^(?:user|root|ubuntu|nvidia|pi|ros|robot|developer|admin)(?:@|$)", re.IGNORECASE
)
"""Names and addresses that stand for nobody."""
_MAIL = frozenset(
    "126.com 163.com aol.com foxmail.com gmail.com gmx.de gmx.net googlemail.com hotmail.com icloud.com live.com"
    " mail.ru me.com msn.com naver.com outlook.com pm.me proton.me protonmail.com qq.com users.noreply.github.com"
    " web.de yahoo.com yandex.ru".split()
)
"""Domains that say nothing of who has an address there."""
_HOSTED = regex(r"^https?://(?:www\.)?(?:github\.com|gitlab\.com|bitbucket\.org)/[\w.-]+/([\w.-]+)")
_KEPT_IN = frozenset("common driver drivers modules packages pkgs robot ros ros2 sensors source sources src".split())
"""Names of folders that say nothing of what is in them."""
_SHORT = 3
"""Letters of a first word of a name that says nothing."""


@dataclass(eq=False)
class Copies:
    """The copies of one tree, by the absolute folders of their packages."""

    files: Files

    def owner(self, source: Source) -> str | None:
        """The folder of the copy that a file is of; None for a file that the tree's own people wrote."""
        folder = self._package_of(os.path.dirname(source.absolute))
        return folder if folder in self.found else None

    def names(self, folder: str) -> Iterator[str]:
        """What a copy may be called: its name, its folder, and the folders above that hold nothing else."""
        yield str(self.found[folder].name)
        for each in self._above(folder):
            name = os.path.basename(each)
            if each in self._of_own:
                break
            if name.lower() not in _KEPT_IN and not _FOR_OTHERS.search(f"{name}/"):
                yield name

    def has(self, path: str) -> bool:
        """Whether a file lies in a copy, or beside one in the repository that it comes from."""
        folder = os.path.dirname(path)
        if self._package_of(folder) in self.found:
            return True
        while folder not in self._of_copies and folder not in self._of_own and len(folder) > len(self._top):
            folder = os.path.dirname(folder)
        return folder in self._of_copies and folder not in self._of_own and self._is_theirs(folder)

    def _is_theirs(self, folder: str) -> bool:
        """Whether a folder is of a repository of others, rather than one in which the tree keeps these."""
        return any(self._is_repository(each) or self._is_kept(os.path.dirname(each)) for each in self._above(folder))

    def _is_kept(self, folder: str) -> bool:
        return bool(_FOR_OTHERS.search(os.path.relpath(folder, self._top) + "/"))

    @cached_property
    def _of_own(self) -> frozenset[str]:
        """The folders above the tree's own packages."""
        return frozenset(each for folder in self._manifests if folder not in self.found for each in self._above(folder))

    @cached_property
    def _of_copies(self) -> frozenset[str]:
        """The folders above copies."""
        return frozenset(each for folder in self.found for each in self._above(folder))

    @cached_property
    def found(self) -> dict[str, Manifest]:
        marked = [folder for folder, manifest in self._manifests.items() if self._is_marked(folder, manifest)]
        own = [self._manifests[folder] for folder in self._manifests.keys() - set(marked)]
        people = {each for manifest in own for each in _people(manifest)}
        words = {_first_word(str(manifest.name)) for manifest in own} - {""}

        def is_foreign(manifest: Manifest) -> bool:
            theirs = set(_people(manifest))
            if str(manifest.name) in self._public:
                return theirs.isdisjoint(people)
            return bool(theirs) and theirs.isdisjoint(people) and _first_word(str(manifest.name)) not in words

        if not own:
            return {}
        foreign = {folder for folder in marked if is_foreign(self._manifests[folder])}
        homes = {home for folder in foreign if (home := self._home(folder)) is not None}
        nobodys = {folder for folder in marked if not any(_people(self._manifests[folder]))}
        with_them = {folder for folder in nobodys if self._home(folder) in homes}
        return {folder: self._manifests[folder] for folder in marked if folder in foreign | with_them}

    def _home(self, folder: str) -> str | None:
        """The top of the repository of its own that a package lies in."""
        return next(filter(self._is_repository, self._above(folder)), None)

    @cached_property
    def _manifests(self) -> dict[str, Manifest]:
        from bringup_lint.parsers import package_xml

        manifests = self.files.parsed(package_xml.parse, self.files.of_kind("ros-package"))
        return {os.path.dirname(each.source.absolute): each for each in manifests if each.name}

    def is_kept_apart(self, folder: str) -> bool:
        """Whether a package lies in a folder for what others wrote, or is one of a minority with a change log as
        releases have it."""
        return folder in self._released or self._is_kept(folder)

    def _is_marked(self, folder: str, manifest: Manifest) -> bool:
        """Whether something says that others wrote a package."""
        if self.is_kept_apart(folder) or folder in self._apart or str(manifest.name) in self._public:
            return True
        return _has_own_address(manifest, self._above(folder))

    def _above(self, folder: str) -> Iterator[str]:
        """A folder and those above it, below the one that holds all packages."""
        while len(folder) > len(self._top):
            yield folder
            folder = os.path.dirname(folder)

    @cached_property
    def _apart(self) -> frozenset[str]:
        """The folders of packages in repositories of their own; empty when most packages are kept so."""
        found = {folder for folder in self._manifests if any(map(self._is_repository, self._above(folder)))}
        return frozenset(found) if 2 * len(found) < len(self._manifests) else frozenset()

    @memo
    def _is_repository(self, folder: str) -> bool:
        exists = self.files.tree.exists
        if any(exists(os.path.join(folder, name)) for name in _OF_REPOSITORY):
            return True
        is_package = folder in self._manifests
        return not is_package and all(any(exists(os.path.join(folder, name)) for name in names) for names in _PAGES)

    @cached_property
    def _released(self) -> frozenset[str]:
        """The folders of packages with a change log; empty when most packages have one, as their own repository has."""
        found = {folder for folder in self._manifests if self._has_change_log(folder)}
        return frozenset(found) if 2 * len(found) < len(self._manifests) else frozenset()

    def _has_change_log(self, folder: str) -> bool:
        return any(self.files.tree.is_file(os.path.join(folder, name)) for name in _CHANGE_LOGS)

    @cached_property
    def _public(self) -> frozenset[str]:
        """The names of packages that are known to have another home; empty when most packages have such a name."""
        found = {str(each.name) for each in self._manifests.values()} & carried.names()
        return frozenset(found) if 2 * len(found) < len(self._manifests) else frozenset()

    @cached_property
    def _top(self) -> str:
        return os.path.commonpath(self._manifests) if self._manifests else "/"

    def _package_of(self, folder: str) -> str | None:
        """The package that an absolute folder is, or lies in."""
        passed = []
        while folder not in self._packages:
            passed.append(folder)
            above = os.path.dirname(folder)
            if folder in self._manifests or above == folder:
                self._packages[folder] = folder if folder in self._manifests else None
            else:
                folder = above
        found = self._packages[folder]
        self._packages.update(dict.fromkeys(passed, found))
        return found

    @cached_property
    def _packages(self) -> dict[str, str | None]:
        return {}


def _has_own_address(manifest: Manifest, folders: Iterable[str]) -> bool:
    """Whether a package says that it comes from a repository that is called as it is, or as a folder around it."""
    names = {_plain(os.path.basename(folder)) for folder in folders} | {_plain(str(manifest.name))}
    found = (_HOSTED.search(each) for each in manifest.repositories)
    return any(match is not None and _plain(match[1].removesuffix(".git")) in names for match in found)


def _plain(name: str) -> str:
    """A name without what people write in several ways."""
    return name.lower().replace("-", "_").removesuffix("_ros2").removesuffix("_ros")


def _first_word(name: str) -> str:
    word = name.partition("_")[0]
    return word if len(word) >= _SHORT else ""


def _people(manifest: Manifest) -> Iterator[str]:
    """Who wrote a package: full names, addresses, and the domains of addresses that belong to somebody."""
    for each in manifest.people:
        word = each.strip().lower()
        if _NOBODY.search(word):
            continue
        _, at, domain = word.rpartition("@")
        if at or " " in word:
            yield word
        if at and domain not in _MAIL:
            yield domain
