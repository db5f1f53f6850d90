"""Programs that start another one: the words of the other begin after their own."""

from __future__ import annotations

import re

import pytest

from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.source import Source


@pytest.mark.parametrize(
    "before",
    [
        "exec",
        "env A=1",
        "/usr/bin/env -u B",
        "nice -n 5",
        "sudo -u rover",
        "runuser -u rover --",
        "gosu rover",
        "su-exec rover",
        "prlimit --nofile=64",
        "unshare --net",
        "chroot --userspec=rover /mnt",
        "systemd-inhibit --what=sleep",
        "systemd-cat -t rover",
        "dbus-run-session --",
        "tini -s --",
        "dumb-init -r 15:2",
        "xvfb-run -a -s '-ac'",
        "exec nice -n 5 env A=1",
    ],
)
def test_program_after_a_wrapper(before: str) -> None:
    source = Source("start", f"{before} ros2 launch rover rover.launch.py")
    words = tuple(source.located(found.start(), found.end()) for found in re.finditer(r"\S+", source.text))
    assert [str(word) for word in unwrapped(words)][:2] == ["ros2", "launch"]


def test_a_new_root_without_a_program_has_a_shell() -> None:
    source = Source("start", "sudo chroot /mnt")
    words = tuple(source.located(found.start(), found.end()) for found in re.finditer(r"\S+", source.text))
    assert [str(word) for word in unwrapped(words)] == ["chroot", "/mnt"]
