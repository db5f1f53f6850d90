
/* The camera */

function place() {
  const { scale, x, y } = camera;
  scene.setAttribute("transform", `translate(${num(x)} ${num(y)}) scale(${scale})`);
  canvas.classList.toggle("far", scale < FAR);
  canvas.style.setProperty("--legible", `${num(Math.min(10.5 / scale, 36))}px`);
  for (const [index, head] of [...pane.querySelectorAll(".band")].entries()) {
    const band = drawn.plan.bands[index];
    head.style.transform = `translateX(${num(band.x * scale + x)}px)`;
    head.style.width = `${num(band.width * scale)}px`;
  }
}

function room() {
  const { width, height } = canvas.getBoundingClientRect();
  const side = !panel.hidden && width > 700 ? panel.offsetWidth + 16 : 0;
  return { width: width - side, height: height - (!panel.hidden && !side ? panel.offsetHeight : 0), top: 34 };
}

/* The room that the whole drawing is laid out for: the pane, whatever lies over it now. */
function roomFor() {
  const { width, height } = pane.getBoundingClientRect();
  return { width: Math.max(320, width - 32), height: Math.max(240, height - 82) };
}

/* The scale at which an area is as large as there is room for. */
function scaleFor(area, most = MOST) {
  const { width, height, top } = room();
  return Math.min(most, (width - 32) / Math.max(area.width, 1), (height - top - 48) / Math.max(area.height, 1));
}

function fit(area = { x: 0, y: 0, width: drawn.plan.width, height: drawn.plan.height }, most = MOST, least = 0.05) {
  const { width, height, top } = room();
  if (!width || !height || !drawn.nodes.length) return;
  camera.scale = Math.max(least, scaleFor(area, most));
  camera.x = (width - area.width * camera.scale) / 2 - area.x * camera.scale;
  camera.y = top + (height - top - area.height * camera.scale) / 2 - area.y * camera.scale;
  place();
}

function zoom(factor, at) {
  const { width, height } = room();
  const { x, y } = at ?? { x: width / 2, y: height / 2 };
  if (factor > 1 && grouped()) {
    enter({ x, y });
    return;
  }
  const scale = Math.min(4, Math.max(0.05, camera.scale * factor));
  camera.x = x - ((x - camera.x) * scale) / camera.scale;
  camera.y = y - ((y - camera.y) * scale) / camera.scale;
  camera.scale = scale;
  place();
}

function pan(x, y) {
  camera.x += x;
  camera.y += y;
  place();
}

/* The area around boxes. */
function around(indices) {
  const boxes = indices.map((index) => drawn.plan.boxes[index]);
  const [left, top] = [Math.min(...boxes.map((box) => box.x)), Math.min(...boxes.map((box) => box.y))];
  return {
    x: left - 40, y: top - 40,
    width: Math.max(...boxes.map((box) => box.x + box.width)) - left + 80,
    height: Math.max(...boxes.map((box) => box.y + box.height)) - top + 80,
  };
}

/* Brings boxes into view, near enough to read them; what is in view already stays where it is. */
function bring(indices) {
  const shown = indices.filter((index) => drawn.plan.boxes[index]);
  if (!shown.length) return;
  const area = around(shown);
  const { width, height, top: edge } = room();
  const [x, y] = [area.x * camera.scale + camera.x, area.y * camera.scale + camera.y];
  const seen = x >= 0 && y >= edge && x + area.width * camera.scale <= width && y + area.height * camera.scale <= height;
  if (!seen || camera.scale < FAR) fit(area, Math.max(camera.scale, 1));
}

/* Pointers */

const pointers = new Map();
let moved = 0;
const spotOf = (event) => {
  const { left, top } = canvas.getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
};
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  if (event.shiftKey) pan(-(event.deltaX || event.deltaY), 0);
  else zoom(Math.exp(-event.deltaY * (event.ctrlKey ? 0.01 : 0.0015)), spotOf(event));
}, { passive: false });
canvas.addEventListener("pointerdown", (event) => {
  if (!pointers.size) moved = 0;
  pointers.set(event.pointerId, spotOf(event));
});
window.addEventListener("pointermove", (event) => {
  const before = pointers.get(event.pointerId);
  if (!before) return;
  const now = spotOf(event);
  const other = [...pointers.entries()].find(([id]) => id !== event.pointerId)?.[1];
  if (other) {
    const apart = (spot) => Math.hypot(spot.x - other.x, spot.y - other.y) || 1;
    zoom(apart(now) / apart(before), { x: (now.x + other.x) / 2, y: (now.y + other.y) / 2 });
  } else pan(now.x - before.x, now.y - before.y);
  moved += Math.abs(now.x - before.x) + Math.abs(now.y - before.y);
  pointers.set(event.pointerId, now);
  canvas.classList.toggle("dragged", moved > 4);
});
for (const type of ["pointerup", "pointercancel"]) {
  window.addEventListener(type, (event) => {
    pointers.delete(event.pointerId);
    canvas.classList.remove("dragged");
  });
}
canvas.addEventListener("click", (event) => {
  if (moved > 4) event.stopPropagation();
  else if (!event.target.closest(".node, .edge")) choose(null);
}, true);

/* Keys */

/* Makes a node the one that Tab reaches, and gives it the keyboard. */
function roam(index, focus = true) {
  drawn.boxes[state.at]?.setAttribute("tabindex", -1);
  state.at = index;
  const box = drawn.boxes[index];
  box?.setAttribute("tabindex", 0);
  if (!focus || !box) return;
  box.focus({ preventScroll: true });
  bring([index]);
}

function neighbour(index, [right, down]) {
  const centre = ({ x, y, width, height }) => [x + width / 2, y + height / 2];
  const [fromX, fromY] = centre(drawn.plan.boxes[index]);
  let [best, least] = [index, Infinity];
  drawn.plan.boxes.forEach((box, other) => {
    const [x, y] = centre(box);
    const [along, across] = right ? [(x - fromX) * right, Math.abs(y - fromY)] : [(y - fromY) * down, Math.abs(x - fromX)];
    const cost = along + (right ? 2 : 6) * across;
    if (other !== index && along > 1 && cost < least) [best, least] = [other, cost];
  });
  return best;
}

const ARROWS = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowDown: [0, 1], ArrowUp: [0, -1] };
pane.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("aside, .tools, .legend, #outline")) return;
  const node = event.target.closest(".node");
  const index = node ? Number(node.dataset.index) : null;
  const arrow = ARROWS[event.key];
  const acts = {
    "+": () => zoom(1.25), "=": () => zoom(1.25), "-": () => zoom(0.8), 0: () => overview(),
    ...(node && { Enter: () => node.dispatchEvent(new MouseEvent("click", { bubbles: true })), f: () => isolate(drawn.nodes[index].members[0]) }),
    ...(node && { " ": () => node.dispatchEvent(new MouseEvent("click", { bubbles: true })) }),
  };
  if (arrow && node && !event.shiftKey) roam(neighbour(index, arrow));
  else if (arrow) pan(-60 * arrow[0], -60 * arrow[1]);
  else if (acts[event.key]) (moved = 0), acts[event.key]();
  else return;
  event.preventDefault();
});
document.addEventListener("keydown", (event) => {
  const typing = event.target.closest("input, select, textarea");
  if (event.key === "/" && !typing) {
    event.preventDefault();
    byId("search").focus();
  } else if (event.key === "Escape") {
    if (pane.classList.contains("listed")) list(false);
    else if (state.query.length) search("");
    else if (state.chosen) choose(null);
    else if (state.only !== null) unfocus();
    if (typing) canvas.focus();
  }
});
