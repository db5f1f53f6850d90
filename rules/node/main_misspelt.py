"""The name with which a program asks whether it is run is misspelt.

## What it finds
`__name__` compared with a word that is a letter or two away from `__main__`, in the source of a node.

## Why it matters on a robot
Python calls the module that it runs `__main__`, and no other name. The comparison is false, the program ends at once
with success, and nothing says why: `python3 node.py` and a script that CMake installs start no node. A console script
of setup.py calls the function itself, and hides the mistake.

## Bad
```python
if __name__ == '__mian__':
    main()
```

## Good
```python
if __name__ == '__main__':
    main()
```

## When to ignore it
Never: no module has such a name.

## References
- Python documentation, `__main__`
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest

MAIN = "__main__"
ASKED = regex(
    r"^[ \t]*(?:el)?if[ \t(]+__name__[ \t]*==[ \t]*[\"'](_{0,3}\w{2,8}?_{0,3})[\"'][ \t)]*:", re.M, "__name__"
)


@rule("warning", fix="safe", silent="the program ends with status 0 and prints nothing")
def main_misspelt(robot: Robot) -> Iterator[Finding]:
    judged = [source for source in robot.of_kind("python-node") if source.judged]
    for source in judged:
        for match in ASKED.finditer(source.said):
            word = source.located(*match.span(1))
            if word != MAIN and nearest(word, [MAIN]):
                yield finding(
                    word,
                    f"No module is called '{word}': what follows is not run, and the program ends at once",
                    advice=f"write {MAIN}",
                    fix=fix(f"write {MAIN}", (word, MAIN)),
                )
