"""Say which arguments rclpy takes; each list in a process of its own, because some of them make rcl crash.

Usage: python ros_arguments_runner.py < QUESTIONS; a JSON list of lists of words. Prints a list with null for what
is taken, else the kind of the error.
"""

from __future__ import annotations

import json
import os
import sys

from rclpy.context import Context


def verdict(words: list[str]) -> str | None:
    reading, writing = os.pipe()
    process = os.fork()
    if not process:
        try:
            Context().init(["program", *words])
            answer = "taken"
        except BaseException as error:
            answer = type(error).__name__
        os.write(writing, answer.encode())
        os._exit(0)
    os.close(writing)
    answer = os.read(reading, 4096).decode()
    os.close(reading)
    os.waitpid(process, 0)
    return None if answer == "taken" else answer or "crash"


answers = [verdict(words) for words in json.load(sys.stdin)]
print("\n" + json.dumps(answers))
