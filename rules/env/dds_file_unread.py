"""Nothing applies a file of DDS settings.

## What it finds
A Cyclone DDS file in a tree whose processes select `rmw_cyclonedds_cpp`, or a file of Fast DDS profiles in one whose
processes select `rmw_fastrtps_cpp`, when no file of the tree sets, or speaks of, the variable that names such a file,
and none speaks of the file. Silent for the file names that Fast DDS reads by itself.

## Why it matters on a robot
The library reads only what the variable names. Interfaces, peers and buffer sizes in the file do not apply, and the
nodes run with the defaults, without a message.

## Bad
```ini
# config/cyclonedds.xml is installed, and nothing names it
Environment=RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
```

## Good
```ini
Environment=RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
Environment=CYCLONEDDS_URI=file:///etc/rover/cyclonedds.xml
```

## When to ignore it
When something outside of the tree sets the variable.

## References
- https://docs.ros.org/en/jazzy/Installation/RMW-Implementations/DDS-Implementations/Working-with-Eclipse-CycloneDDS.html
- https://docs.ros.org/en/jazzy/Tutorials/Advanced/FastDDS-Configuration.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

RMW = "RMW_IMPLEMENTATION"
OF_ITSELF = ("DEFAULT_FASTRTPS_PROFILES.xml", "DEFAULT_FASTDDS_PROFILES.xml")
"""Names that Fast DDS looks for in the working directory."""
DOCUMENT = regex(r"\.(?:md|rst|txt|adoc|mk|j2|ya?ml|py|cpp|hpp|sh|bash)$|(?:^|/)(?:Makefile|Dockerfile[^/]*|justfile)$")
NAME = regex(r"[\w.+-]+\.xml")
SPOKEN = regex(r"[\w.+-]+")
MOST = 65536
"""Characters of a document that are looked through."""
FILES = 2000
FEW = 40
"""Words that are looked for in a text before it is taken to pieces."""


class Middleware(NamedTuple):
    """A middleware and the variable that names its file."""

    rmw: str
    variable: str
    words: tuple[str, ...]
    """One of them is wherever the variable is spoken of."""


CYCLONE = Middleware("rmw_cyclonedds_cpp", "CYCLONEDDS_URI", ("CYCLONEDDS_URI", "CYCLONE_DDS_URI"))
FAST = Middleware(
    "rmw_fastrtps_cpp",
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    ("FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE", "XMLProfileManager"),
)


@rule("info", confidence="medium", silent="the nodes start with the defaults")
def dds_file_unread(robot: Robot) -> Iterator[Finding]:
    chosen = _chosen(robot) if robot.may_hold(RMW) else {}
    if CYCLONE.rmw in chosen:
        sources = [each.source for each in robot.dds.configurations if each.source.kind == "cyclonedds"]
        yield from _unread(robot, CYCLONE, sources, chosen[CYCLONE.rmw])
    if FAST.rmw in chosen:
        sources = [each.source for each in robot.dds.profile_files if each.source.basename not in OF_ITSELF]
        yield from _unread(robot, FAST, sources, chosen[FAST.rmw])


def _chosen(robot: Robot) -> dict[str, Located]:
    """The middlewares that processes select -> where one does."""
    found = (process.environment.get(RMW) for process in robot.ros.processes)
    return {each.text: each.value for each in found if each is not None and each.text}


def _unread(robot: Robot, middleware: Middleware, sources: list[Source], chosen: Located) -> Iterator[Finding]:
    files = [each for each in sources if each.judged and NAME.fullmatch(each.basename)]
    files = [each for each in files if robot.same_robot(each, chosen)]
    documents = [path for path in robot.tree.paths if DOCUMENT.search(path)] if files else []
    wanted = {*middleware.words, *(each.basename for each in files)}
    spoken = _spoken_of(robot, documents, wanted) if files and len(documents) <= FILES else wanted
    is_set = not spoken.isdisjoint(middleware.words)
    unread = [each for each in files if each.basename not in spoken and not is_set]
    for source in unread:
        yield finding(
            source,
            f"No process reads this file: nothing sets {middleware.variable}, so none of its settings applies",
            advice=f"set {middleware.variable} to the file where {RMW} is set",
            related=[note(chosen, "selected here, without a file")],
        )


def _spoken_of(robot: Robot, documents: list[str], wanted: set[str]) -> set[str]:
    """The words of all files of the tree that have one of those that are asked for."""
    words: set[str] = set()
    few = wanted if len(wanted) <= FEW else {""}
    for text in (*(source.text for source in robot.sources), *(robot.tree.head(path, MOST) for path in documents)):
        if any(word in text for word in few):
            words.update(SPOKEN.findall(text))
    return {word.strip(".") for word in words}
