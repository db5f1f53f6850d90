"""The report as SARIF 2.1.0, the OASIS interchange format of code scanning services."""

from __future__ import annotations

import json

from bringup_lint.report.model import Report
from bringup_lint.report.sarif.run import run
from bringup_lint.report.unicode import harmless
from bringup_lint.report.unicode import sound

SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"


def render(report: Report) -> str:
    log = {"$schema": SCHEMA, "version": "2.1.0", "runs": [run(report)]}
    return harmless(json.dumps(sound(log), indent=2)) + "\n"
