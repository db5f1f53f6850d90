"""docker compose cannot read the file.

## What it finds
A compose file that is not valid YAML (an open bracket or quote, a tab as indentation, an alias without an anchor), and
a key that appears twice in one mapping, which compose refuses too. Two merge keys (`<<`) in one mapping count as a key
that appears twice: a list of aliases replaces them.

## Why it matters on a robot
`docker compose up` stops with an error and starts none of the services. Everything else in the file stays unread, by
this linter too.

## Bad
```yaml
services:
  driver:
    image: [robot/driver:1.2
```

## Good
```yaml
services:
  driver:
    image: robot/driver:1.2
```

## When to ignore it
Never: docker compose stops here.

## References
- https://github.com/compose-spec/compose-spec
- YAML 1.2 specification, "Mappings": keys are unique
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Problem
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.yaml import YamlCode

CONSEQUENCE = "docker compose starts nothing"


@rule(
    "error",
    symptoms=[
        "yaml: line *: did not find expected",
        "mapping values are not allowed in this context",
        "mapping key already defined",
        "yaml: unmarshal errors",
    ],
)
def syntax(robot: Robot) -> Iterator[Finding]:
    for file in robot.compose.files:
        if not file.source.template:
            for problem in file.problems:
                message, advice = _explain(problem)
                yield finding(problem.where, f"{message}: {CONSEQUENCE}", advice=advice)


def _explain(problem: Problem) -> tuple[str, str]:
    """What is wrong, and what to do about it."""
    if problem.code == YamlCode.TAB:
        return "YAML does not allow tabs in the indentation", "write blanks"
    if problem.code == "duplicate":
        if str(problem.where) == "<<":
            return f"A second merge key, the first is in line {problem.detail}", "write <<: [*one, *other]"
        return f"The key appears already in line {problem.detail}", "remove one of the two"
    return f"Not valid YAML ({problem.detail})", "correct the line"
