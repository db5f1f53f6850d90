"""Asks the real sshd under an account without rights: run by root, it demands /run/sshd, which the service makes."""

from __future__ import annotations

import os
import pwd
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

SSHD = shutil.which("sshd", path=f"{os.environ.get('PATH', '')}:/usr/sbin:/sbin")
ACCOUNT = "nobody"


@contextmanager
def sshd_folder() -> Iterator[Path]:
    """A folder with a host key that the account can read, below none of root's."""
    with tempfile.TemporaryDirectory(prefix="sshd-") as name:
        folder = Path(name)
        subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", str(folder / "key")], check=True)
        if os.geteuid() == 0:
            for path in (folder, *folder.iterdir()):
                os.chown(path, pwd.getpwnam(ACCOUNT).pw_uid, -1)
        yield folder


def sshd(folder: Path, text: str, *options: str) -> subprocess.CompletedProcess[str]:
    """``sshd OPTIONS`` with the configuration, which is the file ``config`` of the folder."""
    file = folder / "config"
    file.write_bytes(text.encode("utf-8"))
    return subprocess.run(
        [str(SSHD), "-f", str(file), "-h", str(folder / "key"), *options],
        capture_output=True,
        text=True,
        errors="replace",
        check=False,
        user=ACCOUNT if os.geteuid() == 0 else None,
    )


def version() -> str:
    """Such as ``sshd 9.2``; without the number where it is not installed."""
    if SSHD is None or shutil.which("ssh-keygen") is None:
        return "sshd"
    run = subprocess.run([SSHD, "-V"], capture_output=True, text=True, check=False)
    found = re.search(r"OpenSSH_([\w.]+)", run.stderr + run.stdout)
    return f"sshd {found[1] if found else 'of OpenSSH'}"
