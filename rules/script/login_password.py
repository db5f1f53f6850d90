"""A script, an image or cloud-init's user data sets a password that it holds itself.

## What it finds
A password as a literal that goes to `chpasswd` or `passwd`, or after `useradd -p` and `usermod -p`. A value from a
variable that the script does not set, and a command that asks for it, are fine.

In the entry point of a container without sshd, xrdp or VNC, nobody can log in with it: it is an info.
`passwd -d root` in an image that gives up root afterwards is a warning: `su` asks for nothing. It is an info where its
user has sudo anyway.

In user data: `plain_text_passwd:` of a user, and `password:` or `chpasswd:` with `expire: false`. A hash is a warning,
because it can be tried out on a computer; a password that expires at the first login and a random one are fine.

## Why it matters on a robot
Everybody who can read the repository can log in on every robot that was set up with it: over SSH, or at a screen. For
root, or for a user who may use sudo, that is the whole robot and its motors.

## Bad
```sh
echo 'rover:rover123' | sudo chpasswd
```

## Good
```sh
sudo passwd --lock rover
install -D -m 600 -o rover operator.pub /home/rover/.ssh/authorized_keys
```

## When to ignore it
When the password expires at the first login (`chage -d 0`), or when the image is never connected to a network.

## References
- chpasswd(8)
- cloud-init documentation, modules "Set Passwords" and "Users and Groups"
- CWE-798: Use of Hard-coded Credentials
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of
from bringup_lint.api.docker import last_user
from bringup_lint.api.docker import user_name
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import unwrapped
from bringup_lint.api.templates import is_stand_in

PROGRAMS = ("chpasswd", "passwd", "useradd", "usermod")
PAIR = regex(r"^(?P<user>[a-z_][\w-]*):(?P<password>[^\s:{}$]+)$", re.M)
TWICE = regex(r"(?P<password>[^\s{}$]+)\n(?P=password)\n?")
HASH = regex(r"\$\w+\$")
SERVER = regex(r"\b(?:sshd|openssh-server|xrdp|\w{0,20}vnc\w{0,20})\b")
SUDO = regex(r"NOPASSWD|(?:^|&&|;|\bthen\b)[ \t\\\n]{0,40}sudo[ \t]|(?:-a?G|--groups)[= ][\w,]{0,60}\bsudo\b", re.M)
"""What shows that the user of an image becomes root with sudo as well."""
EXPIRES = regex(r"\bchage\s+(?:-d\s*0|--lastday[= ]0)|passwd\s+(?:-e|--expire)\b")


@rule("error", silent="the password works for everybody who knows it", tags=["CWE-798", "CWE-259"])
def login_password(robot: Robot) -> Iterator[Finding]:
    in_containers = set(_of_containers(robot))
    for source, run in robot.scripts.run(*PROGRAMS):
        if EXPIRES.search(source.said):
            continue
        for user, password in _set(run):
            yield finding(
                password,
                f"The password of {user} is in this script: everybody with a copy of it can log in on the robot",
                advice="lock the password and log in with keys, or make a password for each robot at its first boot",
                secrets=[password],
                severity="info" if source in in_containers else None,
                confidence=None if run.certain else "medium",
            )
    for file in robot.dockerfiles:
        for stage in file.stages:
            yield from _opened(stage)
    for login in robot.user_data_logins:
        if not is_stand_in(login.password):
            yield _of_user_data(login.user or "the default user", login.password)


def _opened(stage: Stage) -> Iterator[Finding]:
    """An account of root without a password, in an image whose processes are not root."""
    user = last_user(stage)
    if user is None or user_name(user) in (None, "root"):
        return
    for command in commands_of(stage):
        words = unwrapped(command.words)
        if [str(word) for word in words] in (["passwd", "-d", "root"], ["passwd", "--delete", "root"]):
            yield finding(
                words[0],
                f"root has no password in this image: every program of {user} becomes root with su",
                advice="remove this step, or lock the account with passwd --lock",
                related=[note(user, "the user of the container")],
                severity="info"
                if SUDO.search("\n".join(str(each.value) for each in stage.instructions))
                else "warning",
            )


def _of_user_data(user: str, password: Located) -> Finding:
    hashed = HASH.match(password) is not None
    return finding(
        password,
        f"The password of {user} is in this user data{' as a hash' if hashed else ''}: every robot that is set up with "
        "it has the same one",
        advice="log in with ssh_authorized_keys:, or let the password expire at the first login",
        severity="warning" if hashed else None,
        secrets=[password],
    )


def _of_containers(robot: Robot) -> Iterator[Source]:
    """The scripts that containers start, where no image and none of the scripts lets somebody log in from outside."""
    if any(SERVER.search(each.text) for each in robot.files.of_kind("dockerfile", "compose")):
        return
    started = {
        runner.reads(str(line.program)) for runner in robot.runners.all if runner.in_container for line in runner.main
    }
    for source in robot.files.of_kind("shell-script"):
        if (source in started or "entrypoint" in source.basename) and not SERVER.search(source.text):
            yield source


def _set(run: Run) -> Iterator[tuple[str, Located]]:
    """The users whose passwords a command sets, with the passwords."""
    source = run.command.words[0].span.source
    text = str(run.given or "")
    place = run.given_at
    if run.name == "chpasswd":
        for pair in PAIR.finditer(text):
            yield pair["user"], _located(source, place(*pair.span("password")))
    elif run.name == "passwd":
        twice = TWICE.fullmatch(text)
        if twice:
            users = [word for word in run.arguments if not word.startswith("-")]
            yield (users[-1] if users else "the user"), _located(source, place(*twice.span("password")))
    else:
        for option, value in zip(run.words[1:], run.words[2:]):
            if option in ("-p", "--password") and re.fullmatch(r"[^\s${}()`*!]+", value):
                yield str(run.words[-1]), value


def _located(source: Source, span: Span) -> Located:
    return source.located(span.start, span.end)
