"""The picture as data; ``docs/graph.schema.json`` describes it."""

from __future__ import annotations

import json
from typing import Any

from bringup_lint.report.unicode import harmless
from bringup_lint.report.unicode import sound


def render(document: dict[str, Any]) -> str:
    return harmless(json.dumps(sound(document), indent=2, ensure_ascii=False)) + "\n"
