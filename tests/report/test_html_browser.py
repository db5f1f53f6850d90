"""The page in a real, headless Chromium: it is opened from disk and clicked through."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

from bringup_lint.finding import Finding
from bringup_lint.finding import Related
from bringup_lint.report import Report
from bringup_lint.report.html import page
from bringup_lint.source import Source
from tests.conftest import PROJECT
from tests.lint import lint
from tests.report.html_picture import crowd
from tests.report.html_picture import document
from tests.report.html_picture import hostile
from tests.report.html_picture import mower
from tests.report.html_picture import node
from tests.report.sample import clean
from tests.report.sample import sample
from tests.report.test_html import hostile_report

pytestmark = pytest.mark.slow

DRAWING = """() => [1, 2, 3, 4].map(() => {
  const started = performance.now(); draw(); return performance.now() - started;
})"""
"""Milliseconds in which the picture is drawn again, a few times."""


def nodes(tab, also: str = "") -> list[str]:
    """The labels of the drawn nodes, or of those of a class."""
    return tab.eval_on_selector_all(f".node{also} .label", "found => found.map(one => one.textContent)")


def scale(tab) -> float:
    return tab.evaluate("document.getElementById('scene').getCTM().a")


def opacity(tab, selector: str) -> float:
    return float(tab.eval_on_selector(selector, "one => getComputedStyle(one).opacity"))


def unfolded(tab):
    """The tab with every node in view, however small."""
    tab.evaluate("() => { state.byHand = true; state.folded.clear(); redraw(); }")
    return tab


def choose(tab, label: str) -> None:
    tab.locator(".node", has_text=label).first.click()


def boxes(tab) -> list[dict]:
    return tab.eval_on_selector_all(
        ".node .box",
        """found => found.map(one => {
            const {left, top, right, bottom} = one.getBoundingClientRect();
            return {left, top, right, bottom};
        })""",
    )


def test_a_node_shows_its_findings_and_its_edges(opened) -> None:
    tab = opened(page(mower(), sample()))
    choose(tab, "mower.service")
    details = tab.inner_text("#details")
    assert "All 14 nodes run as root" in details
    assert "orders After=" in details
    assert "etc/mower.service:7" in details
    assert set(nodes(tab, ".lit")) == {
        *("network.target", "blade.service", "mower.service", "mower.env", "mower.launch.py"),
    }
    tab.click("#details .ends >> text=mower.launch.py")
    assert tab.inner_text("#details h2") == "mower.launch.py"
    tab.keyboard.press("Escape")
    assert tab.is_hidden("#details")
    assert nodes(tab, ".lit") == []


def test_findings_and_picture_lead_to_each_other(opened) -> None:
    tab = opened(page(mower(), sample()))
    tab.click("#finding-0 .locate")
    assert nodes(tab, ".chosen") == ["mower.service"]
    assert tab.locator(".edge.lit").count() == 1
    assert "chosen" in tab.get_attribute("#finding-0", "class")
    tab.keyboard.press("Escape")
    choose(tab, "mower.service")
    tab.click("#details >> text=All 14 nodes run as root")
    assert "chosen" in tab.get_attribute("#finding-2", "class")
    assert tab.evaluate("document.activeElement.id") == "finding-2"
    assert not tab.is_visible("#finding-1 .locate")


def test_a_finding_explains_its_rule(opened) -> None:
    tab = opened(page({}, sample()))
    assert tab.is_hidden("#finding-1 .explain")
    tab.click("#finding-0 .explain")
    said = tab.inner_text("#finding-0 .doc")
    assert "The participant binds to nothing, and stays so." in said
    assert "does not match an available interface" in said
    assert tab.get_attribute("#finding-0 .doc a", "href") == "https://www.rfc-editor.org/rfc/rfc1112"
    tab.click("#finding-0 .explain")
    assert tab.locator(".doc").count() == 0


def test_an_edge_says_why(opened) -> None:
    tab = opened(page(mower()))
    tab.locator('.edge[data-kind="binds"]').dispatch_event("click")
    assert "NetworkInterface" in tab.inner_text("#details")
    assert set(nodes(tab, ".lit")) == {"cyclonedds.xml", "enp2s0"}


def test_findings_are_filtered_and_grouped(opened) -> None:
    tab = opened(page(mower(), sample()))
    shown = ".finding:visible"
    assert tab.locator(shown).count() == 8
    tab.click(".chip.error")
    assert tab.locator(shown).count() == 4
    tab.select_option("#family", "udev")
    assert tab.locator(shown).count() == 2
    assert tab.inner_text("#shown") == "2 of 8"
    tab.click(".chip.error")
    tab.select_option("#family", "")
    tab.select_option("#group", "file")
    heads = tab.eval_on_selector_all(".group:not([hidden]) h2", "found => found.map(one => one.textContent)")
    assert heads == ["/srv/image/99-mower.rules 2", "config/empty.xml 1", "etc/systemd/system/mower.service 5"]


def test_search_narrows_and_jumps(opened) -> None:
    tab = opened(page(mower(), sample()))
    tab.keyboard.press("/")
    tab.keyboard.type("14 nodes")
    assert tab.locator(".finding:visible").count() == 1
    tab.fill("#search", "service")
    assert set(nodes(tab, ".found")) == {"blade.service", "mower.service"}
    assert tab.inner_text("#matches") == "2 of 10 nodes"
    tab.press("#search", "Enter")
    first = nodes(tab, ".chosen")
    tab.press("#search", "Enter")
    assert {*first, *nodes(tab, ".chosen")} == {"blade.service", "mower.service"}
    tab.press("#search", "Escape")
    assert tab.input_value("#search") == ""
    assert nodes(tab, ".found") == []
    assert tab.locator(".finding:visible").count() == 8


def test_keyboard_walks_from_node_to_node(opened) -> None:
    tab = opened(page(mower()))
    tab.focus("#canvas")
    before = tab.get_attribute("#scene", "transform")
    tab.keyboard.press("ArrowRight")
    assert tab.get_attribute("#scene", "transform") != before
    tab.keyboard.press("Tab")
    label = "document.activeElement.querySelector('.label').textContent"
    first = tab.evaluate(label)
    walked = [first]
    for _ in range(12):
        tab.keyboard.press("ArrowRight")
        walked.append(tab.evaluate(label))
    assert walked[-1] in ("/cmd_vel", "enp2s0")
    tab.keyboard.press("Enter")
    assert nodes(tab, ".chosen") == [walked[-1]]
    assert tab.evaluate("document.activeElement.matches('.node.chosen')")
    for _ in range(12):
        tab.keyboard.press("ArrowLeft")
    for _ in range(3):
        tab.keyboard.press("ArrowUp")
    assert tab.evaluate("document.activeElement.matches('.node')")
    assert tab.evaluate(label) == "network.target"


def test_zoom_and_pan(opened) -> None:
    tab = unfolded(opened(page(crowd(100))))
    whole = scale(tab)
    tab.focus("#canvas")
    tab.keyboard.press("+")
    assert scale(tab) > whole
    tab.keyboard.press("0")
    assert scale(tab) == pytest.approx(whole)
    tab.click("#out")
    assert scale(tab) < whole
    tab.mouse.move(600, 500)
    tab.mouse.wheel(0, -400)
    assert scale(tab) > whole
    before = boxes(tab)[0]
    tab.mouse.move(700, 880)
    tab.mouse.down()
    tab.mouse.move(740, 860, steps=4)
    tab.mouse.up()
    after = boxes(tab)[0]
    assert after["left"] - before["left"] == pytest.approx(40, abs=1)
    assert after["top"] - before["top"] == pytest.approx(-20, abs=1)
    assert tab.is_hidden("#details")


def test_small_labels_are_left_out(opened) -> None:
    tab = unfolded(opened(page(crowd(100))))
    tab.focus("#canvas")
    for _ in range(8):
        tab.keyboard.press("-")
    assert tab.locator(".node .label >> visible=true").count() == 0
    tab.evaluate("choose({node: 0}, false)")
    assert 1 <= tab.locator(".node .label >> visible=true").count() <= 24
    tab.keyboard.press("Escape")
    for _ in range(12):
        tab.keyboard.press("+")
    assert tab.locator(".node .label >> visible=true").count() == 100


def test_the_mark_of_a_short_name_leaves_its_kind_free(opened) -> None:
    boxed = [node("parameters", "parameter-file", "a", findings=(0,)), node("boot", "unit", "b", 0, (0,))]
    tab = unfolded(opened(page(document(boxed, [], mower()["findings"]), sample())))
    gaps = tab.eval_on_selector_all(
        ".node",
        """found => found.map(one => one.querySelector(".icon").getBoundingClientRect().left
            - one.querySelector(".kind").getBoundingClientRect().right)""",
    )
    assert len(gaps) == 2
    assert min(gaps) > 0


def test_a_layer_folds_and_unfolds(opened) -> None:
    tab = opened(page(mower()))
    tab.click('.band[data-layer="boot"]')
    assert "3 in Boot" in nodes(tab)
    assert "mower.service" not in nodes(tab)
    assert tab.get_attribute('.band[data-layer="boot"]', "aria-expanded") == "false"
    choose(tab, "3 in Boot")
    assert "All 14 nodes run as root" in tab.inner_text("#details")
    tab.click("#details >> text=mower.service")
    assert nodes(tab, ".chosen") == ["mower.service"]
    assert tab.get_attribute('.band[data-layer="boot"]', "aria-expanded") == "true"


def test_focus_leaves_what_a_node_is_tied_to(opened) -> None:
    tab = opened(page(mower()))
    choose(tab, "cyclonedds.xml")
    tab.click("text=Show only what it is tied to")
    assert "/drive" not in nodes(tab)
    assert {"enp2s0", "mower.env", "mower.service", "blade.service"} < set(nodes(tab))
    tab.click("#whole")
    assert len(nodes(tab)) == 10
    tab.locator(".node", has_text="network.target").dblclick()
    assert "/drive" not in nodes(tab)


def test_kinds_of_edges_can_be_hidden(opened) -> None:
    tab = opened(page(mower()))
    tab.click(".legend summary")
    tab.uncheck(".kinds label:has-text('orders') input")
    assert tab.locator(".edge").count() == 8


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_light_and_dark(opened, scheme: str) -> None:
    tab = opened(page(mower(), sample()), color_scheme=scheme)
    lightness = "getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number).reduce((a, b) => a + b)"
    was_dark = tab.evaluate(lightness) < 200
    assert was_dark == (scheme == "dark")
    tab.click("#theme")
    assert (tab.evaluate(lightness) < 200) != was_dark
    tab.click("#theme")
    assert (tab.evaluate(lightness) < 200) == was_dark


def test_four_hundred_nodes(opened) -> None:
    tab = unfolded(opened(page(crowd(400))))
    assert tab.locator(".node").count() == 400
    found = boxes(tab)
    room = tab.locator("#canvas").bounding_box()
    assert all(room["x"] <= box["left"] and box["right"] <= room["x"] + room["width"] for box in found)
    by_column: dict[float, list[dict]] = {}
    for box in found:
        by_column.setdefault(round(box["left"]), []).append(box)
    for column in by_column.values():
        column.sort(key=lambda box: box["top"])
        assert all(above["bottom"] <= below["top"] for above, below in pairwise(column))
    tab.fill("#search", "launch_39")
    tab.press("#search", "Enter")
    assert len(nodes(tab, ".chosen")) == 1
    assert set(nodes(tab, ".chosen")) <= set(nodes(tab, ".found"))
    assert tab.locator(".node.chosen .label").is_visible()


def test_drawing_takes_time_as_the_nodes_do(opened) -> None:
    few, many = (min(tab.evaluate(DRAWING)) for tab in (unfolded(opened(page(crowd(count)))) for count in (100, 800)))
    assert many / 8 <= 3 * max(few, 1)


def test_units_stand_in_the_order_of_the_boot(opened) -> None:
    tab = unfolded(opened(page(crowd(150))))
    columns = tab.evaluate(
        """() => {
            const linked = new Set(drawn.links.flatMap(({from, to}) => [from, to]));
            const columns = {};
            drawn.nodes.forEach(({rank}, index) => {
                const {x, y} = drawn.plan.boxes[index];
                if (rank !== null && linked.has(index)) (columns[x] ??= []).push([y, rank]);
            });
            return Object.entries(columns).sort(([a], [b]) => a - b).map(([, held]) => held);
        }"""
    )
    ranks = [rank for column in columns for _, rank in sorted(column)]
    assert len(set(ranks)) > 4
    assert ranks == sorted(ranks)


def test_no_line_runs_through_a_box(opened) -> None:
    tab = unfolded(opened(page(crowd(80))))
    through = tab.evaluate(
        """() => drawn.lines.flatMap((line, index) => {
            const path = line.querySelector(".line");
            const {from, to} = drawn.links[index];
            const held = [];
            for (let at = 4; at < path.getTotalLength() - 4; at += 8) {
                const {x, y} = path.getPointAtLength(at);
                drawn.plan.boxes.forEach((box, number) => {
                    const [right, down] = [x - box.x, y - box.y];
                    const inside = right > 1 && right < box.width - 1 && down > 1 && down < box.height - 1;
                    if (inside && number !== from && number !== to) held.push(number);
                });
            }
            return held;
        })"""
    )
    assert through == []


def test_names_of_the_tree_do_nothing(opened) -> None:
    tab = opened(page(hostile(), hostile_report()))
    assert len(nodes(tab)) == 2
    choose(tab, "script")
    assert "alert('1')" in tab.inner_text("#details")
    assert tab.locator("#finding-0 .locate").count() == 1


def test_what_is_empty(opened) -> None:
    assert "Clear for bring-up" in opened(page(mower(), clean())).inner_text("#findings")
    assert "No picture" in opened(page({})).inner_text("#picture")
    tab = opened(page({}, sample()))
    assert tab.is_hidden("#picture")
    assert tab.locator(".finding:visible").count() == 8


def test_on_a_phone(opened) -> None:
    tab = opened(page(mower(), sample()), {"width": 390, "height": 844})
    assert tab.is_visible("#finding-0")
    assert tab.evaluate("document.documentElement.scrollWidth") <= 390
    assert cut_off(tab, "#findings") == []
    tab.click("[data-show=picture]")
    assert tab.is_hidden("#finding-0")
    assert "3 in Boot" in nodes(tab)
    assert cut_off(tab, "#canvas .node") == []
    assert smallest_name(tab) >= LEGIBLE
    tab.click("#in")
    assert len(nodes(tab)) == 10
    assert smallest_name(tab) >= LEGIBLE
    tab.click("#fit")
    choose(tab, "3 in Boot")
    tab.click("#details .close")


LEGIBLE = 9
"""Pixels."""


def smallest_name(tab) -> float:
    return 12 * scale(tab)


def cut_off(tab, selector: str) -> list[str]:
    """What the window cuts off at its sides."""
    return tab.eval_on_selector_all(
        f"{selector}, {selector} *",
        """found => found.filter(one => {
            const {left, right, width} = one.getBoundingClientRect();
            return width && (left < -1 || right > innerWidth + 1);
        }).map(one => `${one.tagName} ${one.textContent.slice(0, 40)}`)""",
    )


@pytest.fixture(scope="module")
def robot(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The page of a whole robot."""
    file = tmp_path_factory.mktemp("robot") / "guide.html"
    options = ("--root", ".", "--output-format", "html", "--output-file", file)
    assert lint(*options, cwd=PROJECT / "fixtures/robots/guide/tree").code == 1
    return file.read_text("utf-8")


