"""Netplan's files and their merge."""

import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.graph.netplan.netplan import assemble
from bringup_lint.model.netplan import Netplan
from bringup_lint.model.schema import Code
from bringup_lint.parsers.netplan import parse
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.spelling import nearest
from tests.lint import lint


def read(**files: str) -> Netplan:
    """The netplan of a tree; ``etc__10`` stands for ``etc/netplan/10.yaml``."""
    names = {name: f"{name.replace('__', '/netplan/')}.yaml" for name in files}
    return assemble(parse(Source(names[name], text, kind="netplan")) for name, text in files.items())


BASE = "network:\n  ethernets:\n    eth0:\n      dhcp4: true\n      addresses: [10.0.0.1/24]\n"


def test_scalars_are_replaced_and_sequences_add_up():
    more = "network: {ethernets: {eth0: {dhcp4: no, addresses: [10.0.0.1/24, 10.0.0.2/24]}}}"
    (plan,) = read(etc__10=BASE, etc__20=more).plans
    interface = plan.interfaces["eth0"]
    assert not interface.dhcp4
    assert [str(address.text) for address in interface.addresses] == ["10.0.0.1/24", "10.0.0.2/24"]
    assert interface.flag("dhcp4").where.path == "etc/netplan/20.yaml"
    assert interface.addresses[0].text.path == "etc/netplan/10.yaml"


def test_files_are_read_in_the_order_of_their_names_whatever_the_folder():
    late = "network: {ethernets: {eth0: {mtu: 9000}}}"
    early = "network: {ethernets: {eth0: {mtu: 1500}}}"
    (plan,) = read(lib__30=late, run__20=early).plans
    assert plan.interfaces["eth0"].value("mtu") == "9000"


def test_a_name_in_run_hides_the_same_name_in_etc():
    netplan = read(etc__10=BASE, run__10="network: {ethernets: {eth0: {mtu: 1500}}}")
    (plan,) = netplan.plans
    assert not plan.interfaces["eth0"].dhcp4
    assert [(hidden.source.name, winner.source.name) for hidden, winner in netplan.shadowed] == [
        ("etc/netplan/10.yaml", "run/netplan/10.yaml")
    ]


def test_files_outside_of_netplans_folders_stand_alone():
    assert len(read(variants__a=BASE, variants__b=BASE).plans) == 2


@pytest.mark.parametrize(
    ("body", "device"),
    [
        ("{}", "eth0"),
        ("{match: {name: enp3s0}}", "enp3s0"),
        ("{match: {name: 'enp*'}}", None),
        ("{match: {macaddress: '02:00:00:00:00:01'}}", None),
        ("{match: {macaddress: '02:00:00:00:00:01'}, set-name: lan0}", "lan0"),
    ],
)
def test_the_name_of_the_device(body, device):
    (plan,) = read(etc__10=f"network: {{ethernets: {{eth0: {body}}}}}").plans
    assert plan.interfaces["eth0"].device == device


@pytest.mark.parametrize(
    ("renderers", "backend"),
    [
        ("", "networkd"),
        ("renderer: NetworkManager, ", "NetworkManager"),
    ],
)
def test_the_renderer_of_an_interface(renderers, backend):
    (plan,) = read(etc__10=f"network: {{{renderers}ethernets: {{eth0: {{}}}}}}").plans
    assert plan.interfaces["eth0"].backend == backend


def test_the_renderer_of_a_device_type_holds_for_what_follows():
    point = "{access-points: {depot: {}}}"
    text = f"network: {{wifis: {{wlan0: {point}, renderer: NetworkManager, wlan1: {point}}}}}"
    (plan,) = read(etc__10=text).plans
    assert [interface.backend for interface in plan.interfaces.values()] == ["networkd", "NetworkManager"]


def test_the_network_of_cloud_init_is_read():
    text = "#cloud-config\nhostname: robot\nnetwork:\n  version: 2\n  ethernets:\n    eth0: {dhcp: true}\n"
    file = parse(Source("user-data", text, kind="cloud-init-network"))
    assert [problem.code for problem in file.problems] == [Code.UNKNOWN]


def test_version_1_of_cloud_init_is_left_alone():
    text = "network:\n  version: 1\n  config:\n    - type: physical\n"
    assert parse(Source("network-config", text, kind="cloud-init-network")).problems == []


@pytest.mark.parametrize(
    ("word", "meant"),
    [("adresses", ["addresses"]), ("dhcp", ["dhcp4", "dhcp6"]), ("rendrer", ["renderer"]), ("ip", [])],
)
def test_nearest(word, meant):
    assert nearest(word, ["addresses", "dhcp4", "dhcp6", "renderer", "id"]) == meant


MAPPINGS = [
    "network",
    "ethernets",
    "wifis",
    "vlans",
    "bridges",
    "tunnels",
    "eth0",
    "wlan0",
    "match",
    "auth",
    "parameters",
]
KEYS = [
    "version",
    "renderer",
    "addresses",
    "routes",
    "to",
    "via",
    "name",
    "link",
    "id",
    "peers",
    "keys",
    "interfaces",
]
VALUES = [
    "2",
    "10.0.0.1/24",
    "default",
    "true",
    "{}",
    "[]",
    "~",
    "'x'",
    "*a",
    "&a",
    "access-points",
    "password",
]
WORDS = MAPPINGS + KEYS + VALUES
TREES = st.recursive(
    st.sampled_from(WORDS),
    lambda inner: st.one_of(
        st.lists(inner, max_size=3).map(lambda items: "[" + ", ".join(items) + "]"),
        st.lists(st.tuples(st.sampled_from(WORDS), inner), max_size=3).map(
            lambda pairs: "{" + ", ".join(f"{key}: {value}" for key, value in pairs) + "}"
        ),
    ),
    max_leaves=12,
)


@given(st.sampled_from(["", "network: ", "network: {ethernets: ", "network: {wifis: {wlan0: "]), TREES)
def test_no_text_raises_and_every_problem_lies_inside(start, tree):
    text = start + tree + "}" * start.count("{")
    file = parse(Source("etc/netplan/10.yaml", text, kind="netplan"))
    netplan = assemble([file])
    for plan in netplan.plans:
        for problem in [*file.problems, *plan.problems, *file.newer]:
            span = problem.where if isinstance(problem.where, Span) else problem.where.span
            assert 0 <= span.start <= span.end <= len(text)
        for interface in plan.interfaces.values():
            lists = (interface.addresses, interface.routes, interface.access_points, interface.members)
            assert all(isinstance(items, list) for items in lists)
        list(plan.default_routes)


CORPUS = os.environ.get("BRINGUP_LINT_CORPUS", "")


@pytest.mark.corpus
@pytest.mark.skipif(not CORPUS, reason="BRINGUP_LINT_CORPUS names no folder")
def test_netplans_own_examples_are_clean():
    examples = Path(CORPUS) / "canonical__netplan"
    run = lint(
        "--select",
        "netplan",
        "--output-format",
        "concise",
        "--min-severity",
        "warning",
        "examples",
        cwd=examples,
    )
    assert (run.code, run.stdout) == (0, "")


@pytest.mark.corpus
@pytest.mark.skipif(not CORPUS, reason="BRINGUP_LINT_CORPUS names no folder")
def test_the_labelled_password_is_found():
    robot = Path(CORPUS) / "turtlebot__turtlebot4_setup"
    run = lint("--select", "netplan", "--output-format", "concise", "--min-severity", "warning", ".", cwd=robot)
    assert [line.partition(":")[2].partition(":")[0] for line in run.stdout.splitlines()] == ["10"]
