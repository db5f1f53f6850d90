"""DDS Security documents, sros2 policies and the keys beside them: XML by its first two elements, never other XML."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex
from bringup_lint.spelling import nearest

_XML = regex(r"\.xml$", re.I)
_SIGNED = regex(r"\.(?:p7s|smime)$", re.I)
_NOISE = regex(r"<!--.*?(?:-->|$)|<\?.*?(?:\?>|$)|<!DOCTYPE[^>\[]*(?:\[.*?\]\s*)?>", re.S)
_TAGS = regex(r"<(?:\w+:)?([A-Za-z_][\w.-]*)(?:[^<>\w.-][^<>]*)?>\s*<(?:\w+:)?([A-Za-z_][\w.-]*)")
_GOVERNANCE = regex(r"(?:^|/)enclaves/governance\.xml$")
_PERMISSIONS = regex(r"(?:^|/)enclaves/(?:[^/]+/)+permissions\.xml$")
"""Where sros2 puts the documents of a keystore: they are that, whatever they hold."""
_KEY = regex(r"(?:^|/)(?:private/[\w.-]*key[\w.-]*|enclaves/(?:[^/]+/)*key)\.(?:pem|p11)$")
_CERTIFICATE = regex(r"(?:^|/)(?:public/[\w.-]*cert|enclaves/(?:[^/]+/)*cert)\.pem$")


def _below(path: str, head: Head) -> tuple[str, str]:
    """The names of the root and of its first child, of XML and of signed XML."""
    if not _XML.search(path) and not _SIGNED.search(path):
        return "", ""
    text = _NOISE.sub("", head())
    match = _TAGS.search(text)
    if match is None or (_XML.search(path) and text[: match.start()].strip("\ufeff \t\r\n")):
        return "", ""
    return match[1], match[2]


def _is_called(path: str, head: Head, root: str, child: str) -> bool:
    """Whether the root and its first child have these names; one of them may be misspelt."""
    one, two = _below(path, head)
    if one == root:
        return two == child or nearest(two, [child]) == [child]
    return two == child and nearest(one, [root]) == [root]


def _is_governance(path: str, head: Head) -> bool:
    return bool(_GOVERNANCE.search(path)) or _is_called(path, head, "dds", "domain_access_rules")


def _is_permissions(path: str, head: Head) -> bool:
    return bool(_PERMISSIONS.search(path)) or _is_called(path, head, "dds", "permissions")


KINDS = (
    Kind("sros2-governance", _is_governance),
    Kind("sros2-permissions", _is_permissions),
    Kind("sros2-policy", lambda path, head: _is_called(path, head, "policy", "enclaves")),
    Kind("sros2-key", lambda path, head: bool(_KEY.search(path)) and "PRIVATE KEY" in head(), "key"),
    Kind("sros2-certificate", lambda path, head: bool(_CERTIFICATE.search(path)) and "CERTIFICATE" in head(), "cert"),
)
