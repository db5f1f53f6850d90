"""A call of a class of launch ends with an exception.

## What it finds
Python launch files that give functions and the classes of launch and launch_ros what they do not take:

- keywords that they do not have (`namspace=`, `params=`), missing ones (`executable=`), arguments without a name where
  a name is needed;
- numbers and truth values where launch takes texts (`default_value=True`, `arguments=['--rate', 50]`);
- a text as `arguments=`, `launch_arguments=` without `.items()`, a whole number as the `period` of a timer, a text as
  `respawn=`;
- one action where a list is needed, a list, a text or an event handler where an action is needed, a `condition=` that
  is none;
- `on_exit=` and its like with a text, an event or a `LaunchConfiguration`, event handlers that wait for the end of an
  include or a group, an action as the event of `EmitEvent`;
- an XML or YAML file for `PythonLaunchDescriptionSource`, a Python file for `FrontendLaunchDescriptionSource`;
- calls of functions of the file itself that hand over too much, too little, or another name, also those that
  `OpaqueFunction` makes: it hands the context over first.

Silent where the file catches TypeError. It is an info where the file holds names to be filled in, as `your_package`.

## Why it matters on a robot
The exception ends launch: most of these while the file is loaded, before a single node has started.

## Bad
```python
DeclareLaunchArgument('use_lidar', default_value=True)
```

## Good
```python
DeclareLaunchArgument('use_lidar', default_value='true')
```

## When to ignore it
When the class is one of your own that only has the name and module of launch's.

## References
- ros2/launch, `launch.utilities.normalize_to_list_of_substitutions`
- ros2/launch and ros2/launch_ros, the constructors of the actions
"""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.launch import RefusedCall
from bringup_lint.api.launch import parameters_of
from bringup_lint.api.spelling import nearest

NUMBER = regex(r"^-?[0-9.]+$")
WHOLE = regex(r"^-?[0-9]+$")
MEANT = {
    "arguments": "launch_arguments",
    "args": "arguments",
    "cfg": "parameters",
    "command": "cmd",
    "default": "default_value",
    "exec": "executable",
    "launch_args": "launch_arguments",
    "node_name": "name",
    "ns": "namespace",
    "params": "parameters",
    "pkg": "package",
    "plugin": "executable",
    "remap": "remappings",
    "type": "executable",
}
"""Unknown arguments that other classes, XML or ROS 1 have."""
MESSAGES = {
    "keyword": "{owner} has no argument '{word}': launch ends with a TypeError",
    "missing": "{owner} needs {word}=: launch ends with a TypeError",
    "positional": "{owner} takes this argument by its name only: launch ends with a TypeError",
    "text": "{word} of {owner} takes texts and substitutions, not {given}: launch ends with a TypeError",
    "words": "{word} of {owner} is a text and not a list: the program gets each letter as an argument of its own",
    "pairs": "launch_arguments is a dictionary and not its pairs: launch ends with a ValueError at this include",
    "seconds": "The period of a timer is a whole number, which {owner} refuses: launch ends with a TypeError",
    "truth": "{word} of {owner} is neither True nor False nor a substitution: launch ends with a TypeError",
    "actions": "{word} of {owner} is an action and not a list of them: launch ends with a TypeError",
    "action": "A list is not an action: launch ends with \"AttributeError: 'list' object has no attribute 'visit'\"",
    "registered": "Nothing registers this event handler: launch ends with \"AttributeError: ... no attribute 'visit'\"",
    "function": "function= is not a function but what a call of it returns: launch ends with a TypeError",
    "one": "{word} of {owner} is a substitution and not a list of them: launch ends with a TypeError",
    "letters": "cmd is a text and not a list: launch looks for a program called as its first letter, and finds none",
    "dictionary": "{word} of {owner} is {given} and not a dictionary: launch ends with an AttributeError",
    "pair": "launch_arguments takes pairs of name and value, not this: launch ends with a ValueError at this include",
    "visited": "The list holds {given}, which is not an action: launch ends with an AttributeError, because it has no "
    "attribute 'visit'",
    "reaction": "{word} of {owner} takes actions or a function, not {given}: launch ends with an exception there",
    "event": "EmitEvent takes an event and not an action: launch ends with a RuntimeError",
    "script": "{owner} runs this file as Python: launch ends with a SyntaxError at the include",
    "markup": "{owner} reads XML and YAML, not Python: launch ends with an exception at the include",
    "process": "{word} of {owner} is no process: launch ends with a TypeError",
    "lifecycle": "{word} of {owner} is no LifecycleNode: launch ends with a RuntimeError",
    "components": "{word} of {owner} is a component and not a list of them: launch ends with a TypeError",
    "component": "A process is no component: launch ends with an exception when it loads it",
    "callable": "{word} of {owner} is a text and not a function: launch ends with a TypeError",
    "own": "{owner}() {word}: launch ends with a TypeError",
    "condition": "condition= is not a condition: launch ends with \"AttributeError: ... no attribute 'evaluate'\"",
}
ADVICE = {
    "positional": "write the name of the argument",
    "words": "write a list of the arguments",
    "pairs": "write .items() after it",
    "seconds": "write it with a decimal point",
    "truth": "write True or False, without quotes",
    "action": "unpack the list with *",
    "registered": "put it into RegisterEventHandler(...)",
    "actions": "put it into a list",
    "function": "name the function without calling it",
    "condition": "write IfCondition(...)",
    "own": "call the function as it is defined",
    "callable": "name the function without quotes",
    "one": "put it into a list",
    "letters": "write a list of the words",
    "dictionary": "write a dictionary of names and values",
    "pair": "write [('name', 'value')], or a dictionary with .items()",
    "visited": "put only actions into the list",
    "reaction": "write an action, as launch.actions.Shutdown()",
    "event": "use the action itself, or the event of launch.events",
    "script": "use AnyLaunchDescriptionSource",
    "markup": "use PythonLaunchDescriptionSource",
    "process": "name the Node or ExecuteProcess that is meant",
    "lifecycle": "make the node a LifecycleNode",
    "components": "put it into a list",
    "component": "write ComposableNode(...)",
}

