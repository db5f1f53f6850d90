
/* Views, tools and start */

const panes = () => ({ findings: byId("findings").offsetWidth > 0, picture: pane.offsetWidth > 0 });
const narrow = window.matchMedia("(max-width: 900px)");
function show(view) {
  const wanted = view === "both" && narrow.matches ? (panes().picture ? "findings" : "picture") : view;
  body.dataset.view = wanted;
  list(false);
  document.querySelectorAll(".views button").forEach((one) => one.setAttribute("aria-pressed", String(one.dataset.show === wanted)));
  redraw();
}

/* Lays the drawing out for the room that there is now. */
function redraw() {
  if (!pane.offsetWidth) return;
  overview();
}

/* The picture in words, in its place. */
function list(listed) {
  pane.classList.toggle("listed", listed);
  byId("outline").open = listed;
  byId("words").setAttribute("aria-pressed", String(listed));
}

function setUpLegend() {
  const kinds = [...new Set(data.edges.map((edge) => edge.kind))].sort();
  pane.querySelector(".kinds").append(...kinds.map((kind) => {
    const box = make("input", { type: "checkbox", checked: true, onchange: () => {
      if (!state.hidden.delete(kind)) state.hidden.add(kind);
      if (state.chosen?.link !== undefined) choose(null);
      draw();
      place();
    } });
    const sample = make("svg", { class: "sample", viewBox: "0 0 26 8", "aria-hidden": "true" }, make("path", { class: "line", "data-kind": kind, d: "M0 4h26" }));
    return make("label", {}, box, sample, kind, make("i", {}, String(data.edges.filter((edge) => edge.kind === kind).length)));
  }));
  const marks = SEVERITIES.filter((severity) => data.findings.some((finding) => finding.severity === severity)).reverse();
  const ranked = data.nodes.some((node) => node.rank != null);
  pane.querySelector(".marks").append(...marks.map((severity) => make("span", {}, icon(severity), severity)),
    ...(ranked ? [make("span", {}, make("b", {}, "2"), "step of the boot")] : []));
  pane.querySelector(".legend").hidden = !kinds.length && !marks.length;
}

byId("in").addEventListener("click", () => zoom(1.25));
byId("out").addEventListener("click", () => zoom(0.8));
byId("fit").addEventListener("click", () => overview());
byId("whole").addEventListener("click", () => unfocus());
byId("words").addEventListener("click", () => list(!pane.classList.contains("listed")));
byId("theme").addEventListener("click", () => {
  const dark = getComputedStyle(document.documentElement).colorScheme;
  const now = dark === "light dark" ? (window.matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light") : dark;
  document.documentElement.dataset.theme = now === "dark" ? "light" : "dark";
});
document.querySelectorAll(".views button").forEach((one) => one.addEventListener("click", () => show(one.dataset.show)));
let resized = 0;
window.addEventListener("resize", () => {
  clearTimeout(resized);
  resized = setTimeout(redraw, 120);
});
/* On paper the drawing takes the width of the sheet, whatever is in view now. */
window.addEventListener("beforeprint", () => {
  canvas.setAttribute("viewBox", `0 -40 ${drawn.plan.width} ${drawn.plan.height + 50}`);
  canvas.classList.remove("far");
  scene.removeAttribute("transform");
});
window.addEventListener("afterprint", () => {
  canvas.removeAttribute("viewBox");
  place();
});

body.classList.add("scripted");
body.classList.toggle("without-picture", !data.nodes.length);
setUpFindings();
setUpLegend();
draw();
show(body.classList.contains("picture") ? "picture" : !data.nodes.length || narrow.matches ? "findings" : "both");
const linked = /^#finding-(\d+)$/.exec(location.hash);
if (linked && byId(`finding-${linked[1]}`)) toArticle(Number(linked[1]));
