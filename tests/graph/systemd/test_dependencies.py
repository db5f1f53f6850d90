"""The dependency graph: written, implicit and distribution edges, cycles, and what waits for what."""

from __future__ import annotations

import pytest

from bringup_lint.graph.systemd.units import Units
from tests.graph.systemd.test_units import load
from tests.graph.systemd.test_units import only


def service(unit: str = "", install: str = "", own: str = "") -> str:
    return f"[Unit]\n{unit}\n[Service]\nExecStart=/bin/true\n{own}\n[Install]\n{install}\n"


def orders(units: Units, before: str, after: str) -> list[str]:
    return [
        edge.why for edge in units.graph.edges("orders") if edge.source.name == before and edge.target.name == after
    ]


def cycle(units: Units) -> tuple[list[str], str | None, bool]:
    (found,) = units.cycles
    return sorted(found.units), found.root.name if found.root else None, found.fatal


def test_target_is_ordered_after_what_it_wants(tmp_path, monkeypatch):
    units = load(
        tmp_path,
        {
            "a.service": service(install="WantedBy=robot.target"),
            "robot.target": "[Unit]\nWants=b.service\n",
            "b.service": service(),
        },
        monkeypatch,
    )
    assert orders(units, "a.service", "robot.target")
    assert orders(units, "b.service", "robot.target")


def test_no_implicit_order_against_an_explicit_one_or_without_default_dependencies(tmp_path, monkeypatch):
    units = load(
        tmp_path,
        {
            "a.service": service("After=robot.target", "WantedBy=robot.target"),
            "b.service": service("DefaultDependencies=no", "WantedBy=robot.target"),
            "robot.target": "[Unit]\n",
        },
        monkeypatch,
    )
    assert not orders(units, "a.service", "robot.target")
    assert not orders(units, "b.service", "robot.target")
    assert not units.cycles


@pytest.mark.parametrize(
    ("files", "before", "after"),
    [
        ({"a.service": service()}, "basic.target", "a.service"),
        ({"a.timer": "[Timer]\nOnBootSec=1\n", "a.service": service()}, "a.timer", "a.service"),
        ({"a.timer": "[Timer]\nOnCalendar=daily\n"}, "time-sync.target", "a.timer"),
        (
            {"a.socket": "[Socket]\nListenStream=1\nService=b.service\n", "b.service": service()},
            "a.socket",
            "b.service",
        ),
        ({"a.service": service(own="Sockets=x.socket")}, "x.socket", "a.service"),
        ({"a.service": service(own="Slice=robot.slice")}, "robot.slice", "a.service"),
        ({"a.service": service(own="Type=dbus\nBusName=a.b")}, "dbus.socket", "a.service"),
        ({"a.service": service(own="PrivateTmp=yes")}, "systemd-tmpfiles-setup.service", "a.service"),
        (
            {"a.service": service("RequiresMountsFor=/data/x"), "data.mount": "[Mount]\nWhere=/data\n"},
            "data.mount",
            "a.service",
        ),
        (
            {"a.service": service(own="WorkingDirectory=/data"), "data.mount": "[Mount]\nWhere=/data\n"},
            "data.mount",
            "a.service",
        ),
        (
            {"data-x.mount": "[Mount]\nWhere=/data/x\n", "data.mount": "[Mount]\nWhere=/data\n"},
            "data.mount",
            "data-x.mount",
        ),
        ({"data.mount": "[Mount]\nWhere=/data\n"}, "data.mount", "local-fs.target"),
        ({"data.mount": "[Mount]\nWhere=/data\nType=nfs\n"}, "network-online.target", "data.mount"),
        (
            {"a@.service": service("After=b@%i.service"), "c.service": service("Wants=a@x.service")},
            "b@x.service",
            "a@x.service",
        ),
        ({"a.service": service("After=b@.service")}, "b@a.service", "a.service"),
        ({"a.service": service("After=default.target")}, "graphical.target", "a.service"),
    ],
    ids=lambda value: None if isinstance(value, str) else " ".join(value),
)
def test_edges(tmp_path, monkeypatch, files, before, after):
    assert orders(load(tmp_path, files, monkeypatch), before, after)


def test_user_units_stay_in_their_own_graph(tmp_path, monkeypatch):
    files = {
        "systemd/user/a.service": service("After=b.service"),
        "systemd/system/b.service": service("After=a.service"),
    }
    units = load(tmp_path, files, monkeypatch)
    assert not units.cycles
    assert not [edge for edge in units.graph.edges() if edge.source.kind != edge.target.kind]


