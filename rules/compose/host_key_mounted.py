"""A container gets a private key of the host.

## What it finds
A bind mount of a private SSH key (`~/.ssh/id_rsa` and the like), of the whole `.ssh` folder, or of the host keys of
sshd. Public keys, `known_hosts`, the socket of an agent and build secrets are not reported.

## Why it matters on a robot
Who breaks into one node takes the key and logs in wherever it is accepted: on other robots, on the build server, in the
repository. Mounted without `ro`, the container can replace it too.

## Bad
```yaml
volumes:
  - ~/.ssh/id_rsa:/root/.ssh/id_rsa
```

## Good
```yaml
volumes:
  - ${SSH_AUTH_SOCK}:/ssh-agent
```

## When to ignore it
When the key is made for this container alone and opens nothing else.

## References
- CWE-522
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

KEY = regex(r"(?:.*/)?\.ssh(?:/(?:id_(?:rsa|dsa|ecdsa|ed25519)(?:_sk)?)?)?|/etc/ssh(?:/(?:ssh_host_\w+_key)?)?")


@rule("warning", silent="a mounted key is a file like any other", tags=["CWE-522"])
def host_key_mounted(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        for volume in service.volumes:
            own = volume.where.span.start >= service.body.span.start
            if not own or volume.source is None or not KEY.fullmatch(volume.source):
                continue
            may = "can read" if volume.read_only else "can read and replace"
            yield finding(
                volume.where,
                f"Service '{service.name}' {may} private keys of the host: {volume.source}",
                advice="forward the socket of an agent, or give the container a key of its own",
            )
