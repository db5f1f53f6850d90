"""netplan does not know a key.

## What it finds
A key that netplan's schema does not have at that place: a typing mistake, a key one level too high or too
low, or a key of another tool. Netplan has no prefix for extensions: everything unknown is an error.

## Why it matters on a robot
`netplan generate` stops at the first unknown key and writes nothing. The robot keeps the old network until
the next boot, and then comes up without a network, or without the interface that this file should configure.

## Bad
```yaml
network:
  version: 2
  ethernets:
    eth0:
      adresses: [10.0.0.10/24]
```

## Good
```yaml
network:
  version: 2
  ethernets:
    eth0:
      addresses: [10.0.0.10/24]
```

## When to ignore it
If the robot has a netplan that is newer than the schema of this linter and knows the key.

## References
- netplan YAML reference, https://netplan.readthedocs.io/en/stable/netplan-yaml/
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.netplan import home_of
from bringup_lint.api.schema import Code
from bringup_lint.api.spelling import nearest
from bringup_lint.api.yaml import is_free_key

FOREIGN = {
    "ssid": "write the SSID as the key itself, below access-points",
    "psk": "write password",
    "address": "write addresses: [10.0.0.10/24]",
    "ip": "write addresses: [10.0.0.10/24]",
    "netmask": "append the prefix length to the address: 10.0.0.10/24",
    "gateway": "write routes: [{to: default, via: 10.0.0.1}]",
    "dns": "write nameservers: {addresses: [10.0.0.1]}",
}
"""Keys of other tools, and what netplan has instead."""


@rule("error", fix="unsafe", symptoms=["Error in network definition: unknown key '*'"])
def unknown_key(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.remarks(Code.UNKNOWN):
        key, table = problem.word, problem.known.name.strip("{}")
        if table == "root":
            continue
        near = [] if key in FOREIGN else nearest(key, problem.known.children)
        is_clear = bool(near) and is_free_key(near[0], key, problem.known.children)
        elsewhere = None if near else home_of(str(key))
        if near:
            advice = f"did you mean {' or '.join(near)}?"
        elif key in FOREIGN:
            advice = FOREIGN[str(key)]
        else:
            advice = f"move it into {elsewhere}" if elsewhere else f"remove it: {table} has no such key"
        yield finding(
            key,
            f"Unknown key '{key}' in {table}: netplan generates nothing",
            advice=advice,
            fix=fix(f"rename to {near[0]}", (key, near[0])) if is_clear else None,
        )
