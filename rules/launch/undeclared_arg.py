"""A launch configuration is read but never declared.

## What it finds
`LaunchConfiguration('x')` or `$(var x)` without a default, where neither the file nor a file that includes it declares
or sets `x`. The declaration in a file that it includes comes too late; an argument that the included file requires and
that is only handed on to it is left alone. A certain read in a Python file is an error, unless a command of the tree
passes the argument; other reads are warnings. If the file reads more than two such names, or another launch file
mentions it, it is probably part of a larger launch file, and the finding is info, as it is where each command of the
tree that launches the file passes the argument, and where a declaration without a default is not added: the argument
must be passed with it, too.

## Why it matters on a robot
launch stops with "launch configuration 'x' does not exist" unless somebody passes `x:=…` by hand. A unit that
starts the file without it fails at every boot.

## Bad
```python
LaunchDescription([
    Node(package='demo', executable='talker', namespace=LaunchConfiguration('robot_name')),
])
```

## Good
```python
LaunchDescription([
    DeclareLaunchArgument('robot_name', default_value='robot'),
    Node(package='demo', executable='talker', namespace=LaunchConfiguration('robot_name')),
])
```

## When to ignore it
When the file is only ever included, by a launch file outside this tree that sets the configuration.

## References
- launch, `LaunchConfiguration.perform`
"""

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import Expansion
from bringup_lint.api.launch import LaunchFile
from bringup_lint.api.launch import Used
from bringup_lint.api.launch import Value
from bringup_lint.api.launch import literal
from bringup_lint.api.launch import walk
from bringup_lint.api.spelling import nearest

OWN = ("ros_namespace", "ros_remaps", "global_params")
"""launch_ros keeps these among the launch configurations."""
DECLARE = "DeclareLaunchArgument"
LONGEST = 600
"""Characters after the name of an argument that its declaration takes."""


LEVELS: dict[str | None, int] = {None: 0, "warning": 1, "info": 2}


@rule("error", symptoms=["launch configuration '*' does not exist"])
def undeclared_arg(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        later = {(id(each.file), each.name) for each in expansion.declared}
        unbound = [used for used in expansion.unbound if (id(used.file), str(used.argument.name)) not in later]
        missing = {str(used.argument.name) for used in unbound}
        for name in sorted(missing - set(OWN)):
            uses = [used for used in unbound if used.certain and used.argument.name == name]
            if uses and not required(expansion, name, uses):
                yield undeclared(robot, expansion, uses, missing)


def required(expansion: Expansion, name: str, uses: list[Used]) -> bool:
    """Whether a configuration is only handed on to included files that declare it without a default: an argument that
    must be passed, like any other of this kind."""
    declared = [each for each in expansion.declared if each.name == name]
    if not declared or any(each.action.default is not None for each in declared):
        return False
    return all(handed_on(expansion, used) for used in uses)


def undeclared(robot: Robot, expansion: Expansion, uses: list[Used], missing: set[str]) -> Finding:
    """One finding for a name, where it does most harm, with the other places that read it."""
    declared = {each.name: each for each in expansion.declared}
    name = str(uses[0].argument.name)
    late = declared.get(name)
    near = [] if late else nearest(name, declared)
    grades = [None if near else grade(robot, expansion, used, missing) for used in uses]
    first = min(range(len(uses)), key=lambda at: LEVELS[grades[at]])
    related = [note(span, "included from here") for span in uses[first].chain]
    related += [note(declared[other].action.span, f"'{other}' is declared here") for other in near]
    if late is not None:
        related.append(note(late.action.span, "declared here, after the read"))
    left_out = unlisted(uses[first].file, name) if late is None and not near else []
    related += left_out
    related += passed(robot, expansion.entry, name)
    related += [note(used.argument.name, "read here, too") for used in uses if used is not uses[first]]
    what = f"launch configuration '{name}' is not declared"
    if left_out:
        what = f"The declaration of '{name}' is not in the launch description"
    return finding(
        uses[first].argument.name,
        f"{what}: launch aborts unless {name}:= is passed",
        advice=f"add the declaration of '{name}' to the launch description"
        if left_out
        else f"declare '{name}'" + (f", or read '{near[0]}'" if near else " before it is read" if late else ""),
        severity=grades[first],
        related=related,
    )


def unlisted(file: LaunchFile, name: str) -> list[Related]:
    """The declaration that a Python file makes, and leaves out of its launch description."""
    text = file.source.text
    made = declaration(file, name)
    if made is None:
        return []
    kept = re.escape(made["kept"] or "")
    if kept and len(re.findall(rf"(?<!['\"])\b{kept}\b(?!['\"])", text)) == 1:
        return [note(file.source.span(*made.span("name")), "declared here, and never added")]
    lists = re.search(r"\breturn (LaunchDescription)\(\[", text)
    if lists is None:
        return []
    return [
        note(file.source.span(*made.span("name")), "declared here"),
        note(file.source.span(*lists.span(1)), "which the launch description does not hold"),
    ]


def declaration(file: LaunchFile, name: str) -> re.Match[str] | None:
    """The call of a Python file that declares an argument."""
    if file.format != "python":
        return None
    named = rf"(?:name\s*=\s*)?['\"](?P<name>{re.escape(name)})['\"]"
    return re.search(rf"(?:\b(?P<kept>\w+)\s*=\s*)?{DECLARE}\(\s*{named}", file.source.text)


def must_be_passed(file: LaunchFile, name: str) -> bool:
    """Whether a Python file declares an argument without a default."""
    made = declaration(file, name)
    if made is None:
        return False
    rest = file.source.text[made.end() : made.end() + LONGEST].partition(DECLARE)[0]
    return "default_value" not in rest and re.match(r"\s*,\s*(?!\w+\s*=)[^\s)]", rest) is None


def grade(robot: Robot, expansion: Expansion, used: Used, missing: set[str]) -> str | None:
    """A file gets its arguments from others if it is a test, if it reads many configurations, if another file mentions
    it, if it only hands the configuration on to what it includes, as files in XML do for a scope around them, or if
    all commands pass it."""
    if len(missing) > 2 or robot.launch.is_named_elsewhere(expansion.entry) or is_test(expansion.entry):
        return "info"
    if must_be_passed(used.file, str(used.argument.name)):
        return "info"
    if used.file.format != "python" and handed_on(expansion, used):
        return "info"
    name = str(used.argument.name)
    starters = robot.runners.launching(expansion.entry)
    passing = passed(robot, expansion.entry, name)
    if passing and len(passing) == len(starters):
        return "info"
    certain = used.file is expansion.entry and not used.conditions and used.file.format == "python"
    return None if certain and not passing else "warning"


def passed(robot: Robot, file: LaunchFile, name: str) -> list[Related]:
    """The commands of the tree that launch the file with the argument."""
    commands = robot.runners.launching(file)
    return [note(key, "passed here") for each in commands for key, _ in each.arguments if key == name]


def is_test(file: LaunchFile) -> bool:
    """Whether launch_test runs the file: its CMakeLists.txt passes arguments with it."""
    return file.entry is not None and file.entry.text == "generate_test_description"


def handed_on(expansion: Expansion, used: Used) -> bool:
    """Whether the place is the value that an include gives to an argument of the same name."""
    name = str(used.argument.name)
    given = (each.action.arguments for each in expansion.includes if each.source is used.file)
    return any(key == name and used.argument in walk(value) for pairs in given for key, value in named(pairs))


def named(pairs: Iterable[tuple[Value, Value]]) -> Iterator[tuple[str, Value]]:
    for key, value in pairs:
        yield literal(key) or "", value
