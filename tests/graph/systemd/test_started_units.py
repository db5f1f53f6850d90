"""Which units something starts, and whose files a fix may change."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.graph.systemd.test_units import SERVICE
from tests.graph.systemd.test_units import load
from tests.graph.systemd.test_units import only


def test_units_of_the_distribution_are_started(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    files = {"ssh.service": SERVICE, "systemd-robot.service": SERVICE, "arm.service": SERVICE}
    units = load(tmp_path, files, monkeypatch)
    assert [name for name in files if units.is_started(only(units, name))] == ["ssh.service", "systemd-robot.service"]


def test_templates_are_not_changed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    units = load(tmp_path, {"arm.service": SERVICE, "leg.service.in": SERVICE + "User=@USER@\n"}, monkeypatch)
    assert only(units, "arm.service").editable
    assert not only(units, "leg.service").editable
