r"""echo of bash writes a backslash and an n.

## What it finds
`echo "...\n"` and `echo "\n..."` without `-e` whose output goes to a file, by `>`, `>>` or `tee`, in scripts that begin
with `#!/bin/bash`. Silent where `shopt -s xpg_echo` is set, for text with `\n` only in its middle, which may be meant
for another program, and for files of programs (`.py`, `.c`, `.cpp`).

## Why it matters on a robot
bash leaves `\n` as it is, only `sh` of Debian and Ubuntu makes a new line of it. A line that is added to `.bashrc` ends
with an n too many, as in `setup.bashn`, or begins with `nexport`: the shell does not find it, and the nodes start
without their environment.

## Bad
```sh
#!/bin/bash
echo "source /opt/ros/jazzy/setup.bash\n" >> ~/.bashrc
```

## Good
```sh
#!/bin/bash
echo "source /opt/ros/jazzy/setup.bash" >> ~/.bashrc
```

## When to ignore it
When the file is to hold a backslash and an n.

## References
- bash(1), "SHELL BUILTIN COMMANDS": echo
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

BASH = regex(r"#!\s*\S*/(?:env\s+(?:-S\s+)?)?bash\b")
INTERPRETS = regex(r"\bxpg_echo\b", hints="xpg_echo")
OPTIONS = regex(r"-[neE]+")
OF_C = "$'"
r"""Begins a text in which the shell itself reads \n."""
ELSEWHERE = regex(r"\.(?:py|c|h|cpp|hpp|js|awk)$|^/dev/(?:null|std|fd|tty$)")


@rule("warning", symptoms=["setup.bashn: No such file or directory", "nexport: command not found"])
def echo_backslash(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or "\\n" not in source.text or not BASH.match(source.text):
            continue
        if not source.says(INTERPRETS):
            yield from _of_script(robot, source)


def _of_script(robot: Robot, source: Source) -> Iterator[Finding]:
    runs = [did for did in robot.scripts.done(source) if isinstance(did, Run)]
    for run, after in zip(runs, (*runs[1:], None)):
        word = _kept(run) if run.name == "echo" else None
        path = None if word is None else _file(run, after)
        if word is not None and path is not None and not ELSEWHERE.search(path):
            yield finding(
                word,
                rf"echo of bash leaves \n as it is: {path} gets a backslash and an n, and no new line",
                advice=r"leave \n out, which echo adds at the end anyway, or use printf",
            )


def _file(run: Run, after: Run | None) -> Located | None:
    """The file that gets what echo prints."""
    for redirect in run.command.redirects:
        if redirect.writes:
            return redirect.target
    if run.command.ends != "|" or after is None or after.name != "tee":
        return None
    return next((word for word in after.words[1:] if not word.startswith("-")), None)


def _kept(run: Run) -> Located | None:
    r"""The word that begins or ends with a backslash and an n."""
    words = list(run.words[1:])
    while words and OPTIONS.fullmatch(words[0]):
        if "e" in words.pop(0):
            return None
    if not words or any(OF_C in word.span.text for word in words):
        return None
    if run.text(words[0]).startswith("\\n"):
        return words[0]
    return words[-1] if run.text(words[-1]).endswith("\\n") else None
