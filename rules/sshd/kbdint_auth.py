"""Keyboard-interactive login is still on: sshd still accepts passwords.

## What it finds
`PasswordAuthentication no` without `KbdInteractiveAuthentication no`, when `UsePAM yes` is set. It is a
warning when nothing sets UsePAM. Configurations with AuthenticationMethods are not checked.

## Why it matters on a robot
KbdInteractiveAuthentication is on by default, and with PAM it asks for the password. The file says that
passwords are off, but they are not.

## Bad
```
PasswordAuthentication no
UsePAM yes
```

## Good
```
PasswordAuthentication no
KbdInteractiveAuthentication no
UsePAM yes
```

## When to ignore it
When PAM asks for a one-time code instead of the password.

## References
- sshd_config(5), "KbdInteractiveAuthentication", "UsePAM"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.sshd import Option


@rule("error", fix="unsafe", tags=["CWE-287"], symptoms=["Accepted keyboard-interactive/pam for"])
def kbdint_auth(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        password = sshd.get("PasswordAuthentication")
        if password is None or password.value.lower() != "no" or not sshd.files or not password.span.source.judged:
            continue
        if sshd.says("KbdInteractiveAuthentication", "yes") != "yes" or sshd.get("AuthenticationMethods"):
            continue
        pam = sshd.get("UsePAM")
        if pam is not None and pam.value.lower() != "yes":
            continue
        option = sshd.get("KbdInteractiveAuthentication")
        yield finding(
            option.value if option else password.keyword,
            "KbdInteractiveAuthentication is on"
            + ("" if option else " by default")
            + (": sshd still accepts passwords" if pam else ": with UsePAM yes, sshd still accepts passwords"),
            advice="add KbdInteractiveAuthentication no",
            related=[note(pam.keyword, "PAM asks for the password")] if pam else (),
            fix=_fix(option, password),
            severity=None if pam else "warning",
        )


def _fix(option: Option | None, password: Option) -> Fix:
    if option is not None:
        return fix("set KbdInteractiveAuthentication no", (option.value, "no"))
    end = password.span.source.span(password.span.end, password.span.end)
    return fix("set KbdInteractiveAuthentication no", (end, "\nKbdInteractiveAuthentication no"))
