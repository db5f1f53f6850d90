"""Pins are set up without a numbering mode.

## What it finds
`GPIO.setup()` of RPi.GPIO or Jetson.GPIO in a package that calls `GPIO.setmode()` nowhere, and imports no library that
does.

## Why it matters on a robot
The call raises `RuntimeError: Please set pin numbering mode using GPIO.setmode(GPIO.BOARD) or GPIO.setmode(GPIO.BCM)`.
The node ends when it is made.

## Bad
```python
GPIO.setup(18, GPIO.OUT)
```

## Good
```python
GPIO.setmode(GPIO.BCM)
GPIO.setup(18, GPIO.OUT)
```

## When to ignore it
When a module that is not in the tree sets the mode.

## References
- RPi.GPIO 0.7, source/common.c, check_gpio_priv and get_gpio_number
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule("error", confidence="medium", symptoms=["RuntimeError: Please set pin numbering mode using GPIO.setmode"])
def pin_mode_missing(robot: Robot) -> Iterator[Finding]:
    for file, call in nodes.without_pin_mode(robot.nodes):
        yield finding(
            file.span_of(call),
            "GPIO.setmode() is never called before setup(), which raises RuntimeError: the node does not start",
            advice="call GPIO.setmode(GPIO.BCM) or GPIO.setmode(GPIO.BOARD) first, as the program numbers its pins",
            severity=robot.nodes.lowered(file.source, "error"),
        )
