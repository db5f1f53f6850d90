"""detect-secrets, as a reference: what its detectors of known forms find in planted files, no output shows."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.finding.redact import mask_of
from bringup_lint.source import Source
from tests.report.planted import planted

GUESSES = ("Base64 High Entropy String", "Hex High Entropy String", "Public IP (ipv4)")


def found(path: Path) -> set[str]:
    """The values that detect-secrets is sure of."""
    scan = pytest.importorskip("detect_secrets.core.scan")
    settings = pytest.importorskip("detect_secrets.settings")
    with settings.default_settings():
        return {each.secret_value for each in scan.scan_file(str(path)) if each.type not in GUESSES}


def test_known_forms_are_masked(tmp_path: Path) -> None:
    pytest.importorskip("detect_secrets")
    seen = 0
    for number, each in enumerate(planted()):
        path = tmp_path / f"{number}-{each.file.replace('/', '-')}"
        path.write_text(each.text)
        values = found(path)
        mask = mask_of((), [source := Source(each.file, each.text)])
        masked = mask.source(source).text if mask else each.text
        seen += len(values)
        assert not [value for value in values if each.secret in value and value in masked]
    assert seen > 20
