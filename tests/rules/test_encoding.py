from pathlib import Path

from tests.lint import lint

UNIT = "[Service]\nType=oneshot\nExecStart=/usr/bin/true\n"
MODULE = "# -*- coding: latin-1 -*-\n# caf\u00e9\nLIMIT = 1\n"


def test_no_module_is_refused_for_its_encoding(tmp_path: Path) -> None:
    (tmp_path / "once.service").write_text(UNIT, "utf-8")
    (tmp_path / "tool.py").write_text(MODULE, "latin-1")
    assert "lint/encoding" not in lint("--isolated", "--output-format", "concise", ".", cwd=tmp_path).stdout
