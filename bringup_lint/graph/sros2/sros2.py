"""The security of ROS 2: documents, keystores, enclaves, and the processes that use them."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.sros2.enclaves import OVERRIDE
from bringup_lint.graph.sros2.enclaves import launched_processes
from bringup_lint.graph.sros2.enclaves import selected
from bringup_lint.graph.sros2.keystore import Keystore
from bringup_lint.graph.sros2.keystore import anchor
from bringup_lint.graph.sros2.keystore import load_keystores
from bringup_lint.graph.sros2.keystore import ships
from bringup_lint.graph.sros2.misspelt_names import MisspeltRight
from bringup_lint.graph.sros2.misspelt_names import misspelt_rights
from bringup_lint.graph.sros2.policed import policed_nodes
from bringup_lint.graph.sros2.secured import Secured
from bringup_lint.graph.sros2.secured import without_enclave
from bringup_lint.graph.sros2.shared import User
from bringup_lint.graph.sros2.shared import shared_enclaves
from bringup_lint.graph.sros2.ungranted import Ungranted
from bringup_lint.graph.sros2.ungranted import grants_of
from bringup_lint.graph.sros2.ungranted import ungranted
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Remark
from bringup_lint.model.shell import Command
from bringup_lint.model.sros2 import AccessRule
from bringup_lint.model.sros2 import DomainRule
from bringup_lint.model.sros2 import Domains
from bringup_lint.model.sros2 import Governance
from bringup_lint.model.sros2 import Grant
from bringup_lint.model.sros2 import Permissions
from bringup_lint.model.sros2_policy import Policy
from bringup_lint.model.sros2_policy import PolicyEnclave
from bringup_lint.model.sros2_policy import Profile
from bringup_lint.parsers import sros2
from bringup_lint.parsers.certificate import Certificate
from bringup_lint.parsers.certificate import parse as certificate
from bringup_lint.parsers.shell import shell_commands
from bringup_lint.parsers.sros2_policy import policy
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.templates import has_control_flow

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.graph.topics.topics import Topics

_OTHERS = regex(r"(?:^|/)(?:tests?|examples?|docs?|samples?|defaults?)/", re.I)
"""Folders whose documents no robot uses."""
_USED = regex(r"(?:^|/)(?:governance|permissions)\.(?:xml|p7s|smime)$")
_APPLIES = regex(r"create_permission|generate_artifacts", hints="create_permission generate_artifacts")
"""What makes permissions from a policy, as a command, in Python and in CMake."""
_ENCLAVES = regex(r"(?:^|/)enclaves/")
SIGNED_FORMS = (".p7s", ".smime")


@dataclass(eq=False)
class Sros2:
    """Asked as ``robot.sros2``: keystores, policies, enclaves, and the processes that are given them."""

    files: Files
    ros: RosEnvironment
    runners: Callable[[], Runners]
    launch: Callable[[], Launch]
    topics: Callable[[], Topics]
    domain: Callable[[], tuple[int, Located] | None]
    """The DDS domain that the files of the tree agree on."""

    @cached_property
    def governances(self) -> list[Governance]:
        """Templates are left out, and signed files beside the document that was signed."""
        return self.files.parsed(sros2.governance, self._sources("sros2-governance"))

    @cached_property
    def permissions(self) -> list[Permissions]:
        return self.files.parsed(sros2.permissions, self._sources("sros2-permissions"))

    @property
    def documents(self) -> list[Governance | Permissions]:
        return [*self.governances, *self.permissions]

    @cached_property
    def policies(self) -> list[Policy]:
        return self.files.parsed(policy, self._sources("sros2-policy"))

    @cached_property
    def policies_and_templates(self) -> list[Policy]:
        """The policies, and the templates of such in which only words are to be filled in."""
        found = (each for each in self.files.of_kind("sros2-policy") if each.judged and each.template)
        return self.policies + self.files.parsed(policy, [each for each in found if not has_control_flow(each.text)])

    def _sources(self, kind: str) -> list[Source]:
        found = [source for source in self.files.of_kind(kind) if source.judged and not source.template]
        names = {source.name for source in found}
        return [source for source in found if not sros2.is_signed(source) or _unsigned_name(source) not in names]

    @cached_property
    def switched_on(self) -> bool:
        """Whether the tree sets a variable of ROS 2's security."""
        return any(setting.name.startswith("ROS_SECURITY_") for setting in self.ros.settings)

    @cached_property
    def keystores(self) -> list[Keystore]:
        return load_keystores(self.files.tree)

    def anchor(self, folder: str) -> Source:
        """A file of an enclave to point at."""
        return anchor(self.files.tree, folder)

    def anchor_of(self, keystore: Keystore) -> Source:
        """A file of a keystore to point at."""
        return self.anchor(next(iter(keystore.enclaves.values())).folder)

    def ships(self, source: Source) -> bool:
        """Whether a file goes with the repository."""
        return ships(self.files.tree, source)

    @property
    def without_enclave(self) -> list[list[Secured]]:
        """The secured processes that select no enclave; those that one setting secures together."""
        launch = self.launch()
        nodes = launched_processes(self.files, launch)
        return without_enclave(self.ros, (each for each in nodes if not launch.never_runs(each)))

    @property
    def shared_enclaves(self) -> Iterator[tuple[User, list[User]]]:
        """A process that moves the robot, and others beside it with the same enclave."""
        return shared_enclaves(self.files, self.ros, self.launch())

    @property
    def ungranted(self) -> Iterator[Ungranted]:
        """Topics that a process uses and that the permissions of its enclave do not allow."""
        if not self.files.of_kind(*LAUNCH):
            return iter(())
        grants = grants_of((grant, self.governances_of(each.source)) for each, grant in self.ros_grants)
        return ungranted(grants, (node for running in self.topics().runs for node in running.nodes) if grants else ())

    @cached_property
    def selected(self) -> list[Located]:
        """The enclaves that something names, where it does."""
        found = {each.span: each for each in selected(self.files, self.ros, self.runners(), self.launch())}
        return [each for each in found.values() if each.span.source.judged]

    @property
    def overridden(self) -> bool:
        """Whether a variable may select the enclave of every process."""
        return self.in_launch(OVERRIDE) or any(setting.name == OVERRIDE for setting in self.ros.settings)

    def in_launch(self, word: str) -> bool:
        """Whether a launch file mentions a word, in whatever way."""
        return any(word in source.text for source in self.files.of_kind(*LAUNCH))

    @cached_property
    def certificates(self) -> list[tuple[Source, Certificate]]:
        """The certificates that can be read."""
        found = ((source, certificate(source.text)) for source in self.files.of_kind("sros2-certificate"))
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
        for source in self.files.of_kind("shell-script"):
            if word in source.text and source.judged and not source.template:
                yield source, shell_commands(source)

    def signed_text(self, source: Source) -> tuple[Source, str] | None:
        """The document inside the signed file beside a document, when both are in the tree."""
        stem = source.name.rpartition(".")[0]
        for other in self.files.of_kind(source.kind):
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

    def is_unset(self, process: RosProcess, name: str) -> bool:
        """Whether neither the environment of a process nor what launch may do to it unseen sets a variable."""
        unseen = not self.ros.is_settled(process) and self.in_launch(name)
        return process.environment.defines(name) is False and not unseen

    def uncovered_domain(
        self, document: Governance | Permissions, rules: Iterable[DomainRule | AccessRule]
    ) -> tuple[int, Located, list[Domains]] | None:
        """The domain of the processes that use a document, where it is written, and the domains that the rules cover
        instead; None when they cover it, or one of the two is not known."""
        used = self.domain_of(document)
        known = [each.domains for each in rules if each.domains is not None]
        if used is None or not known or any(each.covers(used[0]) for each in known):
            return None
        return *used, known

    def domain_of(self, document: Governance | Permissions) -> tuple[int, Located] | None:
        """The domain of the processes that use the keystore of a document; where none names it, that of the robot."""
        users = [each for each in self.ros.processes if self._names_keystore(each, document.source)]
        found: dict[int, Located] = {}
        for process in users:
            variable = process.environment.get("ROS_DOMAIN_ID")
            if variable is not None and variable.text is not None and re.fullmatch(r"\d{1,3}", variable.text):
                found.setdefault(int(variable.text), variable.value)
        if found:
            return next(iter(found.items())) if len(found) == 1 else None
        robots = self.domain()
        return robots if robots and self.files.same_robot(robots[1], document.source) else None

    @staticmethod
    def _names_keystore(process: RosProcess, document: Source) -> bool:
        folder = (process.environment.text("ROS_SECURITY_KEYSTORE") or "").rstrip("/")
        return len(folder) > 1 and folder.startswith("/") and f"{folder}/" in f"{document.robot_path or ''}/"

    @property
    def misspelt_rights(self) -> Iterator[MisspeltRight]:
        """Names of policies that nothing else of the tree has, a letter away from one of others."""
        return misspelt_rights(self.files)

    @property
    def policy_profiles(self) -> Iterator[Profile]:
        """The rights of nodes in all policies that can be read."""
        for each in self.policies_and_templates:
            if not each.document.problems:
                yield from (profile for enclave in each.enclaves for profile in enclave.profiles)

    @property
    def policy_enclaves(self) -> Iterator[PolicyEnclave]:
        """The enclaves whose rights are all in one policy that sros2 accepts, for the robot."""
        for each in self.used_policies:
            if each.open or each.document.problems or each.remarks:
                continue
            for enclave in each.enclaves:
                if not enclave.open and not any(profile.open for profile in enclave.profiles):
                    yield enclave

    @property
    def policed_nodes(self) -> Iterator[tuple[Started, Located, PolicyEnclave]]:
        """The launched nodes whose enclave a policy describes completely."""
        return policed_nodes([each for each in self.policies if not each.document.problems], self.ros, self.launch)

    @property
    def used_policies(self) -> Iterator[Policy]:
        """The policies for a robot, with the templates of such."""
        return (each for each in self.policies_and_templates if not _OTHERS.search(each.source.name))

    def is_unapplied(self, where: Located | Span) -> bool:
        """Whether a place is in a template of a policy of which the tree makes no permissions, or in a policy whose
        script does not: another one may be the one that is used."""
        source = where.span.source if isinstance(where, Located) else where.source
        if source.origin is not None:
            return not _APPLIES.search(source.origin.whole.source.said)
        return bool(source.template) and not self.files.mentions(_APPLIES)

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
        for document in self.documents:
            for remark in document.remarks:
                if remark.code in codes:
                    yield document, remark


def _unsigned_name(source: Source) -> str:
    return source.name.rpartition(".")[0] + ".xml"
