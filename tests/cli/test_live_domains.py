"""Other domains in ``live``: which are looked at, by the ports of this computer, and what is advised."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from bringup_lint.live import ports
from bringup_lint.live.ports import domains_of
from bringup_lint.live.ports import open_domains
from tests.conftest import PROJECT
from tests.lint import lint

TABLE = """   sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode
 1873: 020200C0:AC15 00000000:0000 07 00000000:00000000 00:00000000 00000000     0        0 6056759
15632: 00000000:21D4 00000000:0000 07 00000000:00000000 00:00000000 00000000     0        0 6056756
15633: 00000000:21D5 00000000:0000 07 00000000:00000000 00:00000000 00000000     0        0 6056757
"""
TABLE6 = """  sl  local_address                         remote_address                        st tx_queue rx_queue
 1873: 00000000000000000000000000000000:46E6 00000000000000000000000000000000:0000 07 00000000:00000000
"""


@pytest.mark.parametrize(
    ("bound", "domains"),
    [
        ({7400}, [0]),
        ({7400 + 250 * 42}, [42]),
        ({7410 + 250 * 5, 7411 + 250 * 5}, [5]),
        ({7424, 7425, 7660, 7661}, [0, 1]),
        ({7410 + 250 * 5}, []),
        ({7411 + 250 * 5, 7412 + 250 * 5}, []),
        ({7402, 7403}, []),
        ({7400 + 250 * 233}, []),
        ({53, 5353, 7150}, []),
    ],
)
def test_the_domains_of_ports(bound: set[int], domains: list[int]) -> None:
    assert domains_of(bound) == domains


def test_the_tables_of_the_kernel(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "udp").write_text(TABLE)
    (tmp_path / "udp6").write_text(TABLE6)
    monkeypatch.setattr(ports, "TABLES", (str(tmp_path / "udp"), str(tmp_path / "udp6"), str(tmp_path / "none")))
    assert open_domains() == [5, 43]


@pytest.mark.parametrize(
    ("loads", "advice"),
    [
        (True, "otter.service loads ros.env: restart it, and look for what starts nodes without it, such as a shell"),
        (False, "make otter.service load ros.env"),
    ],
)
def test_the_advice_on_a_node_of_another_domain(loads: bool, advice: str, tmp_path: Path) -> None:
    tree = shutil.copytree(PROJECT / "fixtures/live/domain_mismatch/bad_single", tmp_path / "tree")
    unit = tree / "etc/systemd/system/otter.service"
    if not loads:
        unit.write_text(unit.read_text().replace("EnvironmentFile=", "# "))
    run = lint("live", "--load", "graph.yaml", "--output-format", "json", "--select", "live/domain-mismatch", cwd=tree)
    assert [each["advice"] for each in json.loads(run.stdout)["findings"]] == [advice]