@pytest.mark.parametrize("size", [(390, 844), (1400, 900), (2560, 1440)], ids=str)
def test_names_can_be_read_from_the_first_view(opened, robot: str, size: tuple[int, int]) -> None:
    tab = opened(robot, {"width": size[0], "height": size[1]})
    assert cut_off(tab, "#findings") == []
    tab.click("[data-show=picture]")
    assert smallest_name(tab) >= LEGIBLE
    assert cut_off(tab, "#canvas .node") == []
    layers = nodes(tab)
    assert ("27 in Boot order" in layers) == (size[0] < 2000), "a large screen shows every name"
    tab.click("#in")
    assert smallest_name(tab) >= LEGIBLE
    assert "heron-stack.service" in nodes(tab)
    tab.click("#fit")
    assert nodes(tab) == layers


def test_a_small_robot_shows_its_names(opened) -> None:
    """Those of small layers as boxes, those that there is no room for in the box of their layer."""
    tab = opened(page(crowd(40), sample()), {"width": 1100, "height": 700})
    assert smallest_name(tab) >= LEGIBLE
    folded = tab.locator(".node:has(.name)")
    assert 0 < folded.count() < 5
    assert tab.locator(".node:not(:has(.name))").count() > 15
    assert "… " in folded.first.locator(".name").last.text_content()
    assert cut_off(tab, "#canvas .node") == []


