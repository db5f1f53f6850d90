"""The users and groups of /etc/passwd and /etc/group in the tree: passwd(5), group(5)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.files import Files
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Source


class Account(NamedTuple):
    """A line of /etc/passwd."""

    name: str
    uid: str
    gid: str
    home: str
    """Without a slash at the end; empty for ``/``."""
    shell: str

    @property
    def can_log_in(self) -> bool:
        """Whether it is a regular user with a shell, by the numbers of Debian and Ubuntu."""
        regular = self.uid.isdecimal() and 1000 <= int(self.uid) < 60000
        return regular and not self.shell.endswith(("nologin", "false"))


class Group(NamedTuple):
    """A line of /etc/group."""

    name: str
    gid: str
    members: frozenset[str]


@dataclass(eq=False)
class UserDatabase:
    files: Files

    @cached_property
    def passwd(self) -> Source | None:
        return self.files.tree.find("/etc/passwd")

    @cached_property
    def group(self) -> Source | None:
        return self.files.tree.find("/etc/group")

    @cached_property
    def accounts(self) -> dict[str, Account]:
        """By name; of a name that is listed twice the first line counts."""
        found: dict[str, Account] = {}
        for name, *rest in _rows(self.passwd, 6):
            found.setdefault(name, Account(name, rest[1], rest[2], rest[4].rstrip("/"), "".join(rest[5:6])))
        return found

    @cached_property
    def _by_uid(self) -> dict[str, Account]:
        return {account.uid: account for account in reversed(self.accounts.values())}

    @cached_property
    def groups(self) -> dict[str, Group]:
        found: dict[str, Group] = {}
        for row in _rows(self.group, 4):
            found.setdefault(row[0], Group(row[0], row[2], frozenset(row[3].strip().split(","))))
        return found

    def account(self, user: str) -> Account | None:
        """The account of a user name or number."""
        return self.accounts.get(user) or self._by_uid.get(user)

    def groups_of(self, user: str) -> frozenset[str]:
        """The names of the groups that have the user as a member, the primary one included."""
        account = self.account(user)
        name, gid = (account.name, account.gid) if account else (user, None)
        return frozenset(
            group.name
            for group in self.groups.values()
            if name in group.members or (gid is not None and group.gid == gid)
        )


def _rows(source: Source | None, fields: int) -> Iterator[list[str]]:
    if source is None:
        return
    for line in source.text.splitlines():
        row = line.split(":")
        if len(row) >= fields:
            yield row
