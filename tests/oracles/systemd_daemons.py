"""What systemd's own programs say of the files that no `systemd-analyze verify` reads.

The daemons read `journald.conf`, `logind.conf` and `system.conf` as they start, here in namespaces of their own: no
network, no processes of the host, empty `/run` and `/var/log`. They are ended as soon as they have read their file.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

GENERATOR = Path("/usr/lib/systemd/user-environment-generators/30-systemd-environment-d-generator")
"""Reads the files of `environment.d` with the parser that reads `EnvironmentFile=`."""
_LIB = "/usr/lib/systemd"
_AS_USER = ("setpriv", "--reuid", "65534", "--clear-groups", "env", "HOME=/run", "XDG_RUNTIME_DIR=/run")
DAEMONS: dict[str, tuple[str, ...]] = {
    "journald.conf": ("timeout", "1", f"{_LIB}/systemd-journald"),
    "logind.conf": ("timeout", "1", f"{_LIB}/systemd-logind"),
    "system.conf": (*_AS_USER, f"{_LIB}/systemd", "--test", "--system", "--no-pager"),
}
"""File -> the program that reads it; as a user, `systemd --test` takes it from `user.conf`, which has the same keys."""
_NAMESPACES = ("unshare", "--kill-child", "--mount", "--pid", "--fork", "--net", "--uts", "--ipc", "sh", "-e", "-c")
_PREPARED = """
mount --make-rprivate /
mount -t tmpfs tmpfs /run
mount -t tmpfs tmpfs /var/log
mkdir /run/conf
cp "$1" "/run/conf/$2"
cp "$1" /run/conf/user.conf
chmod -R a+rX /run
mount --bind /run/conf /etc/systemd
shift 2
exec timeout -s KILL 20 "$@"
"""
_RUNS = "systemd-journald running as PID"
"""What a daemon that would stay says once it has read its file."""
_SAID = re.compile(r"^/etc/systemd/[^:]*:\d+: (.*)")


@cache
def can_start_daemons() -> bool:
    """Whether there are the programs, and the right to give them namespaces."""
    if os.name != "posix" or os.geteuid() != 0 or not all(map(shutil.which, ("unshare", "setpriv", "timeout"))):
        return False
    if not all(Path(_LIB, f"systemd{name}").is_file() for name in ("", "-journald", "-logind")):
        return False
    trial = subprocess.run([*_NAMESPACES, "mount -t tmpfs tmpfs /run"], capture_output=True, check=False)
    return trial.returncode == 0


def complaints(path: Path, name: str) -> Counter[str]:
    """What the daemon of a configuration file says of its lines, without their numbers."""
    found = (_SAID.match(line) for line in _said([*_NAMESPACES, _PREPARED, "sh", str(path), name, *DAEMONS[name]]))
    return Counter(re.sub(r"\d+", "0", said[1]) for said in found if said)


def _said(command: list[str]) -> Iterator[str]:
    """The lines of a daemon until it has read its file."""
    environment = {"PATH": os.environ["PATH"], "SYSTEMD_LOG_TARGET": "console", "SYSTEMD_LOG_COLOR": "0"}
    with subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        env={**environment, "SYSTEMD_LOG_LEVEL": "debug"},
    ) as process:
        for line in process.stdout or ():
            yield line
            if line.startswith(_RUNS):
                process.kill()


def of_environment(path: Path) -> Counter[str]:
    """What systemd's reader of environment files says. An empty value is wrong in `environment.d` alone, where it is
    called invalid syntax."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder, "environment.d", "x.conf")
        place.parent.mkdir()
        place.write_bytes(path.read_bytes())
        environment = {"XDG_CONFIG_HOME": folder, "HOME": folder, "SYSTEMD_LOG_TARGET": "console"}
        run = subprocess.run(
            [str(GENERATOR)], capture_output=True, text=True, errors="replace", check=False, env=environment
        )
    lines = (line.rpartition("x.conf:")[2] for line in run.stderr.splitlines() if "x.conf:" in line)
    lines = (line for line in lines if "invalid syntax" not in line)
    return Counter(re.sub(r"\d+", "0", line) for line in lines)
