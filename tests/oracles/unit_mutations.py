"""Unit files with one to six mistakes of every sort, the same in every run."""

from __future__ import annotations

import random
from collections.abc import Callable
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from bringup_lint.facts.systemd import directives
from tests.oracles.verify import systemd_version

LETTERS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
BASES = {
    "service": "[Service]\nType=oneshot\nExecStart=/bin/true\n",
    "timer": "[Timer]\nOnBootSec=5min\nUnit=stub.service\n",
    "socket": "[Socket]\nListenStream=/run/mutant.sock\nService=stub.service\n",
    "path": "[Path]\nPathExists=/run/mutant\nUnit=stub.service\n",
    "target": "",
}
SINGLE_USE = {"Unit", "Slice", "Service"}
"""Keys whose second assignment is another mistake than the one that is meant."""


class Mutant(NamedTuple):
    name: str
    text: str


def keys_of(section: str) -> list[directives.Directive]:
    """Keys that the installed release knows and that are not obsolete."""
    return [
        found
        for found in directives.of_section(section)
        if found.since <= systemd_version()
        and (section, found.key, "") not in directives.legacy()
        and found.type != "ignored"
    ]


def mutants(count: int, values: Callable[[str], list[str]], seed: str = "verify") -> Iterator[Mutant]:
    """``values`` gives right and wrong values for a value type."""
    chance = random.Random(seed)
    kinds = ["service"] * 6 + ["timer", "socket", "path", "target"]
    for number in range(count):
        kind = chance.choice(kinds)
        yield Mutant(f"mutant{number}.{kind}", _text(chance, kind, values))


def _text(chance: random.Random, kind: str, values: Callable[[str], list[str]]) -> str:
    own = directives.SECTION_OF_TYPE[kind]
    unit = ["[Unit]"] + [_line(chance, "Unit", kind, values) for _ in range(chance.randrange(3))]
    main = BASES[kind].splitlines() or [f"[{own}]"]
    main += [_line(chance, own, kind, values) for _ in range(chance.randrange(1, 5))]
    install = ["[Install]", "WantedBy=multi-user.target"]
    if chance.random() < 0.1:
        install.append(_line(chance, "Install", kind, values))
    blocks = [unit, main, install]
    if chance.random() < 0.08:
        name = chance.choice(["service", "Srevice", "Timr", "X-Other", "Mount", "unit"])
        blocks.insert(1, [f"[{name}]", "Anything=goes"])
    head = "Stray=line\n" if chance.random() < 0.03 else ""
    return head + "\n".join("\n".join(block) + "\n" for block in blocks)


def _line(chance: random.Random, section: str, kind: str, values: Callable[[str], list[str]]) -> str:
    keys = [found for found in keys_of(section) if values(found.type)]
    roll = chance.random()
    if roll < 0.12 or not keys:
        return f"{_misspelt(chance, chance.choice(keys or keys_of('Unit')).key)}=1"
    if roll < 0.2:
        other = chance.choice([name for name in directives.sections_of_type(kind) if name != section])
        foreign = [found.key for found in keys_of(other)]
        return f"{chance.choice(foreign or ['ExecStart'])}=x"
    if roll < 0.24:
        return chance.choice(["no equals sign", "=value", "X-Note=anything", "# comment = none", "; comment"])
    if roll < 0.28:
        continued = "\\\n"
        return f"Environment=A=1 {continued}  B=2" if section == "Service" else f"Description=a {continued} b"
    key = chance.choice([found for found in keys if found.key not in SINGLE_USE])
    return f"{key.key}={chance.choice(values(key.type))}"


def _misspelt(chance: random.Random, key: str) -> str:
    at = chance.randrange(len(key))
    act = chance.randrange(4)
    if act == 0:
        return key[:at] + key[at + 1 :] or "Z"
    if act == 1:
        return key[:at] + chance.choice(LETTERS) + key[at:]
    if act == 2:
        return key[:at] + key[at].swapcase() + key[at + 1 :]
    return key[: at + 1] + key[at:]


