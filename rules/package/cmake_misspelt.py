"""A CMakeLists.txt has a word that means nothing, and that is a letter away from one that does.

## What it finds
Commands that neither CMake, ament nor the file knows (`add_executabe`), options of commands (`REQUIRRED`,
`DESTINAION`), targets that no command makes, packages that nothing finds or declares, variables that nothing sets
(`${PROJECT_NAE}`) and folders (`DESTINATION shaare/...`), each where exactly one known name is a letter away. A
`project` that is not called like the package in package.xml.

## Why it matters on a robot
CMake stops at an unknown command, target or package, and the package is not built. A variable that nothing sets is
empty, and an option that a command does not know is the name of one more file, target or folder: the build stops, or
installs to a place where ROS does not look.

## Bad
```cmake
add_executable(drive src/drive.cpp)
ament_target_dependencies(drvie rclcpp)
```

## Good
```cmake
add_executable(drive src/drive.cpp)
ament_target_dependencies(drive rclcpp)
```

## When to ignore it
When an included file or another package makes the name.

## References
- cmake-commands(7), cmake-variables(7)
- ament_cmake_core, `ament_package_xml.cmake`: "package name ... does not match current PROJECT_NAME"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.packages import MisspeltBuild

_EFFECTS = {
    "command": "CMake knows no command {word}: the build of {name} stops",
    "word": "The command does not know the word {word} and takes it for a name: {name} is not built right",
    "target": "No command makes the target {word}: the build of {name} stops",
    "package": "There is no package {word} here: the build of {name} stops",
    "variable": "Nothing sets the variable {word}: it is empty in the build of {name}",
    "folder": "{name} installs files to the folder {word}, where ROS does not look",
    "project": "The project {word} is not called like its package {name}: ament_package stops the build",
}


@rule(
    "error",
    confidence="medium",
    symptoms=[
        "Unknown CMake command",
        "which is not built by this project",
        "does not match current PROJECT_NAME",
        "called with incorrect number of arguments",
    ],
)
def cmake_misspelt(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        for each in robot.dependencies.misspelt_words(package):
            yield finding(
                each.where,
                _EFFECTS[each.kind].format(word=each.where, name=package.name),
                advice=f"did you mean {each.meant}?",
                related=_related(each),
            )


def _related(each: MisspeltBuild) -> list[Related]:
    return [note(each.place, f"{each.meant} is here")] if each.place is not None else []
