"""A README calls a script that is not there.

## What it finds
`./NAME.sh`, `bash NAME.sh` and the like in the code blocks of a README, or a page that is called after the
installation, set-up or start, where no file of the whole tree is called so. Silent where the block clones, downloads
or writes something before, or goes into a folder that the tree lacks, where it or the block before goes to another
computer, for files that git ignores, and for what a build makes.

## Why it matters on a robot
Whoever sets up the next robot follows the page, and stops here: the script was renamed or never came into the
repository, and what it did is not done.

## Bad
```sh
./build_image.sh        # the file is docker/build_base_image.sh
```

## Good
```sh
./docker/build_base_image.sh
```

## When to ignore it
When the script belongs to another repository, which the page explains in its text.

## References
- https://docs.github.com/en/repositories/managing-your-repositorys-settings-and-features/customizing-your-repository/about-readmes
"""

import os
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest_of_few

PAGE = regex(
    r"(?i)(?:^|/)(?:readme|install(?:ation|ing)?|usage|set[_-]?up|bring[_-]?up|quick[_-]?start|getting[_-]?started)"
    r"(?:\.(?:md|rst))?$"
)
FENCE = regex(r"(?m)^[ \t]*(?:```|~~~)[^\n]*$")
CALL = regex(
    r"(?m)^[ \t]*(?:\$[ \t]+)?(?:sudo[ \t]+)?(?:(?:bash|sh)[ \t]+(?:\./)?|\./)"
    r"(?P<path>(?:[\w-]+/){0,6}[\w.-]+\.(?:sh|bash))(?=[ \t\r\n]|$)"
)
BRINGS = regex(
    r"\b(?:git clone|wget|curl|unzip|tar[ \t]+-?\w*x|scp|docker exec|ssh|docker run|tee)\b|>[ \t]*\S|<<"
    r"|\b(?:nano|vim?)[ \t]"
)
HEADING = regex(r"(?m)^#{1,6}[ \t]")
REMOTE = regex(r"(?m)^[ \t]*(?:\$[ \t]+)?(?:ssh|docker (?:exec|run)|docker compose exec)\b")
COMMENT = regex(r"(?m)^[ \t]*#[^\n]*")
ENTERS = regex(r"\bcd[ \t]+(?P<folder>[^\s;&|)]+)")
MADE = regex(r"(?:^|/)(?:install|build|devel|_build)/|(?:^|/)(?:local_)?setup\.(?:ba)?sh$")
MOST = 20


@rule("warning", symptoms=["bash: *.sh: No such file or directory"])
def guide_script_missing(robot: Robot) -> Iterator[Finding]:
    read = filter(None, map(robot.tree.read, robot.tree.like(PAGE)))
    sources = [source for source in read if source.judged and ".sh" in source.text]
    scripts = {os.path.basename(each.name) for each in robot.of_kind("shell-script")} if sources else set()
    folders = {name for path in robot.tree.paths for name in path.split("/")[:-1]} if sources else set()
    for source in sources:
        yield from _of_page(robot, source, scripts, {*folders, "..", "."})


def _of_page(robot: Robot, source: Source, scripts: set[str], folders: set[str]) -> Iterator[Finding]:
    lost: dict[str, list[Located]] = {}
    is_remote, last = False, 0
    for start, end in _blocks(source.text):
        is_remote = is_remote and HEADING.search(source.text, last, start) is None
        looked, is_of_tree = start, not is_remote
        for match in CALL.finditer(source.text, start, end):
            if MADE.search(match["path"]) or not _is_lost(robot, source, match["path"]):
                continue
            is_of_tree = is_of_tree and _stays(source.text[looked : match.start()], folders)
            looked = match.start()
            if is_of_tree:
                lost.setdefault(match["path"], []).append(source.located(*match.span("path")))
        is_remote, last = REMOTE.search(source.text, start, end) is not None, end
    for name, (first, *others) in lost.items():
        near = nearest_of_few(os.path.basename(name), scripts, 4)
        yield finding(
            first,
            f"There is no {name}: who follows this page stops here",
            advice=f"call {near[0]}" if len(near) == 1 else "correct the name, or add the script",
            related=[note(each, "here too") for each in others[:MOST]],
        )


def _blocks(text: str) -> Iterator[tuple[int, int]]:
    """Where the code of each block begins and ends."""
    fences = [match.span() for match in FENCE.finditer(text)]
    for (_, start), (end, _) in zip(fences[::2], fences[1::2]):
        yield start, end


def _stays(lines: str, folders: set[str]) -> bool:
    """Whether the commands before a call bring nothing new, and stay in folders of the tree."""
    lines = COMMENT.sub("", lines)
    entered = (os.path.basename(match["folder"].rstrip("/")) for match in ENTERS.finditer(lines))
    return not BRINGS.search(lines) and folders.issuperset(entered)


def _is_lost(robot: Robot, source: Source, path: str) -> bool:
    if any(robot.tree.named(os.path.basename(path))):
        return False
    return not robot.tree.is_ignored(os.path.join(os.path.dirname(source.absolute), path))
