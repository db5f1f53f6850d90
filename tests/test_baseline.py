"""Baselines: what is known is not reported again."""

from __future__ import annotations

import json
from collections.abc import Iterable

import pytest

from bringup_lint import baseline
from bringup_lint.finding import Finding
from bringup_lint.finding.presented import presented
from tests.report.sample import FINDINGS
from tests.report.sample import PASSWORD

ROOT = "/home/robot/mower"


PRESENTED = presented(FINDINGS, ROOT).findings


def written(findings: Iterable[Finding]) -> str:
    return baseline.written(baseline.entries_of(findings, ROOT))


def test_what_is_written_is_known() -> None:
    known = baseline.read(written(PRESENTED))
    sifted = baseline.sift(PRESENTED, known)
    assert [finding.rule for finding in sifted.new] == ["systemd/restart-unlimited"], "suppressed ones are not kept"
    assert sifted.gone == ()


def test_new_ones_and_gone_ones() -> None:
    known = baseline.read(written(PRESENTED[:4]))
    sifted = baseline.sift(PRESENTED[2:], known)
    assert sifted.known == PRESENTED[2:4]
    assert sifted.new == PRESENTED[4:]
    assert [entry.rule for entry in sifted.gone] == [finding.rule for finding in PRESENTED[:2]]


def test_text_is_stable_and_holds_no_secret() -> None:
    text = written(PRESENTED)
    assert text == written(reversed(PRESENTED))
    assert PASSWORD not in text
    assert text.endswith("}\n")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "not a baseline: "),
        ("[]", "not a baseline: it has no version"),
        ('{"version": 2, "findings": []}', "baseline of version 2; this program reads 1"),
        ('{"version": 1, "findings": [{}]}', "not a baseline: findings without fingerprints"),
        ('{"version": 1, "findings": ["x"]}', "not a baseline: findings without fingerprints"),
        ('{"version": 1, "findings": 3}', "not a baseline: findings without fingerprints"),
        ("[" * 100_000, "not a baseline: "),
    ],
)
def test_what_is_no_baseline_says_so(text: str, message: str) -> None:
    with pytest.raises(baseline.BaselineError, match=message):
        baseline.read(text)


def test_entries_say_what_they_are() -> None:
    first = json.loads(written(PRESENTED))["findings"][0]
    assert list(first) == ["path", "rule", "message", "fingerprint"]
