"""A script runs a playbook for a tag that nothing has.

## What it finds
`ansible-playbook --tags` (or `-t`) in a script, in a tree whose plays, roles and tasks have no tags at all, or none of
the tags that the script names. Silent for the tags of Ansible's own (`all`, `tagged`, `untagged`, `always`, `never`),
and where roles come from elsewhere (`requirements.yml`) or the playbook is not in the tree.

## Why it matters on a robot
Ansible skips every task, and ends with success: the script says that the robot is up to date, and nothing was
deployed.

## Bad
```sh
ansible-playbook -i hosts deploy.yml --tags "$NODE"    # deploy.yml and its roles have no tags
```

## Good
```yaml
- ansible.builtin.include_role: {name: node, apply: {tags: [lidar]}}
  tags: [lidar]
```

## When to ignore it
When the tags are those of a collection that is installed on the computer.

## References
- https://docs.ansible.com/ansible/latest/playbook_guide/playbooks_tags.html
"""

import re
from collections.abc import Iterator
from itertools import islice

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

OPTIONS = ("--tags", "-t")
OWN = ("all", "tagged", "untagged", "always", "never")
TAGS = regex(r"\btags\b[\"']?[ \t]*[:=]", hints="tags")
UNKNOWN = regex(
    r"\btags\b[\"']?[ \t]*[:=][^\n]{0,80}\{\{"
    r"|^[ \t]*-[ \t]+(?:role:[ \t]*)?[\"']?[a-z]\w{0,60}\.\w{1,60}[\"']?[ \t]*$",
    re.M,
)
"""Tags that a variable gives, and roles of others."""
PAGE = regex(r"\.ya?ml$")
SIZE = 64 * 1024
"""How much is read of a page."""
FOREIGN = ("requirements.yml", "requirements.yaml")
"""Name roles and collections that are not in the tree."""
MOST = 50
"""Commands that are looked at."""
PLAIN = regex(r"[\w.-]+")
PLAYBOOK = regex(r".*(?:\.ya?ml|\$.*)")


@rule("warning", silent="Ansible reports the tasks that it skips as skipped, and ends with success")
def ansible_tag_missing(robot: Robot) -> Iterator[Finding]:
    if not robot.of_kind("ansible") or any(True for name in FOREIGN for _ in robot.tree.named(name)):
        return
    if robot.tree.submodules or any(each.matches(UNKNOWN) for each in robot.of_kind("ansible")):
        return
    asked = list(islice(_asked(robot), MOST))
    texts = list(_texts(robot)) if asked else []
    has_tags = any(map(TAGS.search, texts))
    for word, names in asked:
        if not has_tags:
            yield finding(
                word,
                "No play, role or task of the tree has tags: Ansible skips every task, and ends with success",
                advice="give the tasks tags, or choose them by a variable and when:",
            )
        elif all(map(PLAIN.fullmatch, names)) and not any(_has(texts, name) for name in names):
            yield finding(
                word,
                f"No play, role or task has the tag {', '.join(names)}: Ansible skips every task and succeeds",
                advice="write a tag that the tasks have",
            )


def _asked(robot: Robot) -> Iterator[tuple[Located, list[str]]]:
    """The tags that scripts ask for, of playbooks of the tree."""
    for _, run in robot.scripts.run("ansible-playbook"):
        word = _tags(run)
        if word is not None and _is_of_tree(robot, run, word):
            names = [name.strip() for name in run.text(word).rpartition("=")[2].split(",")]
            if not any(name in OWN for name in names):
                yield word, names


def _tags(run: Run) -> Located | None:
    """The word that says the tags."""
    for before, word in zip(("", *run.words), run.words, strict=False):
        if before in OPTIONS or word.startswith("--tags="):
            return word
    return None


def _is_of_tree(robot: Robot, run: Run, tags: Located) -> bool:
    """Whether the playbooks that a command names are in the tree, or a variable says which."""
    named = [word for word in run.words[1:] if word is not tags and PLAYBOOK.fullmatch(word)]
    files = [run.text(word).rpartition("/")[2] for word in named if "$" not in word]
    return bool(named) and all(any(robot.tree.named(name)) for name in files)


def _has(texts: list[str], name: str) -> bool:
    """Whether a play may give a task a tag of this name: it says the word."""
    word = re.compile(rf"(?<![\w.-]){re.escape(name)}(?![\w-])")
    return any(map(word.search, texts))


def _texts(robot: Robot) -> Iterator[str]:
    """What plays, roles, tasks and their variables say."""
    yield from (each.text for each in robot.of_kind("ansible", "ansible-vars"))
    yield from robot.tree.pages(PAGE, SIZE)
