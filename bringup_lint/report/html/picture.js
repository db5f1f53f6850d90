
/* The picture as it is drawn now. Nothing on this page is fetched, stored or evaluated. */

const data = JSON.parse(document.getElementById("data").textContent);
const SEVERITIES = ["info", "warning", "error"];
const FAR = 0.5;
const FEW = 24;
const LEGIBLE = 0.75;
const MOST = 1.25;
const UPRIGHT = 700;
const SVG = "http://www.w3.org/2000/svg";
const byId = (id) => document.getElementById(id);
const [body, canvas, scene, panel] = [document.body, byId("canvas"), byId("scene"), byId("details")];
const pane = byId("picture");

const state = { byHand: false, named: false, chosen: null, only: null, folded: new Set(), hidden: new Set(), query: [], at: -1, pressed: null };
const camera = { scale: 1, x: 0, y: 0 };
let drawn = null;

const [leaving, arriving] = [data.nodes.map(() => []), data.nodes.map(() => [])];
data.edges.forEach((edge, index) => {
  leaving[edge.source].push(index);
  arriving[edge.target].push(index);
});
const worstOf = (findings) =>
  SEVERITIES[Math.max(-1, ...findings.map((index) => SEVERITIES.indexOf(data.findings[index].severity)))] ?? "";

/* Making elements; text only ever goes in as text. */

