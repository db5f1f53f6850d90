"""What boot loaders hand to the kernel."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.parsers.kernel_command_line import parse
from bringup_lint.source import Source


def words(name: str, text: str) -> list[tuple[str, str, int]]:
    return [(word.name, str(word.value), word.value.span.line) for word in parse(Source(name, text))]


def test_firmware_reads_the_first_line_alone() -> None:
    text = "console=serial0,115200 quiet root=LABEL=writable\nconsole=tty1\n"
    assert words("boot/cmdline.txt", text) == [("console", "serial0,115200", 1), ("root", "LABEL=writable", 1)]


def test_extlinux_has_a_line_for_each_entry() -> None:
    text = "DEFAULT one\nLABEL one\n  append ${cbootargs} console=ttyTCU0\n  FDT /boot/a.dtb\n#APPEND console=ttyS9\n"
    assert words("boot/extlinux/extlinux.conf", text) == [("console", "ttyTCU0", 3)]


def test_grub_keeps_it_in_quotes() -> None:
    text = "GRUB_CMDLINE_LINUX_DEFAULT='quiet console=ttyS0,115200n8'\n# GRUB_CMDLINE_LINUX=\"console=ttyS1\"\n"
    assert words("etc/default/grub", text) == [("console", "ttyS0,115200n8", 1)]


@given(st.text(alphabet="console=tyS0, \"'\n#APEND GRUB_CMDLINE_LINUX", max_size=80))
def test_each_value_stands_where_it_says(text: str) -> None:
    for name in ("cmdline.txt", "extlinux.conf", "etc/default/grub"):
        for word in parse(Source(name, text)):
            assert text[word.value.span.start : word.value.span.end] == word.value
