"""RewrittenYaml gives a file to a parameter that the parameter file does not have.

## What it finds
Names in `param_rewrites` of `RewrittenYaml` that are no key of its source file, where the value is a file of the tree:
a behavior tree, a map. Parameter files that an argument chooses are judged by its default. Silent where a tree is that
of the other action, which would fail where it is used.

## Why it matters on a robot
RewrittenYaml replaces the values of keys that it finds, and adds none. The node runs with its default: the tree, map or
file of this robot is never read, and nothing says so.

## Bad
```python
# nav2_params.yaml has default_nav_to_pose_bt_xml in a comment only
RewrittenYaml(source_file=params_file, param_rewrites={'default_nav_to_pose_bt_xml': own_tree}, convert_types=True)
```

## Good
```yaml
bt_navigator:
  ros__parameters:
    default_nav_to_pose_bt_xml: ""   # RewrittenYaml fills it in
```

## When to ignore it
When the parameter file that is always passed in place of the default one has the key.

## References
- nav2_common, `RewrittenYaml`: `substitute_params` and, from Jazzy on, `add_params`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import unmatched_rewrites


@rule("warning", silent="RewrittenYaml leaves out what it does not find, without a message")
def rewrite_unmatched(robot: Robot) -> Iterator[Finding]:
    for each in unmatched_rewrites(robot.params, robot.launch):
        name = each.file.source.basename
        yield finding(
            each.key,
            f"{name} has no key '{each.key}', and RewrittenYaml adds none: {each.given} is never used",
            advice=f'write {each.key}: "" into {name}, below the node that has the parameter',
            related=[note(each.file.source.span(0, len(each.file.source.line_text(1))), "the key is not in this file")],
            chain=robot.provenance.chain_to(each.key, f"'{each.key}' is to be replaced"),
        )
