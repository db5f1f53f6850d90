"""Draws trees with the real command, and reads the picture."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import jsonschema

from tests.conftest import PROJECT
from tests.lint import lint

ROBOTS = PROJECT / "fixtures/robots"


def drawn(folder: Path, *arguments: str) -> dict[str, Any]:
    run = lint("graph", "--format", "json", *arguments, cwd=folder)
    assert (run.code, run.stderr) == (0, ""), run.stderr
    return json.loads(run.stdout)


def said(document: dict[str, Any]) -> set[tuple[str, str, str]]:
    labels = {node["id"]: node["label"] for node in document["nodes"]}
    return {(labels[edge["source"]], edge["kind"], labels[edge["target"]]) for edge in document["edges"]}


def tree(folder: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def check(document: dict[str, Any]) -> None:
    """The schema, and what it cannot say: every reference leads somewhere."""
    schema = json.loads((PROJECT / "docs/graph.schema.json").read_text("utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.Draft202012Validator(schema).validate(document)
    ids = [node["id"] for node in document["nodes"]]
    assert len(ids) == len(set(ids))
    assert {end for edge in document["edges"] for end in (edge["source"], edge["target"])} <= set(ids)
    numbers = {index for each in (*document["nodes"], *document["edges"]) for index in each["findings"]}
    assert numbers <= set(range(len(document["findings"])))
    ranks = {node["id"]: node["rank"] for node in document["nodes"]}
    for edge in document["edges"]:
        if edge["kind"] == "orders" and ranks[edge["source"]] is not None:
            assert ranks[edge["source"]] <= ranks[edge["target"]]
