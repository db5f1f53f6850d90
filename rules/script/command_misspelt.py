"""The name of a well-known command is misspelt.

## What it finds
The first word of a command of a shell script or of a `RUN` of a Dockerfile that is no command, and in which two
neighbouring letters of a well-known one are exchanged, or one letter is wrong: `sudp`, `suod`, `soruce`, `mkidr`,
`apt-gte`. Silent where the script or the tree defines a function, an alias or a file of that name.

## Why it matters on a robot
The shell says "command not found" and goes on with the next line: the package is not installed, the file is not
sourced, and the robot starts without it.

## Bad
```sh
sudp apt-get install -y can-utils
```

## Good
```sh
sudo apt-get install -y can-utils
```

## When to ignore it
When a program of this name is on the robot.

## References
- bash(1), "Command Execution"
"""

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import commands_of
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.shell import unwrapped

MISSPELT = {
    "sudo": "sudp suod sduo sudi sido sodu usdo sud0 sudoo ssudo",
    "source": "soruce sorce souce sourec suorce soure soucre surce",
    "export": "exprot exort expotr exprt epxort xport",
    "mkdir": "mkdri mkidr mdkir mkdit makdir mkdirr",
    "echo": "ehco ecoh eho ceho echp",
    "apt-get": "apt-gte apt-ge atp-get apt-gett aptget apt-gt",
    "apt": "aptt atpt",
    "chmod": "chomd chmdo cmhod chmodd chmos",
    "chown": "chonw chwon chowm",
    "git": "gti giit",
    "grep": "gerp grpe gerep",
    "sleep": "slepp slep sleeep selep",
    "systemctl": "systemclt sytemctl systmctl systemctrl systemct systectl systemcl",
    "colcon": "colocn clocon colcn colon colcom",
    "ros2": "rso2 rps2",
    "rosdep": "rosde rodsep rsodep",
    "python3": "pyhton3 pytohn3 pyton3 phyton3 pythn3",
    "docker": "dokcer dcoker docekr doker",
    "modprobe": "modprob mobprobe mdoprobe",
    "exit": "exti eixt exitt",
    "usermod": "usermdo usemod",
    "udevadm": "udevamd udevad udvadm",
}
"""Command -> slips of the keyboard."""
MEANT = {wrong: right for right, slips in MISSPELT.items() for wrong in slips.split()}
MAY_BE = regex(rf"(?<![\w./-])(?:{'|'.join(MEANT)})(?![\w./-])", hints=" ".join(MEANT))


@rule("error", confidence="medium", symptoms=["command not found"])
def command_misspelt(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and MAY_BE.search(source.text):
            for word in _names(shell_commands(source)):
                if not _is_defined(robot, source, word):
                    yield _finding(word)
    for file in robot.dockerfiles:
        if MAY_BE.search(file.source.text):
            for stage in file.stages:
                yield from map(_finding, _names(commands_of(stage)))


def _finding(word: Located) -> Finding:
    return finding(
        word,
        f"There is no command '{word}': the shell does not run this",
        advice=f"write {MEANT[str(word)]}",
    )


def _names(commands: Iterable[Command]) -> Iterator[Located]:
    for command in commands:
        for words in (command.words, unwrapped(command.words)):
            if words and str(words[0]) in MEANT and words[0].span.text == words[0]:
                yield words[0]
                break


def _is_defined(robot: Robot, source: Source, word: Located) -> bool:
    defines = re.compile(rf"\b(?:function|alias)[ \t]+{re.escape(word)}\b|(?m:^[ \t]*{re.escape(word)}[ \t]*\(\))")
    return defines.search(source.text) is not None or any(robot.tree.named(str(word)))
