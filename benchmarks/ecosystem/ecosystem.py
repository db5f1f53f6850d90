"""Every error and warning on public robots, compared with a ledger of verdicts.

    python benchmarks/ecosystem/ecosystem.py CHECKOUTS [--use read|held-out|all] [--record] [--rule ID] [--jobs N]

CHECKOUTS holds one folder a repository of ``repositories.tsv``, called ``owner+name``, at the commit named there. A
finding that the ledger does not know has appeared; one that is gone is told, too. With ``--record`` the new findings
are added to the ledger without a verdict, to be read and judged. The exit code is 1 when a finding has no verdict, or
when one that appeared is judged false or arguable.

The ledger holds facts only: repository, path, line, rule, severity, fingerprint, verdict (true, arguable, false) and a
few words why.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import subprocess
import sys
from collections import Counter
from collections.abc import Iterable
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

HERE = Path(__file__).parent
PROJECT = HERE.parent.parent
LEDGER = HERE / "ledger.tsv"
REPOSITORIES = HERE / "repositories.tsv"
VERDICTS = ("true", "arguable", "false")
SECONDS = 600
"""A robot may take so long."""


class Row(NamedTuple):
    """One finding on one robot."""

    repository: str
    path: str
    line: int
    rule: str
    severity: str
    fingerprint: str
    verdict: str = ""
    why: str = ""

    @property
    def key(self) -> tuple[str, str]:
        return self.repository, self.fingerprint


def repositories(use: str) -> list[str]:
    wanted = {"read": ("read",), "held-out": ("held out",), "all": ("read", "held out")}[use]
    return [row["repository"] for row in _table(REPOSITORIES) if row["use"] in wanted]


def ledger() -> list[Row]:
    rows = _table(LEDGER) if LEDGER.exists() else []
    return [Row(**{**row, "line": int(row["line"])}) for row in rows]


def _table(path: Path) -> list[dict[str, str]]:
    lines = [line for line in path.read_text("utf-8").splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines, delimiter="\t", quoting=csv.QUOTE_NONE))


def write(rows: Iterable[Row]) -> None:
    lines = ["# Verdicts on errors and warnings: facts only, nothing of the repositories themselves."]
    lines.append("\t".join(Row._fields))
    lines += ["\t".join(map(str, row)) for row in sorted(rows)]
    LEDGER.write_text("\n".join(lines) + "\n", "utf-8")


def findings(checkouts: Path, repository: str, rules: tuple[str, ...]) -> list[Row] | None:
    """The errors and warnings on one robot; None when it is not there."""
    folder = checkouts / repository.replace("/", "+")
    if not folder.is_dir():
        return None
    select = [word for rule in rules for word in ("--select", rule)]
    command = [
        sys.executable,
        "-m",
        "bringup_lint",
        "--isolated",
        "--exit-zero",
        "--output-format",
        "json",
        *select,
        ".",
    ]
    environment = {**os.environ, "PYTHONPATH": str(PROJECT)}
    run = subprocess.run([*command, "."], cwd=folder, env=environment, capture_output=True, text=True, timeout=SECONDS)
    found = json.loads(run.stdout)["findings"]
    return [
        Row(
            repository,
            each["location"]["path"],
            each["location"]["start"]["line"],
            each["rule"],
            each["severity"],
            each["fingerprint"],
        )
        for each in found
        if each["severity"] != "info" and not each["suppressed"]
    ]


def compared(now: list[Row], before: list[Row]) -> tuple[list[Row], list[Row]]:
    """The findings with the verdicts of the ledger, and the rows of the ledger that are gone."""
    known = {row.key: row for row in before}
    judged = [
        row._replace(verdict=known[row.key].verdict, why=known[row.key].why) if row.key in known else row for row in now
    ]
    keys = {row.key for row in now}
    return judged, [row for row in before if row.key not in keys]


def report(rows: list[Row], gone: list[Row], known: set[tuple[str, str]]) -> Iterator[str]:
    for sign, changed in (("+", [row for row in rows if row.key not in known]), ("-", gone)):
        for row in changed:
            verdict = row.verdict or "not judged"
            yield f"{sign} {row.repository} {row.path}:{row.line} {row.severity}[{row.rule}] {verdict}"
    counts = {row.rule: Counter[str]() for row in rows}
    for row in rows:
        counts[row.rule][row.verdict or "not judged"] += 1
    yield f"\n{'rule':44} {'true':>6} {'arguable':>9} {'false':>6} {'not judged':>11}"
    for rule in sorted(counts, key=lambda name: (-counts[name]["false"] - counts[name]["arguable"], name)):
        each = counts[rule]
        yield f"{rule:44} {each['true']:6} {each['arguable']:9} {each['false']:6} {each['not judged']:11}"
    for name, chosen in (("errors", "error"), ("warnings", "warning"), ("all", "")):
        yield summary(name, [row for row in rows if not chosen or row.severity == chosen])


def summary(name: str, rows: list[Row]) -> str:
    count = Counter(row.verdict for row in rows)
    judged = sum(count[verdict] for verdict in VERDICTS)
    share = f"{count['true'] / judged:.1%} true, {count['false'] / judged:.1%} false" if judged else "none judged"
    return f"{name}: {len(rows)}, {judged} judged, {share}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("checkouts", type=Path)
    parser.add_argument("--use", choices=["read", "held-out", "all"], default="read")
    parser.add_argument("--rule", action="append", default=[], help="only this rule or family")
    parser.add_argument("--repository", action="append", default=[], help="only this repository")
    parser.add_argument("--record", action="store_true", help="write new findings to the ledger, drop those gone")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    chosen = options.repository or repositories(options.use)
    with ThreadPoolExecutor(options.jobs) as pool:
        results = list(pool.map(lambda name: findings(options.checkouts, name, tuple(options.rule)), chosen))
    there = {name for name, found in zip(chosen, results) if found is not None}
    for name in sorted(set(chosen) - there):
        print(f"{name} is not in {options.checkouts}", file=sys.stderr)
    book = ledger()
    within = [row for row in book if row.repository in there and (not options.rule or _is_of(row, options.rule))]
    rows, gone = compared([row for found in results if found is not None for row in found], within)
    known = {row.key for row in within}
    print("\n".join(report(rows, gone, known)))
    if options.record:
        write([row for row in book if row not in within] + rows)
    return int(any(not row.verdict or (row.key not in known and row.verdict != "true") for row in rows))


def _is_of(row: Row, rules: list[str]) -> bool:
    return any(row.rule == rule or row.rule.startswith(f"{rule}/") for rule in rules)


if __name__ == "__main__":
    sys.exit(main())