def test_variants_of_one_unit_make_no_common_cycle(tmp_path, monkeypatch):
    files = {
        "one/a.service": service("After=b.service", "WantedBy=multi-user.target"),
        "one/b.service": service(install="WantedBy=multi-user.target"),
        "two/a.service": service(install="WantedBy=multi-user.target"),
        "two/b.service": service("After=a.service", "WantedBy=multi-user.target"),
    }
    assert not load(tmp_path, files, monkeypatch).cycles


def test_cycle_of_wanted_units_loses_a_job(tmp_path, monkeypatch):
    files = {
        name: service(f"After={after}.service", "WantedBy=multi-user.target")
        for name, after in (("a.service", "b"), ("b.service", "c"), ("c.service", "a"))
    }
    members, root, fatal = cycle(load(tmp_path, files, monkeypatch))
    assert members == ["a.service", "b.service", "c.service"]
    assert root in ("graphical.target", "multi-user.target")
    assert not fatal


def test_cycle_of_required_units_is_fatal(tmp_path, monkeypatch):
    files = {
        "a.service": service("Requires=b.service\nAfter=b.service"),
        "b.service": service("Requires=a.service\nAfter=a.service"),
    }
    assert cycle(load(tmp_path, files, monkeypatch))[2]


def test_unit_after_a_target_that_waits_for_the_one_that_wants_it(tmp_path, monkeypatch):
    files = {"a.service": service("After=graphical.target", "WantedBy=multi-user.target")}
    members, _, fatal = cycle(load(tmp_path, files, monkeypatch))
    assert members == ["a.service", "graphical.target", "multi-user.target"]
    assert not fatal


def test_latent_cycle_has_no_root(tmp_path, monkeypatch):
    files = {"a.service": service("After=b.service"), "b.service": service("After=a.service")}
    assert cycle(load(tmp_path, files, monkeypatch))[1] is None


def test_masked_unit_breaks_the_cycle(tmp_path, monkeypatch):
    files = {
        "a.service": service("After=b.service", "WantedBy=multi-user.target"),
        "b.service": service("After=a.service", "WantedBy=multi-user.target"),
        "c.service": service("After=a.service d.service", "WantedBy=multi-user.target"),
        "d.service": "",
    }
    files["b.service"] = ""
    assert not load(tmp_path, files, monkeypatch).cycles


def test_waits_through_others_but_not_through_packages(tmp_path, monkeypatch):
    files = {
        "a.service": service("Wants=network-online.target\nAfter=network-online.target", "WantedBy=multi-user.target"),
        "b.service": service("Requires=a.service\nAfter=a.service"),
        "c.service": service("After=multi-user.target"),
        "d.service": service("After=docker.service\nRequires=docker.service"),
        "e.service": service("After=basic.target"),
    }
    units = load(tmp_path, files, monkeypatch)
    waiting = {name: bool(units.waits_for(only(units, name), "network-online.target")) for name in files}
    assert waiting == dict(zip(files, (True, True, True, True, False)))
    bringing = {name: bool(units.brings_in(only(units, name), "network-online.target")) for name in files}
    assert bringing == dict(zip(files, (True, True, False, True, False)))
    assert units.brought_in(only(units, "e.service"), "network-online.target")


def test_packages_that_may_not_be_installed_prove_nothing(tmp_path, monkeypatch):
    units = load(tmp_path, {"c.service": service("After=multi-user.target")}, monkeypatch)
    assert not units.waits_for(only(units, "c.service"), "network-online.target")
    assert not units.brought_in(only(units, "c.service"), "network-online.target")


def test_links_of_a_root_file_system_decide_what_is_enabled(tmp_path, monkeypatch):
    files = {
        "etc/systemd/system/a.service": service(install="WantedBy=multi-user.target"),
        "etc/systemd/system/b.service": service(install="WantedBy=multi-user.target"),
        "etc/systemd/system/multi-user.target.wants/a.service": "-> ../a.service",
    }
    units = load(tmp_path, files, monkeypatch, root=True)
    pulled = {edge.target.name for edge in units.graph.edges("wants") if edge.source.name == "multi-user.target"}
    assert {"a.service"} == pulled & {"a.service", "b.service"}
