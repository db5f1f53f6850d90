"""A process of its own that starts real nodes: environments as JSON on stdin, a report for each on stdout.

Each case has the variables of ROS that are set, and ``node``: whether to create a node, or only the context.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from typing import NamedTuple

MARK = "@@"


class Started(NamedTuple):
    domain: int | None
    """What the context says; None when there is none."""
    running: bool
    """Whether all that was asked for could be created."""
    output: str
    """Everything that the process printed meanwhile, and the exception; ``died`` when it ended."""


def start(cases: list[dict[str, str]], *, node: bool = True, each_alone: bool = False) -> list[Started]:
    """What becomes of nodes with these variables, in order.

    A case that ends its process costs only itself.
    """
    answers: list[Started] = []
    while len(answers) < len(cases):
        rest = cases[len(answers) :][: 1 if each_alone else None]
        run = subprocess.run(
            [sys.executable, __file__],
            input=json.dumps({"node": node, "cases": rest}),
            capture_output=True,
            text=True,
            errors="replace",
            timeout=120,
            check=False,
            env={name: value for name, value in os.environ.items() if not _is_read(name)},
        )
        finished = _read(run.stdout)
        answers += finished
        if len(rest) > len(finished):
            output = run.stdout.rpartition(f"\n{MARK} begin\n")[2]
            answers.append(Started(None, False, f"{output}\ndied with {run.returncode}"))
    return answers


def _is_read(name: str) -> bool:
    return name.startswith(("ROS_", "RMW_", "RCUTILS_", "FASTRTPS_", "FASTDDS_", "CYCLONEDDS_"))


def _read(output: str) -> list[Started]:
    found = []
    for text, answer in re.findall(rf"^{MARK} begin\n(.*?)^{MARK} end ([^\n]*)$", output, flags=re.M | re.S):
        said = json.loads(answer)
        found.append(Started(said["domain"], said["running"], text + said["error"]))
    return found


def main() -> None:
    task = json.load(sys.stdin)
    os.dup2(1, 2)
    for variables in task["cases"]:
        for name in [name for name in os.environ if _is_read(name)]:
            del os.environ[name]
        os.environ.update(variables)
        os.write(1, f"\n{MARK} begin\n".encode())
        answer = json.dumps(attempt(task["node"]))
        os.write(1, f"\n{MARK} end {answer}\n".encode())


def attempt(node: bool) -> dict[str, object]:
    """A context, a node in it if that is asked for, and a line of its log."""
    import rclpy
    from rclpy.context import Context

    context = Context()
    domain = None
    try:
        rclpy.init(context=context)
        domain = context.get_domain_id()
        if node:
            options = {"enable_rosout": False, "start_parameter_services": False}
            probe = rclpy.create_node("probe", context=context, **options)
            probe.get_logger().info("hello")
            probe.destroy_node()
        context.shutdown()
    except Exception as error:
        return {"domain": domain, "running": False, "error": str(error)}
    return {"domain": domain, "running": True, "error": ""}


if __name__ == "__main__":
    main()
