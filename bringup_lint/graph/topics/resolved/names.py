"""Names of topics as rcl reads them: what is valid, and what a name means for a node in its namespace."""

from __future__ import annotations

import re

from bringup_lint.pattern import regex

LONGEST = 247
"""Characters of a full name: 255 less what the middleware puts before it (``RMW_TOPIC_MAX_NAME_LENGTH``)."""
SUBSTITUTIONS = ("node", "ns", "namespace")
_FORBIDDEN = regex(r"[^A-Za-z0-9_/~{}]")
_SUBSTITUTION = regex(r"\{(\w*)\}", re.A)
_LEADING_DIGIT = regex(r"(?:^|/)[0-9]")


def complaint(name: str) -> str | None:
    """Why rcl refuses a name as it is written (``rcl_validate_topic_name``); None when it takes it."""
    if not name:
        return "it is empty"
    bad = _FORBIDDEN.search(name)
    if bad is not None:
        return f"it contains {bad[0]!r}"
    if name.endswith("/"):
        return "it ends with '/'"
    bare = _SUBSTITUTION.sub("", name)
    if "{" in bare or "}" in bare:
        return "its braces are not a substitution"
    if any(word[:1].isdecimal() for word in _SUBSTITUTION.findall(name)):
        return "the name in its braces begins with a digit"
    if _LEADING_DIGIT.search(name):
        return "one of its parts begins with a digit"
    if name.startswith("~") and len(name) > 2 and name[1] != "/":
        return "'~' is not followed by '/'"
    if "~" in name[1:]:
        return "'~' is not at the beginning"
    return None


def unknown_substitution(name: str) -> str | None:
    """A ``{word}`` that rcl does not fill in, so that the name is refused when it is expanded."""
    return next((f"{{{word}}}" for word in _SUBSTITUTION.findall(name) if word not in SUBSTITUTIONS), None)


def full_complaint(name: str) -> str | None:
    """Why the middleware refuses a full name (``rmw_validate_full_topic_name``); None when it takes it."""
    if not name.startswith("/"):
        return "it is not absolute"
    if name.endswith("/"):
        return "it ends with '/'"
    bad = re.search(r"[^A-Za-z0-9_/]", name)
    if bad:
        return f"it contains {bad[0]!r}"
    if "//" in name:
        return "it contains '//'"
    if _LEADING_DIGIT.search(name):
        return "one of its parts begins with a digit"
    if len(name) > LONGEST:
        return f"it has {len(name)} characters, but only {LONGEST} are allowed"
    return None


def refusal(name: str) -> str | None:
    """Why a topic or service name is refused wherever the node is; None when it is not."""
    if complaint(name):
        return complaint(name)
    unknown = unknown_substitution(name)
    if unknown is not None:
        return f"'{unknown}' is not a substitution"
    full = expand(name, "n", "/")
    return full_complaint(full) if full is not None else None


def expand(name: str, node: str | None, namespace: str | None) -> str | None:
    """The full name that ``scan``, ``~/scan``, ``/scan`` or ``{node}/scan`` has for a node (``rcl_expand_topic_name``).

    ``node`` is the bare name, ``namespace`` absolute. None when the name is not valid, or depends on something that is
    not known.
    """
    if complaint(name):
        return None
    if name.startswith("~"):
        if node is None or namespace is None:
            return None
        name = f"{_prefix(namespace)}/{node}{name[1:]}"
    for word in _SUBSTITUTION.findall(name):
        value = {"node": node, "ns": namespace, "namespace": namespace}.get(word)
        if value is None:
            return None
        name = name.replace(f"{{{word}}}", value)
    if name.startswith("/"):
        return name
    return None if namespace is None else f"{_prefix(namespace)}/{name}"


def _prefix(namespace: str) -> str:
    return "" if namespace == "/" else namespace


def tail(name: str) -> str:
    """The last part of a name."""
    return name.rpartition("/")[2]
