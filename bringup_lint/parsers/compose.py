"""Compose files (https://github.com/compose-spec/compose-spec), through located YAML nodes."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.model.compose import ComposeFile
from bringup_lint.model.compose import Service
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import YamlFile
from bringup_lint.parsers import compose_schema
from bringup_lint.parsers import yaml_nodes
from bringup_lint.parsers.shell import commands
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

_NAMED = regex(r"(?:^|/)(?:docker-)?compose(?:[._-][^/]*)?\.ya?ml$", re.I)


def parse(source: Source) -> ComposeFile:
    """Read the services of a compose file. Problems are those of YAML, and ``duplicate`` for keys that appear twice."""
    yaml = yaml_nodes.parse(source)
    file = ComposeFile(source, yaml, problems=[*yaml.problems, *_twice(yaml)])
    root = yaml.root
    if yaml.complete and is_certain(source.name, root):
        file.remarks.extend(compose_schema.remarks(yaml))
    services = root.mapping("services") if isinstance(root, Mapping) else None
    if services is None:
        return file
    for name, body in services.merged:
        if isinstance(body, Mapping):
            file.services.append(Service(name.value, body, _words))
    for service in file.services:
        _extend(service, file)
    for service in [each for each in file.services if _is_too_deep(each)]:
        service.base = None
    return file


def _words(text: Located) -> Iterator[Located]:
    """The words of a command before the first operator, which Compose drops with all that follows it
    (github.com/mattn/go-shellwords); a newline is a blank."""
    for command in commands(text):
        targets = [each.target.span.start for each in command.redirects if each.target is not None]
        end = min(targets, default=text.span.end)
        yield from (word for word in (*command.assignments, *command.words) if word.span.start < end)
        if command.redirects or command.ends not in ("", "\n"):
            return


def is_certain(path: str, root: Node | None) -> bool:
    """Whether nothing but docker compose reads the file: its name says so, or all keys at the top are of compose."""
    if not isinstance(root, Mapping):
        return False
    return bool(_NAMED.search(path)) or all(
        key.value in compose_schema.known_keys("root") or key.value.startswith("x-") for key, _ in root.entries
    )


def _twice(yaml: YamlFile) -> Iterator[Problem]:
    """Keys that appear twice in one mapping, merge keys included: compose refuses them."""
    for node in yaml.nodes:
        if isinstance(node, Mapping):
            for first, again in node.duplicates:
                yield Problem("duplicate", again.value, str(first.value.span.line))
            merges = [key for key, _ in node.entries if key.value == "<<" and not key.style]
            for again in merges[1:]:
                yield Problem("duplicate", again.value, str(merges[0].value.span.line))


_DEEPEST = 50
"""Services that extend one another in a row."""


def _is_too_deep(service: Service) -> bool:
    chain: Service | None = service
    for _ in range(_DEEPEST):
        chain = chain.base if chain is not None else None
    return chain is not None


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
