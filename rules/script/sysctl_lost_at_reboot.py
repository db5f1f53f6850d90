"""A kernel parameter is set for the running kernel only.

## What it finds
`sysctl -w` in a script with a buffer of the network stack or of IP fragments (`net.core.rmem_max`,
`net.ipv4.ipfrag_time`, ...), when no `sysctl.d` file of the tree sets the parameter and no unit, container or cron
job runs the script, nor a script that starts the robot's software.

In a script that sets a robot up, which installs packages, writes to `/etc` or enables units, also other settings of the
running kernel: any `sysctl -w` and `echo VALUE > /proc/sys/...`, `iptables -A` where nothing saves the rules, and
`modprobe` of a module that no device loads (`v4l2loopback`, `i2c-dev`, ...).

## Why it matters on a robot
The value is gone after the next boot. Large messages such as images and point clouds are then lost again, days after
somebody has tuned the robot and seen them arrive.

## Bad
```sh
sudo sysctl -w net.core.rmem_max=16777216
```

## Good
```sh
echo 'net.core.rmem_max=16777216' | sudo tee /etc/sysctl.d/60-dds.conf
sudo sysctl --system
```

## When to ignore it
When something that the tree does not hold runs the script at every boot.

## References
- sysctl(8)
- sysctl.d(5), modules-load.d(5)
- iptables-save(8)
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import Written

TUNED = regex(r"(net\.core\.(?:[rw]mem_(?:max|default)|netdev_max_backlog)|net\.ipv4\.ipfrag_\w+)=")
KEY = regex(r"([a-z]\w*(?:\.[\w-]+)+)=")
DONE_HERE = regex(r"sysctl\.(?:conf|d)\b")
OF_KERNEL = regex(r"/proc/sys/([\w./-]+)")
SAVED = regex(r"iptables-save|netfilter-persistent|iptables-persistent|iptables-restore|\bnft\b|\bufw\b")
UNLOADED = ("v4l2loopback", "i2c-dev", "i2c_dev", "slcan", "snd-aloop", "snd_aloop")
"""Modules that no device and no socket loads by itself."""
LOADED = regex(r"/etc/modules|modules-load\.d")
SCRIPT = regex(r"[\w.-]{1,80}\.(?:ba)?sh\b")
STARTS = regex(r"(?m)^[ \t]*(?:exec[ \t]+)?(?:ros2[ \t]+(?:launch|run)[ \t]|\"?\$@)")
"""The script sets the parameter at each start of the robot's software."""
CHANGES = regex(r"\b(?:sysctl|iptables|modprobe)\b|/proc/sys/", hints="sysctl iptables modprobe /proc/sys/")
KNOWN = regex(
    r"^[ \t]*#[^\n]{0,200}\b(?:persist|re-?run"
    r"|(?:each|every|once per|after (?:a |the |each |every )?)[ \t]?(?:re)?(?:boot|start-?up))",
    re.M | re.I,
    "persist run boot start",
)
"""A comment that says that the script is to be run after each boot."""
INSTALLERS = ("apt", "apt-get", "pip", "pip3", "dpkg")


class Lost(NamedTuple):
    """A setting of the running kernel that the next boot takes back."""

    where: Located
    name: str
    becomes: str = "at its default again"
    how: str = "sysctl -w sets"
    advice: str = "write it to a file in /etc/sysctl.d, and run sysctl --system"


@rule("warning", tags=["CWE-1188"], symptoms=["failed to increase socket receive buffer size"])
def sysctl_lost_at_reboot(robot: Robot) -> Iterator[Finding]:
    by_script: dict[Source, list[Lost]] = {}
    for source, run in robot.scripts.run("sysctl"):
        if _key(run, TUNED) and not DONE_HERE.search(source.said) and not robot.sysctl.mentions(_key(run, TUNED)):
            by_script.setdefault(source, []).append(Lost(run.words[0], _key(run, TUNED)))
    for source in robot.of_kind("shell-script"):
        if source.judged and source not in by_script and CHANGES.search(source.text):
            lost = list(_of_set_up(robot, source))
            if lost:
                by_script[source] = lost
    at_each_start = _of_starts(robot) if by_script else set()
    for source, (first, *others) in by_script.items():
        if robot.scripts.starts_by_itself(source) or source.basename in at_each_start or KNOWN.search(source.text):
            continue
        yield finding(
            first.where,
            f"{first.name} is {first.becomes} after the next boot: {first.how} the running kernel only",
            advice=first.advice,
            related=[note(other.where, f"{other.name} is lost too") for other in others],
        )


def _of_starts(robot: Robot) -> set[str]:
    """The names of the scripts that start the software of the robot, and of those that they run."""
    starting = [each for each in robot.of_kind("shell-script") if STARTS.search(each.said)]
    return {name for each in starting for name in (each.basename, *SCRIPT.findall(each.said))}


def _of_set_up(robot: Robot, source: Source) -> Iterator[Lost]:
    """What a script that sets a robot up leaves to the running kernel."""
    did = robot.scripts.done(source)
    if not any(_sets_up(each) for each in did):
        return
    for each in did:
        found = _lost(robot, source, each) if each.certain else None
        if found is not None:
            yield found


def _sets_up(did: Run | Written) -> bool:
    if isinstance(did, Written):
        return did.path.startswith("/etc/")
    if did.name == "systemctl":
        return "enable" in did.words
    if did.name in ("cp", "install"):
        return did.arguments[-1:] != [] and did.arguments[-1].startswith("/etc/")
    return did.name in INSTALLERS and "install" in did.words


def _lost(robot: Robot, source: Source, did: Run | Written) -> Lost | None:
    """A setting that the next boot takes back, with the word of the script that makes it."""
    if isinstance(did, Written):
        of_kernel = OF_KERNEL.fullmatch(did.path)
        key = of_kernel[1].replace("/", ".") if of_kernel else ""
        return Lost(did.where, key, how="a write to /proc sets") if _is_lost(robot, source, key) else None
    if did.name == "sysctl":
        key = _key(did, KEY)
        return Lost(did.words[0], key) if _is_lost(robot, source, key) else None
    if did.name == "iptables" and {"-A", "-I"} & set(did.words) and not robot.mentions(SAVED):
        return Lost(did.words[0], "This rule", "gone", "iptables changes", "run netfilter-persistent save afterwards")
    module = next(iter(did.arguments), "") if did.name == "modprobe" else ""
    if module in UNLOADED and not robot.mentions(LOADED):
        return Lost(did.words[0], module, "not loaded", "modprobe changes", "name it in a file in /etc/modules-load.d")
    return None


def _is_lost(robot: Robot, source: Source, key: str) -> bool:
    """Whether neither the script nor a file of the tree sets a parameter for every boot."""
    return bool(key) and not DONE_HERE.search(source.said) and not robot.sysctl.mentions(key)


def _key(run: Run, pattern: re.Pattern[str]) -> str:
    """The parameter that a command sets; empty for any other command."""
    return next((found[1] for word in run.arguments if (found := pattern.match(word))), "")
