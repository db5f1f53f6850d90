"""A class is made although a method of it is still abstract.

## What it finds
In Python nodes and the modules that they import, calls of a class, or of a function that makes the class that it is
handed, where the class or one that it builds on marks a method with `@abstractmethod`, and none of them defines the
method. Classes that build on something that is not in the tree are left out.

## Why it matters on a robot
Python refuses to make an object of such a class. The node ends with a TypeError when the line runs: at its start, or
when the first goal comes.

## Bad
```python
class Gripper(ABC):
    @abstractmethod
    def open(self): ...

class RoverGripper(Gripper):
    def close(self): ...

gripper = RoverGripper()
```

## Good
```python
class RoverGripper(Gripper):
    def open(self): ...
    def close(self): ...
```

## When to ignore it
When something adds the method to the class at run time.

## References
- https://docs.python.org/3/library/abc.html, "abstractmethod"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["TypeError: Can't instantiate abstract class * with abstract method*"])
def abstract_method(robot: Robot) -> Iterator[Finding]:
    for found in nodes.unfinished_classes(robot.nodes):
        yield finding(
            found.file.span_of(found.call),
            f"TypeError: {found.made} can't be made, because {found.method.name}() is abstract and nothing defines it",
            advice=f"define {found.method.name}() in {found.made}",
            related=[
                note(found.of.span_of(found.cls), "does not define it"),
                note(found.base.span_of(found.method), "is abstract"),
            ],
            severity=robot.nodes.lowered_if_vendored(found.file.source, "error"),
        )
