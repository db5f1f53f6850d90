"""Servers for people that ask for no password: desktops, notebooks and shells."""

from __future__ import annotations

import re
from enum import Enum

from bringup_lint.addresses import host_of
from bringup_lint.addresses import is_loopback
from bringup_lint.addresses import is_wildcard
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_VNC = regex(r"(?:x0|X|tiger|tight)?vnc(?:server)?(?:\.\w+)?|x0tigervncserver|x0vncserver|Xvnc|Xtigervnc", re.I, "vnc")
_JUPYTER = regex(r"jupyter(?:-\w+)?", 0, "jupyter")
_NO_TOKEN = regex(r"--(?:Notebook|Server|Lab|Identity)(?:App|Provider)\.token=?(?:''|\"\")?")
_PASSWORD = regex(r"--\w+\.(?:hashed_)?password=.")


class Offer(Enum):
    DESKTOP = "the desktop"
    NOTEBOOK = "a notebook, and with it a shell"
    TERMINAL = "a shell"


class OpenAccess(NamedTuple):
    program: str
    word: Located
    """What switches the password off, or the program that has none."""
    offer: Offer
    advice: str


_LAST_NAME = 200
"""Words among which the name of a program may be that another one starts."""


def open_access(words: tuple[Located, ...]) -> OpenAccess | None:
    """The server that a command starts, when it lets in everybody who reaches it."""
    plain = unwrapped(words)
    if not plain:
        return None
    for known in (_vnc, _x11vnc, _jupyter, _terminal):
        found = known(program_name(plain[0]), plain)
        if found is not None:
            return found
    return _started_by_another(plain)


def _started_by_another(words: tuple[Located, ...]) -> OpenAccess | None:
    """``python3 -m jupyter lab``, ``docker exec screen x11vnc``."""
    for at, word in enumerate(words[1:_LAST_NAME], 1):
        name = program_name(word)
        for known in (_vnc, _x11vnc, _jupyter):
            found = known(name, words[at:])
            if found is not None:
                return found
    return None


def _vnc(name: str, words: tuple[Located, ...]) -> OpenAccess | None:
    if not _VNC.fullmatch(name) or _is_local(name, words):
        return None
    types = _option(words, "SecurityTypes")
    if types is None or types.lower().rpartition(",")[2] != "none":
        return None
    option = next(word for word in words if word.lstrip("-").lower().startswith("securitytypes"))
    advice = "use -SecurityTypes VncAuth with a password file, or -localhost"
    return OpenAccess(name, option, Offer.DESKTOP, advice)


def _is_local(name: str, words: tuple[Located, ...]) -> bool:
    """Whether a VNC server listens on the loopback interface only, as the wrappers of TigerVNC do by default."""
    by_default = name.lower() in ("vncserver", "tigervncserver")
    return _is_on(words, "localhost", otherwise=by_default) or is_loopback(_option(words, "interface") or "")


def _x11vnc(name: str, words: tuple[Located, ...]) -> OpenAccess | None:
    protected = ("-localhost", "-rfbauth", "-passwd", "-passwdfile", "-usepw", "-unixpw", "-listen", "-allow", "-ssl")
    if name != "x11vnc" or "-inetd" in words or any(word.startswith(protected) for word in words):
        return None
    opened = next((word for word in words if word == "-nopw"), None)
    return OpenAccess(name, opened, Offer.DESKTOP, "use -rfbauth with a password file") if opened else None


def _jupyter(name: str, words: tuple[Located, ...]) -> OpenAccess | None:
    if not _JUPYTER.fullmatch(name) or any(map(_PASSWORD.match, words)):
        return None
    opened = next((word for word in words if _NO_TOKEN.fullmatch(word)), None)
    address = _option(words, "ip")
    if opened is None or address is None or not is_wildcard(address):
        return None
    return OpenAccess(name, opened, Offer.NOTEBOOK, "remove the empty token, or set a password")


def _terminal(name: str, words: tuple[Located, ...]) -> OpenAccess | None:
    if name == "ttyd":
        limited = ("-c", "--credential", "-i", "--interface", "-H", "--auth-header", "-A", "--ssl-ca")
        if any(word.partition("=")[0] in limited for word in words[1:]):
            return None
        return OpenAccess(name, words[0], Offer.TERMINAL, "set a user and a password with --credential")
    address = _option(words, "bind-addr") or _option(words, "host")
    if name != "code-server" or address is None or is_loopback(host_of(address)):
        return None
    value = _option(words, "auth")
    return OpenAccess(name, value, Offer.TERMINAL, "use --auth password") if value == "none" else None


def _option(words: tuple[Located, ...], name: str) -> Located | None:
    """The value of ``-name value``, ``-name=value`` or ``--name=value``."""
    for at, word in enumerate(words):
        key, equals, _ = word.partition("=")
        if key.lstrip("-").lower() != name.lower() or not word.startswith("-"):
            continue
        if equals:
            value = word.part(len(key) + 1, len(word))
            return value.part(1, len(value) - 1) if value[:1] in ("'", '"') and len(value) > 1 else value
        return words[at + 1] if at + 1 < len(words) else None
    return None


def _is_on(words: tuple[Located, ...], name: str, *, otherwise: bool) -> bool:
    """Whether a switch of an X server is on: ``-name``, ``-name=1``, ``-name yes``."""
    given = next((word for word in words if word.lstrip("-").partition("=")[0] == name), None)
    if given is None:
        return otherwise
    return (_option(words, name) or "").lower() not in ("0", "no", "off", "false")
