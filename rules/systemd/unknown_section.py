"""A section that systemd does not know: it ignores everything in it.

## What it finds
A section header that no unit type has: a misspelled name, wrong capitals, or a header without its closing
bracket. Sections whose name starts with `X-` are for other programs and are exempt.

## Why it matters on a robot
systemd ignores everything below the header. The service loses its restart policy or is never enabled, while
systemctl reports it as loaded. With a broken header the unit does not load at all.

## Bad
```ini
[service]
ExecStart=/usr/bin/robot-drivers
```

## Good
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
```

## When to ignore it
Never: systemd ignores the section. Prefix its name with `X-` if another program reads it.

## References
- systemd.unit(5), systemd.syntax(7)
- journal: "Unknown section 'service'. Ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest
from bringup_lint.api.systemd import directives


@rule("error", fix="unsafe", symptoms=["Unknown section", "Invalid section header"])
def unknown_section(robot: Robot) -> Iterator[Finding]:
    for file in robot.units.unit_files:
        allowed = directives.sections_of_type(file.type)
        for section in file.sections:
            name = section.name
            if name in directives.sections() or name.startswith("X-"):
                continue
            meant, unfinished = nearest(name, allowed), bool(file.source.template)
            if unfinished and not meant:
                continue
            yield finding(
                name,
                f"Unknown section [{name}]: systemd ignores everything in it",
                advice=f"did you mean [{meant[0]}]?" if meant else f"use {_listed(allowed)}",
                fix=fix(f"rename to [{meant[0]}]", (name, meant[0])) if len(meant) == 1 and not unfinished else None,
            )
        for problem in file.problems:
            if problem.code == "bad-section-header" and not file.source.template:
                yield finding(
                    problem.where,
                    "The section header is not closed: the unit does not load",
                    advice="end the header with ]",
                )


def _listed(sections: tuple[str, ...]) -> str:
    *first, last = (f"[{name}]" for name in sections)
    return f"{', '.join(first)} or {last}"
