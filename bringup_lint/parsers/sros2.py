"""Governance and permissions documents of DDS Security, plain or inside the clear text of their S/MIME signature."""

from __future__ import annotations

import re

from bringup_lint.dataclass import replace
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Remark
from bringup_lint.model.sros2 import AccessRule
from bringup_lint.model.sros2 import DomainRule
from bringup_lint.model.sros2 import Domains
from bringup_lint.model.sros2 import Governance
from bringup_lint.model.sros2 import Grant
from bringup_lint.model.sros2 import Permissions
from bringup_lint.model.sros2 import Range
from bringup_lint.model.sros2 import TopicRule
from bringup_lint.model.xml import Document
from bringup_lint.model.xml import Element
from bringup_lint.parsers.sros2_schema import check
from bringup_lint.parsers.xml import parse as parse_xml
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

_SIGNED = regex(r"\.(?:p7s|smime|p7m)$", re.I)
_PAYLOAD = regex(r"(?:<\?xml\b[^>]*>\s*)?<(?:\w+:)?dds\b.*?</(?:\w+:)?dds\s*>", re.S)
_VISIBLE = regex(r"[^\r\n]")


def is_signed(source: Source) -> bool:
    return bool(_SIGNED.search(source.name))


def payload(source: Source) -> str | None:
    """The document inside a signed file; None when its text is encoded."""
    match = _PAYLOAD.search(source.text)
    return match[0] if match else None


def governance(source: Source) -> Governance:
    document = _document(source)
    model = Governance(source, document, _remarks(document, "governance"))
    top = document.root.find("domain_access_rules") if document.root is not None else None
    if top is None:
        return model
    for element in top.find_all("domain_rule"):
        rule = DomainRule(element, _domains(element.find("domains"), model.remarks), _fields(element))
        rules = element.find("topic_access_rules")
        if rules is not None:
            for each in rules.find_all("topic_rule"):
                fields = _fields(each)
                rule.topic_rules.append(TopicRule(each, fields.pop("topic_expression", None), fields))
        model.rules.append(rule)
    return model


def permissions(source: Source) -> Permissions:
    document = _document(source)
    model = Permissions(source, document, _remarks(document, "permissions"))
    top = document.root.find("permissions") if document.root is not None else None
    if top is None:
        return model
    for element in top.find_all("grant"):
        validity = element.find("validity")
        grant = Grant(
            element,
            element.get("name"),
            _text(element.find("subject_name")),
            _text(validity.find("not_before")) if validity is not None else None,
            _text(validity.find("not_after")) if validity is not None else None,
            default=_text(element.find("default")),
        )
        for child in element.children:
            if child.local in ("allow_rule", "deny_rule"):
                grant.rules.append(_access_rule(child, model.remarks))
        model.grants.append(grant)
    return model


def _document(source: Source) -> Document:
    """The document; that of a signed file keeps its places."""
    match = _PAYLOAD.search(source.text) if is_signed(source) else None
    if match is None:
        return parse_xml(source)
    start, end = match.span()
    blank = _VISIBLE.sub(" ", source.text[:start]), _VISIBLE.sub(" ", source.text[end:])
    text = f"{blank[0]}{match[0]}{blank[1]}"
    return parse_xml(replace(source, text=text))


def _remarks(document: Document, file: str) -> list[Remark]:
    remarks = [
        not_wellformed(problem)
        for problem in document.problems
        if not (problem.code == "late-declaration" and is_signed(document.source))
    ]
    if document.root is not None and not remarks:
        remarks += (each for each in check(document.root, file) if each.code not in _TOLERATED)
    return remarks


_TOLERATED = (Code.UNKNOWN_ATTRIBUTE, Code.TEXT, Code.SHAPE)
"""What the plugins read over."""


def not_wellformed(problem: Problem) -> Remark:
    return Remark(Code.XML, problem.where, problem.detail, xml=problem.code)


def _text(element: Element | None) -> Located | None:
    return None if element is None else element.text


def _fields(element: Element) -> dict[str, Located]:
    return {str(child.local): child.text for child in element.children if not child.children}


def _domains(element: Element | None, remarks: list[Remark]) -> Domains | None:
    if element is None:
        return None
    domains = Domains(element)
    if not element.children:
        remarks.append(Remark(Code.MISSING, element.name, "id", element=element))
    for child in element.children:
        ends: tuple[Located | None, Located | None]
        if child.local == "id":
            ends = (child.text, child.text)
        elif child.local == "id_range":
            ends = (_text(child.find("min")), _text(child.find("max")))
        else:
            domains.known = False
            continue
        first, last = (int(end) if end and end.isascii() and end.isdecimal() else None for end in ends)
        if child.local == "id_range" and first is None and ends[0] is None:
            remarks.append(Remark(Code.RANGE, child.span, "no minimum", element=child))
        if first is None or (last is None and ends[1] is not None):
            domains.known = False
        elif last is not None and first > last:
            detail = f"the minimum {first} is above the maximum {last}"
            remarks.append(Remark(Code.RANGE, child.span, detail, element=child))
        else:
            domains.ranges.append(Range(first, last, child.span))
    return domains


def _access_rule(element: Element, remarks: list[Remark]) -> AccessRule:
    rule = AccessRule(element, element.local == "allow_rule", _domains(element.find("domains"), remarks))
    for child in element.children:
        topics = {"publish": rule.publish, "subscribe": rule.subscribe}.get(child.local)
        if topics is not None:
            for group in child.find_all("topics"):
                topics += [topic.text for topic in group.find_all("topic")]
            topics += [topic.text for topic in child.find_all("topic")]
    return rule
