"""How a kind of file writes a comment on a line of its own."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Source


class Form(NamedTuple):
    """A comment on a line of its own."""

    opens: str
    closes: str = ""

    def __call__(self, text: str) -> str:
        return " ".join(filter(None, (self.opens, text, self.closes)))


HASH = Form("#")
XML = Form("<!--", "-->")
_CPP = Form("//")

XML_KINDS = frozenset(
    {
        "cyclonedds",
        "fastdds",
        "launch-ros1",
        "launch-xml",
        "ros-package",
        "sros2-governance",
        "sros2-permissions",
        "sros2-policy",
        "urdf",
    }
)
_NO_COMMENTS = frozenset({"sros2-certificate", "sros2-key", "ssh-private-key"})
_NO_COMMENTS_IN = ("cmdline.txt",)
"""Files of which every word goes to the kernel."""
PYTHON_KINDS = frozenset({"launch-python", "python-node", "setup-py"})
CPP_KINDS = frozenset({"cpp-driver", "cpp-node"})
SHELL_KINDS = frozenset({"dockerfile", "shell-script"})


def form_of(source: Source) -> Form | None:
    """The comment of a file's format; None where the format has no comments, such as JSON and keys."""
    if not source.kind or source.virtual or source.kind in _NO_COMMENTS or source.basename in _NO_COMMENTS_IN:
        return None
    if source.name.endswith((".json", ".p7s")):
        return None
    if source.kind in XML_KINDS:
        return XML
    return _CPP if source.kind in CPP_KINDS else HASH


def starts_of(source: Source) -> tuple[str, ...]:
    """What a line that is only a comment begins with."""
    if source.kind in XML_KINDS:
        return ("<!--",)
    return ("//",) if source.kind in CPP_KINDS else ("#", ";", "//")
