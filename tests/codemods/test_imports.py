"""Where the import that a change needs is written."""

from __future__ import annotations

import ast

import pytest

from bringup_lint.codemods.imports import Import
from bringup_lint.codemods.imports import with_import

SHUTDOWN = Import("launch.actions", "Shutdown")
ADDED = "from launch.actions import Shutdown\n"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("from launch.actions import Shutdown\n", "from launch.actions import Shutdown\n"),
        ("from launch.actions import *\n", "from launch.actions import *\n"),
        ("from launch.actions import A\n", "from launch.actions import A, Shutdown\n"),
        ("from launch.actions import A, T\n", "from launch.actions import A, Shutdown, T\n"),
        ("from launch.actions import T, A  # why\n", "from launch.actions import T, A, Shutdown  # why\n"),
        ("from launch.actions import A as B\n", "from launch.actions import A as B, Shutdown\n"),
        (
            "from launch.actions import (\n    A,\n    T,\n)\n",
            "from launch.actions import (\n    A,\n    Shutdown,\n    T,\n)\n",
        ),
        (
            "from launch.actions import (\n    A,  # é\n    B\n)\n",
            "from launch.actions import (\n    A,  # é\n    B,\n    Shutdown\n)\n",
        ),
        ("from launch.actions import (A,\n    B)\n", "from launch.actions import (A,\n    B,\n    Shutdown)\n"),
        (
            "import os\n\nfrom launch import A\nfrom launch.substitutions import B\nfrom launch_ros.actions import C\n",
            f"import os\n\nfrom launch import A\n{ADDED}"
            "from launch.substitutions import B\nfrom launch_ros.actions import C\n",
        ),
        ("import os\nfrom launch.substitutions import B\n", f"import os\n{ADDED}from launch.substitutions import B\n"),
        ("import os\nfrom yaml import B\n\nx = 1\n", f"import os\nfrom yaml import B\n{ADDED}\nx = 1\n"),
        (
            '"""What it is.\n\nimport nothing\n"""\n\nfrom __future__ import annotations\n\nx = 1\n',
            f'"""What it is.\n\nimport nothing\n"""\n\nfrom __future__ import annotations\n{ADDED}\nx = 1\n',
        ),
        ('"""What it is."""\n\nx = 1\n', f'"""What it is."""\n\n{ADDED}\nx = 1\n'),
        ('"""What it is."""; import os\nx = 1\n', f'"""What it is."""; import os\n{ADDED}\nx = 1\n'),
        ("import os; x = [\n    1]\n", f"import os; x = [\n    1]\n{ADDED}"),
        ("#!/usr/bin/env python3\n@a\ndef f(): pass\n", f"#!/usr/bin/env python3\n{ADDED}\n@a\ndef f(): pass\n"),
        ("import os\r\nx = 1\r\n", "import os\r\nfrom launch.actions import Shutdown\r\n\r\nx = 1\r\n"),
        ("import os\n\x0c\nx = '\u2028'", f"import os\n{ADDED}\x0c\nx = '\u2028'"),
        ("import os", f"import os\n{ADDED}"),
        (
            "try:\n    import launch\nexcept ImportError:\n    pass\n",
            f"{ADDED}\ntry:\n    import launch\nexcept ImportError:\n    pass\n",
        ),
        ("not Python:\n", "not Python:\n"),
    ],
)
def test_place(before: str, after: str) -> None:
    assert with_import(before, SHUTDOWN) == after
    assert with_import(after, SHUTDOWN) == after
    if after != "not Python:\n":
        assert ast.get_docstring(ast.parse(after)) == ast.get_docstring(ast.parse(before))