def test_the_picture_is_taller_where_that_shows_all_names(opened) -> None:
    tab = opened(page(mower(), sample()), {"width": 1400, "height": 600})
    assert len(nodes(tab)) == 10
    assert tab.locator(".tall").count() == 1
    assert smallest_name(tab) >= LEGIBLE
    tab.set_viewport_size({"width": 1400, "height": 1200})
    tab.wait_for_selector(".tall", state="detached")
    assert len(nodes(tab)) == 10


def test_a_layer_is_unfolded_where_the_wheel_turns(opened, robot: str) -> None:
    tab = opened(robot)
    box = tab.locator(".node", has_text="in Devices").bounding_box()
    tab.mouse.move(box["x"] + 10, box["y"] + 10)
    tab.mouse.wheel(0, -100)
    room = tab.locator("#canvas").bounding_box()
    place = tab.locator(".node", has_text="/dev/heron/imu").first.bounding_box()
    assert room["x"] <= place["x"] <= room["x"] + room["width"]


def test_findings_and_search_unfold_what_they_need(opened, robot: str) -> None:
    tab = opened(robot)
    tab.click(".finding[data-rule='device/unstable-path'][data-file$='gnss.yaml'] .locate")
    assert {"gnss.yaml", "/dev/ttyUSB0"} <= set(nodes(tab))
    again = opened(robot)
    again.fill("#search", "ttyUSB0")
    again.press("#search", "Enter")
    assert nodes(again, ".chosen") == ["/dev/ttyUSB0"]


