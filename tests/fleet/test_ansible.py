"""Inventories of Ansible; the answers are those of ``ansible-inventory --list`` of ansible-core 2.17."""

from __future__ import annotations

from pathlib import Path

import pytest

from bringup_lint.config import ConfigError
from bringup_lint.fleet.ansible import expanded
from bringup_lint.fleet.inventory import read_inventory
from tests.fleet.test_fleet import write
from tests.lint import lint

HOSTS = """\
all:
  vars:
    bringup_lint_site: inline_all
    bringup_lint_root: "robots/{{ inventory_hostname }}"
  hosts:
    a: {bringup_lint_role: inline_a}
  children:
    scouts:
      hosts:
        a:
        b: {bringup_lint_role: inline_b, bringup_lint_domain: 5}
      vars: {bringup_lint_role: inline_scouts, bringup_lint_site: inline_scouts}
    rovers:
      vars: {bringup_lint_role: inline_rovers, bringup_lint_domain: 9}
      children:
        heavy:
          hosts:
            r-[01:03]:
yard:
  vars: {bringup_lint_site: inline_yard, bringup_lint_domain: 3}
  children:
    scouts:
heavy:
  vars: {ansible_group_priority: 5}
zz:
  vars: {bringup_lint_role: inline_zz}
  hosts: {c: , r-02: }
"""
FILES = {
    "group_vars/all.yml": "bringup_lint_site: file_all\n",
    "group_vars/rovers/a.yml": "bringup_lint_role: file_rovers1\n",
    "group_vars/rovers/b.yml": "bringup_lint_role: file_rovers2\n",
    "group_vars/heavy.yaml": "bringup_lint_role: file_heavy\nbringup_lint_site: file_heavy\n",
    "host_vars/b": "bringup_lint_role: file_b\n",
    "host_vars/r-03.yml": "bringup_lint_domain: 77\n",
}
ANSWERS = {
    "a": ("inline_a", "file_all", 3),
    "b": ("file_b", "file_all", 5),
    "c": ("inline_zz", "file_all", None),
    "r-01": ("file_heavy", "file_heavy", 9),
    "r-02": ("file_heavy", "file_heavy", 9),
    "r-03": ("file_heavy", "file_heavy", 77),
}


def test_variables_count_as_ansible_counts_them(tmp_path: Path) -> None:
    write(tmp_path, {"hosts.yml": HOSTS, **FILES, **{f"robots/{name}/etc/hostname": f"{name}\n" for name in ANSWERS}})
    members = read_inventory([str(tmp_path / "hosts.yml")]).members
    assert {each.name: (each.role, each.site, each.domain) for each in members} == ANSWERS
    assert [each.layers for each in members] == [(str(tmp_path / "robots" / name),) for name in sorted(ANSWERS)]


@pytest.mark.parametrize(
    ("pattern", "hosts"),
    [
        ("rover", ["rover"]),
        ("rover-[8:10]", ["rover-8", "rover-9", "rover-10"]),
        ("rover-[08:10].hall", ["rover-08.hall", "rover-09.hall", "rover-10.hall"]),
        ("r[a:b][1:2]", ["ra1", "ra2", "rb1", "rb2"]),
        ("r[0:4:2]", ["r0", "r2", "r4"]),
        ("r[3:1]", []),
    ],
)
def test_ranges_of_hosts(pattern: str, hosts: list[str]) -> None:
    assert list(expanded(pattern)) == hosts


def test_a_circle_of_groups_ends(tmp_path: Path) -> None:
    write(tmp_path, {"hosts.yml": "a:\n  children: {b: }\nb:\n  hosts: {x: }\n  children: {a: }\n"})
    with pytest.raises(ConfigError, match="nothing says where the files of 'x' lie"):
        read_inventory([str(tmp_path / "hosts.yml")])


def test_groups_that_lie_around_each_other_in_many_layers(tmp_path: Path) -> None:
    inward = ["{" + ", ".join(f"{name}{at}: " for name in "abc") + "}" for at in range(1, 19)]
    layers = [f"{name}{at}:\n  children: {inner}\n" for at, inner in enumerate(inward) for name in "abc"]
    root = "all:\n  vars: {bringup_lint_root: robot}\n"
    outer = "z:\n  vars: {bringup_lint_role: outer}\n  children: {a0: }\n"
    innermost = "a18:\n  hosts: {alpha: }\n  vars: {bringup_lint_role: innermost}\n"
    write(tmp_path, {"hosts.yml": "".join([root, *layers, innermost, outer]), "robot/etc/hostname": "alpha\n"})
    assert [each.role for each in read_inventory([str(tmp_path / "hosts.yml")]).members] == ["innermost"]


def test_files_of_a_role_that_is_not_deployed_are_on_no_robot(tmp_path: Path) -> None:
    key = "[Interface]\nPrivateKey = " + "Q" * 43 + "=\n"
    hosts = 'all:\n  vars: {bringup_lint_root: ".", bringup_lint_overlays: ["robots/{{ inventory_hostname }}"]}\n'
    write(
        tmp_path,
        {
            "hosts.yml": f"{hosts}  hosts: {{a: , b: }}\n",
            "roles/common/files/wireguard/wg0.conf": key,
            "robots/a/etc/hostname": "a\n",
            "robots/b/etc/hostname": "b\n",
        },
    )
    run = lint("fleet", "--workers", "1", "--select", "fleet", "--output-format", "concise", "hosts.yml", cwd=tmp_path)
    assert "vpn" not in run.stdout and "key" not in run.stdout


@pytest.mark.parametrize("pattern", ["r[1:99999999999]", "[a:z][1:999][1:999][1:999]"])
def test_a_range_without_bounds_is_refused(tmp_path: Path, pattern: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bringup_lint.fleet.ansible._MOST", 1000)
    write(tmp_path, {"hosts.yml": f'all:\n  hosts: {{"{pattern}": }}\n  vars: {{bringup_lint_root: "."}}\n'})
    with pytest.raises(ConfigError, match="names more than 1000 hosts"):
        read_inventory([str(tmp_path / "hosts.yml")])
