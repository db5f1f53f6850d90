"""A script works on a container that has another name.

## What it finds
`docker exec`, `attach`, `logs`, `stop`, `restart` and `start` of a name, in a script that runs `docker compose up`,
where no service of the tree has that name as its `container_name` or as the one that compose makes of its own name, no
`--name` of a script gives it, also by a variable, and nothing else in the tree holds the word.

Silent for names with a part that is not known, for commands whose failure is expected (`||`, `if`, `2>/dev/null`), and
where the compose files of the tree name no container, or name one with a variable.

## Why it matters on a robot
Docker answers "No such container". The script that is to stop the robot's software, or to look into it, does nothing.

## Bad
```sh
docker compose up -d               # container_name: heron_base
docker exec -it heron bash
```

## Good
```sh
docker compose up -d
docker exec -it heron_base bash
```

## When to ignore it
When the container is started by something that is not in the tree.

## References
- docker container exec
- https://docs.docker.com/reference/compose-file/services/#container_name
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
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import is_forgiven

NAMED = regex(r"\bcontainer_name\b", hints="container_name")
VERBS = ("exec", "attach", "logs", "stop", "restart", "start")
VALUED = frozenset(
    "-e --env -u --user -w --workdir --env-file --detach-keys -n --tail --since --until -s --signal --timeout".split()
)
NUMBERED = regex(r"(?P<before>.+)[-_]\d+")
JOINED = regex(r"[-_]")
NAME = regex(r"[a-zA-Z0-9][\w.-]{0,200}")


@rule("warning", confidence="medium", symptoms=["Error response from daemon: No such container: *"])
def container_missing(robot: Robot) -> Iterator[Finding]:
    if not robot.mentions(NAMED):
        return
    names = [(str(service.name), service.scalar("container_name")) for service in robot.compose.services]
    given = [name for _, name in names if name is not None]
    if not given or any("$" in name for name in given):
        return
    called_so = set(map(str, given))
    made = {service for service, name in names if name is None}
    scripts = _by_script(robot)
    own = {_pattern(name) for runs in scripts.values() for run in runs for name in _own(run)}
    given_by_scripts = [re.compile(each) for each in own]
    for source, runs in scripts.items():
        if not any(map(_brings_up, runs)):
            continue
        asked = [(word, run.text(word)) for run in runs if (word := _container(run)) is not None]
        wrong = [
            (word, name)
            for word, name in asked
            if not (name in called_so or _is_made(name, made) or _is_held(robot, source, name))
            and not any(each.fullmatch(name) for each in given_by_scripts)
        ]
        near = next((name for name in given if robot.same_robot(name, source)), None)
        if wrong and near is not None:
            (first, called), *others = wrong
            yield finding(
                first,
                f"No container of the tree is called {called}: docker answers 'No such container'",
                advice=f"write {near}" if len(called_so) == 1 else "write the container_name of the service",
                related=[note(near, "a container of the tree"), *(note(each, "nor here") for each, _ in others)],
            )


def _by_script(robot: Robot) -> dict[Source, list[Run]]:
    found: dict[Source, list[Run]] = {}
    for source, run in robot.scripts.run("docker", "docker-compose"):
        found.setdefault(source, []).append(run)
    return found


def _brings_up(run: Run) -> bool:
    return "up" in run.words and (run.name == "docker-compose" or "compose" in run.words[:2])


def _container(run: Run) -> Located | None:
    """The word that names a running container, where it is known and a failure is not expected."""
    words = run.words
    if len(words) < 3 or words[1] not in VERBS or is_forgiven(run.command):
        return None
    at = 2
    seconds = ("-t", "--time") if words[1] in ("stop", "restart") else ()
    while at < len(words) and words[at].startswith("-"):
        at += 2 if words[at] in VALUED or words[at] in seconds else 1
    return words[at] if at < len(words) and NAME.fullmatch(run.text(words[at])) else None


def _is_made(name: str, services: set[str]) -> bool:
    """Whether compose makes this name, as in ``project-service-1``, of that of a service."""
    numbered = NUMBERED.fullmatch(name)
    if numbered is None:
        return False
    before = numbered["before"]
    return any(before[at.end() :] in services for at in JOINED.finditer(before, 1))


def _is_held(robot: Robot, source: Source, name: str) -> bool:
    """Whether something else may give a container this name."""
    own = re.search(rf"--name[= ][\"']?{re.escape(name)}(?![\w-])", source.text)
    word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    return own is not None or any(
        name in each.text and word.search(each.text) for each in robot.sources if each is not source
    )


def _own(run: Run) -> Iterator[str]:
    """The names that a command gives to containers of its own."""
    words = run.arguments
    for option, value in zip(words, (*words[1:], "")):
        if option == "--name":
            yield value
        elif option.startswith("--name="):
            yield option.removeprefix("--name=")


def _pattern(given: str) -> str:
    """The expression for a name of which some parts may not be known. What is between two of them is taken where it is
    first, and not again."""
    first, *rest = map(re.escape, re.split(r"\{\{.*?\}\}", given))
    between = (f"(?=(?P<p{at}>.+?{part}))(?P=p{at})" for at, part in enumerate(rest[:-1]))
    return first + "".join(between) + "".join(f".+{part}" for part in rest[-1:])
