"""An answer of a board that is cut short ends the driver.

## What it finds
In C++ drivers, a text that is read from a board and taken apart at fixed places: a field behind the first of a line
that `split()` made, or `substr(3)` of an answer. The function asks neither how many fields there are nor how long the
answer is, and nothing in it takes the exception.

## Why it matters on a robot
A line is lost or cut short now and then: when the board restarts, when the time is over, when a motor disturbs the
cable. `substr()` then throws `std::out_of_range`, and the process with the hardware aborts while the robot drives. A
field that is not there is no text at all: reading it is undefined, which is a crash at best and an encoder value at
worst.

## Bad
```cpp
std::string answer = send("getp");
position = std::atoi(answer.substr(3).c_str());
```

## Good
```cpp
std::string answer = send("getp");
if (answer.size() <= 3) { return false; }
position = std::atoi(answer.substr(3).c_str());
```

## When to ignore it
When what reads the line has looked at its length.

## References
- C++ standard, [string.substr]: throws out_of_range when the place is behind the end; [vector.data], [sequence.reqmts]
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["terminate called after throwing an instance of 'std::out_of_range'"])
def answer_short(robot: Robot) -> Iterator[Finding]:
    for driver in robot.nodes.drivers:
        for found in driver.short_answers:
            asked, end = f"how long '{found.name}' is", "is cut short throws std::out_of_range here"
            if found.is_field:
                asked, end = f"how many fields '{found.name}' has", "lacks this one is read behind its end"
            first, *others = found.places
            yield finding(
                first,
                f"{found.function}() does not ask {asked}: an answer that {end}",
                advice="look at its size() first, and leave out this answer when it is too small",
                related=[note(each, "the same") for each in others],
                severity=robot.nodes.lowered_if_vendored(driver.source, "warning"),
            )
