
/* Search */

const holds = (text) => state.query.every((part) => text.toLowerCase().includes(part));
const wordsOf = (member) => ["label", "kind", "path"].map((key) => data.nodes[member][key] ?? "").join(" ");
function matches() {
  return new Set(drawn.nodes.flatMap((node, index) =>
    node.members.some((member) => holds(wordsOf(member))) ? [index] : []));
}

function search(text) {
  byId("search").value = text;
  state.query = text.toLowerCase().split(/\s+/).filter(Boolean);
  light();
  count();
  filter();
}

/* How many nodes the search finds, folded ones too; of what the focus leaves where it leaves some out. */
function count() {
  const shown = drawn.nodes.flatMap(({ members }) => members);
  const found = shown.filter((member) => holds(wordsOf(member))).length;
  byId("matches").textContent = state.query.length && data.nodes.length ? `${found} of ${counted(shown.length, "node")}` : "";
}

function nextMatch() {
  const found = [...matches()].sort((a, b) => a - b);
  if (!found.length || !panes().picture) return;
  const next = found.find((index) => index > state.at && drawn.nodes[index].members[0] !== state.chosen?.node) ?? found[0];
  roam(next, false);
  const { members } = drawn.nodes[next];
  choose({ node: members.find((member) => holds(wordsOf(member))) ?? members[0] });
}

byId("search").addEventListener("input", (event) => search(event.target.value));
byId("search").addEventListener("keydown", (event) => event.key === "Enter" && nextMatch());

/* The list of findings */

const articles = [...document.querySelectorAll(".finding")];
const silenced = new Set();
function filter() {
  const [family, file] = [byId("family").value, byId("file").value];
  for (const article of articles) {
    const { severity, family: own, file: path } = article.dataset;
    article.hidden = silenced.has(severity) || (family && own !== family) || (file && path !== file)
      || (state.query.length > 0 && !holds(article.textContent));
  }
  for (const group of document.querySelectorAll(".group")) {
    const shown = group.querySelectorAll(".finding:not([hidden])").length;
    group.hidden = !shown;
    group.querySelector(".count").textContent = shown;
  }
  const shown = articles.filter((article) => !article.hidden).length;
  byId("shown").textContent = shown === articles.length ? "" : `${shown} of ${articles.length}`;
}

function clearFilters() {
  silenced.clear();
  document.querySelectorAll(".chip").forEach((chip) => chip.setAttribute("aria-pressed", "true"));
  byId("family").value = byId("file").value = "";
  search("");
}

function regroup(by) {
  const groups = new Map();
  const name = ({ dataset }) => (by === "severity" ? { error: "Errors", warning: "Warnings", info: "Info" }[dataset.severity] : dataset[by]);
  const placed = [...articles].sort((a, b) => a.dataset.finding - b.dataset.finding);
  for (const article of by === "severity" ? articles : placed) {
    const key = name(article);
    if (!groups.has(key)) {
      groups.set(key, make("section", { class: `group by-${by}` }, make("h2", {}, `${key} `, make("span", { class: "count" }))));
    }
    groups.get(key).append(article);
  }
  const ordered = by === "severity" ? [...groups.values()] : [...groups.keys()].sort().map((key) => groups.get(key));
  if (articles.length) byId("list").replaceChildren(...ordered, ...document.querySelectorAll("template"));
  filter();
}

function setUpFindings() {
  for (const severity of [...SEVERITIES].reverse()) {
    const count = articles.filter((article) => article.dataset.severity === severity).length;
    if (!count) continue;
    const chip = button("", () => {
      if (!silenced.delete(severity)) silenced.add(severity);
      chip.setAttribute("aria-pressed", String(!silenced.has(severity)));
      filter();
    }, { class: `chip ${severity}`, "aria-pressed": "true" });
    chip.append(icon(severity), severity === "info" ? `${count} info` : counted(count, severity));
    document.querySelector(".chips").append(chip);
  }
  for (const key of ["family", "file"]) {
    const values = [...new Set(articles.map((article) => article.dataset[key]))].sort();
    byId(key).append(...values.map((value) => make("option", { value }, value)));
    byId(key).addEventListener("change", filter);
  }
  byId("group").addEventListener("change", (event) => regroup(event.target.value));
  const drawnFindings = new Set([...data.nodes, ...data.edges].flatMap((item) => item.findings));
  for (const article of articles) {
    const finding = Number(article.dataset.finding);
    const locate = article.querySelector(".locate");
    locate.hidden = !drawnFindings.has(finding);
    locate.addEventListener("click", () => chooseFinding(finding));
    const doc = document.querySelector(`template[data-rule="${CSS.escape(article.dataset.rule)}"]`);
    const explain = article.querySelector(".explain");
    explain.hidden = !doc;
    explain.addEventListener("click", () => {
      const open = article.querySelector(".doc");
      explain.setAttribute("aria-expanded", String(!open));
      if (open) open.remove();
      else article.append(make("div", { class: "doc" }, doc.content.cloneNode(true)));
    });
  }
}
