"""A user may run everything as root without a password, or everybody something.

## What it finds
In a sudoers file, or in what a script writes to one:

- A line `USER ALL=(ALL) NOPASSWD: ALL`, with other commands beside `ALL` or without. It is info where a comment on
  the line or right above it says that root or sudo is intended, or one at the head of the script says that sudo
  without a password is.
- A line `ALL ALL=(ALL) NOPASSWD: COMMAND, ...`: every user and service of the robot may run the commands as root.
  It is info where they only shut the computer down.
- A line `USER ALL=(root) NOPASSWD: COMMAND` without arguments, or with `*` alone, where the command runs any program or
  writes any file for whoever calls it: a shell, an interpreter, `mount`, `tee`, `cp`, `systemctl`, `docker`, `apt`.
- A line `USER ALL=(root) NOPASSWD: COMMAND` whose command is a file in the home of the user, or in the checkout that
  the script which writes the line lies in. `Cmnd_Alias` is read. Silent where the variable with the checkout is set
  twice, or the script gives files to root with chown.

Not reported: what an Ansible role writes that plays run only where a variable asks for it that is false by default.

## Why it matters on a robot
Whatever runs as this user is root: a node with a hole, a web interface, a USB stick that types. File permissions,
`User=` of the units and the sandbox of systemd then protect nothing.

## Bad
```sh
echo 'rover ALL=(ALL) NOPASSWD:ALL' | sudo tee /etc/sudoers.d/rover
```

## Good
```sh
echo 'rover ALL=(root) NOPASSWD: /usr/bin/systemctl restart rover.service' | sudo tee /etc/sudoers.d/rover
```

## When to ignore it
When the user exists on development machines only.

## References
- sudoers(5), "NOPASSWD and PASSWD"
- CWE-250: Execution with Unnecessary Privileges
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

AS_ROOT = regex(
    r"^[ \t]*(?P<who>[%+\w.{}-]+(?: +[%+\w.{}-]+)*?)[ \t]+\S+[ \t]*=[ \t]*(?:\((?:ALL|root)[^)\n]*\)[ \t]*)?"
    r"(?P<what>NOPASSWD:[ \t]*(?P<commands>[^ \t\n][^\n]*))$",
    re.M,
)
ENDS = ("shutdown", "reboot", "poweroff", "halt")
KEPT = regex(
    r"""^[ \t]*(?P<name>\w+)=["'](?P<who>[%\w.{}$-]+)[ \t]+ALL=\([^)\n]{1,20}\)[ \t]*"""
    r"""(?P<what>NOPASSWD:[ \t]*(?P<all>ALL))["']""",
    re.M,
)
"""A line that a script keeps in a variable before it writes it."""
BECOME_ROOT = frozenset(
    "bash sh dash zsh python python3 perl ruby lua node vi vim nvim nano emacs less more man awk gawk mawk find env "
    "nice timeout xargs tee dd cp mv chmod chown install ln rsync tar mount docker podman pip pip3 apt apt-get dpkg "
    "snap systemd-run systemctl make gdb strace nsenter unshare chroot su sudo passwd usermod visudo crontab insmod "
    "modprobe ip tcpdump wget curl sed ansible-playbook ros2".split()
)
"""Programs that run any program or write any file, if their arguments are free (gtfobins.github.io)."""
ROLE = regex(r"(?:^|/)roles/(?P<name>[\w.-]+)/tasks/")
WHEN = regex(r"\bwhen:[ \t]*(?P<variable>\w+)[ \t]*$")
FALSE = regex(r"^(?P<variable>\w+):[ \t]*(?:false|no)\b", re.M | re.I)
ALIAS = regex(r"^[ \t]*Cmnd_Alias[ \t]+(?P<name>[A-Z]\w*)[ \t]*=(?P<commands>(?:[^\\\n]|\\\s){0,9000})", re.M)
IN_HOME = regex(r"/home/(?P<user>[^/]+)/.+")
IN_FOLDER = regex(r"\{\{ (?P<variable>\w+) \}\}(?P<path>/.+)")
ASSIGNED = r"^[ \t]*(?:(?:readonly|export|local|declare)[ \t]+(?:-r[ \t]+)?)?%s=(?P<value>[^\n]*)"
OWN_FOLDER = regex(
    r"[\"']?(?:\$\(|`)[^\n]{0,60}?\b(?:dirname[^\n]{1,60}(?:\$0|\bBASH_SOURCE\b)|rev-parse[ \t]+--show-toplevel)"
)
BELOW = regex(
    r"[\"']?(?:\$\([ \t]*cd[ \t]+[\"']?)?\$\{?(?P<variable>\w+)\}?(?:/[\w./-]*)?[\"']?(?:[ \t]*&&[ \t]*pwd\))?"
    r"[\"']?[ \t]*$"
)
HERE = regex(r"[\"']?(?:\$\(pwd\)|\$PWD|\$\{PWD\})")
GOES = regex(r"^[ \t]*(?:cd|pushd)\b", re.M)
PROTECTS = regex(r"\bchown\b[^\n]{0,60}\broot\b")
INTENDED = r"\b(?:intentional(?:ly)?|deliberate(?:ly)?|on purpose)\b"
OF_SUDO = r"(?:\bsudo|\bNOPASSWD\b|\b(?:as|becomes?) root\b|\broot rights\b)"
MEANT = regex(
    rf"{INTENDED}[^.;]{{0,200}}?{OF_SUDO}|{OF_SUDO}[^.;]{{0,200}}?{INTENDED}",
    re.I,
    hints="intentional deliberate purpose",
)
"""One sentence says that the right is intended, and that it is about root."""
OF_RIGHT = r"(?:\bNOPASSWD\b|\bpassword-?less(?:ly)? sudo\b|\bsudo (?:rights )?without (?:a |any )?password\b)"
MEANT_FAR = regex(
    rf"{INTENDED}[^.;]{{0,200}}?{OF_RIGHT}|{OF_RIGHT}[^.;]{{0,200}}?{INTENDED}",
    re.I,
    hints="intentional deliberate purpose",
)
"""The same far from the line: there, sudo and root may be those of the whole script."""
HEAD = 20
LONGEST_HEAD = 2_000
"""The lines and characters at the top of a file in which comments speak of the whole."""
DEEPEST = 3
"""Variables that are made of others."""
MOST = 200
"""Commands of one line that are looked at."""
TAGGED = regex(r"\s*(?P<tags>(?:[A-Z_]+:\s*)*)(?P<command>.*)")


