"""Cyclone DDS configuration and Fast DDS profiles: XML by its root element, never other XML."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_XML = regex(r"\.xml(?:\.(?:in|j2|jinja|jinja2|em|tmpl|tpl|template|erb))?$", re.I)
_PROLOG = regex(r"(?:\ufeff|\s|<\?.*?(?:\?>|$)|<!--.*?(?:-->|$)|<![A-Z][^>\[]*(?:\[.*?\]\s*)?>)*", re.S)
_TAG = regex(r"<([A-Za-z_][\w.-]*:)?([A-Za-z_][\w.-]*)([^>]*)")
_NOISE = regex(r"<!--.*?(?:-->|$)|<\?.*?(?:\?>|$)", re.S)
_CYCLONE_GROUPS = {
    "domain",
    "general",
    "discovery",
    "internal",
    "tracing",
    "cyclone",
    "cyclone_dds",
    "cyclonedds",
}
_FASTDDS_TOP = {"profiles", "library_settings", "log", "types"}
_FASTDDS_PROFILES = {
    "participant",
    "data_writer",
    "data_reader",
    "publisher",
    "subscriber",
    "topic",
    "transport_descriptors",
    "domainparticipant_factory",
    "requester",
    "replier",
}
_OTHER_DDS = {
    "domain_access_rules",
    "permissions",
    "qos_library",
    "domain_library",
    "participant_library",
    "rtps",
}
"""What is below ``dds`` in the files of DDS Security and of other vendors."""


def _is_cyclonedds(path: str, head: Head) -> bool:
    if not _XML.search(path):
        return False
    names = _names(head())
    if names and names[0].lower() == "cyclonedds":
        return True
    return bool(names) and "cyclone" in path.rpartition("/")[2].lower() and names[0].lower() in _CYCLONE_GROUPS


def _is_fastdds(path: str, head: Head) -> bool:
    if not _XML.search(path):
        return False
    text = head()
    names = _names(text)
    if not names:
        return False
    root, below = names[0], names[1] if len(names) > 1 else ""
    eprosima = "eprosima.com" in text and below not in _OTHER_DDS
    if root == "dds":
        return below in _FASTDDS_TOP or (eprosima and below != "staticdiscovery")
    if root == "profiles":
        return below in _FASTDDS_PROFILES or eprosima
    if eprosima and below == "profiles":
        return True
    if root.lower() in ("dds", "profiles", "fastdds", "fastrtps", "participant"):
        return eprosima or (below in _FASTDDS_TOP | _FASTDDS_PROFILES and _fast_name(path))
    return False


def _fast_name(path: str) -> bool:
    name = path.rpartition("/")[2].lower()
    return any(word in name for word in ("fastdds", "fastrtps", "fast_dds", "fast-dds"))


def _names(text: str) -> list[str]:
    """The local names of the first two elements."""
    prolog = _PROLOG.match(text)
    text = _NOISE.sub("", text[prolog.end() if prolog else 0 :])
    if not text.startswith("<"):
        return []
    return [match[2] for _, match in zip(range(2), _TAG.finditer(text), strict=False)]


KINDS = (
    Kind("cyclonedds", _is_cyclonedds),
    Kind("fastdds", _is_fastdds),
)
