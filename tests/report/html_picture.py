"""Pictures made by hand: a small one in which everything occurs, and one of any size."""

from __future__ import annotations

from random import Random
from typing import Any

LAYERS = ("boot", "environment", "launch", "parameters", "dds", "security", "network", "devices", "topics")
HOSTILE = "</script><script>alert('1')</script>\"&]]>--!>\u2028\u202e\x1b[31m\udc80${x}"
"""A name as an attacker would choose it."""


def document(nodes: list[dict], edges: list[dict], findings: list[dict]) -> dict[str, Any]:
    return {
        "schema_version": 1,
        "tool": {"name": "bringup-lint", "version": "0.1.0"},
        "layers": [{"id": layer, "title": "DDS" if layer == "dds" else layer.capitalize()} for layer in LAYERS],
        "nodes": nodes,
        "edges": edges,
        "findings": findings,
    }


def node(layer: str, kind: str, label: str, rank: int | None = None, findings: tuple[int, ...] = ()) -> dict[str, Any]:
    place = {"path": f"etc/{label.strip('/')}", "line": 1, "rank": rank}
    return {"id": f"{kind}:{label}", "kind": kind, "layer": layer, "label": label, **place, "findings": list(findings)}


def edge(source: dict, target: dict, kind: str, why: str = "", findings: tuple[int, ...] = ()) -> dict[str, Any]:
    ends = {"source": source["id"], "target": target["id"], "path": source["path"], "line": 7}
    return {
        **ends,
        "kind": kind,
        "layer": target["layer"],
        "why": why,
        "origin": "setting",
        "condition": "",
        "findings": list(findings),
    }


def finding(rule: str, severity: str, message: str, path: str, line: int) -> dict[str, Any]:
    return {"rule": rule, "severity": severity, "message": message, "advice": "", "path": path, "line": line}


def mower() -> dict[str, Any]:
    """Ten nodes; its two findings are the first and the third of ``sample``."""
    network = node("boot", "unit", "network.target", 0)
    blade = node("boot", "unit", "blade.service", 1)
    unit = node("boot", "unit", "mower.service", 2, (0, 1))
    env = node("environment", "env-file", "mower.env")
    launch = node("launch", "launch-file", "mower.launch.py")
    drive = node("launch", "ros-node", "/drive")
    params = node("parameters", "parameter-file", "drive.yaml")
    dds = node("dds", "dds-file", "cyclonedds.xml")
    interface = node("network", "interface", "enp2s0")
    topic = node("topics", "topic", "/cmd_vel")
    edges = [
        edge(unit, network, "orders", "After=", (0,)),
        edge(unit, blade, "orders", "After="),
        edge(blade, unit, "requires", "Requires="),
        edge(unit, env, "loads-env", "EnvironmentFile="),
        edge(unit, launch, "runs", "ExecStart="),
        edge(launch, drive, "starts"),
        edge(drive, params, "loads-params"),
        edge(env, dds, "selects", "CYCLONEDDS_URI="),
        edge(dds, interface, "binds", "NetworkInterface"),
        edge(drive, topic, "subscribes"),
    ]
    path = "etc/systemd/system/mower.service"
    findings = [
        finding("systemd/network-target", "warning", "network.target is reached too early", path, 3),
        finding("systemd/root-user", "error", "All 14 nodes run as root", path, 6),
    ]
    nodes = [network, blade, unit, env, launch, drive, params, dds, interface, topic]
    return document(nodes, edges, findings)


def hostile() -> dict[str, Any]:
    """Two nodes and a finding whose every text wants to get out."""
    first, second = (node("boot", HOSTILE, f"{HOSTILE}{number}", findings=(0,)) for number in range(2))
    found = finding(HOSTILE, "error", HOSTILE, HOSTILE, 1) | {"advice": HOSTILE}
    return document([first, second], [edge(first, second, HOSTILE, HOSTILE, (0,))], [found])


def crowd(size: int, seed: int = 1) -> dict[str, Any]:
    """As many nodes, with links as robots have them and a finding here and there."""
    random = Random(seed)
    shares = dict(zip(LAYERS, (13, 5, 34, 12, 2, 6, 2, 5, 21), strict=True))
    findings = [finding("systemd/x", random.choice(["error", "warning", "info"]), f"{n}", "x", n) for n in range(30)]
    by_layer: dict[str, list[dict]] = {layer: [] for layer in LAYERS}
    for number in range(size):
        layer = random.choices(LAYERS, list(shares.values()))[0]
        held = (random.randrange(30),) if random.random() < 0.08 else ()
        rank = random.randrange(7) if layer == "boot" else None
        by_layer[layer].append(node(layer, "unit" if layer == "boot" else "file", f"{layer}_{number}", rank, held))
    edges = []
    for place, layer in enumerate(LAYERS):
        for item in by_layer[layer]:
            for _ in range(random.choice((0, 1, 1, 2, 3))):
                near = LAYERS[min(place + random.choice((0, 1, 1, 2, 6)), len(LAYERS) - 1)]
                if by_layer[near]:
                    kind = random.choice(("orders", "loads-env", "starts"))
                    edges.append(edge(item, random.choice(by_layer[near]), kind))
    return document([item for items in by_layer.values() for item in items], edges, findings)
