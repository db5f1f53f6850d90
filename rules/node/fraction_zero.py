"""A fraction of whole numbers in C++ is 0.

## What it finds
In C++ sources, a quotient of two whole numbers of which the first one is smaller: `1 / 30`, or `(3 / 4) * speed`.
Only where it is worked out by itself: `speed * 3 / 4` is left alone.

## Why it matters on a robot
C++ drops the fraction of a quotient of integers, wherever its result goes: the period of a timer becomes 0, so that it
fires without a pause, and a gain, a share or a size becomes 0.

## Bad
```cpp
timer_ = create_wall_timer(std::chrono::duration<double>(1 / 30), callback);
```

## Good
```cpp
timer_ = create_wall_timer(std::chrono::duration<double>(1.0 / 30), callback);
```

## When to ignore it
Never: write 0 where 0 is meant.

## References
- C++ standard, [expr.mul]: "for integral operands the / operator yields the algebraic quotient with any fractional part
  discarded"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

REACH = 80
DURATION = regex(r"\bchrono::(?:nano|micro|milli)?seconds[({][^;]*\Z")


@rule("warning", fix="unsafe", silent="0 is a number like others", tags=["CWE-682"])
def fraction_zero(robot: Robot) -> Iterator[Finding]:
    for found in nodes.zero_fractions(robot.nodes):
        first, *others = found
        double = _as_double(first)
        edits = [] if any(map(_is_duration, found)) else [(each, _as_double(each)) for each in found]
        yield finding(
            first,
            f"{first} is 0: C++ drops the fraction of a quotient of integers",
            advice=f"write {f'std::chrono::duration<double>({double})' if _is_duration(first) else double}",
            related=[note(each, "the same here") for each in others],
            severity=robot.nodes.lowered_if_vendored(first.span.source, "warning"),
            fix=fix("divide as doubles", *edits, safe=False) if edits else None,
        )


def _is_duration(quotient: Located) -> bool:
    """Whether it is in the brackets of a duration of whole units, such as ``std::chrono::milliseconds``, which no
    floating point number initializes."""
    start = quotient.span.start
    return DURATION.search(quotient.span.source.text[max(0, start - REACH) : start]) is not None


def _as_double(quotient: str) -> str:
    part, _, whole = quotient.partition("/")
    return f"{part.strip()}.0 / {whole.strip()}"
