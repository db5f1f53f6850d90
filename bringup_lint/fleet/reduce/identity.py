"""What makes a robot itself: host keys, the machine id, host name, and all other keys and passwords."""

from __future__ import annotations

import base64
import binascii
import re

from bringup_lint.fleet.reduce.statements import Statements
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_PEM = regex(r"-----BEGIN (?P<what>(?:[A-Z]+ )*PRIVATE KEY)-----(?P<body>[^-]+)-----END")
_VAULT = "$ANSIBLE_VAULT;"
_OPENSSH = b"openssh-key-v1\0"
_MACHINE_ID = regex(r"[0-9a-f]{32}")
_HOST_NAME = regex(r"[A-Za-z0-9][A-Za-z0-9.-]{0,252}")
_WIREGUARD = regex(r"^[ \t]*PrivateKey[ \t]*=[ \t]*(?P<key>[A-Za-z0-9+/]{43}=)", re.M)
_ACCESS_POINT = regex(r"^[ \t]*(?:wpa_passphrase|wpa_psk)=(?P<key>\S[^\n]*)", re.M)
_ENTERPRISE = regex(r"^[ \t]*(?:password|private_key_passwd)=(?P<key>\S[^\n]*)", re.M)
_SHADOW = regex(r"^(?P<user>[a-z_][\w.-]*):(?P<hash>\$[^:\n]{8,}):", re.M)


def host(said: Statements) -> None:
    """/etc/hostname and /etc/machine-id."""
    name = said.file("/etc/hostname")
    if name is not None and (match := _HOST_NAME.search(name.text)):
        said.state("host-name", "", match[0], name.located(*match.span()))
    machine = said.file("/etc/machine-id") or said.file("/var/lib/dbus/machine-id")
    if machine is not None and _MACHINE_ID.fullmatch(machine.text.strip()):
        said.mark("machine-id", "", machine.text.strip(), machine.span(0, 1))


def ssh(said: Statements) -> None:
    """Host keys, by their public half, which both files hold."""
    for place, source in said.files(".pub", "_key", below="/etc/ssh/ssh_host_"):
        kind = place.removeprefix("/etc/ssh/ssh_host_").removesuffix(".pub").removesuffix("_key")
        material = _vaulted(source) or (_public_line(source) if place.endswith(".pub") else _public_half(source))
        if material:
            said.mark("ssh-host-key", kind, material, source.span(0, 1))


def _public_line(source: Source) -> bytes:
    words = source.text.split()
    return _decoded(words[1]) if len(words) > 1 else b""


def _public_half(source: Source) -> bytes:
    """The public key in a private key file of OpenSSH (PROTOCOL.key): behind the names of cipher, function and options,
    and the number of keys."""
    match = _PEM.search(source.text)
    data = _decoded(match["body"]) if match else b""
    if not data.startswith(_OPENSSH):
        return data
    rest = data[len(_OPENSSH) :]
    for _ in range(3):
        rest = rest[4 + int.from_bytes(rest[:4], "big") :]
    return rest[8 : 8 + int.from_bytes(rest[4:8], "big")]


def _decoded(text: str) -> bytes:
    try:
        return base64.b64decode("".join(text.split()), validate=True)
    except (binascii.Error, ValueError):
        return b""


def private_keys(said: Statements) -> None:
    """Keys in PEM: those of SROS 2 enclaves and authorities, and of anything that speaks TLS."""
    for place, source in said.files(".pem", ".key"):
        if place.startswith("/etc/ssh/"):
            continue
        if encrypted := _vaulted(source):
            said.mark(_kind(place), place, encrypted, source.span(0, 1))
        match = _PEM.search(source.text)
        if match is None:
            continue
        said.mark(_kind(place), place, _decoded(match["body"]), source.located(*match.span("what")))


def _vaulted(source: Source) -> bytes:
    """A file that ansible-vault has encrypted, which is the same on all robots that get it; else nothing."""
    return source.text.encode() if source.text.startswith(_VAULT) else b""


def _kind(place: str) -> str:
    if "/enclaves/" in place:
        return "sros2-key"
    return "sros2-ca" if place.endswith("ca.key.pem") and "/private/" in place else "tls-key"


def passwords(said: Statements) -> None:
    """Hashes of /etc/shadow: salts are random, so two alike were copied."""
    shadow = said.file("/etc/shadow")
    if shadow is None:
        return
    for match in _SHADOW.finditer(shadow.text):
        said.mark("password", match["user"], match["hash"], shadow.located(*match.span("user")))


def networks(said: Statements) -> None:
    """Keys of VPN, passphrases of the robot's own access point, and passwords of 802.1X; not the passphrase of a Wi-Fi
    that all clients share."""
    for place, source in said.files(".conf", ".nmconnection", ".netdev"):
        if "/wireguard/" in place and (encrypted := _vaulted(source)):
            said.mark("vpn-key", place, encrypted, source.span(0, 1))
        elif "/wireguard/" in place or "[WireGuard]" in source.text:
            _marked(said, "vpn-key", place, source, _WIREGUARD)
        elif "/hostapd" in place:
            _marked(said, "access-point", place, source, _ACCESS_POINT)
        elif "/wpa_supplicant" in place:
            _marked(said, "wifi-login", place, source, _ENTERPRISE)


def _marked(said: Statements, kind: str, place: str, source: Source, pattern: re.Pattern[str]) -> None:
    for match in pattern.finditer(source.text):
        where: Located = source.located(*match.span("key"))
        said.mark(kind, place, where.strip(), where)
