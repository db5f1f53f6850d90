"""Users and groups: which ones the robot has, as far as its files tell."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Collection
from collections.abc import Iterator
from functools import cached_property

from bringup_lint import facts
from bringup_lint.dataclass import dataclass
from bringup_lint.graph.memo import memo
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.graph.systemd.user_database import UserDatabase

_CREATES = regex(r"\b(?:groupadd|addgroup|useradd|adduser|newusers|dscl|ansible\.builtin\.(?:group|user))\b[^\n]*")
_CREATING = ("groupadd", "addgroup", "useradd", "adduser", "newusers", "dscl", "ansible.builtin.")
"""One of them is where something is created, which is found out much sooner."""
_MODULE = regex(
    r"^[ \t-]*(?:group|user):[ \t]*(?:\{[^}\n]{0,80}?\bname:[ \t]*[\"']?([\w-]+)[^\n]*$"
    r"|(?:name=(\S+)[ \t]*)?$(?:\n[ \t]+name:[ \t]*[\"']?([\w-]+))?)",
    re.M,
    hints="group: user:",
)
_SCRIPT = regex(
    r"\.(?:sh|bash|mk|ya?ml|md|rst|txt|cmake|service|conf|in)$|^(?:pre|post)(?:inst|rm)|^(?:Docker|Make|Contain)file"
    r"|^[^.]+$"
)
_MOST_SCRIPTS = 2000

_TEMPLATED = regex(
    r"\b(?:group|user):[ \t]*(?:\{[ \t]*|\n[ \t]+)name:[ \t]*[\"']?\{\{"
    r"|\b(?:useradd|groupadd|adduser|addgroup)\b[^\n]{0,80}\$"
)
"""An Ansible task, or a command, that names what it creates by a variable."""


def _creations(text: str) -> Iterator[re.Match[str]]:
    """The commands that create users or groups."""
    if any(word in text for word in _CREATING):
        yield from _CREATES.finditer(text)


@dataclass(frozen=True, eq=False)
class Accounts:
    """What is known of users and groups."""

    files: Files
    units: Callable[[], Units]

    @property
    def _database(self) -> UserDatabase | None:
        """/etc/passwd and /etc/group of a root file system: a repository's overlay need not be all of it."""
        return self.units().users if self.files.tree.root is not None else None

    def has_group(self, name: str) -> bool | None:
        """Whether the group exists; None when the tree cannot tell."""
        listed = self._database.groups if self._database else {}
        return self._has(name, listed, self._declared("gu"))

    def has_user(self, name: str) -> bool | None:
        """Whether the user exists; None when the tree cannot tell."""
        listed = self._database.accounts if self._database else {}
        return self._has(name, listed, self._declared("u"))

    @property
    def creates_any(self) -> bool:
        """Whether the tree creates users or groups at all, so that one that it does not create is missing."""
        return bool(self._created or self._declared("gu"))

    @cached_property
    def creates_unnamed(self) -> bool:
        """Whether a task or command creates accounts whose names it takes from variables."""
        return any(_TEMPLATED.search(text) for text in self._texts())

    def home_of(self, user: str) -> str | None:
        """The home folder that the tree's /etc/passwd gives to a user."""
        account = self._database.account(user) if self._database else None
        return account.home if account else None

    @memo
    def login_home(self, user: str) -> str | None:
        """The home of a regular user who can log in; None for system users, and when the tree cannot tell."""
        if self._database is not None and self._database.passwd is not None:
            account = self._database.account(user)
            return account.home if account and account.can_log_in else None
        named = re.compile(rf"/home/{re.escape(user)}(?![\w.-])")
        declared = self._declared("u")
        texts = (file.source.text for unit in self.units().services for file in unit.files)
        return f"/home/{user}" if user not in declared and any(map(named.search, texts)) else None

    def groups_of(self, user: str) -> frozenset[str] | None:
        """The groups that the tree's /etc/passwd and /etc/group give to a user; None without these files."""
        database = self._database
        if database is None or database.passwd is None or database.group is None:
            return None
        return database.groups_of(user)

    def _has(self, name: str, listed: Collection[str], declared: frozenset[str]) -> bool | None:
        if name in listed or name in declared:
            return True
        if listed and self.files.tree.complete:
            return False
        return True if name in self._usual or name in self._created else None

    def _declared(self, kinds: str) -> frozenset[str]:
        """Names that sysusers.d(5) lines of these types create; a user comes with a group of its name."""
        lines = (line.split() for source in self.files.of_kind("sysusers") for line in source.text.splitlines())
        return frozenset(word[1] for word in lines if len(word) > 1 and word[0].rstrip("!") in kinds)

    @cached_property
    def _usual(self) -> frozenset[str]:
        return frozenset(row["name"] for row in facts.table("host/accounts"))

    @cached_property
    def _created(self) -> frozenset[str]:
        """Every word of a command in the tree's scripts and documents that creates users or groups."""
        found: set[str] = set()
        for text in self._texts():
            for command in _creations(text):
                found.update(re.findall(r"[\w-]+", command[0]))
            for module in _MODULE.finditer(text):
                found.update(name for name in module.groups() if name)
        return frozenset(found)

    def _texts(self) -> Iterator[str]:
        yield from (source.text for source in self.files.sources)
        tree = self.files.tree
        scripts = [path for path in tree.paths if _SCRIPT.search(path.rpartition("/")[2])]
        for path in scripts[:_MOST_SCRIPTS]:
            source = tree.read(path, judged=False)
            if source is not None:
                yield source.text
