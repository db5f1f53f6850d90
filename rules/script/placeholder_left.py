"""A file with placeholders is installed, and nothing fills them in.

## What it finds
- A script that copies a unit, a udev rule or another file of the tree below `/etc`, `/lib` or `/usr`, where the file
  has placeholders (`@ROS_DISTRO@`, `__USER__`) that the script does not name.
- A script whose `sed` looks for such a placeholder, which no file of the tree has.

Silent where another script that names the file fills the placeholder in, and, for the second, where the script fetches
or writes something that may have it.

## Why it matters on a robot
The unit starts `/opt/ros/@ROS_DISTRO@/setup.bash`, which does not exist, or the one that should run as the user who
installs it has the name and the home folder of its developer.

## Bad
```sh
cp systemd/rover.service /etc/systemd/system/        # it has ExecStart=/home/__USER__/start.sh
```

## Good
```sh
sed "s|__USER__|$USER|g" systemd/rover.service | sudo tee /etc/systemd/system/rover.service
```

## When to ignore it
When a step outside of the tree fills in the installed file.

## References
- sed(1)
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import in_tree

COPIES = ("cp", "install")
SYSTEM = regex(r"/(?:etc|lib|usr)/.*", re.S)
UNKNOWN = regex(r"\{\{ (\w{1,60}) \}\}")
VARIABLE = regex(r"\$\{?(\w{1,60})\}?")
RESULT = regex(r"\$\((?:[^()\n]|\([^()\n]*\))*\)")
TOKEN = r"(?:@[A-Z][A-Z0-9_]{2,40}@|__[A-Z][A-Z0-9_]{2,40}__)"
IN_LINE = regex(rf"^(?![ \t]*[#;])[^\n]{{0,400}}?(?P<token>{TOKEN})", re.M)
ASKED = regex(rf"s(?P<mark>[|/#,:;%!~+])(?P<before>[^|#,;%!~+\n]{{0,80}}?)(?P<token>{TOKEN})")
OF_SYSTEM = regex(r"\.(?:service|socket|timer|target|path|rules|conf|desktop|mount|network|netdev)$")
FETCHES = regex(r"\b(?:curl|wget|git[ \t]+clone|scp|rsync|unzip|tar)\b|<<")
TEXTS = regex(
    r"(?:\.(?:service|socket|timer|target|rules|conf|cfg|ini|desktop|sh|bash|ya?ml|xml|json|in|env|txt|tmpl|template"
    r"|tpl|launch|urdf|xacro|html|toml|plist|list|repos|rviz|lua|py|network|netdev)|/[^/.]+)$"
)
MOST = 100_000


@rule("error", symptoms=["/opt/ros/@*@/setup.bash: No such file or directory", "Failed to determine user credentials"])
def placeholder_left(robot: Robot) -> Iterator[Finding]:
    yield from _copied(robot)
    yield from _not_there(robot)


def _copied(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for source, run in robot.scripts.run(*COPIES):
        if len(run.words) < 3 or not SYSTEM.fullmatch(_expanded(source, run.text(run.words[-1]))):
            continue
        for word in run.words[1:-1]:
            for path in in_tree(robot.tree, _expanded(source, run.text(word)), source):
                file = robot.tree.at(path) if OF_SYSTEM.search(path) else None
                left = IN_LINE.search(file.text) if file is not None else None
                if file is None or left is None or (path, left["token"]) in seen:
                    continue
                if left["token"] in source.text or _is_filled(robot, file, left["token"]):
                    continue
                seen.add((path, left["token"]))
                yield finding(
                    word,
                    f"{file.basename} is installed with {left['token']}, which nothing fills in",
                    advice=f"replace {left['token']} with sed before it is copied",
                    related=[note(file.located(*left.span("token")), "the placeholder")],
                )


def _expanded(source: Source, text: str, depth: int = 4) -> str:
    """A word with the values of variables of which only a part is known, such as the end of a path."""
    for name in dict.fromkeys(UNKNOWN.findall(text)):
        own = re.escape(name)
        assigned = re.compile(rf"^[ \t]*(?:for[ \t]+{own}[ \t]+in[ \t]+|(?:readonly[ \t]+)?{own}=)([^;\n]+)", re.M)
        values = assigned.findall(source.text)
        if len(values) == 1 and depth:
            value = RESULT.sub("{{ of_command }}", values[0].strip()).replace('"', "").replace("'", "")
            value = VARIABLE.sub(r"{{ \1 }}", value)
            text = text.replace(f"{{{{ {name} }}}}", _expanded(source, value, depth - 1))
    return text


def _is_filled(robot: Robot, file: Source, token: str) -> bool:
    """Whether a script that names the file knows the placeholder."""
    scripts = (each for each in robot.of_kind("shell-script", "ansible", "dockerfile") if each is not file)
    return any(token in each.text and file.basename in each.text for each in scripts)


def _not_there(robot: Robot) -> Iterator[Finding]:
    for source, run in robot.scripts.run("sed"):
        if source.says(FETCHES):
            continue
        for word in run.words[1:]:
            found = ASKED.match(word)
            if found is None or source.text.count(found["token"]) != str(run.words).count(found["token"]):
                continue
            if not _has(robot, source, found["token"]):
                yield finding(
                    word,
                    f"No file of the tree has {found['token']}: this command changes nothing, and what it reads is "
                    "installed as it is",
                    advice=f"write {found['token']} into the file where the value belongs, or look for what is there",
                )


def _has(robot: Robot, source: Source, token: str) -> bool:
    """Whether another file of the tree has a placeholder."""
    paths = (path for path in robot.tree.like(TEXTS) if not source.absolute.endswith(path))
    return any(token in robot.tree.head(path, MOST) for path in paths)
