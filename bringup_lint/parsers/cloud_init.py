"""Whom cloud-init's user data lets log in: with a password (modules Set Passwords, Users and Groups), or with keys that
it imports (SSH Import ID)."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.source import Located
from bringup_lint.source import Source

_RANDOM = ("R", "RANDOM")
"""cloud-init makes up a password for each machine."""


class Login(NamedTuple):
    user: str
    """Its name; empty for the default user of the image."""
    password: Located
    """In clear text, or as a hash."""


class KeyImport(NamedTuple):
    """One entry of ``ssh_import_id``."""

    account: Located
    """For a mapping its key."""
    name: str = ""
    """The value of a mapping, which cloud-init does not take: ``gh: name`` with a blank."""
    users: frozenset[str] = frozenset()
    """The accounts of the robot that the user data names."""


def key_imports(source: Source) -> Iterator[KeyImport]:
    """The accounts whose keys may log in."""
    root = parse(source).root
    if not isinstance(root, Mapping):
        return
    install = root.mapping("autoinstall")
    inner = install.mapping("user-data") if install is not None else None
    for data in (root, inner):
        users = [user for user in data.sequence("users") or () if isinstance(user, Mapping)] if data else []
        names = (user.scalar("name") for user in users)
        known = frozenset(str(name.value) for name in names if name is not None)
        for holder in (data, *users):
            yield from _imported(holder.sequence("ssh_import_id") if holder else None, known)


def _imported(accounts: Sequence | None, users: frozenset[str]) -> Iterator[KeyImport]:
    for each in accounts or ():
        if isinstance(each, Scalar):
            yield KeyImport(each.value, users=users)
        elif isinstance(each, Mapping):
            yield from (
                KeyImport(key.value, str(value.value)) for key, value in each.entries if isinstance(value, Scalar)
            )


def logins(source: Source) -> Iterator[Login]:
    """The passwords that stay valid: by default those of Set Passwords expire at the first login."""
    root = parse(source).root
    if not isinstance(root, Mapping):
        return
    chpasswd = root.mapping("chpasswd")
    expire = chpasswd.scalar("expire") if chpasswd is not None else None
    if chpasswd is not None and expire is not None and expire.boolean is False:
        yield from _of_default_user(root)
        yield from _of_list(chpasswd)
        yield from _of_users(chpasswd.sequence("users"), "password")
    yield from _of_users(root.sequence("users"), "plain_text_passwd")


def _of_default_user(root: Mapping) -> Iterator[Login]:
    password = root.scalar("password")
    if password is not None and not password.is_null and password.value not in _RANDOM:
        yield Login("", password.value)


def _of_list(chpasswd: Mapping) -> Iterator[Login]:
    """``list``: a block of lines ``USER:PASSWORD``, or a sequence of them."""
    given = chpasswd.get("list")
    lines = given.scalars if isinstance(given, Sequence) else [given] if isinstance(given, Scalar) else []
    for each in lines:
        at = 0
        for line in str(each.value).split("\n"):
            user, colon, password = line.partition(":")
            if colon and password.strip() and password.strip() not in _RANDOM:
                start = at + len(user) + 1
                yield Login(user.strip(), each.value.part(start, at + len(line)))
            at += len(line) + 1


def _of_users(users: Sequence | None, key: str) -> Iterator[Login]:
    for user in users or ():
        if not isinstance(user, Mapping):
            continue
        name, password, kind = user.scalar("name"), user.scalar(key), user.scalar("type")
        if password is not None and not password.is_null and (kind is None or kind.value not in _RANDOM):
            yield Login(str(name.value) if name is not None else "", password.value)
