"""A script from the network runs at once.

## What it finds
`curl ... | sh`, `wget -O- ... | sudo bash` and the like. It is a warning where the transport is not protected
(`http://`, `curl -k`, `wget --no-check-certificate`), and info otherwise. A file that is loaded with such an option and
run by a later line is a warning too.

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
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

SHELLS = ("sh", "bash", "zsh", "dash", "python3", "python")
INSECURE = regex(r"http://(?!localhost|127\.)\S+")
LOADS = regex(r" (?:-k|--insecure|--no-check-certificate)\b")
UNCHECKED = ("-k", "--insecure", "--no-check-certificate")


@rule("info", silent="the shell runs what it is given", tags=["CWE-494"])
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
    yield from _unchecked(robot)


def _unchecked(robot: Robot) -> Iterator[Finding]:
    """What is loaded without a check of the certificate, kept as a file, and run."""
    kept: dict[tuple[Source, str], Run] = {}
    for source in robot.of_kind("shell-script"):
        if not source.judged or not LOADS.search(source.said):
            continue
        for run in robot.scripts.done(source):
            if not isinstance(run, Run):
                continue
            if run.name in ("curl", "wget") and any(word in UNCHECKED for word in run.arguments):
                kept[source, _file(run)] = run
                continue
            program = run.words[1:2] if run.name in SHELLS else run.words[:1]
            loaded = kept.pop((source, run.text(program[0]).rpartition("/")[2]), None) if program else None
            if loaded is not None:
                option = next(word for word in loaded.arguments if word in UNCHECKED)
                yield finding(
                    loaded.words[0],
                    f"Downloaded with {option}, so without a check of the certificate, and then run: anybody on the "
                    f"network can change {_file(loaded)}",
                    advice="load it with the certificate checked, and check its SHA-256",
                    related=[note(program[0], "it is run here")],
                    severity="warning",
                )


def _file(run: Run) -> str:
    """The name of the file that is written: that of an option, or the last part of the address."""
    words = run.arguments
    for option, value in pairwise(words):
        if option in ("-o", "-O", "--output", "--output-document") and not value.startswith(("-", "http")):
            return value.rpartition("/")[2]
    address = next((word for word in words if "://" in word), "")
    return address.partition("?")[0].rpartition("/")[2] if run.name == "wget" or "-O" in words else ""
