"""A quoted pattern is the name of a file that does not exist.

## What it finds
`cp`, `mv`, `rm`, `ln`, `install`, `chmod` and `chown` with a `*` between quotes in the name of a file.

## Why it matters on a robot
The shell expands a pattern only where it is not quoted. `cp "overlays/*" /boot` looks for a file whose name is an
asterisk, fails, and a script without `set -e` goes on: the device tree, the rules or the parameters are not there.
`rm -rf "$DIR/*"` removes nothing, and says nothing.

## Bad
```sh
cp "overlays/*.dtbo" /boot/overlays/
```

## Good
```sh
cp overlays/*.dtbo /boot/overlays/
```

## When to ignore it
When the command runs on another machine, whose shell expands the pattern.

## References
- bash(1), "Pathname Expansion", "QUOTING"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

COMMAND = regex(r"\$\(|`")
"""In ``"$(ls *.conf)"`` the shell reads the command as if no quotes were around it."""
EXPANSION = regex(r"\$\{[^{}]*\}")
"""In ``${NAME%.*}`` the asterisk is a pattern for the value, and the quotes do not matter."""
PROGRAMS = ("cp", "mv", "rm", "ln", "install", "chmod", "chown")


@rule("error", symptoms=["cannot stat", "cannot access '*': No such file or directory"])
def quoted_glob(robot: Robot) -> Iterator[Finding]:
    for _, run in robot.scripts.run(*PROGRAMS):
        for word in _quoted(run):
            effect = "it removes nothing" if run.name == "rm" else "the command fails"
            yield finding(
                word,
                f"The shell does not expand the quoted '*': {run.name} looks for a file of that name, and {effect}",
                advice="end the quotes before the pattern",
            )


def _quoted(run: Run) -> Iterator[Located]:
    """The words whose text in the script has an asterisk right before the quote that ends them."""
    for word in run.words[1:]:
        written = word.span.text
        if (
            "*" in EXPANSION.sub("", written)
            and written[:1] in "\"'"
            and written[-1:] == written[:1]
            and written.count(written[0]) == 2
            and not (written[0] == '"' and COMMAND.search(written))
        ):
            yield word
