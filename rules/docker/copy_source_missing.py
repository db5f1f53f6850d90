"""An image takes a file that is not in its build context.

## What it finds
Files and folders that COPY or ADD name and that the build context does not hold. The context is that of the compose
service that builds the Dockerfile; without one, no folder from that of the Dockerfile to the top of the repository
holds the path. What `.dockerignore` leaves out is not in the context either. Paths with variables, files that git
ignores, and what a submodule, script or build file of the tree may put there are not reported, nor folders of a
workspace (`src`, `install`, `build`) where the Dockerfile is in a package.

## Why it matters on a robot
The build stops with "not found". The robot keeps the old image, or a new robot gets none.

## Bad
```dockerfile
COPY config/cyclone.xml /rover/cyclonedds.xml
```
where the folder `config` holds `cyclonedds.xml` only.

## Good
```dockerfile
COPY config/cyclonedds.xml /rover/cyclonedds.xml
```

## When to ignore it
When a step outside of the repository puts the file there before the build.

## References
- https://docs.docker.com/reference/dockerfile/#copy
- https://docs.docker.com/build/concepts/context/
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.docker import lacking_sources


@rule(
    "error",
    confidence="medium",
    symptoms=[
        "failed to calculate checksum of ref",
        "COPY failed: file not found in build context",
        "failed to compute cache key: * not found",
        "CopyIgnoredFile: Attempting to COPY file * that is excluded by .dockerignore",
    ],
)
def copy_source_missing(robot: Robot) -> Iterator[Finding]:
    for lacking in lacking_sources(robot.files, robot.compose):
        service = lacking.service
        if lacking.ignoring is not None:
            name = lacking.ignoring.basename
            yield finding(
                lacking.source,
                f"{name} keeps '{lacking.source}' out of the build context: the build stops",
                advice=f"write !{lacking.source} at the end of {name}",
                related=[note(lacking.ignoring, "leaves it out")],
            )
            continue
        context = f"the build context of service '{service.name}'" if service else "the folder of this file or above it"
        yield finding(
            lacking.source,
            f"There is no '{lacking.source}' in {context}: the build stops",
            advice="write the path relative to the build context",
            related=[note(service.name, "builds this image")] if service else (),
        )
