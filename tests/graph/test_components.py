"""Strongly connected components, compared with those of networkx."""

from __future__ import annotations

import networkx
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.graph.components import in_order

numbers = st.integers(0, 12)


@given(st.lists(st.tuples(numbers, numbers), max_size=40))
def test_components_are_those_of_networkx(edges: list[tuple[int, int]]) -> None:
    graph = networkx.DiGraph(edges)
    found = list(in_order(list(graph), lambda node: list(graph.successors(node))))
    assert sorted(map(sorted, found)) == sorted(map(sorted, networkx.strongly_connected_components(graph)))
    before: set[int] = set()
    for each in found:
        before |= each
        assert all(before.issuperset(graph.successors(node)) for node in each)


def test_a_long_ring_is_one_component() -> None:
    size = 50_000
    (found,) = in_order(range(size), lambda node: [(node + 1) % size])
    assert len(found) == size
