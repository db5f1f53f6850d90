"""A private key or build secret stays in a layer of the image.

## What it finds
COPY or ADD of a private SSH key (`id_rsa`, `id_ed25519`, ...) or of a whole `.ssh` folder into the final image or into
a stage that a build of the tree names as its target, and a RUN that copies a file from `/run/secrets`, from the target
of `--mount=type=secret`, or a key from that of `--mount=type=bind`, to another place and does not remove it in the same
step. A copy that only a condition of the step makes is a warning, and an info where nothing of the tree pushes images
to a registry. A key that `ssh-keygen` makes in a RUN is a warning, too: the host keys of `ssh-keygen -A` and a key that
signs in elsewhere are then the same on every robot. So is a keystore of SROS2 (`ros2 security create_keystore`,
`generate_artifacts`), whose authority signs the participants of all robots; it is info where the command itself says
that these are simulated.

## Why it matters on a robot
Everybody who can pull the image, or has a robot with it, can read the key: `docker save` shows every layer, also when a
later step deletes the file. A key for the repositories then opens all of them.

## Bad
```dockerfile
RUN --mount=type=secret,id=key cp /run/secrets/key /root/.ssh/id_ed25519
```

## Good
```dockerfile
RUN --mount=type=ssh git clone git@example.org:rover/driver.git
```

## When to ignore it
When the image never leaves the machine that built it.

## References
- https://docs.docker.com/build/building/secrets/
- CWE-522: Insufficiently Protected Credentials
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Instruction
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of_run
from bringup_lint.api.ros import is_simulation
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped

KEY = regex(r"(?:^|/)(?:id_(?:rsa|dsa|ecdsa|ed25519)\w*|\.ssh/?)$")
KEYS = regex(r"(?:^|/)(?:id_(?:rsa|dsa|ecdsa|ed25519)\w*|\.ssh(?:/\*?)?)$")
"""Also all files of the folder."""
SECRET = regex(r"/run/secrets/\S+")
TARGET = regex(r"(?:^|,)(?:target|dst|destination)=(?P<path>/[^,]+)")
PUBLIC = regex(r"pub(?:lic)?(?:_key|_keys|\.key)?$|allowed_signers$|known_hosts$")
GONE = regex(r"/(?:tmp|run|dev/shm|var/tmp)/")
CACHE = regex(r"/var/(?:lib/apt|cache)/|/tmp/")
PUSH = regex(r"\bdocker(?:[ \t]+(?:image|compose|buildx))?[ \t]+push\b|--push\b|\bpush:[ \t]*(?:true|\$)", hints="push")
CALLING = regex(r"(?:\.github/workflows/[^/]+|\.gitlab-ci\.yml|Jenkinsfile|Makefile|[jJ]ustfile|\.(?:sh|bash|hcl))$")
MOST = 100_000
KEYSTORE = ("create_keystore", "generate_artifacts")
"""Verbs of `ros2 security` that make an authority."""
OTHER_WORK = regex(r"-[a-zA-Z]{0,8}[FRHlyeispcBDkQrYLMUO]")
"""Options with which ssh-keygen makes no key."""


@rule(
    "error",
    tags=["CWE-522", "CWE-538"],
    symptoms=["SecretsUsedInArgOrEnv: Do not use ARG or ENV instructions for sensitive data"],
)
def secret_in_layer(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if file.final is None:
            continue
        ends = [stage for stage in file.stages if stage is file.final or robot.compose.images.is_target(stage)]
        stages = {id(stage): stage for end in ends for stage in end.chain}
        for stage in stages.values():
            if stage.start.keyword.span.source is file.source:
                yield from (_stays(word) for word in _copied(stage))
                yield from _kept(robot, stage)


def _is_pushed(robot: Robot) -> bool:
    """Whether something of the tree puts images into a registry."""
    return robot.tree.says(CALLING, MOST, PUSH)


def _copied(stage: Stage) -> Iterator[Located]:
    """The private keys that COPY and ADD take from the build context."""
    for instruction in stage.all("COPY", "ADD"):
        if instruction.exec_form is None and not any(flag.startswith("--from") for flag in instruction.flags):
            yield from (word for word in list(instruction.value.words())[:-1] if KEY.search(word))


def _kept(robot: Robot, stage: Stage) -> Iterator[Finding]:
    """What each step writes to a place that stays: build secrets, and keys that it makes."""
    for instruction in stage.all("RUN"):
        commands = list(commands_of_run(instruction))
        if any(map(_removes, commands)):
            continue
        mounts = _mounts(instruction)
        written = [(word, command) for command in commands for word in _written(command, mounts)]
        if written:
            certain = any(command.depth == 0 for _, command in written)
            yield _stays(
                *(word for word, _ in written), severity=None if certain else "warning" if _is_pushed(robot) else "info"
            )
        yield from (_made(command) for command in commands if _makes(command))


def _removes(command: Command) -> bool:
    """Whether it removes files, other than what package managers leave behind."""
    if command.name not in ("rm", "shred"):
        return False
    return not all(word.startswith("-") or CACHE.match(word) for word in command.words[1:])


def _stays(word: Located, *others: Located, severity: str | None = None) -> Finding:
    return finding(
        word,
        f"'{word}' stays in a layer of the image: everybody who can pull it can read the secret",
        advice="use RUN --mount=type=ssh, or --mount=type=secret without a copy, and change the secret",
        related=[note(other, "stays, too") for other in others],
        severity=severity,
    )


def _mounts(run: Instruction) -> dict[str, bool]:
    """Where a step has files that no layer holds, and whether each of them is a secret."""
    found = {}
    for flag in run.flags:
        options = flag.partition("=")[2] if flag.startswith("--mount=") else ""
        target = TARGET.search(options)
        kind = options.partition("type=")[2].partition(",")[0]
        if target is not None and (kind == "secret" or (kind in ("", "bind") and "from=" not in options)):
            found[target["path"].rstrip("/")] = kind == "secret"
    return found


def _is_secret(word: str, mounts: dict[str, bool]) -> bool:
    if PUBLIC.search(word):
        return False
    for path, secret in mounts.items():
        if word == path or word.startswith(f"{path}/"):
            return secret or KEYS.search(word) is not None
    return SECRET.fullmatch(word) is not None


def _written(command: Command, mounts: dict[str, bool]) -> Iterator[Located]:
    words = unwrapped(command.words)
    name = program_name(words[0]) if words else ""
    secrets = [word for word in words[1:] if _is_secret(word, mounts)]
    if name in ("cp", "install", "mv") and secrets and not GONE.match(words[-1]):
        yield from secrets[:1]
    elif name in ("cat", "base64") and command.ends != "|" and secrets:
        targets = [redirect.target for redirect in command.redirects if redirect.writes and redirect.target]
        if any(target.startswith(("/", "~", "$")) and not GONE.match(target) for target in targets):
            yield from secrets[:1]


def _makes(command: Command) -> bool:
    """Whether ssh-keygen makes a key at a place that stays, or ros2 an authority."""
    words = unwrapped(command.words)
    if _makes_authority(words):
        return True
    if not words or program_name(words[0]) != "ssh-keygen":
        return False
    if "-A" in words:
        return True
    at = words.index("-f") + 1 if "-f" in words else len(words)
    options = [word for word in words[1:] if word.startswith("-")]
    return at < len(words) and not GONE.match(words[at]) and not any(map(OTHER_WORK.fullmatch, options))


def _makes_authority(words: tuple[Located, ...]) -> bool:
    """Whether ros2 makes a keystore, with the key of its authority, at a place that stays."""
    is_keystore = words[:2] == ("ros2", "security") and len(words) > 3 and words[2] in KEYSTORE
    return is_keystore and not any(map(GONE.match, words[3:]))


def _made(command: Command) -> Finding:
    host = "-A" in command.words
    words = unwrapped(command.words)
    if _makes_authority(words):
        return finding(
            command.words[0],
            "The authority of the keystore is made in the image: who can pull it can sign participants of every robot",
            advice="make the keystore outside of the image, and mount the enclaves of each robot",
            severity="info" if is_simulation(" ".join(words)) else "warning",
        )
    return finding(
        command.words[0],
        "The host keys of SSH are made in the image: every robot has the same, and who can pull it can pose as any"
        if host
        else "A private key is made in the image: every robot has the same, and who can pull it can read it",
        advice="make the key when the robot starts for the first time" + (": ssh-keygen -A" if host else ""),
        severity="warning",
    )
