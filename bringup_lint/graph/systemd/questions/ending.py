"""Command lines that set something up and end by themselves."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.commands.command_line import CommandLine
from bringup_lint.graph.commands.command_line import Step
from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_SETS_UP = frozenset(
    "ip ifconfig modprobe insmod slcan_attach slcand tc ethtool iptables ip6tables nmcli rfkill iwconfig iw stty "
    "setserial jetson_clocks nvpmodel cpupower cpufreq-set amixer pactl gpio raspi-gpio pinctrl i2cset devmem "
    "devmem2 sysctl v4l2-ctl hciconfig mount umount chmod chown chgrp mkdir ln cp mv rm tee touch".split()
)
"""What changes something of the running system and returns."""
_PASSING = frozenset(
    "echo printf sleep true false : [ [[ test if then else fi set export cd exit return local read readonly declare "
    "grep egrep awk sed cut head tail cat wc tr id whoami sudo command which type logger date trap shift unset udevadm "
    "lsmod lsusb dmesg uname hostname basename dirname readlink realpath seq expr systemctl".split()
)
_READERS = ("cat", "tail", "head", "grep", "awk", "sed", "logger")
_LOOPS = regex(
    r"\b(?:while|until)\b|\bfor[ \t]*\(\([ \t]*;|\btail[ \t]+-[fF]|\bmonitor\b|\binfinity\b|\bsleep[ \t]+\d{4}"
    r"|\b(?:subscribe|event|wfi)\b|--(?:follow|wait|mode=|stream)|\bslcand\b[^\n;&|]*[ \t]-\w*F",
    hints="while until for tail monitor infinity sleep subscribe event wfi --follow --wait --mode --stream slcand",
)


def set_up(line: CommandLine) -> Located | None:
    """The first command that sets something up, when all commands of a line are known and end by themselves."""
    if line.scripts_outside or any(_LOOPS.search(text) for text in line.texts):
        return None
    steps = [step for step in line.steps if not _is_followed(line, step)]
    if not steps or any(step.command.background for step in steps):
        return None
    if any(_waits(step) for step in steps):
        return None
    programs = list(_programs(steps))
    if any(name not in _SETS_UP and name not in _PASSING for name, _ in programs):
        return None
    return next((word for name, word in programs if name in _SETS_UP), None)


def _waits(step: Step) -> bool:
    """Whether a command reads what comes in: from a device, a pipe or a person."""
    words = unwrapped(step.command.words)
    name = program_name(words[0]) if words else ""
    if any(each.operator == "<" for each in step.command.redirects):
        return True
    return name == "read" or (name in _READERS and any(word.startswith(("/dev/", "/run/", "/tmp/")) for word in words))


def _is_followed(line: CommandLine, step: Step) -> bool:
    """Whether a command is a shell or a script whose own commands are among the steps."""
    words = unwrapped(step.command.words)
    followed = program_name(words[0]) in SHELLS or "/" in words[0] if words else False
    return followed and any(other.depth > step.depth for other in line.steps)


def _programs(steps: list[Step]) -> Iterator[tuple[str, Located]]:
    for step in steps:
        words = unwrapped(step.command.words)
        if words:
            yield program_name(words[0]), words[0]
