"""How Cyclone DDS finds others: the peers that are written in a file."""

from __future__ import annotations

import pytest

from bringup_lint.graph.dds.cyclonedds_discovery import peers
from bringup_lint.parsers.cyclonedds import parse
from bringup_lint.source import Source


@pytest.mark.parametrize(
    ("address", "found"),
    [("10.0.0.2", ["10.0.0.2"]), ("10.0.0.2,10.0.0.3", ["10.0.0.2", "10.0.0.3"]), ("${BASE:-10.0.0.2}", [])],
)
def test_peers_that_the_environment_chooses_are_left_out(address: str, found: list[str]) -> None:
    text = (
        f'<CycloneDDS><Domain><Discovery><Peers><Peer Address="{address}"/></Peers></Discovery></Domain></CycloneDDS>'
    )
    (domain,) = parse(Source("cyclonedds.xml", text), environment={}).domains
    assert [str(peer) for peer in peers(domain)] == found
