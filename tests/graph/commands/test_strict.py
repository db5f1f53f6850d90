"""Which shell scripts end with their first failing command."""

from __future__ import annotations

import re

import pytest

from bringup_lint.graph.commands.shells import STRICT


@pytest.mark.parametrize(
    "text",
    [
        "set -e",
        "  set -euo pipefail",
        "set -o errexit",
        "set -u -o pipefail -e",
        "cd /ws; set -xe && ls",
        "#!/bin/bash -e\nls",
        "ls\n#!/bin/bash -eu\n",
    ],
)
def test_ends_with_its_first_failing_command(text: str) -> None:
    assert re.search(STRICT, text, re.M)


@pytest.mark.parametrize(
    "text",
    ["set -u", "# set -e", "#set -e", "set +e", "set -o pipefail", "#!/bin/bash\nls", "offset -e"],
)
def test_goes_on_after_a_failing_command(text: str) -> None:
    assert not re.search(STRICT, text, re.M)
