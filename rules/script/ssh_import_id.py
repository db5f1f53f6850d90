"""User data imports SSH keys that are not those of the robot's people.

## What it finds
Entries of `ssh_import_id:` in the user data of cloud-init that are no `gh:NAME` or `lp:NAME`:

- `- gh: name` with a blank, which YAML reads as a mapping;
- the name of an account of the robot (`ubuntu`, `pi`, `root`, or one of `users:`), which means Launchpad.

## Why it matters on a robot
From a mapping, ssh-import-id gets a text such as `{'gh': 'name'}`, which is no account: the keys are not on the robot,
and only the password opens it. A name without a prefix means the account of that name on Launchpad, whoever that is:
its keys may log in on every robot that is set up with the file.

## Bad
```yaml
ssh_import_id:
  - ubuntu
  - gh: rover-team
```

## Good
```yaml
ssh_import_id:
  - gh:rover-team
```

## When to ignore it
When the account of that name on Launchpad is yours.

## References
- cloud-init documentation, module "SSH Import ID"
- ssh-import-id(1)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

ACCOUNTS = ("ubuntu", "pi", "root", "debian", "robot", "ros", "user", "admin")
PREFIXES = ("gh", "lp")


@rule("warning", symptoms=["Failed to run command to import * SSH ids", "Running module ssh_import_id * failed"])
def ssh_import_id(robot: Robot) -> Iterator[Finding]:
    for each in robot.user_data_key_imports:
        account = str(each.account)
        if each.name and account in PREFIXES:
            yield finding(
                each.account,
                f"The blank after '{account}:' makes a mapping of the entry: no key of {each.name} is imported",
                advice=f"write {account}:{each.name}",
                severity="error",
            )
        elif account in ACCOUNTS or account in each.users:
            yield finding(
                each.account,
                f"The keys of the account '{account}' on Launchpad, whoever that is, may log in on the robot",
                advice="name your own accounts, such as gh:NAME, or write the keys below ssh_authorized_keys:",
            )
