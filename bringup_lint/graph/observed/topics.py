"""The topics of a running graph: who is on which side, and which names are meant to be one."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.topics.questions.command_sources import is_velocity
from bringup_lint.graph.topics.questions.compatibility import Conflict
from bringup_lint.graph.topics.questions.compatibility import conflicts
from bringup_lint.graph.topics.questions.misspelt import nearly_equal
from bringup_lint.graph.topics.resolved.names import tail
from bringup_lint.model.observed import Endpoint
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_OF_ROS = frozenset(("/rosout", "/parameter_events"))
_HIDDEN = regex(r"/_")


@dataclass(eq=False)
class Topic:
    name: str
    publishers: list[Endpoint] = field(default_factory=list)
    subscriptions: list[Endpoint] = field(default_factory=list)

    @cached_property
    def types(self) -> frozenset[str]:
        return frozenset(str(each.type) for each in (*self.publishers, *self.subscriptions))

    @property
    def pairs(self) -> Iterator[tuple[Endpoint, Endpoint, list[Conflict]]]:
        """Publisher and subscription of the same type that never match, once for each two nodes."""
        seen = set()
        for publisher in self.publishers:
            for subscription in self.subscriptions:
                found = list(conflicts(publisher.qos, subscription.qos))
                key = (publisher.node, subscription.node, tuple(each.policy for each in found))
                if found and publisher.type == subscription.type and key not in seen:
                    seen.add(key)
                    yield publisher, subscription, found

    @property
    def is_velocity(self) -> bool:
        """Whether it carries velocity commands: ``cmd_vel``, or a name like it and a type for velocities."""
        return tail(self.name) == "cmd_vel" or any(is_velocity(self.name, each) for each in self.types)


class Meant(NamedTuple):
    """A subscription that nobody publishes to, and the publisher that it most likely waits for."""

    subscription: Endpoint
    publisher: Endpoint
    why: str
    """``name`` or ``namespace``: what differs."""


def topics(endpoints: Iterable[Endpoint]) -> list[Topic]:
    """The topics with their endpoints, without those of ROS's own machinery."""
    found: dict[str, Topic] = {}
    for each in endpoints:
        if each.topic in _OF_ROS or _HIDDEN.search(each.topic):
            continue
        topic = found.setdefault(str(each.topic), Topic(str(each.topic)))
        (topic.publishers if each.publishes else topic.subscriptions).append(each)
    return list(found.values())


def meant(all_topics: list[Topic]) -> Iterator[Meant]:
    """Subscriptions without a publisher, each with the one other topic of its type that its name comes close to."""
    served: dict[str, list[Topic]] = {}
    for topic in all_topics:
        if not topic.publishers:
            continue
        for each in topic.types:
            served.setdefault(each, []).append(topic)
    for topic in all_topics:
        if topic.publishers or not topic.subscriptions or len(topic.types) > 1:
            continue
        others = served.get(next(iter(topic.types)), [])
        near = [other for other in others if nearly_equal(topic.name, other.name)]
        if len(near) == 1:
            yield Meant(topic.subscriptions[0], near[0].publishers[0], "name")
            continue
        unheard = [other for other in others if not other.subscriptions and tail(other.name) == tail(topic.name)]
        if not near and len(unheard) == 1 and len(others) == 1:
            yield Meant(topic.subscriptions[0], unheard[0].publishers[0], "namespace")