function make(name, attributes = {}, ...children) {
  const svg = ["svg", "g", "path", "rect", "text", "use", "title"].includes(name);
  const element = svg ? document.createElementNS(SVG, name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (value !== null && value !== false) element.setAttribute(key, value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

const icon = (severity) => make("svg", { class: `icon ${severity}`, "aria-hidden": "true" }, make("use", { href: `#icon-${severity}` }));
const layerOf = (id) => data.layers.find((layer) => layer.id === id);
const placeOf = ({ path, line }) => (path ? path + (line ? `:${line}` : "") : "");
const counted = (number, word) => `${number} ${word}${number === 1 ? "" : "s"}`;
const button = (text, action, attributes = {}) => make("button", { type: "button", onclick: action, ...attributes }, text);

/* What is drawn: all, or what a node is tied to, with folded layers as one box each. */

function tiedTo(start) {
  const found = new Set([start]);
  for (const [edges, end] of [[leaving, "target"], [arriving, "source"]]) {
    const queue = [start];
    const seen = new Set(queue);
    while (queue.length) {
      for (const index of edges[queue.pop()]) {
        const next = data.edges[index][end];
        if (!seen.has(next)) {
          seen.add(next);
          queue.push(next);
        }
      }
    }
    seen.forEach((index) => found.add(index));
  }
  return found;
}

function graph() {
  const shown = state.only === null ? null : tiedTo(state.only);
  const nodes = [];
  const boxOf = new Map();
  const folded = new Map();
  data.nodes.forEach((node, index) => {
    if (shown && !shown.has(index)) return;
    if (!state.folded.has(node.layer)) {
      boxOf.set(index, nodes.length);
      nodes.push({ ...node, members: [index], worst: worstOf(node.findings), full: node.label, label: short(node.label) });
      return;
    }
    if (!folded.has(node.layer)) {
      folded.set(node.layer, nodes.length);
      nodes.push({ layer: node.layer, kind: "folded", rank: 0, members: [], findings: [] });
    }
    const box = nodes[folded.get(node.layer)];
    boxOf.set(index, folded.get(node.layer));
    box.members.push(index);
    box.findings = [...new Set([...box.findings, ...node.findings])];
  });
  for (const index of folded.values()) {
    const box = nodes[index];
    box.label = box.full = `${box.members.length} in ${layerOf(box.layer).title}`;
    box.worst = worstOf(box.findings);
    box.names = state.named ? namesIn(box) : [];
  }
  const links = new Map();
  data.edges.forEach((edge, index) => {
    const [from, to] = [boxOf.get(edge.source), boxOf.get(edge.target)];
    if (from === undefined || to === undefined || from === to || state.hidden.has(edge.kind)) return;
    const key = `${from} ${to}`;
    if (!links.has(key)) links.set(key, { from, to, edges: [] });
    links.get(key).edges.push(index);
  });
  return { nodes, links: [...links.values()], boxOf };
}

/* Some names of a folded layer, those with findings first, then those with most links. */
function namesIn(box) {
  const links = (index) => leaving[index].length + arriving[index].length;
  const rank = (index) => SEVERITIES.indexOf(worstOf(data.nodes[index].findings));
  const inOrder = [...box.members].sort((a, b) => rank(b) - rank(a) || links(b) - links(a) || a - b);
  const first = inOrder.slice(0, inOrder.length > SIZE.names ? SIZE.names - 1 : SIZE.names);
  const left = inOrder.length - first.length;
  return [...first.map((index) => short(data.nodes[index].label)), ...(left ? [`… ${left} more`] : [])];
}

/* A label without its middle: names of files and topics differ at their ends. */
function short(label) {
  const most = data.nodes.length > SIZE.roomy ? 24 : 32;
  const letters = [...label];
  if (letters.length <= most) return label;
  return letters.slice(0, most * 0.4).join("") + "…" + letters.slice(-(most * 0.6 - 1)).join("");
}

/* Drawing */

/* What is drawn, and where. */
function planned() {
  const { nodes, links, boxOf } = graph();
  const upright = grouped() && isNarrow();
  const plan = upright ? stacked(nodes, links) : arrange(nodes, links, data.layers.map((layer) => layer.id), roomFor());
  return { nodes, links, boxOf, plan };
}

function draw() {
  drawn = planned();
  const { nodes, links, plan } = drawn;
  const lines = make("g", { class: "edges" });
  drawn.lines = links.map((link, index) => lines.appendChild(lineOf(link, plan.routes[index], index)));
  const boxes = make("g", { class: "nodes" });
  drawn.boxes = nodes.map((node, index) => boxes.appendChild(boxFor(node, plan.boxes[index], index)));
  const stripes = make("g", { class: "stripes" }, ...plan.bands.flatMap((band) => [
    make("rect", { "data-layer": band.layer, x: band.x, y: -20000, width: band.width, height: 40000 }),
    make("text", { x: band.x + 2, y: -16 }, layerOf(band.layer).title)]));
  scene.replaceChildren(stripes, lines, boxes);
  pane.querySelector(".bands").replaceChildren(...plan.bands.map(bandHead));
  byId("whole").hidden = state.only === null;
  roam(state.at >= 0 && state.at < nodes.length ? state.at : 0, false);
  light();
  count();
}

/* Layers of several nodes, the smallest first. */
function layersOfMany() {
  const sizeOf = (id) => data.nodes.filter(({ layer }) => layer === id).length;
  const many = data.layers.map(({ id }) => id).filter((id) => sizeOf(id) > 1);
  return many.sort((a, b) => sizeOf(a) - sizeOf(b));
}

const isNarrow = () => roomFor().width < UPRIGHT;

/* Whether layers are folded because the room is too small for all names. */
const grouped = () => state.only === null && !state.byHand && state.folded.size > 0;

const isLegible = () => scaleFor(planned().plan) >= LEGIBLE;

/* Everything, in the room that there is. */
function overview() {
  if (!state.byHand && !state.chosen && state.only === null) foldForRoom();
  draw();
  fit();
}

/* Nothing is folded where all names can be read, in a taller picture at most; else layers are, but those of a small
   robot that can stay. */
function foldForRoom() {
  state.folded.clear();
  state.named = false;
  for (const tall of [false, true]) {
    body.classList.toggle("tall", tall);
    if (isLegible()) return;
  }
  const many = layersOfMany();
  many.forEach((id) => state.folded.add(id));
  if (data.nodes.length <= SIZE.roomy && !isNarrow()) many.forEach(unfoldIfLegible);
  body.classList.toggle("tall", state.folded.size < many.length);
  state.named = !isNarrow();
  state.named &&= isLegible();
}

function unfoldIfLegible(layer) {
  state.folded.delete(layer);
  if (!isLegible()) state.folded.add(layer);
}

/* From the layers to the nodes of the nearest one, near enough to read them. */
function enter(at) {
  const apart = ({ x, y, width, height }) =>
    Math.hypot((x + width / 2) * camera.scale + camera.x - at.x, (y + height / 2) * camera.scale + camera.y - at.y);
  const nearest = drawn.plan.boxes.reduce((best, box, index, all) => (apart(box) < apart(all[best]) ? index : best), 0);
  const { layer } = drawn.nodes[nearest];
  state.folded.clear();
  if (state.chosen?.box !== undefined || state.chosen?.link !== undefined) choose(null);
  draw();
  fit(around(drawn.nodes.flatMap((node, index) => (node.layer === layer ? [index] : []))), 1, LEGIBLE + 0.1);
}

function lineOf(link, { d, arrow }, index) {
  const edges = link.edges.map((edge) => data.edges[edge]);
  const worst = worstOf(edges.flatMap((edge) => edge.findings));
  const said = edges.map((edge) => [edge.kind, edge.why && `(${edge.why})`, placeOf(edge)].filter(Boolean).join(" ")).join("\n");
  const names = `${drawn.nodes[link.from].full} → ${drawn.nodes[link.to].full}`;
  return make("g", { class: `edge ${worst}`, "data-kind": (edges.find((edge) => edge.kind !== "orders") ?? edges[0]).kind, onclick: () => choose({ link: index }) },
    make("title", {}, `${names}\n${said}`), make("path", { class: "reach", d }), make("path", { class: "line", d }),
    make("path", { class: "arrow", d: arrow }));
}

function boxFor(node, { x, y, width, height }, index) {
  const low = height <= SIZE.low;
  const ranked = node.rank != null && node.kind !== "folded";
  const about = [node.full, node.kind, placeOf(node)].filter(Boolean);
  const told = [...about, counted(node.findings.length, "finding"), node.worst && `worst: ${node.worst}`];
  const start = ranked ? 12 + SIZE.rank : 12;
  const label = make("text", { "aria-hidden": true, class: "label", x: start, y: low ? 16 : 29 }, node.label);
  label.style.setProperty("--aside", `${num(width - start + 6)}px`);
  return make("g", {
    class: `node ${node.worst}`, "data-layer": node.layer, "data-index": index, transform: `translate(${num(x)} ${num(y)})`,
    tabindex: -1, role: "button", "aria-label": told.filter(Boolean).join(", "),
    onclick: (event) => press(node, index, event.timeStamp),
    onpointerenter: () => state.chosen || light(index), onpointerleave: () => state.chosen || light(),
  },
    make("title", {}, about.join("\n")),
    make("rect", { class: "box", width, height, rx: 4 }),
    make("rect", { class: "hue", width: 4, height, rx: 2 }),
    low ? null : make("text", { "aria-hidden": true, class: "kind", x: start, y: 14 }, kindOf(node)),
    ranked ? make("text", { "aria-hidden": true, class: "rank", x: 10, y: low ? 16 : 29 }, String(node.rank)) : null,
    label,
    ...namesOf(node).map((name, row) => make("text", { "aria-hidden": true, class: "name", x: start, y: SIZE.high + 12 + row * SIZE.line }, name)),
    node.worst ? make("g", { transform: `translate(${num(width - 12)} 12)` },
      make("use", { class: `icon ${node.worst}`, href: `#icon-${node.worst}`, x: -7, y: -7, width: 14, height: 14 })) : null);
}

function bandHead(band) {
  const layer = layerOf(band.layer);
  const own = data.nodes.filter((node) => node.layer === band.layer);
  const worst = worstOf(own.flatMap((node) => node.findings));
  const folded = state.folded.has(band.layer);
  return button("", () => fold(band.layer), {
    class: "band", "data-layer": band.layer, "aria-expanded": String(!folded), title: `${layer.title}: ${folded ? "unfold" : "fold"}`,
  }).appendChild(make("span", {}, make("b", {}, layer.title), make("i", {}, String(own.length)), worst ? icon(worst) : null)).parentNode;
}

/* What is lit: the chosen or pointed-at thing with what it is tied to, and what the search found. */

function light(pointed) {
  const [boxes, lines] = [new Set(), new Set()];
  const chosen = state.chosen;
  const around = (index) => {
    boxes.add(index);
    drawn.links.forEach(({ from, to }, line) => {
      if (from === index || to === index) [from, to].forEach((end) => boxes.add(end)), lines.add(line);
    });
  };
  const own = new Set();
  if (chosen?.node !== undefined && drawn.boxOf.has(chosen.node)) own.add(drawn.boxOf.get(chosen.node));
  if (chosen?.box !== undefined) own.add(chosen.box);
  if (chosen?.link !== undefined && drawn.links[chosen.link]) {
    const { from, to } = drawn.links[chosen.link];
    [from, to].forEach((end) => boxes.add(end));
    lines.add(chosen.link);
  }
  if (chosen?.finding !== undefined) {
    const held = holders(chosen.finding);
    held.boxes.forEach((index) => own.add(index));
    held.lines.forEach((index) => lines.add(index));
    held.lines.forEach((index) => [drawn.links[index].from, drawn.links[index].to].forEach((end) => boxes.add(end)));
    held.boxes.forEach((index) => boxes.add(index));
  } else own.forEach(around);
  if (!chosen && pointed !== undefined) around(pointed);
  const found = state.query.length ? matches() : null;
  const alone = state.only !== null && chosen?.node === state.only;
  canvas.classList.toggle("dim", Boolean(boxes.size || lines.size) && !alone);
  canvas.classList.toggle("few", boxes.size <= FEW);
  canvas.classList.toggle("searching", Boolean(found));
  drawn.boxes.forEach((box, index) => {
    box.classList.toggle("lit", boxes.has(index));
    box.classList.toggle("chosen", own.has(index));
    box.classList.toggle("found", Boolean(found?.has(index)));
  });
  drawn.lines.forEach((line, index) => line.classList.toggle("lit", lines.has(index)));
  if (boxes.size <= FEW) name([...boxes]);
  if (chosen && boxes.size <= FEW) raise([...boxes].map((index) => drawn.boxes[index]));
  return found;
}

/* Where labels are too small, those of lit boxes stand above them, or beside them below another lit box. */
function name(indices) {
  const boxes = drawn.plan.boxes;
  for (const index of indices) {
    const close = indices.some((other) => {
      const apart = boxes[index].y - boxes[other].y;
      return boxes[index].x === boxes[other].x && apart > 0 && apart < 48;
    });
    drawn.boxes[index].classList.toggle("aside", close);
  }
}

/* Draws boxes above the others; to move an element takes the keyboard from it. */
function raise(boxes) {
  const held = document.activeElement;
  boxes.forEach((box) => box.parentNode.append(box));
  if (held !== document.activeElement) held.focus({ preventScroll: true });
}

/* The boxes and lines that hold a finding. */
function holders(finding) {
  const boxes = drawn.nodes.flatMap((node, index) => (node.findings.includes(finding) ? [index] : []));
  const lines = drawn.links.flatMap((link, index) => (link.edges.some((edge) => data.edges[edge].findings.includes(finding)) ? [index] : []));
  return { boxes, lines };
}
