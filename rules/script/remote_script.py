"""A script from the network runs at once.

## What it finds
`curl ... | sh`, `wget -O- ... | sudo bash` and the like. It is a warning where the transport is not protected
(`http://`, `curl -k`, `wget --no-check-certificate`), and info otherwise.

## Why it matters on a robot
Whoever controls the server, or the network in between, decides what runs on the robot, mostly as root. Two robots
that were set up in two months differ, and a set-up without a network fails.

## Bad
```sh
curl http://get.example.org/install.sh | sudo bash
```

## Good
```sh
curl -fsSLo install.sh https://get.example.org/v1.4/install.sh
echo '...  install.sh' | sha256sum --check
sudo bash install.sh
```

## When to ignore it
When the vendor offers no other way and the transport is protected.

## References
- CWE-494: Download of Code Without Integrity Check
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

SHELLS = ("sh", "bash", "zsh", "dash", "python3", "python")
INSECURE = regex(r"http://(?!localhost|127\.)\S+")
UNCHECKED = ("-k", "--insecure", "--no-check-certificate")


@rule("info", tags=["CWE-494"])
def remote_script(robot: Robot) -> Iterator[Finding]:
    loading = None
    for source, run in robot.scripts.run("curl", "wget", *SHELLS):
        if run.name in ("curl", "wget"):
            loading = run if run.command.ends == "|" else None
            continue
        if loading is None or loading.words[0].span.source is not source or len(run.words) > 1 + run.reads_input:
            loading = None
            continue
        words = loading.arguments
        open_to_all = any(INSECURE.match(word) for word in words) or any(word in UNCHECKED for word in words)
        how = "and anybody in between can change it" if open_to_all else "unseen"
        yield finding(
            loading.words[0],
            f"{run.name} runs what the network delivers, {how}",
            advice="download a named version, check its SHA-256, then run it",
            severity="warning" if open_to_all else "info",
        )
        loading = None
