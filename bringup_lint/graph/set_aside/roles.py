"""Roles of Ansible that no play takes, while others of their folder are taken."""

from __future__ import annotations

import re
from collections import defaultdict
from functools import cached_property

from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.graph.set_aside.texts import FEWEST
from bringup_lint.graph.set_aside.texts import Texts
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_ROLE = regex(r"(?P<roles>(?:^|.*/)roles)/(?P<name>[\w.-]+)/(?=[^/]+/)")


class IdleRoles:
    """Asked for a role: whether the tree keeps it and does not use it."""

    def __init__(self, files: Files, texts: Texts) -> None:
        self._files = files
        self._texts = texts

    def have(self, source: Source) -> bool:
        role = _ROLE.match(self._texts.path_of(source.absolute))
        return role is not None and self._is_idle((role["roles"], role["name"]))

    @memo
    def _is_idle(self, role: tuple[str, str]) -> bool:
        """Whether no play and no other role names a role, while others of its folder are named."""
        folder, name = role
        taken = self._taken_roles
        if name in taken or len(self._roles[folder] & taken) < FEWEST or any("{{" in each for each in taken):
            return False
        others = (
            each.text for each in self._texts.by_word.get(name, ()) if not each.path.startswith(f"{folder}/{name}/")
        )
        used = re.compile(rf"roles/{re.escape(name)}(?![\w-])|_role\b[^\n]*\bname={re.escape(name)}(?![\w-])")
        return not any(used.search(text) for text in others)

    @cached_property
    def _roles(self) -> defaultdict[str, set[str]]:
        """The folders of roles, each with the names of those in it."""
        found: defaultdict[str, set[str]] = defaultdict(set)
        for match in (match for each in self._texts.all if (match := _ROLE.match(each.path))):
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
