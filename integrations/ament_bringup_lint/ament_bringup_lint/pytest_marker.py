"""The marker with which a package marks its test, as in ``@pytest.mark.bringup_lint``."""

from __future__ import annotations

from typing import Any


def pytest_configure(config: Any) -> None:
    config.addinivalue_line("markers", "bringup_lint: marks tests that check the configuration with bringup-lint")
