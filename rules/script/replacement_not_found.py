"""A script replaces a text that its file does not have.

## What it finds
`sed -i s/old/new/` of a script or a Dockerfile on a file of the tree that has no `old`: by the path of the robot to
which the tree brings the file, by its path in the repository, or by the path of the image to which `COPY` brings it.
Only what is little more than plain text is compared.

Silent where the file has the new text already, as with a script that switches something on beside one that switches it
off, and where the script names the text a second time, writes the file itself, or works in folders that it fetches.

## Why it matters on a robot
sed changes nothing and ends with success. The file keeps the placeholder or the old value: all robots have the same
network name, or the entry script sources a folder that does not exist.

## Bad
```sh
# hostapd.conf has ssid=rover-NUMBER
sed -i "s/XXXX/$SERIAL/" /etc/hostapd/hostapd.conf
```

## Good
```sh
# hostapd.conf has ssid=rover-XXXX
sed -i "s/XXXX/$SERIAL/" /etc/hostapd/hostapd.conf
```

## When to ignore it
When the command is for files of earlier releases only.

## References
- sed(1)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.secrets import assigned_secret
from bringup_lint.api.shell import lost_edits


@rule("warning", silent="sed ends with success whether it replaces anything or not")
def replacement_not_found(robot: Robot) -> Iterator[Finding]:
    for edit in lost_edits(robot.files, robot.scripts, robot.dockerfiles):
        secret = assigned_secret(edit.old)
        said = f"has no {edit.old}" if secret is None else "does not have this text"
        yield finding(
            edit.old,
            f"{edit.file.basename} {said}: this command changes nothing",
            advice="write what the file has",
            secrets=[] if secret is None else [secret.value],
            related=[note(edit.file.whole, "the file that is changed")],
        )
