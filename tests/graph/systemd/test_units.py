"""Units as systemd joins them: load paths, drop-ins, masks, aliases, links and managers."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units
from bringup_lint.robot import Robot

SERVICE = "[Service]\nExecStart=/bin/true\n"


def load(folder: Path, files: dict[str, str], monkeypatch: pytest.MonkeyPatch, *, root: bool = False) -> Units:
    """The units of a tree; ``-> target`` as content makes a link."""
    if root:
        files = {
            "etc/os-release": "ID=ubuntu\n",
            "etc/passwd": "root:x:0:0::/root:/bin/sh\n",
            "usr/x": "",
            **files,
        }
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if text.startswith("-> "):
            path.symlink_to(text[3:])
        else:
            path.write_text(text)
    monkeypatch.chdir(folder)
    return Robot(discover(["."])).units


def only(units: Units, name: str, manager: str = "system") -> Unit:
    (found,) = units.candidates(name, manager)
    return found


def test_dropins_apply_in_the_order_of_their_names_and_reset_lists(tmp_path, monkeypatch):
    units = load(
        tmp_path,
        {
            "a.service": SERVICE + "User=one\nAfter=x.service\n",
            "a.service.d/20-later.conf": "[Service]\nUser=three\n",
            "a.service.d/10-first.conf": "[Service]\nUser=two\nExecStart=\nExecStart=/bin/false\n",
            "a.service.d/notes.txt": "[Service]\nUser=four\n",
        },
        monkeypatch,
    )
    unit = only(units, "a.service")
    assert unit.get("User") == "three"
    assert [str(value) for value in unit.values("ExecStart")] == ["/bin/false"]


def test_dropin_of_the_same_name_in_etc_wins_over_the_vendors(tmp_path, monkeypatch):
    units = load(
        tmp_path,
        {
            "usr/lib/systemd/system/a.service": SERVICE,
            "usr/lib/systemd/system/a.service.d/10-user.conf": "[Service]\nUser=vendor\nGroup=vendor\n",
            "etc/systemd/system/a.service.d/10-user.conf": "[Service]\nUser=admin\n",
        },
        monkeypatch,
    )
    unit = only(units, "a.service")
    assert unit.get("User") == "admin"
    assert unit.get("Group") is None


def test_dropin_linked_to_null_is_masked(tmp_path, monkeypatch):
    units = load(
        tmp_path,
        {
            "usr/lib/systemd/system/a.service": SERVICE,
            "usr/lib/systemd/system/a.service.d/10-user.conf": "[Service]\nUser=vendor\n",
            "etc/systemd/system/a.service.d/10-user.conf": "-> /dev/null",
        },
        monkeypatch,
        root=True,
    )
    assert only(units, "a.service").get("User") is None


@pytest.mark.parametrize(
    "folder",
    [
        "service.d",
        "robot-.service.d",
        "robot-nav-.service.d",
        "robot-nav-x@.service.d",
        "robot-nav-x@a.service.d",
    ],
)
def test_dropin_folders_of_an_instance(tmp_path, monkeypatch, folder):
    files = {"robot-nav-x@a.service": SERVICE, f"{folder}/10.conf": "[Service]\nUser=robot\n"}
    assert only(load(tmp_path, files, monkeypatch), "robot-nav-x@a.service").get("User") == "robot"


def test_dropin_of_another_prefix_does_not_apply(tmp_path, monkeypatch):
    files = {"robot-nav.service": SERVICE, "robo-.service.d/10.conf": "[Service]\nUser=robot\n"}
    assert only(load(tmp_path, files, monkeypatch), "robot-nav.service").get("User") is None


@pytest.mark.parametrize("mask", ["-> /dev/null", ""])
def test_mask_hides_the_vendors_unit(tmp_path, monkeypatch, mask):
    files = {"usr/lib/systemd/system/a.service": SERVICE, "etc/systemd/system/a.service": mask}
    unit = only(load(tmp_path, files, monkeypatch, root=True), "a.service")
    assert unit.masked is not None
    assert unit.fragment is None


def test_file_in_etc_replaces_the_vendors(tmp_path, monkeypatch):
    files = {
        "usr/lib/systemd/system/a.service": SERVICE + "User=vendor\n",
        "etc/systemd/system/a.service": SERVICE,
    }
    units = load(tmp_path, files, monkeypatch, root=True)
    assert only(units, "a.service").get("User") is None
    assert [unit.name for _, unit in units.shadowed] == ["a.service"]


def test_alias_by_link_and_by_install_section(tmp_path, monkeypatch):
    files = {
        "etc/systemd/system/a.service": SERVICE + "[Install]\nAlias=third.service\n",
        "etc/systemd/system/other.service": "-> a.service",
    }
    units = load(tmp_path, files, monkeypatch, root=True)
    assert only(units, "other.service") is only(units, "a.service") is only(units, "third.service")


def test_link_to_a_unit_that_the_tree_lacks_is_a_unit_of_unknown_content(tmp_path, monkeypatch):
    files = {"etc/systemd/system/a.service": "-> /opt/nowhere/a.service"}
    units = load(tmp_path, files, monkeypatch, root=True)
    unit = only(units, "a.service")
    assert unit.fragment is None
    assert unit not in units.judged


def test_alias_of_a_unit_of_the_distribution(tmp_path, monkeypatch):
    files = {"etc/systemd/system/default.target": "-> /usr/lib/systemd/system/multi-user.target"}
    units = load(tmp_path, files, monkeypatch, root=True)
    assert units.real_name("default.target") == "multi-user.target"
    assert units.real_name("runlevel5.target") == "graphical.target"


@pytest.mark.parametrize(
    ("path", "manager"),
    [
        ("etc/systemd/user/a.service", "user"),
        ("home/rover/.config/systemd/user/a.service", "user"),
        ("config/systemd/user/a.service", "user"),
        ("units/user/a.service", "user"),
        ("etc/systemd/system/a.service", "system"),
        ("systemd/a.service", "system"),
        ("home/user/units/a.service", "system"),
    ],
)
def test_manager_of_a_unit(tmp_path, monkeypatch, path, manager):
    (unit,) = load(tmp_path, {path: SERVICE}, monkeypatch).all
    assert unit.manager == manager


def test_links_of_wants_folders(tmp_path, monkeypatch):
    files = {
        "etc/systemd/system/a@.service": SERVICE,
        "etc/systemd/system/multi-user.target.wants/a@left.service": "-> ../a@.service",
        "etc/systemd/user/default.target.wants/b.service": "-> ../b.service",
    }
    units = load(tmp_path, files, monkeypatch, root=True)
    assert {(link.manager, link.unit, link.relation, str(link.name)) for link in units.links} == {
        ("system", "multi-user.target", "Wants", "a@left.service"),
        ("user", "default.target", "Wants", "b.service"),
    }
    assert units.knows_enabled


def test_variants_of_one_name_are_told_apart_by_their_place(tmp_path, monkeypatch):
    files = {
        "small/etc/systemd/system/a.service": SERVICE + "User=small\n",
        "small/etc/systemd/system/b.service": SERVICE,
        "large/etc/systemd/system/a.service": SERVICE + "User=large\n",
        "large/etc/systemd/system/a.service.d/x.conf": "[Service]\nGroup=large\n",
    }
    units = load(tmp_path, files, monkeypatch)
    near = only(units, "b.service")
    assert units.find("a.service", near).get("User") == "small"
    assert units.find("a.service", near).get("Group") is None
    assert len({units.node(unit) for unit in units.candidates("a.service")}) == 2


def test_existence(tmp_path, monkeypatch):
    units = load(tmp_path, {"a.service": SERVICE, "b@.service": SERVICE}, monkeypatch)
    near = only(units, "a.service")
    known = {
        "b@x.service": True,
        "ssh.service": True,
        "getty@tty1.service": None,
        "dev-ttyACM0.device": None,
        "a%i.service": None,
        "nothing.service": False,
    }
    assert {name: units.exists(name, near) for name in known} == known


def test_service_kept_as_conf_is_a_service(tmp_path, monkeypatch):
    units = load(tmp_path, {"opt/robot/nav.conf": "[Unit]\nDescription=x\n" + SERVICE}, monkeypatch)
    assert [unit.name for unit in units.all] == ["nav.service"]


@pytest.mark.parametrize(("beside", "user"), [({}, "sample"), ({"a.service": SERVICE + "User=rover\n"}, "rover")])
def test_sample_is_read_where_there_is_nothing_else(tmp_path, monkeypatch, beside, user):
    units = load(tmp_path, {"a.service.example": SERVICE + "User=sample\n", **beside}, monkeypatch)
    assert only(units, "a.service").get("User") == user
    assert units.files.purpose(only(units, "a.service").where).value == "robot"


def test_new_line_goes_to_the_end_of_the_section_or_makes_it(tmp_path, monkeypatch):
    units = load(tmp_path, {"a.service": "[Unit]\nAfter=b.service\n\n[Service]\nExecStart=/bin/true"}, monkeypatch)
    unit = only(units, "a.service")
    span, text = unit.new_line("Unit", "Wants=b.service")
    assert (span.line, text) == (3, "Wants=b.service\n")
    span, text = unit.new_line("Install", "WantedBy=x.target")
    assert text == "\n\n[Install]\nWantedBy=x.target\n"


def test_folder_behind_a_link_is_read_once(tmp_path, monkeypatch):
    files = {
        "usr/lib/systemd/system/a.service": SERVICE,
        "lib": "-> usr/lib",
        "etc/systemd/system/b.service": SERVICE,
    }
    units = load(tmp_path, files, monkeypatch, root=True)
    assert not units.shadowed
    assert sorted(unit.name for unit in units.all) == ["a.service", "b.service"]
