"""A service answers success for a file that may not have been written.

## What it finds
A function of a C++ node that opens a `std::ofstream`, never asks it whether it is open or has failed, and then sets
`success = true` in an answer.

## Why it matters on a robot
A stream that could not be opened takes everything and throws nothing. The folder does not exist, it belongs to root
since the first run with sudo, `HOME` is not set in a unit, or the card is full: the calibration or the map is gone with
the next start, and whoever asked for it was told that it is saved.

## Bad
```cpp
std::ofstream file(path_);
file << calibration;
response->success = true;
```

## Good
```cpp
std::ofstream file(path_);
file << calibration;
file.close();
response->success = file.good();
```

## When to ignore it
When something else looks whether the file is there.

## References
- C++ standard, [ofstream.cons]: when the file cannot be opened, failbit is set, and nothing is thrown
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="a stream that is not open takes what is written, and says nothing")
def write_unchecked(robot: Robot) -> Iterator[Finding]:
    for driver in robot.nodes.drivers:
        for found in driver.blind_writes:
            yield finding(
                found.answered,
                f"The answer is success whether '{found.name}' was opened and written or not",
                advice=f"close it and answer {found.name}.good()",
                related=[note(found.opened, "nothing asks it whether it has failed")],
                severity=robot.nodes.lowered_if_vendored(driver.source, "warning"),
            )
