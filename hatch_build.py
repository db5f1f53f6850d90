"""Puts the index of the rules into the wheel, so that no installed copy has to make it."""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class IndexOfRules(BuildHookInterface):
    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """An editable installation keeps its own index beside the rules, which may change."""
        if version == "editable":
            return
        sys.path.insert(0, self.root)
        try:
            from bringup_lint.rule_index.stored import FILE
            from bringup_lint.rule_index.stored import made_for_wheel
        finally:
            sys.path.remove(self.root)
        self._folder = tempfile.TemporaryDirectory()
        index = Path(self._folder.name) / FILE
        index.write_bytes(made_for_wheel(str(Path(self.root) / "rules")))
        build_data["force_include"][str(index)] = f"bringup_lint/rules/{FILE}"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        if version != "editable":
            self._folder.cleanup()
