"""usermod -G takes a user out of all groups that it does not list.

## What it finds
- `usermod -G dialout USER` in a script, without `-a`;
- a task of Ansible's `user` module that gives `groups` to a user that the playbook logs in as, without `append: true`:
  `{{ ansible_user }}`, or the name that the inventory, `ansible.cfg` or `remote_user` gives, also where a variable
  stands for it that has no other value in the tree, and that no prompt, task or loop sets.

Silent for a user that the same script creates, for lists with `sudo`, and for groups that a variable gives.

## Why it matters on a robot
The account leaves `sudo`, `video`, `docker` and all other groups in the moment that it gets the serial port. Nobody can
become root any more after the next login, on a robot that may have no screen, and the camera fails next.

## Bad
```sh
sudo usermod -G dialout $USER
```

## Good
```sh
sudo usermod -aG dialout $USER
```

## When to ignore it
When the account is to have these groups and no others.

## References
- usermod(8), -G and -a
- https://docs.ansible.com/ansible/latest/collections/ansible/builtin/user_module.html, "append"
"""

from collections.abc import Container
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
from bringup_lint.api.shell import tasks
from bringup_lint.api.yaml import Mapping
from bringup_lint.api.yaml import Scalar
from bringup_lint.api.yaml import Sequence

GROUPS = regex(r"-[a-zA-Z]*G|--groups")
APPENDS = regex(r"-[a-zA-Z]{0,9}a[a-zA-Z]{0,9}|--append")
APPENDED = regex(r"\bmodule_defaults:(?:[^\n]{0,200}\n){1,20}?[^\n]{0,200}\bappend:[ \t]*[\"']?(?i:true|yes|on)\b")
"""A play lets all its tasks add groups."""
MOST_SETTINGS = 64 * 1024
"""Characters of an ``ansible.cfg`` that are read."""
CREATES = ("useradd", "adduser")
OF_LOGIN = regex(r"\{\{ *(?:ansible_(?:user|user_id|ssh_user|env\.(?:USER|SUDO_USER))|lookup\('env', *'USER'\)) *\}\}")
"""The user that Ansible logs in as exists before the play."""
LOGIN = regex(r"(?m)\b(?:ansible_(?:ssh_)?user|remote_user)[\"']?[ \t]*[:=][ \t]*[\"']?([a-z_][\w-]*)")
SETTING = regex(
    r"(?m)^[ \t]*(?P<name>[a-z_]\w{0,60})[ \t]{0,9}[:=][ \t]*(?P<quote>[\"']?)(?P<value>[^\n\"'#]{1,80})(?P=quote)"
)
"""A variable of one line in an inventory, a play or a file of variables."""
GIVEN = regex(
    r"\b(?:name|register|loop_var)[\"']?[ \t]*:[ \t]*[\"']?([a-z_]\w*)[\"']?[ \t]*(?:[,}#\r\n]|\Z)",
    hints="name register loop_var",
)
"""A variable that has its value only when the play runs: from a prompt (``vars_prompt``), a task or a loop."""


@rule("warning", symptoms=["is not in the sudoers file", "could not open port /dev/tty*: Permission denied"])
def groups_replaced(robot: Robot) -> Iterator[Finding]:
    by_script: dict[Source, list[Located]] = {}
    for source, run in robot.scripts.run("usermod"):
        word = _replaced(run)
        if word is not None and not _is_created(robot, source, run):
            by_script.setdefault(source, []).append(word)
    for first, *others in by_script.values():
        yield finding(
            first,
            f"Without -a, usermod takes the user out of all groups but {first}: also out of sudo",
            advice=f"write usermod -aG {first}",
            related=[note(other, "here too") for other in others],
        )
    yield from _of_tasks(robot)


def _replaced(run: Run) -> Located | None:
    """The groups that a call leaves to a user."""
    options = [word for word in run.words[1:] if word.startswith("-")]
    if any(APPENDS.fullmatch(word) for word in options):
        return None
    for at, word in enumerate(run.words[:-1]):
        if GROUPS.fullmatch(word):
            groups = run.words[at + 1]
            known = "$" not in groups and groups and not groups.startswith("-")
            return groups if known and not {"sudo", "wheel"} & set(groups.split(",")) else None
    return None


def _is_created(robot: Robot, source: Source, run: Run) -> bool:
    """Whether a script makes the user, who then has no other groups that count: any one for a name, the same one for
    a variable."""
    user = str(run.words[-1])
    made = robot.scripts.run(*CREATES)
    return any(user in each.words for script, each in made if script is source or "$" not in user)


def _of_tasks(robot: Robot) -> Iterator[Finding]:
    logins = _logins(robot)
    logins |= frozenset(_variables_of(robot, logins))
    for source in robot.of_kind("ansible"):
        if not source.judged or "groups" not in source.text or APPENDED.search(source.text):
            continue
        for task in tasks(source):
            for module in task.modules:
                if module.name == "user" and isinstance(module.settings, Mapping):
                    yield from _of_module(module.settings, logins)


def _logins(robot: Robot) -> frozenset[str]:
    """The users that the files of Ansible say to log in as, but root."""
    texts = [source.text for source in robot.of_kind("ansible", "ansible-vars")]
    texts += [robot.tree.head(path, MOST_SETTINGS) for path in robot.tree.named("ansible.cfg")]
    return frozenset(name for text in texts for name in LOGIN.findall(text)) - {"root"}


def _variables_of(robot: Robot, logins: Container[str]) -> Iterator[str]:
    """The variables that have only the names of these users, as a task writes them: ``{{ robot_user }}``."""
    values: dict[str, set[str]] = {}
    given_later: set[str] = set()
    for source in robot.of_kind("ansible", "ansible-vars"):
        given_later.update(GIVEN.findall(source.text))
        for match in SETTING.finditer(source.text):
            values.setdefault(match["name"], set()).add(match["value"].strip())
    for name, given in values.items():
        if name not in given_later and all(value in logins or OF_LOGIN.search(value) for value in given):
            yield f"{{{{ {name} }}}}"


def _of_module(settings: Mapping, logins: frozenset[str]) -> Iterator[Finding]:
    name, groups = settings.scalar("name"), settings.get("groups")
    append = settings.scalar("append")
    if name is None or groups is None or (append and append.boolean is not False):
        return
    if not OF_LOGIN.search(name.value) and name.value not in logins:
        return
    words = list(groups.scalars) if isinstance(groups, Sequence) else [groups] if isinstance(groups, Scalar) else []
    text = ",".join(str(word.value) for word in words)
    if text and "{{" not in text and not {"sudo", "wheel"} & set(text.replace(" ", "").split(",")):
        yield finding(
            words[0].value,
            f"Without append: true, the task takes the user out of all groups but {text}: also out of sudo",
            advice="write append: true",
        )
