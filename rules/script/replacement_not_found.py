"""A script replaces a text that its file does not have.

## What it finds
`sed -i s/old/new/` of a script or a Dockerfile on a file of the tree that has no `old`: by the path of the robot to
which the tree brings the file, by its path in the repository, or by the path of the image to which `COPY` brings it.
Only what is little more than plain text is compared.

Also, in scripts, on `/etc/ssh/sshd_config` for a line that OpenSSH's package of Debian and Ubuntu has in another form:
`s/#PermitRootLogin yes/.../`, where the file says `#PermitRootLogin prohibit-password`.

Silent where the file has the new text already, as with a script that switches something on beside one that switches it
off, and where the script names the text a second time, writes the file itself, or works in folders that it fetches.

## Why it matters on a robot
sed changes nothing and ends with success. The file keeps the placeholder or the old value: all robots have the same
network name, or the entry script sources a folder that does not exist.

## Bad
```sh
# hostapd.conf has ssid=rover-NUMBER
sed -i "s/XXXX/$SERIAL/" /etc/hostapd/hostapd.conf
```

## Good
```sh
# hostapd.conf has ssid=rover-XXXX
sed -i "s/XXXX/$SERIAL/" /etc/hostapd/hostapd.conf
```

## When to ignore it
When the command is for files of earlier releases only.

## References
- sed(1)
- sshd_config of openssh-server in Debian 11 to 13 and Ubuntu 20.04 to 24.04
"""

from collections import Counter
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.secrets import assigned_secret
from bringup_lint.api.shell import lost_edits

OF_SSHD = {
    "PermitRootLogin": "prohibit-password",
    "PasswordAuthentication": "yes",
    "PubkeyAuthentication": "yes",
    "PermitEmptyPasswords": "no",
    "Port": "22",
    "MaxAuthTries": "6",
    "AllowTcpForwarding": "yes",
    "AllowAgentForwarding": "yes",
    "GatewayPorts": "no",
    "ClientAliveInterval": "0",
    "ClientAliveCountMax": "3",
    "TCPKeepAlive": "yes",
    "UseDNS": "no",
    "StrictModes": "yes",
}
"""Keyword -> the value in the line of the package, which is a comment."""
WORD = regex(r"[A-Za-z]+")
SSHD = "/etc/ssh/sshd_config"
COMMENTED = regex(
    r"s(?P<mark>[/|#,@])(?P<old>\^?\\?#[ \t]?(?P<key>[A-Za-z]+)[ \t]+(?P<value>[\w-]+))\$?(?P=mark)[^\n]*"
)


@rule("warning", silent="sed ends with success whether it replaces anything or not")
def replacement_not_found(robot: Robot) -> Iterator[Finding]:
    for edit in lost_edits(robot.files, robot.scripts, robot.dockerfiles):
        secret = assigned_secret(edit.old)
        said = f"has no {edit.old}" if secret is None else "does not have this text"
        yield finding(
            edit.old,
            f"{edit.file.basename} {said}: this command changes nothing",
            advice="write what the file has",
            secrets=[] if secret is None else [secret.value],
            related=[note(edit.file.whole, "the file that is changed")],
        )
    yield from _of_sshd(robot)


def _of_sshd(robot: Robot) -> Iterator[Finding]:
    """The edits of sshd's configuration for lines that the package does not have so."""
    for source, run in robot.scripts.run("sed"):
        if SSHD not in run.arguments or not any(word.startswith(("-i", "--in-place")) for word in run.words):
            continue
        for word in run.words[1:]:
            found = COMMENTED.fullmatch(word)
            stock = OF_SSHD.get(found["key"]) if found is not None else None
            if found is None or stock in (None, found["value"]) or _is_elsewhere(source, found["key"], str(word)):
                continue
            old = word.part(*found.span("old"))
            yield finding(
                old,
                f"sshd_config of Debian and Ubuntu has #{found['key']} {stock}: this command changes nothing",
                advice=f"write a file in /etc/ssh/sshd_config.d, or s/^#\\?{found['key']} .*/.../",
            )


def _is_elsewhere(source: Source, key: str, word: str) -> bool:
    """Whether the script has to do with the keyword in another command, too."""
    words = source.once(_is_elsewhere, lambda: Counter(WORD.findall(source.text)))
    return words[key] > WORD.findall(word).count(key)
