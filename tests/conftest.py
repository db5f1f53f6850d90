"""The flag that rewrites expected outputs, and the folder of real configuration."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

PROJECT = Path(__file__).parent.parent


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update-expected", action="store_true", help="rewrite expected outputs; read the diff")


@pytest.fixture
def update_expected(request: pytest.FixtureRequest) -> bool:
    return request.config.getoption("--update-expected")


@pytest.fixture(scope="session")
def corpus() -> Path:
    folder = os.environ.get("BRINGUP_LINT_CORPUS")
    if not folder:
        pytest.skip("BRINGUP_LINT_CORPUS names no folder")
    return Path(folder)
