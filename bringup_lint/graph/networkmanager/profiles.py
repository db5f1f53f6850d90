"""The profiles that NetworkManager reads together on one robot, and what they make of its interfaces."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatch
from itertools import combinations

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.files import Files
from bringup_lint.model.netplan import Address as NetplanAddress
from bringup_lint.model.netplan import Interface
from bringup_lint.model.netplan import Plan
from bringup_lint.model.networkmanager import Address
from bringup_lint.model.networkmanager import Profile
from bringup_lint.model.schema import Remark
from bringup_lint.parsers.networkmanager import parse
from bringup_lint.source import Located
from bringup_lint.source import Problem


@dataclass(eq=False)
class NetworkManager:
    profiles: list[Profile]
    """Templates, whose text is not final, are left out."""

    @property
    def folders(self) -> list[list[Profile]]:
        """The profiles of each folder: only these are certainly of one robot."""
        found: dict[str, list[Profile]] = {}
        for profile in self.profiles:
            found.setdefault(profile.source.name.rpartition("/")[0], []).append(profile)
        return list(found.values())

    @property
    def judged(self) -> list[Profile]:
        return [profile for profile in self.profiles if profile.source.judged]

    def problems(self, *codes: str) -> Iterator[tuple[Profile, Problem]]:
        """What NetworkManager refuses or ignores, by code."""
        for profile in self.judged:
            yield from ((profile, problem) for problem in profile.problems if problem.code in codes)

    def remarks(self, *codes: str) -> Iterator[Remark]:
        """Those of the problems that are about an item of the schema, such as an unknown key or a wrong value."""
        return (problem for _, problem in self.problems(*codes) if isinstance(problem, Remark))

    @property
    def pairs(self) -> Iterator[tuple[Profile, Profile]]:
        """Two profiles of one folder that NetworkManager brings up on different interfaces."""
        for folder in self.folders:
            active = [each for each in folder if each.comes_up and each.interface is not None]
            yield from (pair for pair in combinations(active, 2) if pair[0].interface != pair[1].interface)

    def configures(self, name: str) -> bool:
        """Whether a profile certainly or possibly gives an interface of this name its addresses."""
        return any(_matches(profile, name) for profile in self.profiles)

    @property
    def addresses(self) -> Iterator[tuple[Profile, Address]]:
        return ((profile, address) for profile in self.profiles for address in profile.addresses)


def _matches(profile: Profile, name: str) -> bool:
    if profile.interface is not None:
        return profile.interface == name
    patterns = [each for each in str(profile.get("match", "interface-name") or "").split(";") if each]
    kinds = {"ethernet": "e", "wifi": "w"}
    if patterns:
        return any(fnmatch(name, pattern.lstrip("|&")) for pattern in patterns)
    return profile.type in kinds and name.startswith(kinds[profile.type])


def colliding(one: Profile, other: Profile) -> Iterator[tuple[Address, Address]]:
    """Static addresses of two profiles that lie in one subnet."""
    for mine in one.addresses:
        for theirs in other.addresses:
            if mine.ip.version == theirs.ip.version and mine.ip.network.overlaps(theirs.ip.network):
                yield mine, theirs


def colliding_netplan(
    manager: NetworkManager, plan: Plan | None
) -> Iterator[tuple[Profile, Address, Interface, NetplanAddress]]:
    """Static addresses of profiles in the subnet of another interface of netplan."""
    if plan is None or not plan.whole:
        return
    named = [profile for profile in manager.judged if profile.comes_up and profile.interface is not None]
    for profile in named:
        for interface in plan.interfaces.values():
            if interface.device is None or interface.device == profile.interface:
                continue
            for mine in profile.addresses:
                for theirs in interface.addresses:
                    if theirs.ip is not None and theirs.ip.network.overlaps(mine.ip.network):
                        yield profile, mine, interface, theirs


def alone_off(folder: list[Profile]) -> Located | None:
    """``autoconnect=false`` of the only Wi-Fi profile in a folder, where it joins a network and no other comes up."""
    if any(profile.type != "wifi" and profile.flag("connection", "autoconnect", True) for profile in folder):
        return None
    wireless = [profile for profile in folder if profile.type == "wifi" and not _is_access_point(profile)]
    if len(wireless) != 1 or wireless[0].flag("connection", "autoconnect", True):
        return None
    return wireless[0].get("connection", "autoconnect")


def _is_access_point(profile: Profile) -> bool:
    return any(profile.get(section, "mode") in ("ap", "adhoc", "mesh") for section in ("wifi", "802-11-wireless"))


def load_networkmanager(files: Files) -> NetworkManager:
    sources = [source for source in files.of_kind("networkmanager") if not source.template]
    return NetworkManager(files.parsed(parse, sources))
