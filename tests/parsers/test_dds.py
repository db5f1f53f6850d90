"""The DDS readers on any input, and what the command says of hostile files."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.discover.kinds import kind_of
from bringup_lint.facts import table
from bringup_lint.model.cyclonedds import VERSIONS
from bringup_lint.model.fastdds import VERSIONS as FAST_VERSIONS
from bringup_lint.model.schema import Code
from bringup_lint.parsers import cyclonedds
from bringup_lint.parsers import fastdds
from bringup_lint.parsers.cyclonedds_schema import schema
from bringup_lint.source import Source
from tests.lint import lint

NAMES = sorted({row["path"].replace("@", "/").rpartition("/")[2] for row in table("dds/cyclonedds")})
PROFILE_NAMES = sorted({row["path"].replace("@", "/").rpartition("/")[2] for row in table("dds/fastdds")})
VALUES = st.sampled_from(
    ["true", "no", "10MB", "5 s", "${X:-1}", "${", "eth0", "", " x ", "é", "1" * 40, "0x10", "-1", "inf"]
)


def elements(names: list[str], root: str) -> st.SearchStrategy[str]:
    name = st.sampled_from(names)
    leaf = st.builds(lambda tag, value: f"<{tag}>{value}</{tag}>", name, VALUES)
    attribute = st.builds(lambda tag, key, value: f'<{tag} {key}="{value}"/>', name, name, VALUES)
    broken = st.sampled_from(["<", "</x>", "<!-- -- -->", "&", "<a", "text", "<?x?>", "]]>"])
    node = st.recursive(
        leaf | attribute | broken,
        lambda inner: st.builds(
            lambda tag, children: f"<{tag}>{''.join(children)}</{tag}>", name, st.lists(inner, max_size=4)
        ),
        max_leaves=12,
    )
    return st.lists(node, max_size=4).map(lambda nodes: f"<{root}>{''.join(nodes)}</{root}>")


def inside(where: object, text: str) -> bool:
    span = getattr(where, "span", where)
    return 0 <= span.start <= span.end <= len(text)


@given(elements(NAMES, "CycloneDDS"), st.sampled_from(VERSIONS), st.booleans())
def test_cyclonedds_reads_anything(text: str, version: str, inline: bool) -> None:
    configuration = cyclonedds.parse(Source("a.xml", text), version, inline=inline)
    assert all(inside(remark.where, text) for remark in configuration.all_remarks)
    for domain in configuration.domains:
        assert all(inside(setting.value, text) and setting.item.path for setting in domain.settings)


@given(elements(PROFILE_NAMES, "profiles"), st.sampled_from(FAST_VERSIONS))
def test_fastdds_reads_anything(text: str, version: str) -> None:
    profiles = fastdds.parse(Source("a.xml", text), version)
    assert all(inside(remark.where, text) for remark in profiles.remarks)


@given(st.text(max_size=200))
def test_any_text_is_read(text: str) -> None:
    cyclonedds.parse(Source("a.xml", text))
    fastdds.parse(Source("a.xml", text))


@pytest.mark.parametrize("version", VERSIONS)
def test_moved_items_lead_to_items(version: str) -> None:
    known = schema(version).items
    assert all(item.moved_to in known for item in known.values() if item.moved_to)


def entities() -> str:
    layers = "".join(f'<!ENTITY l{n + 1} "{f"&l{n};" * 10}">' for n in range(9))
    return f'<!DOCTYPE CycloneDDS [<!ENTITY l0 "lol">{layers}]>\n<CycloneDDS><Domain Id="&l9;"/></CycloneDDS>'


HOSTILE = {
    "entities": entities(),
    "external": '<!DOCTYPE CycloneDDS [<!ENTITY x SYSTEM "file:///etc/passwd">]>\n<CycloneDDS>&x;</CycloneDDS>',
    "deep": "<CycloneDDS>" + "<Domain>" * 100_000,
    "wide": "<CycloneDDS>" + "<Domain/>" * 200_000,
    "attributes": "<CycloneDDS " + 'a="b" ' * 100_000 + "/>",
    "cut": "<CycloneDDS><Domain",
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_files_are_refused(name: str, tmp_path: Path) -> None:
    (tmp_path / "cyclonedds.xml").write_text(HOSTILE[name], "utf-8")
    run = lint("--output-format", "concise", ".", cwd=tmp_path)
    assert "[cyclonedds/" in run.stdout and "root:" not in run.stdout and run.code == 1, run


@pytest.mark.parametrize(
    "data", [b"<CycloneDDS>\xff\xfe</CycloneDDS>", "<CycloneDDS/>".encode("utf-16"), b"<CycloneDDS>\0"]
)
def test_wrong_encodings_are_findings(data: bytes, tmp_path: Path) -> None:
    (tmp_path / "cyclonedds.xml").write_bytes(data)
    run = lint("--output-format", "concise", "cyclonedds.xml", cwd=tmp_path)
    assert run.code == 1 and "cyclonedds.xml" in run.stdout


@pytest.mark.parametrize(
    ("path", "text", "kind"),
    [
        ("a.xml", "<CycloneDDS/>", "cyclonedds"),
        ("a.xml", "\n<!-- x --><?xml version='1.0'?><cyclonedds>", "cyclonedds"),
        ("config/cyclonedds.xml", "<General/>", "cyclonedds"),
        ("config/network.xml", "<General/>", ""),
        ("a.txt", "<CycloneDDS/>", ""),
        ("a.xml", "<dds><profiles/></dds>", "fastdds"),
        ("a.xml", "<profiles><participant profile_name='a'/></profiles>", "fastdds"),
        ("a.xml", "<dds xmlns='http://www.eprosima.com'/>", "fastdds"),
        ("fastdds.xml", "<DDS><profiles/></DDS>", "fastdds"),
        ("a.xml", "<dds><qos_library name='a'/></dds>", ""),
        ("governance.xml", "<dds><domain_access_rules/></dds>", ""),
        ("a.xml", "<profiles><profile><id>maven</id></profile></profiles>", ""),
        ("a.launch.xml", "<launch/>", ""),
    ],
)
def test_kind(path: str, text: str, kind: str) -> None:
    found = kind_of(path, lambda: text)
    assert (found if found in ("cyclonedds", "fastdds") else "") == kind


@pytest.mark.corpus
def test_robots_of_the_corpus(corpus: Path) -> None:
    """Robots whose files are labelled clean stay silent; the one labelled buffer is found."""
    found = []
    for folder in sorted(corpus.iterdir()):
        if folder.is_dir() and not folder.name.startswith(("eProsima", "eclipse")):
            run = lint("--select", "cyclonedds", "--select", "fastdds", "--output-format", "concise", ".", cwd=folder)
            found += [f"{folder.name}/{line}" for line in run.stdout.splitlines() if line]
    assert len(found) == 1
    assert "config/cyclonedds.xml:43:" in found[0] and "socket-buffer-exceeds-sysctl" in found[0]


def test_fastdds_ends_at_an_end_tag_behind_the_root():
    text = '<profiles><participant profile_name="a" is_default_profile="true"/></profiles>'
    assert not fastdds.parse(Source("a.xml", f"{text}</dds><bogus")).dropped
    assert fastdds.parse(Source("a.xml", f"</dds>{text}")).dropped


BOMB = "".join(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 10))
ATTACKS = [
    f'<!DOCTYPE x [<!ENTITY e0 "x">{BOMB}]>',
    '<!DOCTYPE x SYSTEM "http://192.0.2.1/x.dtd">',
    '<!DOCTYPE x [<!ENTITY e9 SYSTEM "file:///etc/passwd">]>',
]


@pytest.mark.parametrize("head", ATTACKS)
def test_attacks_in_files_and_inline_are_named_and_load_nothing(head: str) -> None:
    text = f"{head}<CycloneDDS><Domain><General><AllowMulticast>&e9;</AllowMulticast></General></Domain></CycloneDDS>"
    for inline in (False, True):
        found = cyclonedds.parse(Source("a.xml", text), inline=inline)
        assert any(remark.code == "xml" for remark in found.remarks)
        assert "root:" not in str([remark.detail for remark in found.all_remarks])
    text = f'{head}<profiles><participant profile_name="&e9;" is_default_profile="true"/></profiles>'
    profiles = fastdds.parse(Source("a.xml", text))
    assert any(remark.code == "xml" for remark in profiles.remarks)
    assert [str(profile.name) for profile in profiles.profiles] == ["&e9;"]


def test_deep_and_wide_trees_cost_linear_time() -> None:
    for text in ("<a>" * 200_000, "<CycloneDDS>" + "<Domain/>" * 20_000, "<profiles>" * 100_000):
        assert any(remark.fatal for remark in cyclonedds.parse(Source("a.xml", text)).remarks)
        assert fastdds.parse(Source("a.xml", text)).dropped


@pytest.mark.parametrize(("index", "fits"), [(29062, True), (29063, False)])
def test_two_ports_for_each_participant(index: int, fits: bool) -> None:
    """7400 + 2 * 29062 + 11 = 65535, the highest port."""
    written = f"<Discovery><ParticipantIndex>{index}</ParticipantIndex></Discovery>"
    source = Source("a.xml", f"<CycloneDDS><Domain>{written}</Domain></CycloneDDS>")
    (domain,) = cyclonedds.parse(source, environment={}).domains
    assert (Code.PORTS not in [remark.code for remark in domain.remarks]) == fits
