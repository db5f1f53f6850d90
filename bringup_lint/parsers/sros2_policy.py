"""sros2 policies (``policy.xml``). ``xi:include`` is noted and never followed: what it brings stays unknown."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Remark
from bringup_lint.model.sros2_policy import Policy
from bringup_lint.model.sros2_policy import PolicyEnclave
from bringup_lint.model.sros2_policy import Profile
from bringup_lint.model.sros2_policy import Right
from bringup_lint.model.xml import Element
from bringup_lint.parsers.sros2 import not_wellformed
from bringup_lint.parsers.sros2_schema import check
from bringup_lint.parsers.xml import parse as parse_xml
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.templates import has_placeholder
from bringup_lint.templates import is_named_template

VERSION = "0.2.0"
XINCLUDE = "http://www.w3.org/2001/XInclude"
_EXPANDS = regex(r"[$`]")
"""What a shell, envsubst or make replaces; no name of ROS has it."""
_FILLED = regex(
    r"\s(?:path|ns|node)=(?:\"[^\"<>]{0,200}\"|'[^'<>]{0,200}')|<!--(?:(?!<!--|-->).)*-->",
    re.S,
    hints="path= ns= node= <!--",
)
"""Names that may be expanded without a change of the structure, and comments."""
WAYS = {"topics": ("publish", "subscribe"), "services": ("reply", "request"), "actions": ("call", "execute")}


def policy(source: Source) -> Policy:
    document = parse_xml(source)
    model = Policy(source, document, open=_is_expanded(source))
    if not model.open:
        model.remarks += [not_wellformed(problem) for problem in document.problems]
    root = document.root
    if root is None:
        return model
    if not document.problems and not model.open:
        model.remarks += _structure(root)
        if _is_to_complete(source, model.remarks):
            model.open, model.remarks = True, []
    for holder in root.find_all("enclaves"):
        model.open |= _includes(holder)
        model.enclaves += [_enclave(each) for each in holder.find_all("enclave")]
    model.open |= _includes(root)
    return model


def _is_expanded(source: Source) -> bool:
    """Whether a shell or another program puts more than names into the text, which may be whole elements."""
    return bool(_EXPANDS.search(source.text) and _EXPANDS.search(_FILLED.sub("", source.text)))


def _is_to_complete(source: Source, remarks: Iterable[Remark]) -> bool:
    """Whether a template has text where elements are to be: a mark that is replaced by such."""
    is_template = bool(source.template) or is_named_template(source.basename)
    return is_template and any(each.code is Code.TEXT for each in remarks)


def _includes(element: Element) -> bool:
    return any(is_include(child) for child in element.children)


def is_include(element: Element) -> bool:
    return element.local == "include" and ":" in element.name


def _enclave(element: Element) -> PolicyEnclave:
    enclave = PolicyEnclave(element, _attribute(element, "path"), open=_includes(element))
    for holder in element.find_all("profiles"):
        enclave.open |= _includes(holder)
        for child in holder.find_all("profile"):
            profile = Profile(child, _attribute(child, "ns"), _attribute(child, "node"), open=_includes(child))
            rights = list(_rights(child.children))
            profile.rights += [right for right in rights if not _is_to_fill(right)]
            profile.open |= len(profile.rights) < len(rights)
            enclave.profiles.append(profile)
    return enclave


def _attribute(element: Element, name: str) -> Located:
    value = element.get(name)
    return Located("", element.tag) if value is None else value


def _rights(groups: Iterable[Element]) -> Iterator[Right]:
    for group in groups:
        ways = {way: str(value) for way in WAYS.get(group.local, ()) if (value := group.get(way)) is not None}
        for child in group.children:
            if f"{child.local}s" == group.local:
                name = child.texts[0] if len(child.texts) == 1 else child.text
                yield Right(str(child.local), name, ways, group)


def _is_to_fill(right: Right) -> bool:
    """Whether a template or a script does not say yet what a right is for, or what it allows."""
    words = (right.name, *right.ways.values())
    is_template = bool(right.name.span.source.template)
    return any(map(_EXPANDS.search, words)) or (is_template and any(map(has_placeholder, words)))


def _structure(root: Element) -> Iterator[Remark]:
    """What sros2's schema rejects, by the table; what is included is left out, and may be what seems to be missing."""
    if root.namespace:
        yield Remark(Code.NAMESPACE, root.name, root.namespace, element=root)
        return
    including = {id(element) for element in root.walk() if _includes(element)}
    for remark in check(root, "policy"):
        unsure = remark.code is Code.MISSING and id(remark.element) in including
        if not unsure and remark.code is not Code.EMPTY:
            yield remark
    version = root.get("version")
    if version is not None and version != VERSION:
        yield Remark(Code.VERSION, version, str(version), element=root)
