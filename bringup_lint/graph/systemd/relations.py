"""The settings that relate units to each other, as kinds of edges (systemd.unit(5))."""

from __future__ import annotations

PULLS = {
    "Requires": "requires",
    "Requisite": "requisite",
    "BindsTo": "binds-to",
    "Wants": "wants",
    "Upholds": "upholds",
}
HARD = frozenset({"requires", "binds-to"})
PULLING = frozenset({"requires", "binds-to", "wants", "upholds"})
"""Edges that bring the target into the transaction of the source."""
INSTALLED = {"WantedBy": "wants", "RequiredBy": "requires", "UpheldBy": "upholds"}
OTHER = {"PartOf": "part-of", "Conflicts": "conflicts", "OnFailure": "on-failure", "OnSuccess": "on-success"}
STARTING = PULLING | {"triggers", "on-failure", "on-success"}
"""Edges by which the source starts the target."""
ROOTS = ("default.target", "graphical.target", "multi-user.target")
"""What the boot starts."""
