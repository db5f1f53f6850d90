"""The real rcl does with the ROS_SECURITY_* variables and ``--enclave`` what the rules say it does."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(
    importlib.util.find_spec("rclpy") is None, reason="needs pip install 'ros-jazzy-rclpy[fastrtps]'"
)

PROBE = """
import json, os, sys
from rclpy.context import Context
import rclpy
from rclpy.node import Node

outcomes = []
for variables, arguments in json.load(sys.stdin):
    for name in [name for name in os.environ if name.startswith("ROS_SECURITY_")]:
        del os.environ[name]
    os.environ.update(variables)
    context = Context()
    try:
        rclpy.init(args=arguments, context=context)
        Node("probe", context=context, start_parameter_services=False, enable_rosout=False)
        outcomes.append("created")
    except Exception as error:
        outcomes.append(str(error))
print("OUTCOMES " + json.dumps(outcomes))
"""
ON = {"ROS_SECURITY_ENABLE": "true"}
ENFORCE = {**ON, "ROS_SECURITY_STRATEGY": "Enforce"}
CASES = [
    (
        {"ROS_SECURITY_ENABLE": "TRUE", "ROS_SECURITY_STRATEGY": "Enforce", "ROS_SECURITY_KEYSTORE": "NONE"},
        [],
        "created",
    ),
    (
        {"ROS_SECURITY_ENABLE": "True", "ROS_SECURITY_STRATEGY": "Enforce", "ROS_SECURITY_KEYSTORE": "NONE"},
        [],
        "created",
    ),
    ({"ROS_SECURITY_ENABLE": "1", "ROS_SECURITY_STRATEGY": "Enforce", "ROS_SECURITY_KEYSTORE": "NONE"}, [], "created"),
    (
        {"ROS_SECURITY_ENABLE": "yes", "ROS_SECURITY_STRATEGY": "Enforce", "ROS_SECURITY_KEYSTORE": "NONE"},
        [],
        "created",
    ),
    ({"ROS_SECURITY_KEYSTORE": "NONE", "ROS_SECURITY_STRATEGY": "Enforce"}, [], "created"),
    ({**ENFORCE, "ROS_SECURITY_KEYSTORE": "NONE"}, [], "enclaves' does not exist"),
    ({**ENFORCE, "ROS_SECURITY_KEYSTORE": "~/keystore"}, [], "'~/keystore/enclaves' does not exist"),
    ({**ON, "ROS_SECURITY_STRATEGY": "enforce", "ROS_SECURITY_KEYSTORE": "NONE"}, [], "created"),
    ({**ON, "ROS_SECURITY_STRATEGY": "ENFORCE", "ROS_SECURITY_KEYSTORE": "NONE"}, [], "created"),
    ({**ON, "ROS_SECURITY_STRATEGY": "Strict", "ROS_SECURITY_KEYSTORE": "NONE"}, [], "created"),
    ({**ON, "ROS_SECURITY_STRATEGY": "Permissive", "ROS_SECURITY_KEYSTORE": "NONE"}, [], "created"),
    ({**ON, "ROS_SECURITY_KEYSTORE": "NONE"}, [], "created"),
    (ENFORCE, [], "error not set"),
    ({**ENFORCE, "ROS_SECURITY_KEYSTORE": "STORE"}, ["/lawn/motor"], "enclaves/lawn/motor' does not exist"),
    (
        {**ENFORCE, "ROS_SECURITY_KEYSTORE": "STORE", "ROS_SECURITY_ENCLAVE_OVERRIDE": "/x"},
        ["/lawn/y"],
        "enclaves/x' does not",
    ),
    ({**ENFORCE, "ROS_SECURITY_KEYSTORE": "STORE", "ROS_SECURITY_ENCLAVE_OVERRIDE": "lawn/x"}, [], "does not exist"),
    ({}, ["lawn/driver"], "Enclave name is not valid"),
    ({}, ["/lawn/left-driver"], "Enclave name is not valid"),
    ({}, ["/lawn//driver"], "Enclave name is not valid"),
    ({}, ["/lawn/driver/"], "Enclave name is not valid"),
    ({}, ["/2lawn"], "Enclave name is not valid"),
    ({}, ["/lawn/driver"], "created"),
    ({}, ["/"], "created"),
]


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    store = tmp_path_factory.mktemp("keystore")
    Path(store, "enclaves").mkdir()
    places = {"STORE": str(store), "NONE": str(store / "none")}
    batch = [
        (
            {name: places.get(value, value) for name, value in variables.items()},
            ["--ros-args", "--enclave", *enclave] if enclave else [],
        )
        for variables, enclave, _ in CASES
    ]
    run = subprocess.run(
        [sys.executable, "-c", PROBE],
        input=json.dumps(batch),
        capture_output=True,
        text=True,
        timeout=60,
        env={**os.environ, "ROS_DOMAIN_ID": "77", "ROS_LOCALHOST_ONLY": "1"},
    )
    line = next((line for line in run.stdout.splitlines() if line.startswith("OUTCOMES ")), None)
    assert line is not None, run.stderr
    return json.loads(line.removeprefix("OUTCOMES "))


@pytest.mark.parametrize("at", range(len(CASES)))
def test_rcl_agrees(at: int, outcomes: list[str]) -> None:
    assert CASES[at][2] in outcomes[at]
