"""A NetworkManager profile has a misspelled key or section.

## What it finds
A key or section that NetworkManager does not know, and whose name is close to one that it knows. Names are compared
with those of NetworkManager 1.42. Sections with free keys, such as `[vpn]`, and names that are close to nothing are
not judged.

## Why it matters on a robot
NetworkManager ignores the key without a message and keeps its default. With `autoconect=false` the profile connects,
and with `never-defualt=true` the network of the lidar becomes the default route.

## Bad
```ini
[ipv4]
never-defualt=true
```

## Good
```ini
[ipv4]
never-default=true
```

## When to ignore it
If a newer NetworkManager has a key of this name.

## References
- nm-settings(5), nm-settings-keyfile(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.schema import Code
from bringup_lint.api.schema import suggestions
from bringup_lint.api.schema import unknown_name


@rule("warning", fix="unsafe", symptoms=["invalid setting name"])
def unknown_key(robot: Robot) -> Iterator[Finding]:
    for problem in robot.networkmanager.remarks(Code.UNKNOWN):
        section, key = problem.known, problem.word
        near = suggestions(section.children, str(key))
        if near:
            message = f"Unknown key '{key}' in [{section.name}]: NetworkManager ignores it"
            yield unknown_name(key, message, near, "", safe=False)
