"""Parameters of C++ nodes whose changes are heard of, and whose first value is never read."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.graph.memo import memo
from bringup_lint.model.cpp_text import COMMENT
from bringup_lint.model.cpp_text import end_of_block
from bringup_lint.model.node_source import Parameter
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.cpp_source import CppNode

_REGISTERS = regex(r"\badd_on_set_parameters_callback\b")
_READS_OTHERS = regex(
    r"\b(?:get_parameters|get_parameters_by_prefix|list_parameters|get_parameter_or|declare_parameters"
    r"|ParameterEventHandler|AsyncParametersClient|SyncParametersClient|ParamListener|add_post_set_parameters_callback"
    r"|set_parameters?|set_parameters_atomically)\b"
    r"|\bget_parameter\s{0,3}(?:<[\w:<> ]{1,60}>)?\s{0,3}\((?!\s{0,20}\")"
)
"""What may read parameters by names that are not literal, or hand their values to the callback."""
_COMPARED = regex(r"(?:get_name\(\)|\.name)\s{0,9}==\s{0,9}\Z")
FILES = 200
"""Files of a package that are searched."""


def heard_parameters(nodes: Nodes) -> Iterator[tuple[CppNode, Parameter]]:
    """Those that are declared before the callback for changes is registered, and are then only named by it."""
    for node in nodes.cpp:
        if node.declares_others or not node.parameters or nodes.launch.workspace.is_vendored(node.source):
            continue
        if len(_REGISTERS.findall(node.source.text)) != 1:
            continue
        texts = package_texts(nodes, node.source)
        if any(_READS_OTHERS.search(text) for text in texts):
            continue
        for parameter in node.parameters:
            if _is_only_heard(node.source, parameter, texts):
                yield node, parameter


def package_texts(nodes: Nodes, source: Source) -> list[str]:
    """The C++ files of the package of a source, without comments."""
    owner = nodes.launch.workspace.owner(source)
    return [COMMENT.sub("", source.text)] if owner is None else _texts_below(nodes, owner.folder)


@memo
def _texts_below(nodes: Nodes, folder: str) -> list[str]:
    paths = [path for path in nodes.files.tree.walked_below(folder) if path.endswith(CPP)]
    found = (nodes.files.tree.read(path, judged=False) for path in paths[:FILES])
    return [COMMENT.sub("", each.text) for each in found if each is not None]


def _is_only_heard(source: Source, parameter: Parameter, texts: list[str]) -> bool:
    before, after = source.text[: parameter.span.start], source.text[parameter.span.end :]
    line = before[before.rfind(";") + 1 :] if ";" in before[-200:] else before[-200:]
    if COMMENT.sub("", line).strip()[-1:] not in ("", "{", "}"):
        return False
    register = _REGISTERS.search(after)
    if register is None or not _is_same_function(COMMENT.sub("", after[: register.start()])):
        return False
    named = [text[: each.start()] for text in texts for each in re.finditer(f'"{re.escape(parameter.name)}"', text)]
    return len(named) > 1 and sum(not _COMPARED.search(text[-40:]) for text in named) == 1


def _is_same_function(between: str) -> bool:
    """Whether no block that was open before a piece of code ends in it."""
    return end_of_block(between, 0) == len(between)
