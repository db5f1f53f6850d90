"""A chain of filters that is not loaded, or not to its end.

## What it finds
In chains of the package filters, as those of laser_filters and of controllers: a number that is left out (`filter1`
and `filter3`, or none that is called `filter1`), a filter without `name` or `type`, two filters of one name, a name
that is a number, and a type that is not written as `package/Class`.

## Why it matters on a robot
The chain is read from `filter1` on and ends at the first number that is not there: no message appears, and the filters
behind it never run. Of a chain with one of the other mistakes no filter runs, and scans or forces pass as they are: the
robot sees its own frame as an obstacle.

## Bad
```yaml
scan_to_scan_filter_chain:
  ros__parameters:
    filter1: {name: range, type: laser_filters/LaserScanRangeFilter, params: {lower_threshold: 0.2}}
    filter3: {name: box, type: laser_filters/LaserScanBoxFilter, params: {box_frame: base_link}}
```

## Good
```yaml
scan_to_scan_filter_chain:
  ros__parameters:
    filter1: {name: range, type: laser_filters/LaserScanRangeFilter, params: {lower_threshold: 0.2}}
    filter2: {name: box, type: laser_filters/LaserScanBoxFilter, params: {box_frame: base_link}}
```

## When to ignore it
When a launch file adds the missing parameters.

## References
- ros/filters, `load_chain_config` in filter_chain.hpp
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import BrokenChain
from bringup_lint.api.params import broken_chains

NONE = "no filter of the chain is loaded"
MESSAGES = {
    "gap": "There is no {filter}, and the chain ends there: {lost} never loaded",
    "half": f"{{filter}} has no {{missing}}: {NONE}",
    "name": f"The name of {{filter}} is not a text: {NONE}",
    "twice": f"Two filters have the name {{where}}: {NONE}",
    "type": f"{{where}} is not written as package/Class: {NONE}",
}
ADVICE = {
    "gap": "number the filters from 1 on, without a gap",
    "half": "give each filter a name and a type",
    "name": "write it in quotes",
    "twice": "give each filter a name of its own",
    "type": "write the type as package/Class",
}


@rule(
    "warning",
    symptoms=["A filter with the name * already exists", "must be of form <package_name>/<filter_name>"],
)
def filter_chain_broken(robot: Robot) -> Iterator[Finding]:
    for chain in broken_chains(robot.params):
        yield finding(
            chain.where,
            message(chain),
            advice=ADVICE[chain.how],
            related=[] if chain.first is None else [note(chain.first, "the first one")],
        )


def message(chain: BrokenChain) -> str:
    lost = f"{' and '.join(chain.lost)} {'is' if len(chain.lost) == 1 else 'are'}"
    missing = "type" if chain.where == "name" else "name"
    return MESSAGES[chain.how].format(filter=chain.filter, lost=lost, missing=missing, where=chain.where)
