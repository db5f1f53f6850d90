"""What pip installs for a command that needs more than the package itself."""

from __future__ import annotations

REPOSITORY = "https://github.com/bringup-lint/bringup-lint"


def installed_by(extra: str) -> str:
    """The command that installs an extra: from the repository, because no version is on the package index yet."""
    return f"pip install 'bringup-lint[{extra}] @ git+{REPOSITORY}'"
