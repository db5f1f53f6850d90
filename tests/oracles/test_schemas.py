"""The tables against the official schemas, in the folder that BRINGUP_LINT_SCHEMAS names.

Without the folder, or without lxml, the recorded paths and verdicts in `schemas/` stand for them. Where a library and
its schema differ, the library is right: each difference has a reason here.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from collections.abc import Iterator
from pathlib import Path

import pytest

from bringup_lint.model.schema import Item
from bringup_lint.model.schema import Remark
from bringup_lint.parsers import cyclonedds_schema
from bringup_lint.parsers import fastdds_schema
from bringup_lint.parsers import sros2
from bringup_lint.parsers import sros2_policy
from bringup_lint.parsers import sros2_schema
from bringup_lint.parsers.package_xml import DEPENDENCIES
from bringup_lint.schema.table import Schema
from bringup_lint.source import Source
from tests.oracles.xsd import Xsd

RECORDED = Path(__file__).parent / "schemas"
FOLDER = Path(os.environ.get("BRINGUP_LINT_SCHEMAS", "/nonexistent"))
needs_schemas = pytest.mark.skipif(not FOLDER.is_dir(), reason="BRINGUP_LINT_SCHEMAS is not set")

TABLES: dict[str, tuple[str, Callable[[], Schema]]] = {
    "cyclonedds": ("CycloneDDS", lambda: cyclonedds_schema.schema("11")),
    "fastdds_profiles": ("dds", lambda: fastdds_schema.schema("3.6")),
    "sros2_governance": ("dds", lambda: sros2_schema.schema("governance")),
    "sros2_permissions": ("dds", lambda: sros2_schema.schema("permissions")),
    "sros2_policy": ("policy", lambda: sros2_schema.schema("policy")),
}
"""Schema to its root element and the table."""
DIFFERENCES = {
    r"CycloneDDS/Domain/Compatibility/Allow(InvalidExtensibility|MismatchingTypeId|RecursiveTypes)": "newer than 11.0",
    r"(profiles/)?types(/|$)": "descriptions of data types are not read",
    r"profiles/re(quester|plier)/data_\w+[/@]": "the profile inside a requester or replier is not judged",
    r".*/(sender|security_log)_thread[/@]": "the library reads these threads, the table does not judge them",
    r".*/discoveryServersList/locator/": "the locators of servers are not judged",
    r".*/qos/destination_order": "the library knows destinationOrder",
}
"""Paths of a schema that the tables do not have, and why."""
MANIFESTS = ("package_format1", "package_format2", "package_format3")
NO_DEPENDENCY = {
    "conflict": "keeps packages apart",
    "replace": "keeps packages apart",
    "doc_depend": "is for documentation only",
    "buildtool_export_depend": "is for those who build against the package",
}


def paths_of(name: str) -> list[str]:
    """The paths that a schema allows, its own or the recorded ones."""
    if not FOLDER.is_dir():
        return RECORDED.joinpath(f"{name}.txt").read_text("utf-8").splitlines()
    root = TABLES[name][0] if name in TABLES else "package"
    found = dict.fromkeys(Xsd(FOLDER / f"{name}.xsd").paths(root))
    return [path for path in found if not re.search(r"(^|/)types/", path)]


def expanded(schema: Schema, item: Item, path: str) -> Iterator[str]:
    """Every path of a table, shared structures put in their places."""
    shape = schema.inside(item)
    yield path
    yield from (f"{path}@{name}" for name in (*item.attributes, *shape.attributes))
    for child in shape.children.values():
        for name in (child.name, *child.aliases):
            yield from expanded(schema, child, f"{path}/{name}")


def ours(name: str) -> set[str]:
    schema = TABLES[name][1]()
    tops = [item for item in schema.top.children.values() if not item.path.startswith("{")]
    return {path for item in tops for path in expanded(schema, item, item.path)}


@pytest.mark.parametrize("name", TABLES)
def test_table_has_what_the_schema_has(name: str) -> None:
    known = ours(name)
    paths = [path.removeprefix("dds/") if name == "fastdds_profiles" else path for path in paths_of(name)]
    lacking = [path for path in paths if path not in known and path != "dds"]
    unexplained = [path for path in lacking if not any(re.match(each, path) for each in DIFFERENCES)]
    assert len(paths) > 20
    assert unexplained == []


@pytest.mark.parametrize("name", ["sros2_governance", "sros2_permissions", "sros2_policy"])
def test_schema_has_what_the_table_has(name: str) -> None:
    assert ours(name) - set(paths_of(name)) == set()


@pytest.mark.parametrize("name", MANIFESTS)
def test_dependencies_of_manifests_are_known(name: str) -> None:
    tags = {path.split("/")[1] for path in paths_of(name) if path.count("/") == 1 and "@" not in path}
    depending = {tag for tag in tags if tag.endswith("depend") or tag in NO_DEPENDENCY}
    assert depending - DEPENDENCIES - set(NO_DEPENDENCY) == set()


@needs_schemas
@pytest.mark.parametrize("name", [*TABLES, *MANIFESTS])
def test_recorded_paths_are_those_of_the_schema(name: str, update_expected: bool) -> None:
    text = "".join(f"{path}\n" for path in paths_of(name))
    if update_expected:
        RECORDED.joinpath(f"{name}.txt").write_text(text, "utf-8")
    assert RECORDED.joinpath(f"{name}.txt").read_text("utf-8") == text


GOVERNANCE = """<dds><domain_access_rules><domain_rule><domains><id>0</id>
<id_range><min>10</min><max>20</max></id_range></domains><allow_unauthenticated_participants>false</allow_unauthenticated_participants>
<enable_join_access_control>true</enable_join_access_control><discovery_protection_kind>SIGN</discovery_protection_kind>
<liveliness_protection_kind>ENCRYPT</liveliness_protection_kind><rtps_protection_kind>SIGN</rtps_protection_kind>
<topic_access_rules><topic_rule><topic_expression>*</topic_expression>
<enable_discovery_protection>true</enable_discovery_protection>
<enable_liveliness_protection>true</enable_liveliness_protection>
<enable_read_access_control>true</enable_read_access_control>
<enable_write_access_control>true</enable_write_access_control>
<metadata_protection_kind>ENCRYPT</metadata_protection_kind><data_protection_kind>ENCRYPT</data_protection_kind>
</topic_rule></topic_access_rules></domain_rule></domain_access_rules></dds>"""
PERMISSIONS = """<dds><permissions><grant name="/a"><subject_name>CN=/a</subject_name>
<validity><not_before>2026-01-01T00:00:00</not_before><not_after>2027-01-01T00:00:00</not_after></validity>
<allow_rule><domains><id>0</id></domains><publish><topics><topic>rt/a</topic></topics></publish>
<subscribe><topics><topic>rt/b</topic></topics></subscribe></allow_rule><default>DENY</default>
</grant></permissions></dds>"""
POLICY = """<policy version="0.2.0"><enclaves><enclave path="/a"><profiles><profile ns="/" node="a">
<topics publish="ALLOW" subscribe="DENY"><topic>a</topic></topics>
<services reply="ALLOW"><service>s</service></services>
<actions call="ALLOW"><action>x</action></actions></profile></profiles></enclave></enclaves></policy>"""


def governance_remarks(text: str) -> list[Remark]:
    return sros2.governance(Source("governance.xml", text)).remarks


def permissions_remarks(text: str) -> list[Remark]:
    return sros2.permissions(Source("permissions.xml", text)).remarks


def policy_remarks(text: str) -> list[Remark]:
    return sros2_policy.policy(Source("policy.xml", text)).remarks


DOCUMENTS: dict[str, tuple[str, Callable[[str], list[Remark]]]] = {
    "sros2_governance": (GOVERNANCE, governance_remarks),
    "sros2_permissions": (PERMISSIONS, permissions_remarks),
    "sros2_policy": (POLICY, policy_remarks),
}


def mutants(seed: str) -> Iterator[tuple[str, str]]:
    """The seed, and every document with one element or attribute removed, doubled, renamed, emptied or changed."""
    yield "seed", seed
    for at, match in enumerate(re.finditer(r"<(\w+)([^>]*)>([^<]*)</\1>", seed)):
        whole, name = match[0], match[1]
        changes = {
            "removed": "",
            "doubled": whole * 2,
            "renamed": whole.replace(name, f"{name}x"),
            "emptied": whole.replace(f">{match[3]}<", "><"),
            "changed": whole.replace(f">{match[3]}<", ">bogus<"),
        }
        for change, text in changes.items():
            yield f"{at} {name} {change}", seed[: match.start()] + text + seed[match.end() :]
    for at, match in enumerate(re.finditer(r' (\w+)="([^"]*)"', seed)):
        for change, text in {
            "removed": "",
            "renamed": f' {match[1]}x="{match[2]}"',
            "changed": f' {match[1]}="B"',
        }.items():
            yield f"{at} @{match[1]} {change}", seed[: match.start()] + text + seed[match.end() :]


def verdicts(name: str) -> dict[str, bool]:
    """Whether the schema takes each mutant: its own answers, or the recorded ones."""
    from lxml import etree

    text = FOLDER.joinpath(f"{name}.xsd").read_text("utf-8")
    # libxml2 does not fetch the schema of the xml: attributes
    text = re.sub(r'<xs:import[^>]*/>|<xs:attribute ref="xml:base"[^>]*/>', "", text)
    schema = etree.XMLSchema(etree.fromstring(text.encode()))
    return {label: schema.validate(etree.fromstring(document)) for label, document in mutants(DOCUMENTS[name][0])}


def recorded(name: str) -> dict[str, bool]:
    rows = (line.split("\t") for line in RECORDED.joinpath(f"{name}.verdicts.tsv").read_text("utf-8").splitlines())
    return {label: verdict == "valid" for label, verdict in rows}


NO_TOPIC = "an empty name covers no topic, which the rules report"
REASONS: dict[str, dict[str, str]] = {
    "sros2_governance": {
        "1 min removed": "Cyclone DDS refuses a range without minimum",
        "8 topic_expression emptied": NO_TOPIC,
    },
    "sros2_permissions": {
        "0 subject_name emptied": "no identity has an empty name",
        "4 topic emptied": NO_TOPIC,
        "5 topic emptied": NO_TOPIC,
    },
    "sros2_policy": {},
}
"""Where the schema and the readers differ."""


@pytest.mark.parametrize("name", DOCUMENTS)
def test_documents_are_judged_alike(name: str) -> None:
    seed, read = DOCUMENTS[name]
    expected = recorded(name)
    texts = dict(mutants(seed))
    assert texts.keys() == expected.keys()
    own = {label: not any(remark.fatal for remark in read(text)) for label, text in texts.items()}
    differing = {label for label in texts if own[label] != expected[label]}
    assert differing == set(REASONS[name])


@needs_schemas
@pytest.mark.parametrize("name", DOCUMENTS)
def test_recorded_verdicts_are_those_of_lxml(name: str, update_expected: bool) -> None:
    pytest.importorskip("lxml")
    found = verdicts(name)
    if update_expected:
        text = "".join(f"{label}\t{'valid' if verdict else 'invalid'}\n" for label, verdict in found.items())
        RECORDED.joinpath(f"{name}.verdicts.tsv").write_text(text, "utf-8")
    assert recorded(name) == found
