"""A password, key or token is stored in clear text.

## What it finds
A value whose name (`..._PASSWORD`, `..._TOKEN`, `--api-key`) or form (keys of AWS, GitHub, GitLab, Slack or Stripe,
a private key, a password in a URL) shows that it is a secret. Checked are `Environment=` and command lines of
units, environment files, compose files, Dockerfiles, parameter files and launch files. In Python nodes and scripts,
literals of letters and digits with such a name are checked too. So are the passwords of hostapd, wpa_supplicant and
NetworkManager, those that a script gives to `sshpass`, `x11vnc`, `nmcli`, `openssl` or with `expect`, and those that a
Dockerfile gives to users where the image lets somebody log in.

Not reported: variables, paths of credential files, placeholders such as `<your-password>`, environment files that only
root and a group can read, answers to a question of a program such as `yes`, and the password of a key that the same
script writes anew without one. A weak or well-known value, a wireless password that is the robot's name, and one in a
comment, is a warning, and so is a password that the defaults of an Ansible role give to robots whose inventory has
none. It is info for a sample value, the name of the user as the password of another machine, a well-known password that
is called `INITIAL_` in a tree whose program asks for another at the first login, and a password of an Ansible inventory
that names no host but `localhost`, or has `ansible_connection=local`. Places of a file with the same value are one
finding.

## Why it matters on a robot
Every local user can read the settings of a unit with `systemctl show`, and can read arguments in the process list.
Anything in a repository or an image is in every copy of it, on every robot, forever. One lost robot exposes the
fleet.

## Bad
```ini
[Service]
Environment=MQTT_PASSWORD=...
```

## Good
```ini
[Service]
LoadCredential=mqtt-password:/etc/rover/mqtt-password
```

## When to ignore it
When the value protects nothing, such as a test account or a public API key. Say so in the reason.

## References
- systemd.exec(5), "LoadCredential=" and the warning at "Environment="
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
from bringup_lint.api.secrets import Secret

WIRELESS = regex(r"wi-?fi|wpa|hotspot|psk", re.I)
DEFAULTS = regex(r"(?:^|/)roles/[^/\n]{1,200}/defaults/")
PASSWORD = regex(r"pass(?:w(?:or)?d|phrase)|psk", re.I)
INITIAL = regex(r"(?:\w{1,40}_)?(?:INITIAL|FIRST)_", re.I)
ASKS = regex(
    r"password_change_required|(?:must|force|require)_(?:password_change|change_password)|change_password_on_first_login",
    re.I,
    "password",
)
PROGRAM = regex(r"\.(?:py|js|ts|go|rs)$")
MOST = 256 * 1024
"""Bytes of a program that is read."""
WORD = regex(r"[a-z]{4,}")
WHO = {
    "unit": "every local user can read it with systemctl show",
    "command": "every local user can read it in the process list and with systemctl show",
    "process": "every local user can read it in the process list",
    "env-file": "everybody with a copy of this file can read it",
    "compose": "everybody who has a copy of this file, or can inspect the container, can read it",
    "image": "it stays in the layers of the image, and everybody who can pull the image can read it",
    "file": "everybody with a copy of this file can read it",
    "params": "everybody with a copy of this file can read it, and every participant can ask the node for it",
    "launch": "everybody with a copy of this file can read it",
    "program": "everybody with a copy of this file can read it",
}
INSTEAD = {
    "unit": "use LoadCredential=, or an EnvironmentFile= with mode 0600",
    "command": "let the program read it from a file with LoadCredential=, or from an EnvironmentFile= with mode 0600",
    "process": "let the program read it from a file with mode 0600, and change the secret",
    "env-file": "keep the file out of the repository, with mode 0600 on the robot, and change the secret",
    "compose": "use secrets: or a file outside the repository, and change the secret",
    "image": "use a build secret or a run-time secret, and change this one",
    "file": "let the program read it from a file with mode 0600, and change the secret",
    "params": "let the node read it from a file with mode 0600, and change the secret",
    "launch": "let the node read it from a file with mode 0600, and change the secret",
    "program": "read it from the environment or from a file with mode 0600, and change the secret",
}


@rule(
    "error",
    tags=["CWE-798", "CWE-312"],
    symptoms=["SecretsUsedInArgOrEnv: Do not use ARG or ENV instructions for sensitive data"],
)
def plain_secret(robot: Robot) -> Iterator[Finding]:
    found: dict[tuple[Source, str], list[Secret]] = {}
    for secret in robot.secrets:
        key = str(secret.value.span.start) if secret.weak or secret.sample else str(secret.value)
        found.setdefault((secret.value.span.source, key), []).append(secret)
    for secrets in found.values():
        first, *others = sorted(secrets, key=lambda each: _is_commented(each.value))
        weak, default = first.weak or _is_of_product(first), _is_default_of_role(first)
        replaced = weak and INITIAL.match(first.name) is not None and robot.tree.says(PROGRAM, MOST, ASKS)
        source = first.value.span.source
        who = WHO[first.holder]
        if first.holder == "env-file" and source.mode is not None:
            who = f"every local user can read this file (mode {source.mode:04o})"
        lowered = weak or default or _is_commented(first.value)
        message, advice = f"{first.name} is a secret in clear text: {who}", _instead(first)
        if weak:
            message = f"{first.name} is a default that everybody knows or guesses, the same on every robot"
            advice = "make a password for each robot, at its first boot"
        elif default:
            message = f"{first.name} is in every copy of the role: it works on each robot whose inventory sets no other"
            advice = "give no default, and set one for each robot in a file that ansible-vault encrypts"
        yield finding(
            first.value,
            message,
            advice=advice,
            related=[note(each.value, "the same secret") for each in others],
            severity="info" if first.sample or replaced else "warning" if lowered else None,
            secrets=[each.value for each in (first, *others)],
        )


def _instead(secret: Secret) -> str:
    if secret.value.span.source.kind in ("ansible", "ansible-vars"):
        return "keep it in a file that ansible-vault encrypts, and change the secret"
    return INSTEAD[secret.holder]


def _is_commented(value: Located) -> bool:
    """Whether the line is a comment: the secret is given away, but not in use."""
    return value.span.source.line_text(value.span.line).lstrip().startswith(("#", "//", "<!--"))


def _is_default_of_role(secret: Secret) -> bool:
    """Whether a password is what an Ansible role takes where nobody sets it."""
    return DEFAULTS.search(secret.value.span.source.name) is not None and PASSWORD.search(secret.name) is not None


def _is_of_product(secret: Secret) -> bool:
    """Whether the password of a wireless network is nothing but the name of the robot, which is its user's as well."""
    words = set(WORD.findall(secret.value.lower()))
    if len(words) != 1 or not WIRELESS.search(secret.name):
        return False
    (name,) = words
    return f"/home/{name}/" in secret.value.span.source.text
