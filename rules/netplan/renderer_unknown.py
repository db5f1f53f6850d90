"""netplan does not know a renderer.

## What it finds
A `renderer` other than `networkd` and `NetworkManager`. The names are case-sensitive. A VLAN may also have
`sriov`.

## Why it matters on a robot
Netplan stops and generates nothing for any interface.

## Bad
```yaml
renderer: networkmanager
```

## Good
```yaml
renderer: NetworkManager
```

## When to ignore it
Never: `netplan generate` stops here and configures nothing.

## References
- netplan YAML reference, "renderer"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code
from bringup_lint.api.spelling import nearest


@rule("error", fix="safe", symptoms=["unknown renderer"])
def renderer_unknown(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems(Code.RENDERER):
        word = problem.word
        near = nearest(str(word), ["networkd", "NetworkManager"]) or (["networkd"] if "systemd" in word.lower() else [])
        change = fix(f"write {near[0]}", (word, near[0]), safe=_is_spelling_of(word, near[0])) if near else None
        advice = f"write {near[0]}" if near else "write networkd or NetworkManager"
        yield finding(word, f"Unknown renderer '{word}': netplan generates nothing", advice=advice, fix=change)


def _is_spelling_of(word: str, renderer: str) -> bool:
    """Whether only case, signs or the name of systemd differ; anything else may mean the other renderer."""
    letters = "".join(filter(str.isalpha, word.lower()))
    return letters.removeprefix("systemd") == renderer.lower()
