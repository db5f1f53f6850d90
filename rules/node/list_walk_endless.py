"""A loop through a linked list never gets past an entry that it leaves out.

## What it finds
`while (entry) { ... continue; ... entry = entry->next; }` in C++ sources of nodes and drivers: a `continue` before the
only statement that gives the loop its next entry, as often in loops over the addresses of `getifaddrs`.

## Why it matters on a robot
`continue` goes back to the condition, which looks at the same entry again: the thread loops at full speed forever. It
starts with the first entry that is to be left out. For `getifaddrs` that is an interface without an address: a CAN bus,
a VPN, a modem. On the desk there is none.

## Bad
```cpp
while (entry != nullptr) {
  if (!entry->ifa_addr) { continue; }
  use(entry);
  entry = entry->ifa_next;
}
```

## Good
```cpp
for (auto entry = first; entry != nullptr; entry = entry->ifa_next) {
  if (!entry->ifa_addr) { continue; }
  use(entry);
}
```

## When to ignore it
When the list is changed so that the entry is never the same again.

## References
- getifaddrs(3): `ifa_addr` may be NULL
- C++ standard, [stmt.cont]
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", silent="the loop logs nothing", tags=["CWE-835"])
def list_walk_endless(robot: Robot) -> Iterator[Finding]:
    for driver in robot.nodes.drivers:
        for found in driver.endless_walks:
            yield finding(
                found.skips,
                f"{found.name} stays at this entry: the loop never ends once there is one that it leaves out",
                advice=f"write a for loop whose last part is {found.step.text}",
                related=[note(found.step, "not reached")],
                severity=robot.nodes.lowered_if_vendored(driver.source, "error"),
            )
