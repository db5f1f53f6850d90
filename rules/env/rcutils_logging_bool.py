"""A logging variable of rcutils is neither 0 nor 1.

## What it finds
RCUTILS_LOGGING_USE_STDOUT, RCUTILS_COLORIZED_OUTPUT or RCUTILS_LOGGING_BUFFERED_STREAM with a value other than 0
and 1. An empty value is valid.

## Why it matters on a robot
Logging cannot be initialised: the node runs, but not one line of its log is written. Instead, every call of the
logger prints rcutils errors, more than a hundred kilobytes for one node that starts.

## Bad
```sh
RCUTILS_COLORIZED_OUTPUT=true
```

## Good
```sh
RCUTILS_COLORIZED_OUTPUT=1
```

## When to ignore it
Never: rcutils rejects every other value.

## References
- rcutils, `logging.c`: the value must be 0 or 1
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.ros import LOGGING_SWITCHES

WORDS = {"true": "1", "yes": "1", "on": "1", "false": "0", "no": "0", "off": "0"}


@rule(
    "error",
    fix="safe",
    symptoms=["unexpected value [", "error initializing logging", "failed to configure logging"],
)
def rcutils_logging_bool(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of(*LOGGING_SWITCHES):
        if setting.text in ("", "0", "1"):
            continue
        meant = WORDS.get(setting.text.lower())
        yield finding(
            setting.value,
            f"{setting.name} '{setting.text}' stops all logging: rcutils floods stderr with errors",
            advice=f"write {meant}" if meant else "write 0 or 1",
            fix=fix(f"write {meant}", (setting.value, meant)) if meant else None,
        )
