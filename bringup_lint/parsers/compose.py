"""Compose files (https://github.com/compose-spec/compose-spec), through located YAML nodes."""

from __future__ import annotations

from bringup_lint.model.compose import ComposeFile
from bringup_lint.model.compose import Service
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.parsers import yaml_nodes
from bringup_lint.parsers.shell import words
from bringup_lint.source import Source


def parse(source: Source) -> ComposeFile:
    """Read the services of a compose file. Problems are those of YAML."""
    yaml = yaml_nodes.parse(source)
    file = ComposeFile(source, yaml, problems=list(yaml.problems))
    root = yaml.root
    services = root.mapping("services") if isinstance(root, Mapping) else None
    if services is None:
        return file
    for name, body in services.merged:
        if isinstance(body, Mapping):
            file.services.append(Service(name.value, body, words))
    for service in file.services:
        _extend(service, file)
    return file


def _extend(service: Service, file: ComposeFile) -> None:
    """Follow ``extends`` within the file; a service of another file stays unknown."""
    node = service.body.get("extends")
    name = node
    if isinstance(node, Mapping):
        name = None if node.get("file") is not None else node.get("service")
    base = file.service(str(name.value)) if isinstance(name, Scalar) else None
    chain = base
    while chain is not None and chain is not service:
        chain = chain.base
    if base is not None and chain is not service:
        service.base = base
