"""A script reads what only another shell understands.

## What it finds
- `source` in a script that begins with `#!/bin/sh`, and `.` with a `setup.bash` there;
- `source` or `.` with a `setup.zsh` in a script for bash or sh;
- `source`, and `set -o pipefail`, in a task of Ansible's `shell` module without `executable: /bin/bash`;
- `[[ ]]`, an array, `NAME=(a b)`, and `&>` in a script that begins with `#!/bin/sh`.

Lines under a condition are not reported, nor scripts that something of the tree reads with `source`, or starts with
the name of another shell, that start themselves again in bash, or that are for BusyBox (OpenWrt, Alpine).

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
from bringup_lint.api.shell import Redirect
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import has_busybox
from bringup_lint.api.shell import sh_commands
from bringup_lint.api.shell import shell_blocks
from bringup_lint.api.shell import shell_commands

SHELL = regex(r"#!\s*\S*/(?:env\s+)?(sh|dash|bash|zsh)\b")
SETUP = regex(r"(?:^|/)(?:local_)?setup\.(bash|zsh)$")
OF_TASK = {
    "source": "Ansible's shell module runs /bin/sh, which is dash on Ubuntu and Debian and has no 'source': "
    "what follows has no such environment",
    "set": "Ansible's shell module runs /bin/sh, which is dash on Ubuntu and Debian and has no pipefail: the task "
    "fails",
}
OF_ARRAYS = (
    "/bin/sh is dash on Ubuntu and Debian and has no arrays: the script stops here with a syntax error",
    "begin the script with #!/bin/bash",
)
OF_CONDITIONS = (
    "/bin/sh is dash on Ubuntu and Debian and has no [[ ]]: the condition is never true",
    "begin the script with #!/bin/bash, or write [ ]",
)
OF_REDIRECTS = (
    "/bin/sh is dash on Ubuntu and Debian and reads '&>' as '&' and '>': the command runs in the background, and "
    "counts as successful",
    "write > FILE 2>&1",
)
ARRAY = regex(r"(?m)^[ \t]*(\w+)\+?=\(")
MOST = 20
RESTARTS = regex(r"\bexec[ \t]+(?:/usr)?(?:/bin/)?(?:env[ \t]+)?(?:bash|zsh)\b[^\n]{0,40}\$(?:0|\{0\}|BASH_SOURCE)")
"""The script goes on in another shell."""
OF_BUSYBOX = regex(r"^#!/bin/sh[ \t]+/etc/rc\.common|(?m:^[ \t]*(?:uci|opkg|apk)[ \t])")
"""The script is for OpenWrt or Alpine, whose shell is that of BusyBox."""
ALPINE = regex(r"(?:docker\.io/)?(?:library/)?(?:(?:arm64v8|amd64|arm32v7)/)?(?:alpine|busybox)(?:[:@]|$)|[^@]*-alpine")
PAGE = regex(r"\.(?:md|rst|py|json|mk)$|(?:^|/)(?:makefile|justfile)$", re.I)
"""Files that are no configuration, but may say how the script is started."""
MOST_OF_PAGE = 100_000
BOTH = regex(r"\b(?:ZSH_VERSION|ZSH_NAME|BASH_VERSION|BASH_SOURCE)\b")


@rule("error", symptoms=["source: not found", "[[: not found", "bad substitution", "ros2: command not found"])
def other_shell(robot: Robot) -> Iterator[Finding]:
    found: dict[Source, list[tuple[Located, str, str]]] = {}
    by_services = _run_by_services(robot)
    for source, run in robot.scripts.run("source", ".", "[["):
        wrong = _wrong(source, run) if run.certain and source not in by_services else None
        if wrong is not None:
            found.setdefault(source, []).append((run.words[0], *wrong))
    for source in robot.of_kind("shell-script"):
        if source not in found and source not in by_services:
            found[source] = [(word, *OF_REDIRECTS) for word in _redirected(source)]
        array = _array(source)
        if array is not None and source not in by_services:
            found.setdefault(source, []).insert(0, (array, *OF_ARRAYS))
    for source, ((first, message, advice), *others) in ((each, wrong) for each, wrong in found.items() if wrong):
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
    yield from _of_tasks(robot)


def _of_tasks(robot: Robot) -> Iterator[Finding]:
    """One finding for each file of tasks and word that dash refuses."""
    if not robot.of_kind("ansible"):
        return
    found: dict[tuple[Source, str], list[Located]] = {}
    for command in sh_commands(robot.files):
        word = command.words[0] if command.words else None
        if word == "source" or (word == "set" and "pipefail" in command.words[1:]):
            found.setdefault((word.span.source, str(word)), []).append(word)
    for (_, name), (first, *others) in found.items():
        yield finding(
            first,
            OF_TASK[name],
            advice="write executable: /bin/bash below the args of the task",
            related=[note(word, "here too") for word in others[:MOST]],
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


def _array(source: Source) -> Located | None:
    """The first array outside of functions and conditions in a script for sh, at which dash stops reading."""
    shebang = SHELL.match(source.text)
    if shebang is None or shebang[1] not in ("sh", "dash") or not source.judged or source.template:
        return None
    names = {name for block in shell_blocks(source) for name, _ in block.arrays}
    return next((source.located(*match.span()) for match in ARRAY.finditer(source.text) if match[1] in names), None)


def _redirected(source: Source) -> list[Located]:
    """The commands of a script for sh of which both streams are to go to a file."""
    shebang = SHELL.match(source.text)
    if shebang is None or shebang[1] not in ("sh", "dash") or not source.judged or source.template:
        return []
    commands = shell_commands(source) if "&>" in source.text else []
    found = (each for each in commands if each.words and each.ends != "&")
    return [each.words[0] for each in found if any(map(_takes_both, each.redirects))]


def _takes_both(redirect: Redirect) -> bool:
    return redirect.operator in ("&>", "&>>")


def _wrong(source: Source, run: Run) -> tuple[str, str] | None:
    shebang = SHELL.match(source.text)
    if shebang is None or len(run.words) < 2:
        return None
    own = run.shell or shebang[1]
    if run.name == "[[":
        return OF_CONDITIONS if own in ("sh", "dash") else None
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
    if BOTH.search(source.said) or RESTARTS.search(source.said) or OF_BUSYBOX.search(source.said):
        return True
    name = re.escape(source.basename)
    caller = re.compile(
        rf"(?:\b(?:source|bash|zsh)|(?:^|[\s;&(])\.)(?:\s+|['\"]\s*,\s*)(?:-\w+\s+)*['\"]?[^\s'\"]*{name}", re.M
    )
    others = (each for each in robot.sources if each is not source)
    if any(caller.search(each.text) for each in others) or has_busybox(robot.tree, source):
        return True
    if _is_in_busybox(robot, source):
        return True
    return any(map(caller.search, robot.tree.pages(PAGE, MOST_OF_PAGE)))


def _is_in_busybox(robot: Robot, source: Source) -> bool:
    """Whether an image without dash takes the script: the shell of Alpine understands these words."""
    files = (file for file in robot.dockerfiles if source.basename in file.source.text)
    return any(ALPINE.match(stage.origin) for file in files for stage in file.stages)