PLACEHOLDER = regex(r"[\"'/](?:your_(?:package|pkg|robot)|path/to/(?:your|my)?)\b", hints="your_ path/to/")
"""Names in files that are there to be filled in."""


@rule(
    "error",
    fix="safe",
    symptoms=[
        "got an unexpected keyword argument",
        "required keyword-only argument",
        "object is not iterable",
        "object has no attribute 'visit'",
        "too many values to unpack (expected 2)",
        "SyntaxError: invalid syntax (*.launch.xml",
    ],
)
def call_refused(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        groups: dict[tuple[str, ...], list[RefusedCall]] = {}
        for each in launch.refused_calls(robot.launch, file):
            groups.setdefault((message(each), each.word), []).append(each)
        for first, *others in groups.values():
            yield finding(
                first.where,
                message(first),
                advice=advice(first),
                related=[note(each.where, "the same here") for each in others],
                fix=repair([first, *others]),
                severity="info" if file.source.matches(PLACEHOLDER) else None,
            )


def message(call: RefusedCall) -> str:
    return MESSAGES[call.code].format(
        owner=call.owner,
        word=call.word.replace(",", "= and "),
        given=call.given,
    )


def advice(call: RefusedCall) -> str:
    if call.code == "keyword":
        return f"write {meant(call)}=" if meant(call) else "remove it, or use the argument that the class has for it"
    if call.code == "missing":
        return f"pass {call.word.replace(',', '= and ')}="
    if call.code == "text":
        return f"write {quoted(call.given)}" if quoted(call.given) else "give a text"
    return ADVICE[call.code]


def meant(call: RefusedCall) -> str | None:
    """The argument that an unknown one stands for."""
    known = parameters_of(call.owner)
    if MEANT.get(call.word) in known:
        return MEANT[call.word]
    near = nearest(call.word, known)
    return near[0] if near else None


def quoted(text: str) -> str | None:
    """A literal number or truth value as the text that launch takes."""
    if text in ("True", "False"):
        return f"'{text.lower()}'"
    return f"'{text}'" if NUMBER.match(text) else None


def repair(calls: list[RefusedCall]) -> Fix | None:
    edits = [(call.where, replaced(call)) for call in calls]
    known = [(where, text) for where, text in edits if text is not None]
    return fix(advice(calls[0]), *known) if len(known) == len(edits) else None


def replaced(call: RefusedCall) -> str | None:
    """What a place is replaced by, where nothing else can be meant."""
    text = call.where.text
    if call.code == "text":
        return quoted(text)
    if call.code == "seconds" and WHOLE.match(text):
        return f"{text}.0"
    if call.code == "pairs" and text.startswith("{"):
        return f"{text}.items()"
    return None
