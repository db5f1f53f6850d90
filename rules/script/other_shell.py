"""A script reads what only another shell understands.

## What it finds
- `source` in a script that begins with `#!/bin/sh`, and `.` with a `setup.bash` there;
- `source` or `.` with a `setup.zsh` in a script for bash or sh;
- `source`, `set -o pipefail`, and `echo -e` to a file or pipe, in a task of Ansible's `shell` module without
  `executable: /bin/bash`;
- `[[ ]]`, an array, `NAME=(a b)`, and `&>` in a script that begins with `#!/bin/sh`;
- there too: `trap` and `kill` with a signal that is written with `SIG`, `trap ... ERR`, `set -o pipefail`, `echo -e`
  to a file or pipe, `[ a == b ]`, `read` with `-a`, `-n`, `-s` or `-t`, the commands `pushd`, `popd`, `let`,
  `declare`, `typeset`, `shopt`, `mapfile`, `readarray` and `disown`, and expansions such as `${NAME[0]}`,
  `${NAME:0:3}` and `${NAME//a/b}`;
- `sh -c "echo -e ..."` to a file or pipe, in any script.

In a script that only sets up the shell of whoever sources it (`source`, `export`, `alias`), it is info: that shell
may be the other one. Lines under a condition are not reported, but for the last, nor scripts that something of the
tree reads with `source`, or starts with the name of another shell, that start themselves again in bash, or that are
for BusyBox (OpenWrt, Alpine).

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
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import Redirect
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import Word
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
    "echo": "Ansible's shell module runs /bin/sh, which is dash on Ubuntu and Debian and has no -e for echo: it is "
    "written too",
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
HAS_NO = frozenset("pushd popd let declare typeset shopt mapfile readarray disown".split())
GOES_ON = "and the script goes on"
FAILS = f"this command fails, {GOES_ON}"
SIGNAL = regex(r"(?:-s)?-?SIG[A-Z]{2,6}")
JOB = regex(r"(?:^|\bkill\b[^;&|\n]{0,80}\s)%\d")
"""A job by its number, which dash only knows of an interactive shell."""
PSEUDO = ("ERR", "DEBUG", "RETURN")
READS = regex(r"-[pr]*[ansdtNu]\w*")
EXPANSION = regex(r"\$\{(?:![A-Za-z_]|\w+(?:\[[\w@*]|:[0-9]|:[ ]-|/|\^|,))")
SETS_UP = frozenset(("source", ".", "export", "alias", "unset", "ulimit", "umask"))
COMMANDS = ("source", ".", "[[", "[", "test", "trap", "kill", "set", "echo", "read", *HAS_NO)
OF_EXPANSIONS = (
    "/bin/sh is dash on Ubuntu and Debian and cannot read this expansion: the script stops here, 'Bad substitution'",
    "begin the script with #!/bin/bash",
)
ARRAY = regex(r"(?m)^[ \t]*(\w+)\+?=\(")
MOST = 20
RESTARTS = regex(r"\bexec[ \t]+(?:/usr)?(?:/bin/)?(?:env[ \t]+)?(?:bash|zsh)\b[^\n]{0,40}\$(?:0|\{0\}|BASH_SOURCE)")
"""The script goes on in another shell."""
OF_BUSYBOX = regex(r"^#!/bin/sh[ \t]+/etc/rc\.common|(?m:^[ \t]*(?:uci|opkg|apk)[ \t])")
"""The script is for OpenWrt or Alpine, whose shell is that of BusyBox."""
ALPINE = regex(
    r"(?:docker\.io/)?(?:library/)?(?:(?:arm64v8|amd64|arm32v7)/)?(?:alpine|busybox)(?:[:@]|$)|[^@]*[-:]alpine"
)
PAGE = regex(r"\.(?:md|rst|py|json|mk)$|(?:^|/)(?:makefile|justfile)$", re.I)
"""Files that are no configuration, but may say how the script is started."""
MOST_OF_PAGE = 100_000
BOTH = regex(r"\b(?:ZSH_VERSION|ZSH_NAME|BASH_VERSION|BASH_SOURCE)\b")


@rule("error", symptoms=["source: not found", "[[: not found", "bad substitution", "ros2: command not found"])
def other_shell(robot: Robot) -> Iterator[Finding]:
    found: dict[Source, list[tuple[Located, str, str]]] = {}
    by_services = _run_by_services(robot)
    named: dict[Source, list[tuple[Located, str, str]]] = {}
    for source, run in robot.scripts.run(*COMMANDS):
        is_named = run.shell in ("sh", "dash") and run.name == "echo"
        wrong = _wrong(source, run) if (run.certain or is_named) and source not in by_services else None
        if wrong is not None:
            (named if is_named else found).setdefault(source, []).append(wrong)
    for source in (each for each in robot.of_kind("shell-script") if each not in by_services):
        if source not in found:
            found[source] = [(word, *OF_REDIRECTS) for word in _redirected(source)]
        expanded = next(_expanded(robot, source), None)
        if expanded is not None:
            found[source].append(expanded)
        array = _array(source)
        if array is not None:
            found[source].insert(0, (array, *OF_ARRAYS))
    for source, ((first, message, advice), *others) in named.items():
        if not robot.mentions(SH_IS_BASH) and not OF_BUSYBOX.search(source.said):
            yield finding(
                first,
                message,
                advice=advice,
                related=[note(word, "here too") for word, _, _ in others],
                severity="warning",
            )
    for source, wrongs in found.items():
        if not wrongs:
            continue
        (first, message, advice), *others = sorted(wrongs, key=lambda each: each[1].endswith(GOES_ON))
        replaced = SHELL.match(source.said)
        if replaced is not None and replaced[1] == "sh" and robot.mentions(SH_IS_BASH):
            continue
        if not _is_read_otherwise(robot, source):
            yield finding(
                first,
                message,
                advice=advice,
                related=[note(word, "here too") for word, _, _ in others],
                severity="info" if _only_sets_up(robot, source) else "warning" if message.endswith(GOES_ON) else None,
            )
    yield from _of_tasks(robot)


def _only_sets_up(robot: Robot, source: Source) -> bool:
    """Whether a script does nothing but set up the shell of whoever sources it, which may be another one."""
    runs = [did for did in robot.scripts.done(source) if isinstance(did, Run)]
    return all(run.name in SETS_UP for run in runs)


def _of_tasks(robot: Robot) -> Iterator[Finding]:
    """One finding for each file of tasks and word that dash refuses."""
    if not robot.of_kind("ansible"):
        return
    found: dict[tuple[Source, str], list[Located]] = {}
    for command in sh_commands(robot.files):
        word = command.words[0] if command.words else None
        if word is None:
            continue
        if word == "source" or (word == "set" and "pipefail" in command.words[1:]) or _writes_option(command):
            found.setdefault((word.span.source, str(word)), []).append(word)
    for (_, name), (first, *others) in found.items():
        yield finding(
            first,
            OF_TASK[name],
            advice="write executable: /bin/bash below the args of the task",
            related=[note(word, "here too") for word in others[:MOST]],
            severity="warning" if name == "echo" else None,
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


def _wrong(source: Source, run: Run) -> tuple[Located, str, str] | None:
    """The word that the shell of a command does not take as it is meant, what follows, and what to write."""
    shebang = SHELL.match(source.text)
    if shebang is None or len(run.words) < 2:
        return None
    own = run.shell or shebang[1]
    if own in ("sh", "dash"):
        if run.name == "[[":
            return run.words[0], *OF_CONDITIONS
        if run.name == "source":
            return (
                run.words[0],
                "/bin/sh is dash on Ubuntu and Debian and has no 'source': what follows has no such environment",
                "begin the script with #!/bin/bash",
            )
        refused = _refused(run) if run.words == run.command.words else None
        if refused is not None:
            word, message, advice = refused
            return word, f"/bin/sh is dash on Ubuntu and Debian and {message}", advice
    named = SETUP.search(run.text(run.words[1])) if run.name in ("source", ".") else None
    other = named[1] if named is not None else ""
    if other and own != other and (own, other) != ("zsh", "bash"):
        message = f"{own} cannot read a setup.{other}: the environment of ROS is not set"
        return run.words[0], message, f"source the setup.{own}"
    return None


def _refused(run: Run) -> tuple[Located, str, str] | None:
    """The word of a command that dash has not, or takes otherwise."""
    begin = "begin the script with #!/bin/bash"
    name, first, words = run.name, run.words[0], run.words[1:]
    if name in HAS_NO:
        return first, f"has no '{name}': {FAILS}", begin
    if name in ("[", "test"):
        equals = next((word for word in words if word == "=="), None)
        return (equals, f"has no == in [ ]: the condition is false, {GOES_ON}", "write =") if equals else None
    if name in ("trap", "kill"):
        signal = next((word for word in words if SIGNAL.fullmatch(word)), None)
        if signal is not None:
            kills_jobs = any(map(JOB.search, words))
            advice = f"{begin}: in a script, dash cannot kill a job by %1 either" if kills_jobs else ""
            return signal, f"knows no {signal.lstrip('-')}: {FAILS}", advice or f"write {signal.replace('SIG', '')}"
    if name == "trap":
        pseudo = next((word for word in words[1:] if word in PSEUDO), None)
        return (pseudo, f"knows no {pseudo} for trap: {FAILS}", begin) if pseudo is not None else None
    if name == "set":
        option = next((word for word in words if word == "pipefail"), None)
        return (option, "has no pipefail: the script stops here", begin) if option is not None else None
    if name == "echo":
        is_kept = _writes_option(run.command)
        return (words[0], f"has no -e for echo: it is written too, {GOES_ON}", "write printf") if is_kept else None
    option = next((word for word in words if READS.fullmatch(word)), None) if name == "read" else None
    return (option, f"has no {option} for read: {FAILS}", begin) if option is not None else None


def _writes_option(command: Command) -> bool:
    """Whether the ``-e`` of an echo comes into a file or another program."""
    goes_on = command.ends == "|" or any(each.writes for each in command.redirects)
    return command.words[:2] == ("echo", "-e") and goes_on


def _expanded(robot: Robot, source: Source) -> Iterator[tuple[Located, str, str]]:
    """The expansions in a script for sh, outside of conditions and single quotes, at which dash stops."""
    shebang = SHELL.match(source.text)
    if shebang is None or shebang[1] not in ("sh", "dash") or not source.judged or not source.matches(EXPANSION):
        return
    for did in robot.scripts.done(source):
        if not isinstance(did, Run) or not did.certain or did.shell not in ("", "sh", "dash"):
            continue
        for word in (*did.command.assignments, *did.command.words):
            stretches = word.stretches() if isinstance(word, Word) and EXPANSION.search(word) else ()
            for stretch, quote in stretches:
                match = EXPANSION.search(stretch) if quote != "'" else None
                if match is not None:
                    yield stretch.part(*match.span()), OF_EXPANSIONS[0], OF_EXPANSIONS[1]


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
