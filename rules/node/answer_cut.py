"""An answer of a board that does not come is read as the number 0.

## What it finds
A function of a C++ driver that sends something and takes the answer apart: it seeks a character with `find()`, cuts
the answer there with `substr()`, and makes numbers of the parts with `atoi` or the like. It asks neither whether there
is an answer nor whether the character was found, and the function of the same file that gets the answer leaves it empty
when none comes in time.

## Why it matters on a robot
Of an empty text `atoi` makes 0: one line that is lost on the serial cable sets both encoders back to 0, and the next
one forth again. The odometry jumps by the whole way that the wheels have gone, or the velocity by as much in one cycle.
Where the line is cut short, `find()` returns `npos`, `npos + 1` is 0, and both numbers are the first one.

## Bad
```cpp
std::string answer = send("e");
size_t at = answer.find(" ");
left = std::atoi(answer.substr(0, at).c_str());
right = std::atoi(answer.substr(at + 1).c_str());
```

## Good
```cpp
std::string answer = send("e");
size_t at = answer.find(" ");
if (at == std::string::npos) { return false; }
```

## When to ignore it
When the board always answers in time, or the caller notices a jump.

## References
- C++ standard, [string.find] and [string.substr]: `npos` where nothing is found, and all that is left for a count of it
- https://en.cppreference.com/w/cpp/string/byte/atoi: 0 where the text does not begin with digits
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="atoi reports nothing, and the values are numbers")
def answer_cut(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.cut_answers(robot.nodes):
        yield finding(
            first.place,
            f"Without an answer in time '{first.name}' is empty, and {first.reads}() makes 0 of it: what "
            f"{first.function}() reads jumps to 0 and back",
            advice=f"return without new values where find() gives npos, and let the caller of {first.function}() know",
            related=[
                note(first.given, "leaves it empty when no answer comes in time"),
                *(note(each.place, f"the same in {each.function}()") for each in others),
            ],
            severity=robot.nodes.lowered_if_vendored(first.place.source, "warning"),
        )