@rule("warning", silent="sudo logs the commands as allowed", tags=["CWE-250", "CWE-269"])
def sudo_nopasswd_all(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("sudoers"):
        if not source.judged or _is_left_out(robot, source):
            continue
        aliases = {match["name"]: source.located(*match.span("commands")) for match in ALIAS.finditer(source.text)}
        for match in AS_ROOT.finditer(source.text):
            what = source.located(*match.span("what")).strip_located()
            commands = source.located(*match.span("commands")).strip_located()
            found = list(_judged(match["who"], what, commands, aliases))
            yield from found or _of_own(robot, match["who"], commands, aliases)
    for source, did in robot.scripts.written("sudoers.d"):
        kept = KEPT.search(source.text) if "/etc/sudoers" in did.path or "SUDOERS" in did.path else None
        if kept is not None and kept["name"] in (str(did.text) if did.text is not None else ""):
            yield from _judged(kept["who"], source.located(*kept.span("what")), source.located(*kept.span("all")), {})


def _is_left_out(robot: Robot, source: Source) -> bool:
    """Whether an Ansible role writes the file, and each play runs the role only where a variable says so that is false
    by default: in images for developers."""
    role = ROLE.search(source.origin.whole.path) if source.origin is not None else None
    if role is None:
        return False
    texts = [each.text for each in robot.of_kind("ansible", "ansible-vars")]
    called = re.compile(rf"\brole:[ \t]*{re.escape(role['name'])}\b(?P<rest>[^\n}}]{{0,200}})")
    conditions = [WHEN.search(match["rest"]) for text in texts for match in called.finditer(text)]
    names = {match["variable"] for match in conditions if match is not None}
    false = [match["variable"] for text in texts for match in FALSE.finditer(text)]
    return None not in conditions and bool(names) and names <= set(false)


def _judged(who: str, what: Located, text: Located, aliases: dict[str, Located]) -> Iterator[Finding]:
    commands = _without_password(text, aliases)
    if "ALL" in commands and not any(command.startswith("!") for command in commands):
        yield finding(
            what,
            f"Every program that runs as {_user(who)} can become root without a password",
            advice="name the commands that are needed, with their full paths and arguments",
            severity="info" if _is_meant(what) else None,
        )
        return
    programs = list(dict.fromkeys(command.split()[0] for command in commands if command.startswith("/")))
    if who == "ALL" and programs:
        yield finding(
            text,
            f"Every user and service can run {' and '.join(programs)} as root without a password",
            advice="name the user that needs it in place of the first ALL",
            severity="info" if all(program.rpartition("/")[2] in ENDS for program in programs) else None,
        )
        return
    free = [command.split()[0] for command in commands if _is_free(command)]
    if free:
        yield finding(
            text,
            f"With the free arguments of {' or '.join(dict.fromkeys(free))}, {_user(who)} becomes root without a "
            "password",
            advice="name the arguments that are needed",
        )


def _is_meant(what: Located) -> bool:
    """Whether a comment on the line, right above it or at the head says that the right is given on purpose, in the
    file or in the script that writes it."""
    source, span = what.span.source, what.span
    comments = source.comments_at(span.line)
    if source.origin is not None:
        written = source.origin.whole
        source = written.source
        comments += source.comments_at(written.line)
    lines = source.text[:LONGEST_HEAD].splitlines()[:HEAD]
    head = " ".join(line if line.startswith("#") and line.strip("# ") else "." for line in lines)
    return MEANT.search(" ".join(comments)) is not None or MEANT_FAR.search(head) is not None


def _of_own(robot: Robot, who: str, text: Located, aliases: dict[str, Located]) -> Iterator[Finding]:
    """The commands that the user may write to."""
    commands = _without_password(text, aliases)
    own = [command for command in commands if _is_in_home(command, who) or _is_in_checkout(robot, command, text)]
    if own:
        name = own[0].rstrip("/ ").rpartition("/")[2].split()[0]
        alias = next((each for each in aliases.values() if own[0] in each), None)
        at = alias.index(own[0]) if alias is not None else 0
        yield finding(
            alias.part(at, at + len(own[0])) if alias is not None else text,
            f"{_user(who).capitalize() if '{' in who else who} can replace {name}, which sudo runs as root without a "
            "password",
            advice="install the program in /usr/local/sbin, owned by root, and name that path",
            related=[note(text, "who may run it")] if alias is not None else [],
            confidence="medium",
        )


def _is_in_home(command: str, who: str) -> bool:
    home = IN_HOME.match(command)
    return home is not None and home["user"] == who


def _is_in_checkout(robot: Robot, command: str, text: Located) -> bool:
    """Whether it is a file of the tree, at its place below the script that writes the line."""
    inside = IN_FOLDER.match(command)
    origin = text.span.source.origin
    if inside is None or origin is None:
        return False
    path = inside["path"].split()[0].lstrip("/")
    script, variable = origin.whole.source, inside["variable"]
    own = script.once((_is_own, variable), lambda: _is_own(variable, script.said, DEEPEST))
    return (
        own
        and not script.says(PROTECTS)
        and any(f"/{each}".endswith(f"/{path}") for each in robot.tree.named(path.rpartition("/")[2]))
    )


def _is_own(variable: str, script: str, depth: int) -> bool:
    """Whether a variable of a script, which is set only once, is for certain a folder of its checkout."""
    values = [match["value"] for match in re.finditer(ASSIGNED % re.escape(variable), script, re.M)]
    if len(values) != 1 or not depth:
        return False
    if HERE.match(values[0]):
        return GOES.search(script) is None
    base = BELOW.match(values[0])
    return OWN_FOLDER.match(values[0]) is not None or (
        base is not None and _is_own(base["variable"], script, depth - 1)
    )


def _is_free(command: str) -> bool:
    """Whether a command gives a shell or any file to whoever chooses its arguments."""
    program, _, arguments = command.partition(" ")
    return program.startswith("/") and program.rpartition("/")[2] in BECOME_ROOT and arguments.strip() in ("", "*")


def _without_password(text: str, aliases: dict[str, Located]) -> list[str]:
    """The first commands of a list that starts with NOPASSWD:, those of an alias in its place. A tag holds until its
    opposite."""
    found: dict[str, None] = {}
    free = True
    for tagged in filter(None, map(TAGGED.match, text.split(",", MOST)[:MOST])):
        tags = tagged["tags"].replace(":", " ").split()
        free = "NOPASSWD" in tags or (free and "PASSWD" not in tags)
        if free:
            command = tagged["command"].strip()
            listed = str(aliases.get(command, command)).split(",", MOST)[:MOST] if command not in found else ()
            found[command] = None
            found.update((each.strip("\\ \t\n"), None) for each in listed)
        if len(found) > MOST:
            break
    return [each for each in found if each not in aliases]


def _user(who: str) -> str:
    if who == "ALL":
        return "any user"
    if who.startswith("%"):
        return f"a member of {who[1:]}"
    return "a user" if "{" in who else who
