"""The page of a fleet of a thousand robots in a real, headless Chromium."""

from __future__ import annotations

import pytest

from bringup_lint.finding import Severity
from bringup_lint.fleet.fleet import Difference
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.fleet import FleetPlace
from bringup_lint.fleet.summary import Own
from bringup_lint.fleet.summary import Summary
from bringup_lint.report.fleet import FleetReport
from bringup_lint.report.fleet import render
from bringup_lint.report.model import RuleDoc
from tests.browser import HUGE
from tests.browser import PHONE
from tests.browser import WIDE

pytestmark = pytest.mark.slow

RULE = RuleDoc("systemd/root-user", "ROS runs as root", Severity.WARNING, uri="https://example.org/systemd/root-user/")
ROLES = ("rover", "arm", "charger")


def robot(number: int) -> Summary:
    own = Own(
        "systemd/root-user", "warning", "ROS runs as root", "etc/systemd/system/rover.service", 8, 1, f"{number:032}"
    )
    failures = ("robots/0999.tar: not a tar archive",) if number == 999 else ()
    name, role, site = f"rover-{number:04}", ROLES[number % 3], f"hall {number % 2}"
    return Summary(name, role, site, path=f"robots/{name}", files=500, own=(own,) * (number % 4), failures=failures)


@pytest.fixture(scope="module")
def page() -> str:
    robots = tuple(robot(number) for number in range(1000))
    names = tuple(each.name for each in robots if each.role == "rover")
    drift = Difference("net.core.rmem_max", "2147483647", names[:-1], "212992", names[-1:])
    place = FleetPlace(names[-1], "etc/sysctl.d/60-dds.conf", 1)
    clones = tuple(FleetPlace(name, "etc/machine-id", 1) for name in names[:2])
    findings = (
        FleetFinding(
            "2 robots have the same machine-id",
            clones,
            "make a new one",
            severity=Severity.ERROR,
            rule="fleet/same-machine-id",
        ),
        FleetFinding("net.core.rmem_max differs", (place,), difference=drift, rule="fleet/drift"),
    )
    return "".join(render("html", FleetReport(robots, findings, {RULE.id: RULE})))


def shown(tab, selector: str) -> int:
    return tab.locator(f"{selector}:visible").count()


@pytest.mark.parametrize("viewport", [PHONE, WIDE, HUGE], ids=lambda viewport: str(viewport["width"]))
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_is_cut(opened, page: str, viewport: dict[str, int], scheme: str) -> None:
    tab = opened(page, viewport, color_scheme=scheme)
    assert tab.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert tab.evaluate("getComputedStyle(document.querySelector('thead th')).backgroundColor") == (
        "rgb(255, 255, 255)" if scheme == "light" else "rgb(23, 28, 34)"
    )
    assert shown(tab, "th[scope=row]") == 1000 + len(ROLES) * 2


def test_search_finds_robots_roles_and_rules(opened, page: str) -> None:
    tab = opened(page)
    tab.keyboard.press("/")
    tab.keyboard.type("rover-0003 hall")
    assert shown(tab, "tr[data-words] th[scope=row]") == 1
    tab.keyboard.press("Escape")
    assert tab.input_value("#search") == ""
    tab.fill("#search", "drift")
    assert tab.locator("details:visible").all_inner_texts() == [tab.inner_text("#f1")]
    tab.fill("#search", "nothing like this")
    assert tab.is_visible("#none")


def test_the_matrix_leads_to_both_sides_of_a_difference(opened, page: str) -> None:
    tab = opened(page)
    tab.focus("a[title='fleet/drift']")
    tab.keyboard.press("Enter")
    left, right = (tab.locator(f"#f1 .sides > div >> nth={side}").bounding_box() for side in (0, 1))
    assert left["y"] == right["y"] and left["x"] + left["width"] <= right["x"]
    assert tab.locator("#f1 pre").all_inner_texts() == ["2147483647", "212992"]


def test_on_a_phone_the_sides_are_below_each_other(opened, page: str) -> None:
    tab = opened(page, PHONE)
    tab.click("#f1 summary")
    left, right = (tab.locator(f"#f1 .sides > div >> nth={side}").bounding_box() for side in (0, 1))
    assert left["y"] + left["height"] <= right["y"] and left["x"] == right["x"]


def test_a_robot_leads_to_what_was_found_on_it_alone(opened, page: str) -> None:
    tab = opened(page)
    tab.click("a[href='#r3']")
    assert "systemd/root-user ROS runs as root" in tab.inner_text("#r3")
    assert "and 2 more" in tab.inner_text("#r3")
    assert "not a tar archive" in tab.inner_text("#r999")


def test_robots_that_a_finding_names_come_first(opened, page: str) -> None:
    tab = opened(page)
    rows = tab.locator("table:not(.counts) th[scope=row]").all_inner_texts()
    assert rows[:4] == ["rover-0000", "rover-0003", "rover-0999", "rover-0001"]


def test_robots_findings_and_rules_are_linked(opened, page: str) -> None:
    tab = opened(page)
    row = tab.locator("tr", has=tab.locator("a[href='#r3']")).locator("td")
    assert row.all_inner_texts() == ["rover at hall 1", "1", "3", "", "E"]
    tab.click("#f0 summary")
    tab.click("#f0 li >> text=rover-0003")
    assert "With others" in tab.inner_text("#r3")
    tab.click("#r3 a:has-text('fleet/same-machine-id')")
    assert tab.evaluate("location.hash") == "#f0"
    assert tab.get_attribute("#r3 a.rule", "href") == RULE.uri


def test_the_colours_can_be_changed(opened, page: str) -> None:
    tab = opened(page, color_scheme="light")
    tab.click("#theme")
    assert tab.evaluate("getComputedStyle(document.querySelector('thead th')).backgroundColor") == "rgb(23, 28, 34)"


def test_without_scripts_all_is_there(opened, page: str) -> None:
    tab = opened(page, java_script_enabled=False)
    tab.click("#f0 summary")
    assert tab.is_visible("text=make a new one")
