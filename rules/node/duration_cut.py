"""A duration in C++ is much shorter than what is written.

## What it finds
`rclcpp::Duration(seconds, nanoseconds)` whose seconds are a fraction, or whose second number is less than a
millisecond, or one that is called milliseconds; and the period of `RCLCPP_INFO_THROTTLE` and the like, when it is less
than 10. As an info, `std::chrono::seconds` of a `double` that is cast to a
whole number.

## Why it matters on a robot
The seconds are a whole number: 0.5 becomes 0, and a timeout that is to be half a second is none. The second number
counts nanoseconds: 100 is not 100 ms, and a lookup that is to wait for a transform does not wait at all. A log that is
to come once a second comes with each call, and fills the disk with what the callback of a sensor has to say. Where
`update()` of a controller compares its period with such a duration, to publish less often, it publishes each time; with
the right duration it would never do so, because the period is that of the controller manager.

## Bad
```cpp
buffer_.lookupTransform("map", "base_link", stamp, rclcpp::Duration(0.5, 0));
```

## Good
```cpp
buffer_.lookupTransform("map", "base_link", stamp, rclcpp::Duration::from_seconds(0.5));
```

## When to ignore it
When so short a time is meant.

## References
- rclcpp, logging.hpp: the duration of the throttle interval is in milliseconds
- rclcpp, duration.hpp: `Duration(int32_t seconds, uint32_t nanoseconds)`
- tried with g++ 12.2: a conversion from `double` is no error in parentheses
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import regex
from bringup_lint.api import rule

_SAYS = {
    "cast": ("The fraction of {} is lost: 0.5 s become 0 s", "use std::chrono::duration<double>"),
    "cut": ("The seconds of rclcpp::Duration are whole: {} loses its fraction", "use rclcpp::Duration::from_seconds"),
    "small": (
        "The second number of rclcpp::Duration is nanoseconds: {} ns is no time",
        "use std::chrono::milliseconds",
    ),
    "throttle": ("The period of a throttled log is milliseconds: {} ms leaves nothing out", "write 1000 for a second"),
    "milli": ("The second number of rclcpp::Duration is nanoseconds, not {}", "use std::chrono::milliseconds"),
}

_OF_PERIOD = (
    "The seconds of rclcpp::Duration are whole: {} loses its fraction, and every period is longer than 0",
    "keep the time of the last turn, and compare time - last with rclcpp::Duration::from_seconds",
)
"""Of what the period of one update is compared with, which is shorter than the time between two messages."""
_PERIOD = regex(r"\bperiod\s{0,4}>=?[^;{}<>]{0,40}\Z", hints="period")
_UPDATE = regex(r"\bupdate\w{0,40}\s{0,4}\([^(){};]{0,300}\bperiod\s{0,4}\)", hints="update")
_OWN = regex(r"\b(?:Duration|auto)\s{1,4}period\b", hints="period")
"""A variable of this name, which may be the time since anything."""


@rule("warning", silent="the compiler converts the number, and nothing is logged")
def duration_cut(robot: Robot) -> Iterator[Finding]:
    for found in nodes.wrong_durations(robot.nodes):
        message, advice = _SAYS[found.kind]
        if found.kind == "cut" and is_of_update(found.place):
            message, advice = _OF_PERIOD
        severity = "info" if found.kind == "cast" else robot.nodes.lowered_if_vendored(found.place.source, "warning")
        yield finding(found.place, message.format(found.number), advice=advice, severity=severity)


def is_of_update(place: Span) -> bool:
    """Whether a duration is compared with the period that a controller is given for its ``update()``."""
    if not _PERIOD.search(place.source.line_before(place.start)):
        return False
    text = place.source.text
    heads = [each.end() for each in _UPDATE.finditer(text) if each.end() < place.start]
    return bool(heads) and not _OWN.search(text, heads[-1], place.start)
