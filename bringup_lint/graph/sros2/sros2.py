"""The security of ROS 2: documents, keystores, enclaves, and the processes that use them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from fnmatch import fnmatchcase
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.sros2 import enclaves as sros2_enclaves
from bringup_lint.graph.sros2 import keystore as sros2_keystore
from bringup_lint.graph.sros2.keystore import Keystore
from bringup_lint.graph.sros2.policed import policed_nodes
from bringup_lint.graph.sros2.secured import Secured
from bringup_lint.graph.sros2.secured import without_enclave
from bringup_lint.graph.sros2.shared import User
from bringup_lint.graph.sros2.shared import shared_enclaves
from bringup_lint.graph.sros2.ungranted import Ungranted
from bringup_lint.graph.sros2.ungranted import ungranted
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Remark
from bringup_lint.model.shell import Command
from bringup_lint.model.sros2 import Governance
from bringup_lint.model.sros2 import Grant
from bringup_lint.model.sros2 import Permissions
from bringup_lint.model.sros2 import moment
from bringup_lint.model.sros2_policy import Policy
from bringup_lint.model.sros2_policy import PolicyEnclave
from bringup_lint.model.sros2_policy import Profile
from bringup_lint.parsers import sros2
from bringup_lint.parsers.certificate import Certificate
from bringup_lint.parsers.certificate import parse as certificate
from bringup_lint.parsers.shell import commands
from bringup_lint.parsers.sros2_policy import policy
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.robot import Robot

_OTHERS = re.compile(r"(?:^|/)(?:tests?|examples?|docs?|samples?|defaults?)/", re.I)
"""Folders whose documents no robot uses."""
_USED = re.compile(r"(?:^|/)(?:governance|permissions)\.(?:xml|p7s|smime)$")
_ENCLAVES = re.compile(r"(?:^|/)enclaves/")
SIGNED_FORMS = (".p7s", ".smime")


@dataclass(eq=False)
class Sros2:
    robot: Robot
    governances: list[Governance] = field(default_factory=list)
    """Templates are left out, and signed files beside the document that was signed."""
    permissions: list[Permissions] = field(default_factory=list)
    policies: list[Policy] = field(default_factory=list)

    moment = staticmethod(moment)
    enclave_of = staticmethod(sros2_enclaves.of_node)
    matches = staticmethod(fnmatchcase)

    @cached_property
    def switched_on(self) -> bool:
        """Whether the tree sets a variable of ROS 2's security."""
        return any(setting.name.startswith("ROS_SECURITY_") for setting in self.robot.ros.settings)

    @cached_property
    def keystores(self) -> list[Keystore]:
        return sros2_keystore.load_keystores(self.robot.tree)

    def anchor(self, folder: str) -> Source:
        return sros2_keystore.anchor(self.robot.tree, folder)

    def anchor_of(self, keystore: Keystore) -> Source:
        """A file of a keystore to point at."""
        return self.anchor(next(iter(keystore.enclaves.values())).folder)

    def ships(self, source: Source) -> bool:
        """Whether a file goes with the repository."""
        return sros2_keystore.ships(self.robot.tree, source)

    @cached_property
    def nodes(self) -> list[Started]:
        """The processes that launch files start."""
        return sros2_enclaves.nodes(self.robot)

    @property
    def without_enclave(self) -> list[list[Secured]]:
        """The secured processes that select no enclave; those that one setting secures together."""
        return without_enclave(self.robot)

    @property
    def shared_enclaves(self) -> Iterator[tuple[User, list[User]]]:
        """A process that moves the robot, and others beside it with the same enclave."""
        return shared_enclaves(self.robot)

    @property
    def ungranted(self) -> Iterator[Ungranted]:
        """Topics that a process uses and that the permissions of its enclave do not allow."""
        return ungranted(self.robot)

    @cached_property
    def selected(self) -> list[Located]:
        """The enclaves that something names, where it does."""
        found = {(id(each.span.source), each.span.start): each for each in sros2_enclaves.selected(self.robot)}
        return [each for each in found.values() if each.span.source.judged]

    @property
    def overridden(self) -> bool:
        """Whether a variable may select the enclave of every process."""
        return self.in_launch("ROS_SECURITY_ENCLAVE_OVERRIDE") or any(
            setting.name == "ROS_SECURITY_ENCLAVE_OVERRIDE" for setting in self.robot.ros.settings
        )

    def in_launch(self, word: str) -> bool:
        """Whether a launch file mentions a word, in whatever way."""
        return any(word in source.text for source in self.robot.of_kind(*LAUNCH))

    @cached_property
    def certificates(self) -> list[tuple[Source, Certificate]]:
        """The certificates that can be read."""
        found = ((source, certificate(source.text)) for source in self.robot.of_kind("sros2-certificate"))
        return [(source, each) for source, each in found if each is not None]

    def common_name(self, source: Source) -> str | None:
        """What the certificate beside a document certifies."""
        folder = source.name.rpartition("/")[0]
        for other, each in self.certificates:
            if other.name == f"{folder}/cert.pem":
                return each.common_name
        return None

    def scripts(self, word: str) -> Iterator[tuple[Source, list[Command]]]:
        """The shell scripts that hold a word, with their commands."""
        for source in self.robot.of_kind("shell-script"):
            if word in source.text and source.judged and not source.template:
                yield source, commands(source.located(0, len(source.text)))

    def signed_text(self, source: Source) -> tuple[Source, str] | None:
        """The document inside the signed file beside a document, when both are in the tree."""
        stem = source.name.rpartition(".")[0]
        for other in self.robot.of_kind(source.kind):
            if other is not source and other.name in [f"{stem}{form}" for form in SIGNED_FORMS]:
                text = sros2.payload(other)
                return None if text is None else (other, text)
        return None

    def governances_of(self, source: Source) -> list[Governance]:
        """The governance of the keystore that a document lies in."""
        return [
            each
            for each in self.governances
            if "enclaves/" in each.source.name
            and source.name.startswith(each.source.name.rpartition("/")[0] + "/")
            and not each.document.problems
        ]

    def is_used(self, source: Source) -> bool:
        """Whether a document is for a robot with ROS 2, and not a sample or another system's."""
        if _ENCLAVES.search(source.name):
            return True
        if _OTHERS.search(source.name):
            return False
        return self.switched_on or bool(_USED.search(source.name))

    def domain_of(self, document: Governance | Permissions) -> tuple[int, Located] | None:
        """The domain of the processes that use the keystore of a document; where nobody names it, that of the robot."""
        users = [each for each in self.robot.ros.processes if self._names_keystore(each, document.source)]
        found: dict[int, Located] = {}
        for process in users:
            variable = process.environment.get("ROS_DOMAIN_ID")
            if variable is not None and variable.text is not None and re.fullmatch(r"\d{1,3}", variable.text):
                found.setdefault(int(variable.text), variable.value)
        if found:
            return next(iter(found.items())) if len(found) == 1 else None
        robots = self.robot.dds_domain
        return robots if robots and self.robot.same_robot(robots[1], document.source) else None

    @staticmethod
    def _names_keystore(process: RosProcess, document: Source) -> bool:
        folder = (process.environment.text("ROS_SECURITY_KEYSTORE") or "").rstrip("/")
        return len(folder) > 1 and folder.startswith("/") and f"{folder}/" in f"{document.robot_path or ''}/"

    @property
    def policy_profiles(self) -> Iterator[Profile]:
        """The rights of nodes in all policies that can be read."""
        for each in self.policies:
            if not each.document.problems:
                yield from (profile for enclave in each.enclaves for profile in enclave.profiles)

    @property
    def policed_nodes(self) -> Iterator[tuple[Started, Located, PolicyEnclave]]:
        """The launched nodes whose enclave a policy describes completely."""
        return policed_nodes(self.robot, [each for each in self.policies if not each.document.problems])

    @property
    def used_policies(self) -> Iterator[Policy]:
        return (each for each in self.policies if not _OTHERS.search(each.source.name))

    @property
    def used_governances(self) -> Iterator[Governance]:
        return (each for each in self.governances if self.is_used(each.source))

    @property
    def ros_grants(self) -> Iterator[tuple[Permissions, Grant]]:
        """The grants to enclaves in documents that a robot uses."""
        for each in self.permissions:
            if self.is_used(each.source):
                yield from ((each, grant) for grant in each.grants if grant.enclave is not None)

    @property
    def grants(self) -> Iterator[tuple[Permissions, Grant]]:
        return ((each, grant) for each in self.permissions for grant in each.grants)

    def remarks(self, *codes: Code) -> Iterator[tuple[Governance | Permissions, Remark]]:
        """What is wrong with the documents, by code."""
        for document in (*self.governances, *self.permissions):
            for remark in document.remarks:
                if remark.code in codes:
                    yield document, remark


def load_sros2(robot: Robot) -> Sros2:
    return Sros2(
        robot,
        robot.parsed(sros2.governance, _sources(robot, "sros2-governance")),
        robot.parsed(sros2.permissions, _sources(robot, "sros2-permissions")),
        robot.parsed(policy, _sources(robot, "sros2-policy")),
    )


def _sources(robot: Robot, kind: str) -> list[Source]:
    found = [source for source in robot.of_kind(kind) if source.judged and not source.template]
    names = {source.name for source in found}
    return [source for source in found if not sros2.is_signed(source) or _plain(source) not in names]


def _plain(source: Source) -> str:
    return source.name.rpartition(".")[0] + ".xml"
