"""The log format contains an unknown token.

## What it finds
A `{token}` in RCUTILS_CONSOLE_OUTPUT_FORMAT that rcutils, or the rcutils of the robot's distribution, does not
support.

## Why it matters on a robot
rcutils prints the token literally in every line of the log.

## Bad
```sh
RCUTILS_CONSOLE_OUTPUT_FORMAT=[{level}] {message}
```

## Good
```sh
RCUTILS_CONSOLE_OUTPUT_FORMAT=[{severity}] {message}
```

## When to ignore it
When the text in braces is meant to appear in the log.

## References
- rcutils, `logging.c`: the tokens of the output format
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.ros import FORMAT_TOKENS
from bringup_lint.api.ros import FORMAT_TOKENS_SINCE
from bringup_lint.api.ros import at_least
from bringup_lint.api.spelling import nearest


@rule("warning", silent="rcutils prints an unknown token as it is")
def rcutils_format_unknown_token(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of("RCUTILS_CONSOLE_OUTPUT_FORMAT"):
        for token in re.finditer(r"\{(\w+)\}", setting.value):
            since = FORMAT_TOKENS_SINCE.get(token[1])
            if since and at_least(robot.target.ros, since) is False:
                yield finding(
                    setting.value.part(*token.span()),
                    f"{robot.target.ros} does not support {token[0]}: rcutils prints it literally in every log line",
                    advice=f"remove it: it exists from {since} on",
                )
            elif token[1] not in FORMAT_TOKENS:
                near = nearest(token[1], FORMAT_TOKENS)
                yield finding(
                    setting.value.part(*token.span()),
                    f"rcutils does not support {token[0]} and prints it literally in every log line",
                    advice=f"write {{{near[0]}}}" if near else f"known: {', '.join(FORMAT_TOKENS)}",
                )
