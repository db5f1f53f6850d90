"""A task of Ansible that cannot fail is asked for its failure, or installs what the rest needs.

## What it finds
`failed_when: false` in a task:
- whose result the same file asks for: `result is failed`, `result is succeeded`, `result.failed`, or
  `selectattr('failed')` of its `results`, also in the task's own `until`;
- that installs packages with `apt`, `package`, `dnf`, `pip`, `snap`, `apt_repository` or `deb822_repository`, and whose
  result no playbook, variable or template of the tree names, but for whether it is changed.

Silent where two tasks register the same name, for packages that are removed, and for trial runs (`check_mode`).

## Why it matters on a robot
Ansible sets `failed` to false, whatever happened. The check that was to stop the play always passes, and `until:
result is succeeded` ends after the first attempt. A package that could not be downloaded looks like one that was
there before: the play goes on, and the robot is found without it when it is to start.

## Bad
```yaml
- name: Reach the package server
  ansible.builtin.uri: {url: https://packages.ros.org}
  register: server
  retries: 5
  until: server is succeeded
  failed_when: false
- ansible.builtin.fail: {msg: No network}
  when: server is failed
```

## Good
```yaml
- name: Reach the package server
  ansible.builtin.uri: {url: https://packages.ros.org}
  register: server
  retries: 5
  until: server is succeeded
  ignore_errors: true
- ansible.builtin.fail: {msg: No network}
  when: server is failed
```

## When to ignore it
When the robot works without the package.

## References
- https://docs.ansible.com/ansible/latest/playbook_guide/playbooks_error_handling.html
"""

from collections import Counter
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Task
from bringup_lint.api.shell import tasks
from bringup_lint.api.yaml import Mapping
from bringup_lint.api.yaml import Scalar

ASKS = regex(
    r"\b(?P<name>[A-Za-z_]\w*)(?:\.failed\b|\[[\"']failed[\"']\]"
    r"|[ \t]{1,9}is[ \t]{1,9}(?:not[ \t]{1,9})?(?:failed|failure|succeeded|success|successful)\b"
    r"|\.results\b[^\n{}]{0,80}?\b(?:select|reject)attr\([\"']failed[\"'])"
)
USED = regex(r"\b(?P<name>[A-Za-z_]\w*)\b(?!\.changed\b|[ \t]{1,9}is[ \t]{1,9}(?:not[ \t]{1,9})?changed\b)")
WORD = regex(r"[A-Za-z_]\w*")
EXPRESSIONS = regex(
    r"[ \t]*(?:-[ \t]{1,9})?(?:when|until|failed_when|changed_when|that)[ \t]*:|[^\n]{0,300}\{[{%]"
    r"|[ \t]*-[ \t]{1,9}(?![ \t]|[\w.]{1,60}:)"
)
"""The start of a line, up to a question in Jinja."""
NAMING = regex(r"\.(?:ya?ml|j2|jinja2?)$|/templates/")
"""Files that may look at a result."""
READ = 200_000
INSTALLERS = frozenset("apt package dnf pip snap apt_repository deb822_repository".split())
NAMED = ("name", "pkg", "package", "deb", "repo", "uris", "requirements")
"""What is to be installed: without any, the module only renews its lists."""
REMOVING = ("absent", "removed", "build-dep", "fixed")
MOST = 10


@rule("warning", silent="Ansible reports the task as ok")
def failure_suppressed(robot: Robot) -> Iterator[Finding]:
    sources = [each for each in robot.of_kind("ansible") if each.judged and "failed_when" in each.text]
    shared = _shared(robot, sources)
    for source in sources:
        yield from _of_file(source, shared)


def _shared(robot: Robot, sources: list[Source]) -> set[str]:
    """The results of installing tasks that more than one file names, be it a template or defaults."""
    suppressed = (task for source in sources for task in tasks(source) if _never_fails(task) is not None)
    names = {_registered(task) for task in suppressed if _installer(task) is not None} - {""}
    if not names:
        return set()
    texts = (robot.tree.start(path, READ) for path in robot.tree.paths if NAMING.search(path))
    said = Counter(name for text in texts for name in names.intersection(WORD.findall(text)))
    return {name for name, count in said.items() if count > 1}


def _of_file(source: Source, shared: set[str]) -> Iterator[Finding]:
    registered = Counter(filter(None, map(_registered, tasks(source))))
    suppressed = [(never, task) for task in tasks(source) if (never := _never_fails(task)) is not None]
    asked = _places(source) if suppressed else {}
    used = Counter(match["name"] for match in USED.finditer(source.said)) if suppressed else Counter()
    for never, task in suppressed:
        name = _registered(task)
        places = asked.get(name, []) if registered[name] == 1 else []
        module = _installer(task)
        if places:
            yield _of_asked(never, name, places, task)
        elif module is not None and not (name and (name in shared or used[name] > 1)) and not _only_checks(task):
            yield finding(
                never,
                "Where the packages cannot be installed, the task is ok, and the play goes on without them",
                advice="remove failed_when: false, so that the play stops at the failure",
                related=[note(module, "what is to be installed")],
            )


def _of_asked(never: Located, name: str, places: list[Located], task: Task) -> Finding:
    until = task.keys.get("until")
    ends = until is not None and any(until.span.start <= place.span.start < until.span.end for place in places)
    others = [place for place in places if until is None or not until.span.start <= place.span.start < until.span.end]
    effects = ["the task is tried once only"] if ends else []
    effects += ["the condition is always the same"] if others else []
    return finding(
        never,
        f"With this, {name} is never failed: {', and '.join(effects)}",
        advice="write ignore_errors: true, which keeps the failure",
        related=[note(place, "asks for it") for place in places[:MOST]],
    )


def _places(source: Source) -> dict[str, list[Located]]:
    """Where a file asks whether a task has failed, by the name of its result."""
    found: dict[str, list[Located]] = {}
    for match in ASKS.finditer(source.said):
        before = source.line_before(match.start())
        if "#" in before or not EXPRESSIONS.match(before):
            continue
        found.setdefault(match["name"], []).append(source.located(*match.span()))
    return found


def _registered(task: Task) -> str:
    name = task.keys.scalar("register")
    return "" if name is None else str(name.value)


def _only_checks(task: Task) -> bool:
    """Whether the task is one for a trial run, which changes nothing."""
    condition = task.keys.scalar("when")
    is_trial = condition is not None and "ansible_check_mode" in condition.value
    return is_trial or task.keys.get("check_mode") is not None


def _never_fails(task: Task) -> Located | None:
    given = task.keys.get("failed_when")
    return given.value if isinstance(given, Scalar) and given.value.lower() in ("false", "no") else None


def _installer(task: Task) -> Located | None:
    """The module of a task that installs packages, or where they come from."""
    for module in task.modules:
        settings = module.settings
        if module.name in INSTALLERS and isinstance(settings, Mapping):
            state = settings.scalar("state")
            named = any(settings.get(key) is not None for key in NAMED)
            if named and (state is None or state.value not in REMOVING):
                return module.key
    return None