@pytest.mark.parametrize("leave", ["List", "Escape", "Picture"])
def test_the_list_can_be_left(opened, leave: str) -> None:
    tab = opened(page(mower(), sample()))
    tab.click("#words")
    assert tab.is_visible("#outline")
    assert tab.is_hidden("#in")
    if leave == "Escape":
        tab.keyboard.press("Escape")
    else:
        tab.click("#words" if leave == "List" else "[data-show=picture]")
    assert tab.is_hidden("#outline")
    choose(tab, "mower.service")
    assert tab.is_visible("#details")


LONG_LINE = "ExecStart=/usr/bin/rover " + "--option " * 30 + "--last\n"


@pytest.mark.parametrize(("width", "wrapped"), [(390, True), (1400, False)])
def test_a_note_is_next_to_its_mark(opened, width: int, wrapped: bool) -> None:
    short = Source("a.service", "Restart=always\nExecStart=/usr/bin/rover --first --second --third --fourth\n")
    long = Source("b.service", LONG_LINE)
    at = LONG_LINE.index("--last")
    notes = (
        Related(short.span(short.text.index("--fourth"), len(short.text) - 1), "said of the short line"),
        Related(long.span(at, at + 6), "said of the long line"),
    )
    found = Finding("A message", short.span(0, 7), "systemd/a", related=notes)
    tab = opened(page({}, Report((found,))), {"width": width, "height": 900})
    assert tab.evaluate("document.documentElement.scrollWidth") <= width
    assert tab.is_visible(".said:has-text('short line')") == wrapped
    assert tab.is_visible(".note:has-text('short line')") != wrapped
    assert tab.is_visible(".said:has-text('long line')")
    note = tab.locator(".said:has-text('long line')").bounding_box()
    mark = tab.locator("mark", has_text="--last").bounding_box()
    assert 0 <= note["y"] - mark["y"] < 40
    assert note["height"] < 30


