"""The few facts that a robot's start depends on, out of an X.509 certificate in PEM: its subject and its last day.

ITU-T X.690 (DER) and RFC 5280, section 4.1. Nothing is verified; whatever is odd gives None. What this small reader
does not understand is left to ``cryptography``, where the extra ``pki`` has installed it.
"""

from __future__ import annotations

import base64
import binascii
from datetime import date

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_PEM = regex(r"-----BEGIN (?:TRUSTED )?CERTIFICATE-----([A-Za-z0-9+/=\s]+)-----END")
_COMMON_NAME = b"\x55\x04\x03"
_CONTEXT_0 = 0xA0
_UTC_TIME, _GENERALIZED_TIME = 0x17, 0x18


class Certificate(NamedTuple):
    common_name: str | None
    last_day: date


def parse(text: str) -> Certificate | None:
    """The first certificate of a PEM text."""
    match = _PEM.search(text)
    if match is None:
        return None
    try:
        return _read(base64.b64decode(match[1]))
    except (binascii.Error, IndexError, ValueError):
        return _by_cryptography(match[0])


def _by_cryptography(pem: str) -> Certificate | None:
    try:
        from cryptography import x509
    except ImportError:
        return None
    text = f"{pem.replace('TRUSTED ', '')} CERTIFICATE-----\n"
    try:
        read = x509.load_pem_x509_certificate(text.encode())
        names = read.subject.get_attributes_for_oid(x509.NameOID.COMMON_NAME)
    except Exception:
        return None
    return Certificate(str(names[0].value) if names else None, read.not_valid_after_utc.date())


def _read(data: bytes) -> Certificate:
    fields = _parts(_parts(_parts(data)[0][1])[0][1])
    if fields[0][0] == _CONTEXT_0:
        fields = fields[1:]
    validity, subject = fields[3][1], fields[4][1]
    return Certificate(_common_name(subject), _day(*_parts(validity)[1]))


def _parts(data: bytes) -> list[tuple[int, bytes]]:
    """The elements in their order: tag and content."""
    found, at = [], 0
    while at < len(data):
        tag, length, at = data[at], data[at + 1], at + 2
        if length > 0x80:
            count = length - 0x80
            length, at = int.from_bytes(data[at : at + count], "big"), at + count
        if at + length > len(data):
            raise ValueError("cut off")
        found.append((tag, data[at : at + length]))
        at += length
    return found


def _common_name(subject: bytes) -> str | None:
    for _, group in _parts(subject):
        for _, pair in _parts(group):
            kind, value = _parts(pair)
            if kind[1] == _COMMON_NAME:
                return value[1].decode("utf-8")
    return None


def _day(tag: int, content: bytes) -> date:
    text = content.decode("ascii")
    if tag == _UTC_TIME:
        text = ("19" if int(text[:2]) >= 50 else "20") + text
    elif tag != _GENERALIZED_TIME:
        raise ValueError("no time")
    return date(int(text[:4]), int(text[4:6]), int(text[6:8]))
