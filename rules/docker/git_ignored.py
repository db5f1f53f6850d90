"""A step of an image asks git for the version of a repository that `.dockerignore` leaves out.

## What it finds
`git describe`, `git rev-parse`, `git log` and the like in a RUN of a Dockerfile that copies its whole build context,
where `.dockerignore` names `.git`. Silent where the Dockerfile clones or mounts a repository.

## Why it matters on a robot
git says "not a git repository". The step fails, or the image gets no version, or always the one behind `||`: nobody can
tell which software a robot runs, and updates that compare versions do nothing or never end.

## Bad
```dockerfile
# .dockerignore: .git
COPY . /ws/src/rover
RUN git describe --tags > /ws/version || echo v0.0.0 > /ws/version
```

## Good
```dockerfile
ARG VERSION
COPY . /ws/src/rover
RUN echo "$VERSION" > /ws/version
```

## When to ignore it
When the answer behind `||` is meant for every image.

## References
- https://docs.docker.com/build/concepts/context/#dockerignore-files
- git-describe(1)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.docker import without_history


@rule("warning", symptoms=["fatal: not a git repository (or any of the parent directories): .git"])
def git_ignored(robot: Robot) -> Iterator[Finding]:
    for each in without_history(robot.files, robot.compose):
        name = each.ignoring.span.source.basename
        yield finding(
            each.where,
            f"{name} leaves .git out of the build context: git {each.verb} fails in every build",
            advice="pass the version with ARG and --build-arg, or take .git off the list",
            related=[note(each.ignoring, "leaves it out")],
        )
