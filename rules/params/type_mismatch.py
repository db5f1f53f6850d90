"""A parameter gets a value of another type than its node declares.

## What it finds
Numbers, booleans and texts for parameters that the sources of the workspace, or a well-known public node, declare as
another one of these types: `{"port": "8080"}` in a launch file for an integer, `<param name="frame" value="5"/>` for a
string, `enabled: 1` in a parameter file for a boolean. In Python, a text in a dictionary stays a text; XML and YAML
launch files make numbers and booleans of what looks like one, unless `type="str"` says otherwise. Integers for doubles,
doubles for integers, and words in parameter files that look like booleans and numbers have rules of their own. Silent
where the node allows any type, or declares the name with several types.

## Why it matters on a robot
ROS does not convert the value: the node exits with InvalidParameterTypeException at start.

## Bad
```python
Node(package="mower", executable="driver", parameters=[{"baud_rate": "115200"}])
```

## Good
```python
Node(package="mower", executable="driver", parameters=[{"baud_rate": 115200}])
```

## When to ignore it
When the declaration that the linter found belongs to another node than the one that gets the value.

## References
- rclcpp, node_parameters.cpp: a declared parameter keeps its type unless `dynamic_typing` is set
- launch_ros, `normalize_parameters.py` and `evaluate_parameters.py`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.params import WrongType
from bringup_lint.api.params import wrong_types

KINDS = {"string": "a string", "bool": "a boolean", "integer": "an integer", "double": "a double"}
ADVICE = {
    "string": 'give it as a string: in quotes, in a launch file in XML with type="str"',
    "bool": "write true or false, without quotes (True or False in Python)",
    "integer": "write it as a whole number, and not as a text",
    "double": "write it as a number with a decimal point, and not as a text",
}
PAIRS = [(given, wanted) for given in KINDS for wanted in KINDS if given != wanted]
OF_NUMBERS = {"integer", "double"}
READABLE = regex(r"(?i)\s*(?:(?:true|false|yes|no|on|off|y|n|null|~|)\Z|[-+]?[.,]?\d)|[^$<{]*[$<{]")
"""What a reader of YAML may take for another type than text, and a place to be filled in."""


@rule(
    "warning",
    symptoms=[
        "InvalidParameterTypeException",
        "has invalid type: expected [integer] got [string]",
        "has invalid type: expected [bool] got [integer]",
        "Trying to set parameter '*' to '*' of type 'STRING', expecting type 'INTEGER'",
    ],
)
def type_mismatch(robot: Robot) -> Iterator[Finding]:
    for given, wanted in PAIRS:
        if {given, wanted} == OF_NUMBERS:
            continue
        for each in wrong_types(robot.params, given, wanted):
            if _is_known_elsewhere(each, given, wanted) or (
                each.package and robot.dependencies.is_forked(each.package)
            ):
                continue
            text = f'"{each.text}"' if given == "string" else each.text
            yield finding(
                each.where,
                f"'{each.name}: {text}' is {_kind(each, given)}, but {each.node} declares {_kind(each, wanted)}: "
                f"{each.outcome}",
                advice=ADVICE[wanted] + (f", or declare it as {_kind(each, given)}" if each.declared else ""),
                related=[note(each.declared, f"declared as {_kind(each, wanted)} here")] if each.declared else [],
                chain=robot.provenance.chain_to_node(each.started) if each.started is not None else (),
            )


def _kind(each: WrongType, type_: str) -> str:
    return f"a list of {KINDS[type_].split()[1]}s" if each.text.startswith("[") else KINDS[type_]


def _is_known_elsewhere(each: WrongType, given: str, wanted: str) -> bool:
    """Whether params/bool-like-string says it of a parameter file, or a text is one that YAML may read otherwise."""
    if each.declared is not None and each.started is None and wanted == "string":
        return True
    is_python = each.started is not None and each.where.source.name.endswith(".py")
    return given == "string" and not is_python and any(READABLE.match(item.text) for item in each.items)
