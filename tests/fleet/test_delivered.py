"""Files that playbooks copy to hosts: what identifies a robot and comes to several of them is the same on these."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bringup_lint.fleet import plays
from bringup_lint.fleet.inventory import read_inventory
from bringup_lint.parsers.yaml_nodes import parse
from tests.fleet.test_fleet import write
from tests.lint import lint

HOSTS = """\
rovers:
  hosts: {alpha: , beta: }
arms:
  hosts: {gamma: }
"""
VPN = "[Interface]\nPrivateKey = " + "Q" * 43 + "=\n"
OWN = {host: VPN.replace("Q", host[0].upper()) for host in ("alpha", "beta", "gamma")}
ROLE = "roles/vpn/tasks/main.yml"
COPY = "- copy: {src: wg0.conf, dest: /etc/wireguard/wg0.conf}\n"


def found(tmp_path: Path, files: dict[str, str], hosts: str = HOSTS) -> dict[str, list[str]]:
    """Rule -> the robots of its only finding."""
    write(tmp_path, {"hosts.yml": hosts, **files})
    run = lint("fleet", "--workers", "1", "--output-format", "json", "hosts.yml", cwd=tmp_path)
    assert run.code in (0, 1), run.stderr
    return {each["rule"]: each["robots"] for each in json.loads(run.stdout)["findings"]}


def delivered(tmp_path: Path, files: dict[str, str], hosts: str = HOSTS) -> dict[str, list[str]]:
    """Place on a robot -> the robots that get a file there."""
    root = "all:\n  vars: {bringup_lint_root: robot}\n"
    write(tmp_path, {"hosts.yml": root + hosts, "robot/etc/os-release": "ID=ubuntu\n", **files})
    places: dict[str, list[str]] = {}
    for member in read_inventory([str(tmp_path / "hosts.yml")]).members:
        for place, _ in member.delivered:
            places.setdefault(place, []).append(member.name)
    return places


def test_a_key_that_a_role_copies_is_the_same_on_the_hosts_of_the_play(tmp_path: Path) -> None:
    play = "- hosts: rovers\n  roles: [vpn]\n"
    files = {"site.yml": play, ROLE: COPY, "roles/vpn/files/wg0.conf": VPN}
    assert found(tmp_path, files) == {"fleet/same-network-key": ["alpha", "beta"]}


def test_the_place_is_the_file_of_the_project(tmp_path: Path) -> None:
    write(tmp_path, {"hosts.yml": HOSTS, "site.yml": "- hosts: all\n  roles: [vpn]\n", ROLE: COPY})
    write(tmp_path, {"roles/vpn/files/wg0.conf": VPN})
    run = lint("fleet", "--workers", "1", "--output-format", "concise", "hosts.yml", cwd=tmp_path)
    assert run.stdout.startswith("roles/vpn/files/wg0.conf:2: error[fleet/same-network-key] 3 robots have the same")


@pytest.mark.parametrize(
    ("pattern", "hosts"),
    [
        ("all", ["alpha", "beta", "gamma"]),
        ("rovers:arms", ["alpha", "beta", "gamma"]),
        ("all:!arms", ["alpha", "beta"]),
        ("all:&arms", ["gamma"]),
        ("r*", ["alpha", "beta"]),
        ("[alpha, gamma]", ["alpha", "gamma"]),
        ("'{{ target }}'", []),
        ("nobody", []),
    ],
)
def test_patterns_of_hosts(tmp_path: Path, pattern: str, hosts: list[str]) -> None:
    play = f"- hosts: {pattern}\n  tasks:\n    - copy: {{src: a.key, dest: /etc/robot/a.key}}\n"
    places = delivered(tmp_path, {"site.yml": play, "files/a.key": "x"})
    assert places == ({"/etc/robot/a.key": hosts} if hosts else {})


TASKS = {
    "- copy: {src: a.key, dest: /etc/robot/}": "/etc/robot/a.key",
    "- ansible.builtin.template: {src: a.conf.j2, dest: /etc/robot/a.conf}": "/etc/robot/a.conf",
    "- copy: {src: '{{ item }}', dest: /etc/robot/}\n  loop: [a.key]": "/etc/robot/a.key",
    "- copy: {src: keystore/, dest: /opt/keystore}": "/opt/keystore/private/ca.key.pem",
    "- copy: {src: keystore, dest: /opt}": "/opt/keystore/private/ca.key.pem",
    "- block:\n    - copy: {src: a.key, dest: /etc/robot/a.key}": "/etc/robot/a.key",
    "- include_tasks: more.yml": "/etc/robot/more.key",
    "- import_role: {name: other}": "/etc/robot/other.key",
    "- copy: {src: a.key, dest: /etc/robot/a.key}\n  when: is_rover": "",
    "- block:\n    - copy: {src: a.key, dest: /etc/robot/a.key}\n  when: is_rover": "",
    "- copy: {src: a.key, dest: /etc/robot/a.key}\n  delegate_to: localhost": "",
    "- copy: {src: a.key, dest: /etc/robot/a.key}\n  run_once: true": "",
    "- copy: {src: a.key, dest: /etc/robot/a.key}\n  tags: [never]": "",
    "- copy: {src: a.key, dest: /etc/robot/a.key, remote_src: true}": "",
    "- copy: {src: '{{ key }}', dest: /etc/robot/a.key}": "",
    "- copy: {src: a.key, dest: '/etc/{{ site }}/a.key'}": "",
    "- copy: {src: none.key, dest: /etc/robot/a.key}": "",
    "- copy: {src: a.key, dest: /etc/robot/a.key}\n  tags: 'never, factory'": "",
    "- copy: {src: ../../../outside.key, dest: /etc/robot/a.key}": "",
}


@pytest.mark.parametrize("task", TASKS)
def test_tasks_of_a_role(tmp_path: Path, task: str) -> None:
    files = {
        "site.yml": "- hosts: all\n  roles:\n    - role: vpn\n",
        ROLE: task + "\n",
        "roles/vpn/tasks/more.yml": "- copy: {src: more.key, dest: /etc/robot/more.key}\n",
        "roles/vpn/files/a.key": "x",
        "roles/vpn/files/more.key": "x",
        "outside.key": "x",
        "roles/vpn/files/keystore/private/ca.key.pem": "x",
        "roles/vpn/templates/a.conf.j2": "x",
        "roles/other/tasks/main.yml": "- copy: {src: other.key, dest: /etc/robot/other.key}\n",
        "roles/other/files/other.key": "x",
    }
    places = delivered(tmp_path, files)
    assert places == ({TASKS[task]: ["alpha", "beta", "gamma"]} if TASKS[task] else {})


def test_a_file_for_each_host_is_its_own(tmp_path: Path) -> None:
    task = "- copy: {src: '{{ inventory_hostname }}/wg0.conf', dest: /etc/wireguard/wg0.conf}\n"
    files = {"site.yml": "- hosts: all\n  roles: [vpn]\n", ROLE: task}
    keys = {
        f"roles/vpn/files/{host}/wg0.conf": VPN.replace("Q", host[0].upper()) for host in ("alpha", "beta", "gamma")
    }
    assert found(tmp_path, {**files, **keys}) == {}


def test_what_a_variable_decides_is_not_the_same(tmp_path: Path) -> None:
    tasks = (
        "- template: {src: hostname.j2, dest: /etc/hostname}\n"
        "- template: {src: hostapd.conf.j2, dest: /etc/hostapd/hostapd.conf}\n"
        "- template: {src: wg0.conf.j2, dest: /etc/wireguard/wg0.conf}\n"
    )
    files = {
        "site.yml": "- hosts: all\n  roles: [vpn]\n",
        ROLE: tasks,
        "roles/vpn/templates/hostname.j2": "{{ inventory_hostname }}\n",
        "roles/vpn/templates/hostapd.conf.j2": "ssid=rover\nwpa_passphrase={{ passphrase }}\n",
        "roles/vpn/templates/wg0.conf.j2": "{% if inventory_hostname == 'alpha' %}\n" + VPN + "{% endif %}\n",
    }
    assert found(tmp_path, files) == {}


def test_a_key_that_a_vault_holds_is_one_key(tmp_path: Path) -> None:
    files = {
        "site.yml": "- hosts: rovers\n  tasks:\n    - copy: {src: tls.key, dest: /etc/robot/tls.key}\n",
        "files/tls.key": "$ANSIBLE_VAULT;1.1;AES256\n6162\n",
    }
    assert found(tmp_path, files) == {"fleet/same-tls-key": ["alpha", "beta"]}


def test_what_lies_on_the_robot_counts_in_place_of_what_would_come_there(tmp_path: Path) -> None:
    robots = {
        f"robots/{host}/etc/wireguard/wg0.conf": VPN.replace("Q", host[0].upper())
        for host in ("alpha", "beta", "gamma")
    }
    root = 'all:\n  vars: {bringup_lint_root: "robots/{{ inventory_hostname }}"}\n'
    files = {"site.yml": "- hosts: all\n  roles: [vpn]\n", ROLE: COPY, "roles/vpn/files/wg0.conf": VPN, **robots}
    assert found(tmp_path, files, root + HOSTS) == {}


def test_a_key_that_comes_to_two_places(tmp_path: Path) -> None:
    backup = "- copy: {src: wg0.conf, dest: /var/backups/wg0.conf.bak}\n"
    files = {"site.yml": "- hosts: rovers\n  roles: [vpn]\n", ROLE: COPY + backup, "roles/vpn/files/wg0.conf": VPN}
    assert found(tmp_path, files) == {"fleet/same-network-key": ["alpha", "beta"]}


def test_playbooks_above_the_inventory(tmp_path: Path) -> None:
    write(tmp_path, {"inventories/hall/hosts.yml": HOSTS, "ansible.cfg": "[defaults]\n", "files/a.key": "x"})
    write(tmp_path, {"site.yml": "- hosts: arms\n  tasks:\n    - copy: {src: a.key, dest: /etc/robot/a.key}\n"})
    write(tmp_path, {"playbooks/rovers.yml": "- hosts: rovers\n  roles: [vpn]\n", ROLE: COPY})
    write(tmp_path, {"roles/vpn/files/wg0.conf": VPN})
    members = read_inventory([str(tmp_path / "inventories/hall/hosts.yml")]).members
    assert {each.name: [place for place, _ in each.delivered] for each in members} == {
        "alpha": ["/etc/wireguard/wg0.conf"],
        "beta": ["/etc/wireguard/wg0.conf"],
        "gamma": ["/etc/robot/a.key"],
    }


@pytest.mark.parametrize("source", ["{out}/", "{out}/a.key", "linked/", "linked", "linked/a.key", "tied.key", "deep"])
def test_what_lies_outside_of_the_project_is_not_read(tmp_path: Path, source: str) -> None:
    out, project = tmp_path / "out", tmp_path / "project"
    write(out, {"a.key": "x"})
    write(project, {"roles/vpn/files/deep/b.key": "x"})
    (project / "roles/vpn/files/linked").symlink_to(out)
    (project / "roles/vpn/files/tied.key").symlink_to(out / "a.key")
    (project / "roles/vpn/files/deep/tied.key").symlink_to(out / "a.key")
    task = f"- copy: {{src: '{source.format(out=out)}', dest: /etc/robot}}\n"
    places = delivered(project, {"site.yml": "- hosts: all\n  roles: [vpn]\n", ROLE: task})
    assert set(places) == ({"/etc/robot/deep/b.key"} if source == "deep" else set())


@pytest.mark.parametrize("name", ["{out}", "linked", "../../out"])
def test_a_role_outside_of_the_project_is_not_read(tmp_path: Path, name: str) -> None:
    out, project = tmp_path / "out", tmp_path / "project"
    write(out, {"tasks/main.yml": COPY, "files/wg0.conf": VPN})
    write(project, {"roles/vpn/tasks/main.yml": "[]\n"})
    (project / "roles/linked").symlink_to(out)
    play = f"- hosts: all\n  roles: ['{name.format(out=out)}']\n"
    assert delivered(project, {"site.yml": play}) == {}


def test_a_link_to_another_file_of_the_project(tmp_path: Path) -> None:
    write(tmp_path, {"shared/a.key": "x", "roles/vpn/files/b.key": "x"})
    (tmp_path / "roles/vpn/files/a.key").symlink_to("../../../shared/a.key")
    task = "- copy: {src: a.key, dest: /etc/robot/a.key}\n"
    places = delivered(tmp_path, {"site.yml": "- hosts: arms\n  roles: [vpn]\n", ROLE: task})
    assert places == {"/etc/robot/a.key": ["gamma"]}


def test_roles_that_need_each_other_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    parsed: list[str] = []
    monkeypatch.setattr(plays, "parse", lambda source: parsed.append(source.name) or parse(source))
    files = {
        "site.yml": "- hosts: all\n  roles: [vpn]\n",
        ROLE: "- include_role: {name: vpn}\n" + "- include_tasks: main.yml\n" * 5 + COPY,
        "roles/vpn/meta/main.yml": "dependencies: [vpn, {role: vpn}]\n",
        "roles/vpn/files/wg0.conf": VPN,
    }
    assert found(tmp_path, files) == {"fleet/same-network-key": ["alpha", "beta", "gamma"]}
    assert len(parsed) == len(set(parsed))
