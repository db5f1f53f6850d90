"""The connection plugins that variables and plays name, against those of Ansible and its collections."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.parsers.ansible_tasks import plays
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_SET = regex(r"\bansible_connection[ \t]*[:=][ \t]*[\"']?(?P<name>[a-z]\w*)[\"']?[ \t]*(?=[#\r\n]|\Z)")
_KNOWN = frozenset(
    "ssh local smart paramiko paramiko_ssh psrp winrm aws_ssm buildah chroot docker docker_api fortimanager funcd grpc"
    " httpapi incus iocage jail kubectl libvirt_lxc lxc lxd lxd_incus napalm netconf network_cli nsenter oc persistent"
    " podman podman_unshare proxmox_pct_remote proxmox_qm_remote qubes saltstack vmware_tools wsl zone".split()
)
"""Those of ansible-core, and what ``ansible_builtin_runtime.yml`` redirects to collections."""


def unknown_connections(files: Files) -> Iterator[Located]:
    """The words that are the name of no plugin, in a tree that brings none."""
    found = [name for source in files.of_kind("ansible-vars", "ansible") for name in _named(source)]
    unknown = [name for name in found if name not in _KNOWN]
    if unknown and not any("/connection_plugins/" in f"/{path}" for path in files.tree.paths):
        yield from unknown


def _named(source: Source) -> Iterator[Located]:
    if not source.judged or "connection" not in source.text:
        return
    for match in _SET.finditer(source.text):
        if "#" not in source.line_before(match.start()):
            yield source.located(*match.span("name"))
    for play in plays(source):
        given = play.scalar("connection")
        if given is not None and given.value.isidentifier():
            yield given.value
