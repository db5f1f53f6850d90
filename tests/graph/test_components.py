"""Strongly connected components, compared with those of networkx."""

from __future__ import annotations

import networkx
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.graph.components import components

numbers = st.integers(0, 12)


@given(st.lists(st.tuples(numbers, numbers), max_size=40))
def test_components_are_those_of_networkx(edges: list[tuple[int, int]]) -> None:
    graph = networkx.DiGraph(edges)
    found = components(list(graph), lambda node: list(graph.successors(node)))
    expected = [each for each in networkx.strongly_connected_components(graph) if len(each) > 1]
    assert sorted(map(sorted, found)) == sorted(map(sorted, expected))


def test_a_long_ring_is_one_component() -> None:
    size = 50_000
    (found,) = components(range(size), lambda node: [(node + 1) % size])
    assert len(found) == size
