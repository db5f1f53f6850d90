
/* Choosing */

function choose(chosen, jump = true) {
  state.chosen = chosen;
  if (chosen?.node !== undefined) reveal([chosen.node]);
  light();
  describe();
  document.querySelectorAll(".finding.chosen").forEach((article) => article.classList.remove("chosen"));
  if (chosen?.finding !== undefined) byId(`finding-${chosen.finding}`)?.classList.add("chosen");
  if (!jump || !chosen) return;
  if (chosen.node !== undefined) bring([drawn.boxOf.get(chosen.node)]);
  else if (chosen.link !== undefined) bring([drawn.links[chosen.link].from, drawn.links[chosen.link].to]);
  else if (chosen.finding !== undefined) {
    const { boxes, lines } = holders(chosen.finding);
    bring([...boxes, ...lines.flatMap((index) => [drawn.links[index].from, drawn.links[index].to])]);
  }
}

/* One press chooses a box; two, one after the other, unfold it or show only what it is tied to. */
function press(node, index, time) {
  const again = state.pressed?.index === index && time - state.pressed.time < 400;
  state.pressed = again ? null : { index, time };
  if (again && node.kind === "folded") fold(node.layer);
  else if (again) isolate(node.members[0]);
  else choose(node.kind === "folded" ? { box: index } : { node: node.members[0] });
}

/* Draws nodes that are folded away or left out by the focus. */
function reveal(nodes) {
  const away = nodes.filter((node) => !drawn.boxOf.has(node));
  const closed = nodes.filter((node) => state.folded.has(data.nodes[node].layer));
  if (!away.length && !closed.length) return;
  if (away.length) state.only = null;
  closed.forEach((node) => state.folded.delete(data.nodes[node].layer));
  draw();
}

function chooseFinding(finding) {
  const nodes = data.nodes.flatMap((node, index) => (node.findings.includes(finding) ? [index] : []));
  const ends = data.edges.flatMap((edge) => (edge.findings.includes(finding) ? [edge.source, edge.target] : []));
  if (nodes.length + ends.length && !panes().picture) show("both");
  reveal([...nodes, ...ends]);
  choose({ finding });
}

function toArticle(finding) {
  const article = byId(`finding-${finding}`);
  if (!article) return;
  if (!panes().findings) show("both");
  if (article.hidden) clearFilters();
  choose({ finding }, false);
  article.scrollIntoView({ block: "center", behavior: "smooth" });
  article.focus({ preventScroll: true });
}

function isolate(node) {
  if (!state.byHand) state.folded.clear();
  state.only = node;
  draw();
  choose({ node }, false);
  fit();
}

function fold(layer) {
  state.byHand = true;
  if (!state.folded.delete(layer)) state.folded.add(layer);
  if (state.chosen?.box !== undefined || state.chosen?.link !== undefined) choose(null);
  draw();
  describe();
  place();
  pane.querySelector(`.band[data-layer="${CSS.escape(layer)}"]`)?.focus();
}

/* Details of what is chosen */

function describe() {
  const chosen = state.chosen;
  const content = chosen === null ? null
    : chosen.node !== undefined ? nodeDetails(chosen.node)
    : chosen.link !== undefined ? linkDetails(drawn.links[chosen.link])
    : chosen.box !== undefined ? boxDetails(drawn.nodes[chosen.box])
    : panes().findings ? null
    : findingDetails(chosen.finding);
  panel.hidden = content === null;
  panel.replaceChildren(...(content === null ? [] : [
    button("×", () => choose(null), { class: "close", "aria-label": "Close", title: "Close (Esc)" }), ...content]));
  panel.scrollTop = 0;
}

function nodeDetails(index) {
  const node = data.nodes[index];
  return [
    make("p", { class: "kind", "data-layer": node.layer }, `${node.kind} · ${layerOf(node.layer).title}`),
    make("h2", {}, node.label), placed(node),
    state.only === index ? button("Show everything", () => unfocus(), { class: "act" })
      : button("Show only what it is tied to", () => isolate(index), { class: "act", title: "f" }),
    ...found(node.findings),
    ...ends("Comes from", arriving[index], "source"), ...ends("Leads to", leaving[index], "target"),
  ];
}

function linkDetails(link) {
  return [
    make("p", { class: "kind" }, "edge"),
    make("h2", {}, drawn.nodes[link.from].full, make("i", {}, " → "), drawn.nodes[link.to].full),
    ...found([...new Set(link.edges.flatMap((edge) => data.edges[edge].findings))]),
    make("ul", { class: "ends" }, ...link.edges.slice(0, 50).map((index) => {
      const edge = data.edges[index];
      const [source, target] = [data.nodes[edge.source], data.nodes[edge.target]];
      return make("li", {}, word(edge), toNode(edge.source, source.label), " → ", toNode(edge.target, target.label), placed(edge));
    })),
  ];
}

function boxDetails(box) {
  return [
    make("p", { class: "kind", "data-layer": box.layer }, "folded layer"), make("h2", {}, box.full),
    button("Unfold", () => fold(box.layer), { class: "act" }), ...found(box.findings),
    make("ul", { class: "ends" }, ...box.members.map((index) => make("li", {}, toNode(index, data.nodes[index].label)))),
  ];
}

function findingDetails(index) {
  const { boxes, lines } = holders(index);
  const names = [...boxes.map((box) => drawn.nodes[box]).filter((box) => box.members.length === 1).map((box) => make("li", {}, toNode(box.members[0], box.full))),
    ...lines.map((line) => make("li", {}, button(`${drawn.nodes[drawn.links[line].from].full} → ${drawn.nodes[drawn.links[line].to].full}`, () => choose({ link: line }), { class: "to" })))];
  return [make("p", { class: "kind" }, "finding"), ...found([index]),
    names.length ? make("h3", {}, "Where") : null, names.length ? make("ul", { class: "ends" }, ...names) : null].filter(Boolean);
}

const word = (edge) => make("span", { class: "word", "data-kind": edge.kind }, edge.kind, edge.why ? make("i", {}, ` ${edge.why}`) : "");
const toNode = (index, label) => button(label, () => choose({ node: index }), { class: "to" });
const placed = (item) => make("p", { class: "place" }, placeOf(item));

function found(findings) {
  const rank = (index) => -SEVERITIES.indexOf(data.findings[index].severity);
  return [...findings].sort((a, b) => rank(a) - rank(b) || a - b).map((index) => {
    const { rule, severity, message, advice } = data.findings[index];
    const text = byId(`finding-${index}`) ? button(message, () => toArticle(index), { class: "to" }) : make("span", {}, message);
    return make("div", { class: `told ${severity}` }, icon(severity),
      make("div", {}, text, advice ? make("p", { class: "advice" }, advice) : null, make("p", { class: "rule" }, rule)));
  });
}

function ends(title, edges, end) {
  if (!edges.length) return [];
  return [make("h3", {}, title, make("i", {}, ` ${edges.length}`)), make("ul", { class: "ends" }, ...edges.map((index) => {
    const edge = data.edges[index];
    return make("li", { class: worstOf(edge.findings) }, word(edge), toNode(edge[end], data.nodes[edge[end]].label), placed(edge));
  }))];
}

function unfocus() {
  state.only = null;
  overview();
  describe();
}
