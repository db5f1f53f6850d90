"""Policies against sros2's own schema: ``ros2 security create_permission`` takes what it takes, and nothing else.

BRINGUP_LINT_SROS2 names a checkout of ros2/sros2; the schema is asked with lxml.
"""

from __future__ import annotations

import importlib.util
import os
import random
import re
from pathlib import Path

from bringup_lint.parsers.sros2_policy import policy
from bringup_lint.source import Source
from tests.oracles.answers import Oracle
from tests.oracles.xml_mutations import mutants

SEED = (Path(__file__).parent / "dds/policy.xml").read_text("utf-8")
VALUES = ["ALLOW", "DENY", "allow", "", "/x", "~/x", "0.1.0", "yes"]
CHECKOUT = os.environ.get("BRINGUP_LINT_SROS2", "")
MUTANTS = 800


def tool() -> str:
    """Such as ``sros2 0.13.0``; without the number where there is no checkout, or no lxml."""
    if not CHECKOUT or importlib.util.find_spec("lxml") is None:
        return "sros2"
    package = (Path(CHECKOUT) / "sros2/package.xml").read_text("utf-8")
    return f"sros2 {package.partition('<version>')[2].partition('<')[0]}"


def accepted(texts: list[str]) -> list[bool]:
    """Whether each is well-formed and valid for the schema of the checkout."""
    from lxml import etree

    (path,) = Path(CHECKOUT).rglob("policy.xsd")
    text = re.sub(r'<xs:import[^>]*xml.xsd"\s*/>', "", path.read_text("utf-8"))
    schema = etree.XMLSchema(etree.fromstring(re.sub(r'<xs:attribute ref="xml:base"\s*/>', "", text).encode()))

    def is_valid(text: str) -> bool:
        try:
            return schema.validate(etree.fromstring(text.encode()))
        except etree.XMLSyntaxError:
            return False

    return [is_valid(text) for text in texts]


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


def test_policies_are_taken_or_refused_alike(answers: Oracle) -> None:
    variants = [SEED, *slips(), *mutants(SEED, VALUES, MUTANTS, seed=6)]
    pairs = answers.of("sros2/policies", tool(), [text for text in variants if "<policy " in text], accepted).pairs
    remarks = {
        text: [(each.code, each.detail) for each in policy(Source("policy.xml", text)).remarks] for text, _ in pairs
    }
    assert [remarks[text] for text, is_accepted in pairs if is_accepted == bool(remarks[text])] == []
    assert len(pairs) > MUTANTS
    assert 100 < sum(not is_accepted for _, is_accepted in pairs) < len(pairs) - 100