def cycles() -> Iterator[list[Mutant]]:
    """Rings of 2 to 5 units, written with After= or Before=, required or wanted; and chains that are none."""
    for size in (2, 3, 4, 5):
        for order in ("After", "Before"):
            for pull in ("Requires", "Wants"):
                for closed in (True, False):
                    stem = f"{order}{pull}{size}{'ring' if closed else 'chain'}".lower()
                    yield [_member(stem, at, size, order, pull, closed or at + 1 < size) for at in range(size)]


def _member(stem: str, at: int, size: int, order: str, pull: str, joined: bool) -> Mutant:
    following = f"{stem}{(at + 1) % size}.service"
    unit = f"[Unit]\n{order}={following}\n{pull}={following}\n" if joined else "[Unit]\n"
    return Mutant(f"{stem}{at}.service", f"{unit}[Service]\nExecStart=/bin/true\n")


REFUSALS = {
    "noexec.service": "[Service]\nType=oneshot\n",
    "onlystop.service": "[Service]\nExecStop=/bin/true\n",
    "stopremain.service": "[Service]\nExecStop=/bin/true\nRemainAfterExit=yes\n",
    "stopexec.service": "[Service]\nType=exec\nExecStop=/bin/true\nRemainAfterExit=yes\n",
    "success.service": "[Unit]\nSuccessAction=reboot\n[Service]\nType=oneshot\n",
    "reset.service": "[Service]\nExecStart=/bin/true\nExecStart=\n",
    "twice.service": "[Service]\nExecStart=/bin/true\nExecStart=/bin/false\n",
    "twicereset.service": "[Service]\nExecStart=/bin/true\nExecStart=\nExecStart=/bin/false\n",
    "semicolon.service": "[Service]\nExecStart=/bin/true ; /bin/false\n",
    "notsemicolon.service": "[Service]\nExecStart=/bin/true \\; /bin/false\n",
    "twiceoneshot.service": "[Service]\nType=oneshot\nExecStart=/bin/true\nExecStart=/bin/false\n",
    "oneshotalways.service": "[Service]\nType=oneshot\nExecStart=/bin/true\nRestart=always\n",
    "oneshotsuccess.service": "[Service]\nType=oneshot\nExecStart=/bin/true\nRestart=on-success\n",
    "oneshotfailure.service": "[Service]\nType=oneshot\nExecStart=/bin/true\nRestart=on-failure\n",
    "dbus.service": "[Service]\nType=dbus\nExecStart=/bin/true\n",
    "dbusname.service": "[Service]\nType=dbus\nBusName=org.example.A\nExecStart=/bin/true\n",
    "nothing.timer": "[Timer]\nUnit=stub.service\n",
    "clock.timer": "[Timer]\nOnClockChange=yes\nUnit=stub.service\n",
    "calendar.timer": "[Timer]\nOnCalendar=daily\nUnit=stub.service\n",
    "resettimer.timer": "[Timer]\nOnCalendar=daily\nOnCalendar=\nUnit=stub.service\n",
    "nothing.socket": "[Socket]\nService=stub.service\n",
    "listen.socket": "[Socket]\nListenDatagram=9999\nService=stub.service\n",
    "alone.socket": "[Socket]\nListenStream=9998\n",
    "nothing.path": "[Path]\nUnit=stub.service\n",
    "glob.path": "[Path]\nPathExistsGlob=/run/*\nUnit=stub.service\n",
    "mnt-a.mount": "[Mount]\nWhere=/mnt/a\n",
    "mnt-b.mount": "[Mount]\nWhat=/dev/sda1\nWhere=/mnt/b\n",
    "mnt-c.mount": "[Mount]\nWhat=/dev/sda1\nWhere=/mnt/other\n",
    "mnt-d\\x2de.mount": "[Mount]\nWhat=/dev/sda1\nWhere=/mnt/d-e\n",
    "mnt-d-f.mount": "[Mount]\nWhat=/dev/sda1\nWhere=/mnt/d-f\n",
    "ros.service": "[Service]\nExecStart=ros2 launch a b\n",
    "header.service": "[Unit\nDescription=x\n[Service]\nExecStart=/bin/true\n",
    "requires.service": "[Unit]\nRequires=nowhere-to-be-found.service\n[Service]\nExecStart=/bin/true\n",
    "wants.service": "[Unit]\nWants=nowhere-to-be-found.service\n[Service]\nExecStart=/bin/true\n",
    "empty.service": "",
}
"""Units that systemd refuses or takes as a whole."""


