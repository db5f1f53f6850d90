"""The kinds of file that are YAML, whatever they are called."""

from __future__ import annotations

YAML_KINDS = frozenset(
    {
        "ansible",
        "ansible-vars",
        "cloud-init",
        "cloud-init-network",
        "code-server",
        "compose",
        "driver-config",
        "launch-yaml",
        "netplan",
        "params",
    }
)
