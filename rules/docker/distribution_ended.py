"""The distribution of a base image has ended, and apt finds its packages no more.

## What it finds
A stage on an official image of Debian 10 or older, or of a release of Ubuntu that is no LTS and has ended
(`debian:buster`, `python:3.7-stretch`, `ubuntu:21.04`), that runs `apt-get update`, where nothing in the Dockerfile
speaks of an archive or of the sources of apt.

## Why it matters on a robot
The packages have moved to archive.debian.org and old-releases.ubuntu.com, and the image still asks the old servers:
"404 Not Found", "does not have a Release file". The image cannot be built again, neither for a new robot nor for a
repair, and what is built gets no security updates.

## Bad
```dockerfile
FROM debian:buster
RUN apt-get update && apt-get install -y gpsd
```

## Good
```dockerfile
FROM debian:bookworm
RUN apt-get update && apt-get install -y gpsd
```

## When to ignore it
When a proxy or mirror of your own still has the packages.

## References
- https://www.debian.org/distrib/archive
- https://help.ubuntu.com/community/EOLUpgrades
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of_run
from bringup_lint.api.docker import ended_release
from bringup_lint.api.ros import named_distros
from bringup_lint.api.shell import unwrapped

ARCHIVES = regex(
    r"archive\.debian\.org|old-releases|snapshot\.debian\.org|sources\.list(?!\.d\b)|(?:debian|ubuntu)\.sources"
    r"|/etc/apt/[^\s;&|]{0,80}\*|[ \t]/etc(?:/apt)?/?[\"\]]*[ \t]*$",
    re.M,
)
"""What gives apt other servers."""
STRICT = regex(r"\bset\s+-\w{0,8}e|errexit")
"""Without it, the shell of a here-document goes on after a failure."""
HOSTS = {"debian": "archive.debian.org", "ubuntu": "old-releases.ubuntu.com"}


@rule(
    "error",
    symptoms=[
        "deb.debian.org* does not have a Release file",
        "ubuntu.com* no longer has a Release file",
        "http://deb.debian.org* 404  Not Found",
        "ubuntu.com* 404  Not Found",
    ],
)
def distribution_ended(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for file in robot.dockerfiles:
        images = [each for each in file.stages if each in robot.compose.built_stages]
        built = file.needed(images or file.stages[-1:])
        for stage in file.stages:
            release = ended_release(stage.origin) if stage in built else None
            bottom = list(stage.chain)[-1]
            if release is None or bottom in seen or robot.compose.images.is_chosen(stage, tag=True):
                continue
            update = _update(stage)
            if update is not None and not _has_archive(robot, list(_texts(stage))):
                seen.add(bottom)
                name = f"{release.distribution.capitalize()} {release.number} ({release.codename})"
                yield finding(
                    bottom.image,
                    f"The packages of {name} have been in an archive since {release.moved}: apt-get update fails, and "
                    "the build stops",
                    advice=f"take a newer release, or write {HOSTS[release.distribution]} into the sources of apt",
                    related=[note(update, "asks the old servers")],
                    severity="info" if _is_kept(file.source, release.codename) else None,
                )


def _is_kept(source: Source, codename: str) -> bool:
    """Whether the path says for which ended release the file is: it is kept beside those for later ones."""
    return codename in source.name.lower() or bool(named_distros(source.name))


def _has_archive(robot: Robot, texts: list[str]) -> bool:
    """Whether the steps, or a script that they name, give apt other servers."""
    scripts = (each for each in robot.of_kind("shell-script") if any(each.basename in text for text in texts))
    return any(map(ARCHIVES.search, (*texts, *(each.text for each in scripts))))


def _texts(stage: Stage) -> Iterator[str]:
    for instruction in (each for one in stage.chain for each in one.instructions):
        yield from map(str, (instruction.value, *instruction.flags, *instruction.heredocs))


def _update(stage: Stage) -> Located | None:
    """The first command that asks for the lists of packages, where its failure stops the build."""
    steps = (run for run in stage.all("RUN") if not run.heredocs or any(map(STRICT.search, run.heredocs)))
    for command in (each for run in steps for each in commands_of_run(run)):
        words = unwrapped(command.words)
        if words and words[0] in ("apt", "apt-get") and "update" in words and command.ends != "||":
            return words[0]
    return None
