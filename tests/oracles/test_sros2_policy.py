"""Policies against sros2's own schema: ``ros2 security create_permission`` takes what it takes, and nothing else.

BRINGUP_LINT_SROS2 names a checkout of ros2/sros2; without it, or without lxml, the test is skipped.
"""

from __future__ import annotations

import os
import random
import re
from pathlib import Path

import pytest

from bringup_lint.parsers.sros2_policy import policy
from bringup_lint.source import Source
from tests.oracles.xml_mutations import mutants

etree = pytest.importorskip("lxml.etree")

SEED = (Path(__file__).parent / "dds/policy.xml").read_text("utf-8")
VALUES = ["ALLOW", "DENY", "allow", "", "/x", "~/x", "0.1.0", "yes"]
CHECKOUT = os.environ.get("BRINGUP_LINT_SROS2", "")
MUTANTS = 800


def schema():
    if not CHECKOUT:
        pytest.skip("BRINGUP_LINT_SROS2 is not set")
    (path,) = Path(CHECKOUT).rglob("policy.xsd")
    text = re.sub(r'<xs:import[^>]*xml.xsd"\s*/>', "", path.read_text("utf-8"))
    return etree.XMLSchema(etree.fromstring(re.sub(r'<xs:attribute ref="xml:base"\s*/>', "", text).encode()))


def accepted(text: str, by) -> bool:
    try:
        return by.validate(etree.fromstring(text.encode()))
    except etree.XMLSyntaxError:
        return False


def slips() -> list[str]:
    """The seed with elements swapped, renamed, moved and emptied, on top of the usual slips."""
    chance = random.Random(4)
    lines = SEED.splitlines()
    texts = []
    for _ in range(MUTANTS // 4):
        first, second = chance.sample(range(2, len(lines) - 1), 2)
        swapped = list(lines)
        swapped[first], swapped[second] = swapped[second], swapped[first]
        texts.append("\n".join(swapped))
        texts.append("\n".join([*lines[:first], lines[second], *lines[first:]]))
    return texts


def test_policies_are_taken_or_refused_alike() -> None:
    judge = schema()
    bred = [SEED, *slips(), *mutants(SEED, VALUES, MUTANTS, seed=6)]
    texts = [text for text in bred if "<policy " in text]
    differing = []
    for text in texts:
        remarks = policy(Source("policy.xml", text)).remarks
        if accepted(text, judge) is bool(remarks):
            differing.append((text, [(each.code, each.detail) for each in remarks]))
    refused = sum(not accepted(text, judge) for text in texts)
    print(f"{len(texts)} policies, {refused} refused, {len(differing)} differ")
    assert [codes for _, codes in differing] == []
    assert len(texts) > MUTANTS
    assert 100 < refused < len(texts) - 100