ROOT = {
    "usr/lib/systemd/system/base.service": "[Service]\nExecStart=/bin/true\n",
    "usr/lib/systemd/system/base.service.d/10-low.conf": "[Service]\nRestartSec=5sek\n",
    "etc/systemd/system/base.service.d/20-high.conf": "[Service]\nMemoryMax=2GB\n",
    "etc/systemd/system/second.service": "[Service]\nExecStart=/bin/true\n",
    "etc/systemd/system/second.service.d/more.conf": "[Service]\nExecStart=/bin/false\n",
    "etc/systemd/system/reset.service": "[Service]\nExecStart=/bin/true\n",
    "etc/systemd/system/reset.service.d/more.conf": "[Service]\nExecStart=\nExecStart=/bin/false\n",
    "etc/systemd/system/gone.service": "[Service]\nExecStart=/bin/true\n",
    "etc/systemd/system/gone.service.d/none.conf": "[Service]\nExecStart=\n",
    "usr/lib/systemd/system/shadow.service": "[Service]\nExecStart=/bin/true\nRestartSec=bad\n",
    "etc/systemd/system/shadow.service": "[Service]\nExecStart=/bin/true\nRestartSec=5\n",
    "usr/lib/systemd/system/same.service": "[Service]\nExecStart=/bin/true\n",
    "usr/lib/systemd/system/same.service.d/a.conf": "[Service]\nNice=99\n",
    "etc/systemd/system/same.service.d/a.conf": "[Service]\nNice=5\n",
    "etc/systemd/system/notconf.service": "[Service]\nExecStart=/bin/true\n",
    "etc/systemd/system/notconf.service.d/a.txt": "[Service]\nNice=99\n",
    "etc/systemd/system/robot-nav.service": "[Service]\nExecStart=/bin/true\n",
    "etc/systemd/system/robot-.service.d/all.conf": "[Service]\nWatchDogSec=5\n",
    "etc/systemd/system/service.d/everywhere.conf": "[Service]\nUMask=0999\n",
    "etc/systemd/system/inst@.service": "[Service]\nExecStart=/bin/echo %i\n",
    "etc/systemd/system/inst@.service.d/a.conf": "[Service]\nKillSignal=sigint\n",
    "etc/systemd/system/inst@one.service.d/b.conf": "[Service]\nKillMode=maybe\n",
    "etc/systemd/system/late.service": "[Service]\nType=oneshot\nExecStart=/bin/true\n",
    "etc/systemd/system/late.service.d/r.conf": "[Service]\nRestart=always\n",
    "etc/systemd/system/cleared.service": "[Unit]\nAfter=, x\n[Service]\nExecStart=/bin/true\n",
    "etc/systemd/system/misplaced.service": "[Service]\nExecStart=/bin/true\n",
    "etc/systemd/system/misplaced.service.d/u.conf": "[Service]\nOnFailure=x.service\n[Unit]\nUser=root\n",
}
"""A root file system with drop-ins; verified by name with --root."""
ROOT_UNITS = "base second reset gone shadow same notconf robot-nav inst@one late cleared misplaced".split()


def write(folder: Path, files: Iterator[Mutant] | list[Mutant]) -> list[Path]:
    found = []
    for mutant in files:
        path = folder / mutant.name
        path.write_text(mutant.text, "utf-8")
        found.append(path)
    return found
