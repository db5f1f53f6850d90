"""Advice that a user copies must reach the report as it is written."""

from __future__ import annotations

import json

from tests.conftest import PROJECT
from tests.lint import lint


def test_the_escape_of_a_space_in_fstab_is_printed() -> None:
    case = PROJECT / "fixtures" / "fstab" / "field_count" / "bad"
    run = lint("--isolated", "--select", "fstab/field-count", "--output-format", "json", ".", cwd=case)
    assert any("\\040" in finding["advice"] for finding in json.loads(run.stdout)["findings"])
