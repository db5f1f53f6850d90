"""A parameter file has no block for the node that loads it.

## What it finds
A node with a known name and namespace loads a file in which no block and no wildcard matches its full name, but one is
meant for it: it has the same name in another namespace, or a misspelling of it, is called as the package, the
executable or as a public program calls itself (`ekf_filter_node`), or holds what only the program of this node
declares. Also a file that is for none of the nodes of a launch file, where one beside it has a block for the node that
gets it. The name is that of the launch file, else the one that the source gives. It is a warning where the values are
those that the program has by itself. Silent for components, containers and names that are not known.

## Why it matters on a robot
All parameters keep the defaults of the code, without any message. It shows when the robot drives. Only a node that
declares a parameter without a default ends, because the parameter is not initialized.

## Bad
```yaml
planner:                # the node is /robot1/planner
  ros__parameters: {max_speed: 0.5}
```

## Good
```yaml
/**/planner:
  ros__parameters: {max_speed: 0.5}
```

## When to ignore it
When the file is shared by several nodes and this node deliberately uses its defaults.

## References
- https://github.com/manankharwar/fusioncore/issues/134
- rcl_yaml_param_parser, node names and wildcards
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import foreign
from bringup_lint.api.params import unreached


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "ParameterUninitializedException: The parameter '*' is not initialized",
        "parameter '*' is not initialized",
    ],
)
def file_key_mismatch(robot: Robot) -> Iterator[Finding]:
    for found in unreached(robot.topics):
        tail = found.name.rpartition("/")[2]
        better = found.name if found.misspelt else f"/**/{tail}"
        single = len(found.block.keys) == 1
        is_same = found.changes_nothing(robot.topics)
        effect = "its values are those of the code today, and a change of them will do nothing"
        yield finding(
            found.block.key,
            f"The block is for '{found.block.name}', but the node that loads the file is {found.name}: "
            + (effect if is_same else "all its parameters stay at the defaults, without any message"),
            advice=f"name the block {better}",
            chain=robot.provenance.chain_to_load(
                found.load, note(found.block.key, f"the block is for {found.block.name}")
            ),
            related=[note(found.load.where, "loads the file here"), note(found.load.node.span, "the node")],
            severity="warning" if is_same else None,
            fix=fix(f"name the block {better}", (found.block.key, better), safe=False) if single else None,
        )
    for each in foreign(robot.topics):
        yield finding(
            each.where,
            f"{each.file.source.basename} has no block for {each.name}, only for {each.file.blocks[0].name}: "
            f"{each.name} starts with the defaults of its source",
            advice=f"load {each.better.span.source.basename}, which has a block for {each.name}",
            related=[note(each.better.key, "the block for this node"), note(each.load.node.span, "the node")],
            severity="warning",
        )