def test_on_paper(opened) -> None:
    tab = opened(page(mower(), sample()))
    tab.emulate_media(media="print")
    tab.evaluate("dispatchEvent(new Event('beforeprint'))")
    sheet = tab.evaluate("document.documentElement.clientWidth")
    assert all(box["left"] >= 0 and box["right"] <= sheet for box in boxes(tab))
    assert tab.is_visible("#finding-2 h3")
    assert tab.is_hidden(".tools")
    tab.evaluate("dispatchEvent(new Event('afterprint'))")
    assert tab.get_attribute("#canvas", "viewBox") is None


def test_image_of_the_documentation(opened, update_expected: bool, tmp_path: Path) -> None:
    """Delete it and run with ``--update-expected`` to take it anew."""
    image = PROJECT / "docs/images/page.png"
    if update_expected and not image.exists():
        file = tmp_path / "guide.html"
        options = ("--root", ".", "--output-format", "html", "--output-file", file)
        lint(*options, cwd=PROJECT / "fixtures/robots/guide/tree")
        tab = opened(file.read_text("utf-8"), {"width": 1280, "height": 860})
        tab.click(".finding[data-rule='device/unstable-path'][data-file$='gnss.yaml'] .locate")
        tab.click("#fit")
        tab.eval_on_selector(".finding.chosen", "one => one.scrollIntoView({block: 'start'})")
        tab.mouse.move(0, 0)
        tab.screenshot(path=image)
    assert image.stat().st_size < 200_000


def test_as_a_list_and_without_scripts(opened) -> None:
    tab = opened(page(mower(), sample()))
    tab.click("#words")
    assert "CYCLONEDDS_URI=" in tab.inner_text("#outline")
    plain = opened(page(mower(), sample()), java_script_enabled=False)
    assert plain.is_visible("#finding-0")
    plain.click("#outline summary")
    assert "CYCLONEDDS_URI=" in plain.inner_text("#outline")
