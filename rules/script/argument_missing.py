"""A script of the tree is called with fewer arguments than it uses.

## What it finds
A script of the tree that another script or a unit calls by its path with fewer arguments than it reads (`$1`, `$2`).
An error under `set -u`, which ends the script there; otherwise a warning.

Silent for a script that looks at `$#`, shifts, parses options, gives defaults (`${2:-115200}`) or tests the argument,
for arguments that a variable or a pattern may multiply, and for functions, which have arguments of their own.

## Why it matters on a robot
The argument is empty: a port is opened without its speed, a file gets half a name, and `rm -rf "$2"/*` means the whole
disk. With `set -u` the set-up ends with "$2: unbound variable".

## Bad
```sh
./set_baud.sh /dev/ttyS1          # set_baud.sh: stty -F "$1" "$2"
```

## Good
```sh
./set_baud.sh /dev/ttyS1 115200
```

## When to ignore it
When the script works with an empty argument on purpose.

## References
- POSIX, Shell Command Language, 2.5.1 Positional Parameters
"""

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import short_calls


@rule("warning", confidence="medium", symptoms=["unbound variable", "parameter not set"])
def argument_missing(robot: Robot) -> Iterator[Finding]:
    for call in short_calls(robot.of_kind("shell-script"), _calls(robot)):
        given = len(call.words) - 1
        count = "no argument" if not given else "one argument" if given == 1 else f"{given} arguments"
        effect = "it ends with 'unbound variable'" if call.stops else "it goes on with an empty one"
        yield finding(
            call.words[0],
            f"{call.script.basename} gets {count} and uses {call.lacking[0]}: {effect}",
            advice="give the argument, or a default in the script: ${N:-...}",
            related=[note(each, "used here") for each in call.lacking[:5]],
            severity="error" if call.stops else None,
        )


def _calls(robot: Robot) -> Iterator[tuple[Source, Sequence[Located]]]:
    """The commands of scripts and units."""
    for source in (each for each in robot.of_kind("shell-script") if each.judged):
        for did in robot.scripts.done(source):
            if isinstance(did, Run) and did.command.ends != "||":
                yield source, did.words
    for unit in (each for each in robot.units.services if each.judged and not each.uncertain):
        for process in robot.units.processes(unit):
            yield unit.files[0].source, process.argv
