"""rcl cannot parse the parameter file.

## What it finds
YAML errors, tabs in the indentation, a plain value that starts with `@` or `%`, a file that holds only `---`, and a
list at the root. A `%YAML` directive other than 1.1 is a warning.

## Why it matters on a robot
The process that loads the file exits at start: 'Error parsing a event near line N'.

## Bad
```yaml
motors:
        ros__parameters:
                rate: 50
```

## Good
```yaml
motors:
  ros__parameters:
    rate: 50
```

## When to ignore it
When the file is a template that a script fills in before a node loads it.

## References
- rcl_yaml_param_parser, `parse_file_events`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import params
from bringup_lint.api import rule
from bringup_lint.api.params import ParameterFile
from bringup_lint.api.yaml import YamlCode

_WHAT: dict[str, str] = {
    YamlCode.TAB: "YAML does not allow tabs in the indentation",
    "no-key": "There is no node name",
    "list-at-root": "The file is a list, not a mapping of node names",
    "yaml-version": "libyaml before 0.2.5, as in the pip packages of ROS, accepts only %YAML 1.1",
}
_ADVICE: dict[str, str] = {
    YamlCode.TAB: "indent with spaces",
    "no-key": "remove the file, or write node name, ros__parameters and values",
    "list-at-root": "put a node name and ros__parameters above the values",
    "yaml-version": "remove the %YAML line",
}


@rule(
    "error",
    fix="safe",
    symptoms=[
        "Error parsing a event near line",
        "Couldn't parse params file",
        "yaml.scanner.ScannerError",
        "yaml.parser.ParserError",
    ],
)
def not_wellformed(robot: Robot) -> Iterator[Finding]:
    for file, problem in robot.params.problems(
        YamlCode.SYNTAX, YamlCode.TAB, YamlCode.CONTROL_CHARACTER, "yaml-version", "no-key", "list-at-root"
    ):
        if problem.code == "yaml-version" and robot.params.read_by(file) == "pyyaml":
            continue
        what = _WHAT.get(problem.code, f"The file is not valid YAML ({problem.detail})")
        yield finding(
            problem.where,
            f"{what}: the process that loads the file exits at start",
            advice=_ADVICE.get(problem.code, "correct the YAML; quote values that start with a special character"),
            fix=_spaces(robot, file) if problem.code == YamlCode.TAB else None,
            severity=params.severity_of_refusal(robot.params, file)
            or ("warning" if problem.code == "yaml-version" else None),
        )


def _spaces(robot: Robot, file: ParameterFile) -> Fix | None:
    """Spaces for every tab in the indentation, if every usual tab width gives the same structure."""
    width = params.tab_width(file)
    if width is None:
        return None
    edits = [(tab, " " * width) for tab in params.indenting_tabs(file)]
    return fix("indent with spaces", *edits)
