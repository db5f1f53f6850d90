"""A script reads what only another shell understands.

## What it finds
- `source` in a script that begins with `#!/bin/sh`, and `.` with a `setup.bash` there;
- `source` or `.` with a `setup.zsh` in a script for bash or sh.

Lines under a condition are not reported, nor scripts that something of the tree reads with `source`, or starts with
the name of another shell.

## Why it matters on a robot
`/bin/sh` is dash on Ubuntu and Debian: it answers "source: not found" and goes on without the environment of ROS.
bash cannot read the expansions of a `setup.zsh` ("bad substitution"). In both cases `ros2` is not found, or it finds
none of the packages of the workspace.

## Bad
```sh
#!/bin/bash
source /opt/ros/jazzy/setup.zsh
```

## Good
```sh
#!/bin/bash
source /opt/ros/jazzy/setup.bash
```

## When to ignore it
When `/bin/sh` on the robot is bash, as on Fedora or in some Yocto images.

## References
- dash(1)
- zshexpn(1), "Parameter Expansion Flags"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import SH_IS_BASH
from bringup_lint.api.shell import Run

SHELL = regex(r"#!\s*\S*/(?:env\s+)?(sh|dash|bash|zsh)\b")
SETUP = regex(r"(?:^|/)(?:local_)?setup\.(bash|zsh)$")
BOTH = regex(r"\b(?:ZSH_VERSION|ZSH_NAME|BASH_VERSION|BASH_SOURCE)\b")


@rule("error", symptoms=["source: not found", "bad substitution", "ros2: command not found"])
def other_shell(robot: Robot) -> Iterator[Finding]:
    found: dict[Source, list[tuple[Located, str, str]]] = {}
    by_services = _run_by_services(robot)
    for source, run in robot.scripts.run("source", "."):
        wrong = _wrong(source, run) if run.certain and source not in by_services else None
        if wrong is not None:
            found.setdefault(source, []).append((run.words[0], *wrong))
    for source, ((first, message, advice), *others) in found.items():
        replaced = SHELL.match(source.said)
        if replaced is not None and replaced[1] == "sh" and robot.mentions(SH_IS_BASH):
            continue
        if not _is_read_otherwise(robot, source):
            yield finding(
                first,
                message,
                advice=advice,
                related=[note(word, "here too") for word, _, _ in others],
            )


def _run_by_services(robot: Robot) -> set[Source]:
    """The scripts that services run with sh, of which systemd/sh-source speaks."""
    return {
        step.script
        for unit in robot.units.services
        for process in robot.units.processes(unit)
        for step in process.steps
        if step.script is not None and step.shell in ("sh", "dash")
    }


def _wrong(source: Source, run: Run) -> tuple[str, str] | None:
    shebang = SHELL.match(source.text)
    if shebang is None or len(run.words) < 2:
        return None
    own = shebang[1]
    named = SETUP.search(run.text(run.words[1]))
    other = named[1] if named is not None else ""
    if own in ("sh", "dash") and run.name == "source":
        return "/bin/sh is dash on Ubuntu and Debian and has no 'source': what follows has no such environment", (
            "begin the script with #!/bin/bash"
        )
    if other and own != other and (own, other) != ("zsh", "bash"):
        return f"{own} cannot read a setup.{other}: the environment of ROS is not set", f"source the setup.{own}"
    return None


def _is_read_otherwise(robot: Robot, source: Source) -> bool:
    """Whether the script is for several shells, or something names another shell for it."""
    name = re.escape(source.basename)
    caller = re.compile(rf"(?:\b(?:source|bash|zsh)|(?:^|[\s;&(])\.)\s+(?:-\w+\s+)*['\"]?[^\s'\"]*{name}", re.M)
    others = (each for each in robot.sources if each is not source)
    return bool(BOTH.search(source.said)) or any(caller.search(each.text) for each in others)
