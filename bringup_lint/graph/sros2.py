"""The security of ROS 2: documents, keystores, enclaves, and the processes that use them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.model.sros2 import Governance
from bringup_lint.model.sros2 import Grant
from bringup_lint.model.sros2 import Permissions
from bringup_lint.model.sros2 import Remark
from bringup_lint.model.sros2 import moment
from bringup_lint.parsers import sros2
from bringup_lint.source import Source

if TYPE_CHECKING:
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

    moment = staticmethod(moment)

    @cached_property
    def switched_on(self) -> bool:
        """Whether the tree sets a variable of ROS 2's security."""
        return any(setting.name.startswith("ROS_SECURITY_") for setting in self.robot.ros.settings)

    def is_used(self, source: Source) -> bool:
        """Whether a document is for a robot with ROS 2, and not a sample or another system's."""
        if _ENCLAVES.search(source.name):
            return True
        if _OTHERS.search(source.name):
            return False
        return self.switched_on or bool(_USED.search(source.name))

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

    def remarks(self, *codes: str) -> Iterator[tuple[Governance | Permissions, Remark]]:
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
    )


def _sources(robot: Robot, kind: str) -> list[Source]:
    found = [source for source in robot.of_kind(kind) if source.judged and not source.template]
    names = {source.name for source in found}
    return [source for source in found if not sros2.is_signed(source) or _plain(source) not in names]


def _plain(source: Source) -> str:
    return source.name.rpartition(".")[0] + ".xml"
