"""A password, key or token in clear text.

## What it finds
A value whose name (`..._PASSWORD`, `..._TOKEN`, `--api-key`) or form (keys of AWS, GitHub, GitLab, Slack,
Stripe, a private key, a password in a URL) shows a secret, in `Environment=` and command lines of units, in
environment files, compose files, Dockerfiles, parameter files and launch files. In the sources of Python nodes and in
scripts also, where such a name is set to a literal of letters and digits. Variables, paths of credential files,
stand-ins such as `<your-password>` and sample files are left out, and so are environment files that only root and a
group can read.

## Why it matters on a robot
What a unit sets can be read by every local user with `systemctl show`, and by everybody who sees the
process list when it is an argument. What is in a repository or an image is in every copy of it, on every
robot, for ever. One robot that is lost gives away the fleet.

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

## References
- systemd.exec(5), "LoadCredential=" and the warning at "Environment="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

WHO = {
    "unit": "every local user can read it with systemctl show",
    "command": "every local user can read it in the process list and with systemctl show",
    "env-file": "everybody who has a copy of this file has it",
    "compose": "everybody who has a copy of this file, or may inspect the container, has it",
    "image": "it stays in the layers of the image, for everybody who can pull it",
    "params": "everybody who has a copy of this file has it, and every participant can ask the node for it",
    "launch": "everybody who has a copy of this file has it",
    "program": "everybody who has a copy of this file has it",
}
INSTEAD = {
    "unit": "use LoadCredential=, or an EnvironmentFile= with mode 0600",
    "command": "let the program read it from a file: LoadCredential=, or an EnvironmentFile= with mode 0600",
    "env-file": "keep the file out of the repository, with mode 0600 on the robot, and change the secret",
    "compose": "use secrets: or a file outside the repository, and change the secret",
    "image": "use a build secret or a secret at run time, and change this one",
    "params": "let the node read it from a file with mode 0600, and change the secret",
    "launch": "let the node read it from a file with mode 0600, and change the secret",
    "program": "read it from the environment or from a file with mode 0600, and change the secret",
}


@rule("error", tags=["CWE-798", "CWE-312"])
def plain_secret(robot: Robot) -> Iterator[Finding]:
    for secret in robot.secrets:
        source = secret.value.span.source
        who = WHO[secret.holder]
        if secret.holder == "env-file" and source.mode is not None:
            who = f"every local user can read this file (mode {source.mode:04o})"
        yield finding(
            secret.value,
            f"{secret.name} is a secret in clear text: {who}",
            advice=INSTEAD[secret.holder],
            severity="info" if secret.sample else "warning" if secret.weak else None,
            secrets=[secret.value],
        )
