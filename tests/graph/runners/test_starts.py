"""Scripts and units that start very much are read in linear time."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.growth import is_linear
from tests.lint import lint


def start_script(size: int) -> str:
    lines = (f'export A{number}="v{number}"\nros2 run rover node{number} &\n' for number in range(size))
    return "#!/bin/bash\n" + "".join(lines)


def long_command(size: int) -> str:
    return "[Unit]\nDescription=x\n[Service]\nExecStart=/bin/true " + "a " * size + "\n"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "text", "small"),
    [("start.sh", start_script, 250), ("rover.service", long_command, 6_000)],
)
def test_time_grows_as_the_file(tmp_path: Path, name: str, text: Callable[[int], str], small: int) -> None:
    def check(size: int) -> None:
        (tmp_path / name).write_text(text(size))
        lint("--no-cache", "--quiet", ".", cwd=tmp_path)

    assert is_linear(check, small)
