"use strict";

/* Where everything stands. Columns run from power-on at the left to the topics at the right: each layer has a column
   for every step of its own, or, where the room asks for it, columns that hold several steps, one below the other.
   A link that passes over a column gets a track through it, which takes part in ordering like a node, so that no line
   runs through a box; links of one hub share their tracks. The same graph in the same room gives the same drawing. */

const SIZE = {
  letter: 7.25, small: 5.3, padding: 20, badge: 20, narrow: 72, wide: 290,
  low: 24, high: 38, roomy: 60, gap: 8, track: 7,
  margin: 14, between: 12, corridor: 42, crowd: 1.1, broad: 150, arrow: 7, rank: 16, bow: 30,
  names: 7, line: 16,
};
const ROWS = [1, 2, 3, 4, 5, 6, 8, 10, 12, 14, 17, 20, 24, 28, 33, 39, 46, 54, 64];
const SWEEPS = 14;
const STEPS = 6;

function arrange(nodes, links, layers, room) {
  const high = nodes.length <= SIZE.roomy ? SIZE.high : SIZE.low;
  const items = nodes.map((node, index) => ({ index, height: heightOf(node, high), before: [], after: [], beside: [] }));
  const columns = columnsOf(nodes, links, layers, items, room);
  const paths = links.map((link) => laid(link, items, columns, hubOf(links)));
  order(columns);
  rest(columns);
  settle(columns);
  const bands = spread(columns, nodes, layers);
  const top = Math.min(...columns.flatMap((column) => column.items.map(topOf)));
  for (const column of columns) for (const item of column.items) item.y -= top;
  return {
    high,
    bands,
    width: bands.length ? bands.at(-1).x + bands.at(-1).width : 0,
    height: Math.max(0, ...columns.flatMap((column) => column.items.map(bottomOf))),
    boxes: items.map((item) => ({
      x: item.column.x, y: item.y - item.height / 2, width: item.column.width, height: item.height,
    })),
    routes: paths.map(route),
  };
}

/* Columns */

function columnsOf(nodes, links, layers, items, room) {
  const groups = layers.map((layer) => groupsOf(layer, nodes, links, items)).filter((own) => own.length);
  const filled = ROWS.map((rows) => groups.map((own) => fill(own, rows)));
  const best = filled.reduce((a, b) => (worth(b, nodes, room) > worth(a, nodes, room) ? b : a), filled[0]);
  const columns = best.flat();
  columns.forEach((column, number) => {
    column.number = number;
    for (const item of column.items) item.column = column;
  });
  return columns;
}

/* The items of a layer by step. */
function groupsOf(layer, nodes, links, items) {
  const linked = new Set(links.flatMap((link) => [link.from, link.to]));
  const own = items.filter((item) => nodes[item.index].layer === layer);
  const steps = stepsOf(own.map((item) => item.index), nodes, links);
  for (const item of own) item.step = steps.get(item.index);
  return [...new Set(steps.values())].sort((a, b) => a - b).map((step) => {
    const held = own.filter((item) => item.step === step);
    held.sort((a, b) => linked.has(b.index) - linked.has(a.index) || byName(nodes[a.index], nodes[b.index]));
    return { layer, items: held };
  });
}

/* Columns of at most so many rows: small steps share one, large ones take several. */
function fill(groups, rows) {
  const columns = [];
  for (const { layer, items } of groups) {
    const last = columns.at(-1);
    if (last && last.items.length + items.length <= rows) {
      last.items = [...last.items, ...items];
      last.shared += 1;
      continue;
    }
    const parts = Math.ceil(items.length / rows);
    const size = Math.ceil(items.length / parts);
    for (let part = 0; part < parts; part++) {
      columns.push({ layer, items: items.slice(part * size, (part + 1) * size), shared: 0, split: part > 0 });
    }
  }
  return columns;
}

/* How large the drawing can be shown, a little less where steps share a column or take several. */
function worth(groups, nodes, room) {
  let [width, rows, odd] = [0, 0, 0];
  for (const columns of groups) {
    width += 2 * SIZE.margin + SIZE.between - SIZE.corridor;
    for (const column of columns) {
      width += Math.max(SIZE.narrow, ...column.items.map((item) => widthOf(nodes[item.index], item.height))) + SIZE.corridor * 1.4;
      rows = Math.max(rows, column.items.length);
      odd += column.shared + column.split;
    }
  }
  const height = rows * ((nodes.length <= SIZE.roomy ? SIZE.high : SIZE.low) + SIZE.gap) * 1.2;
  return Math.min(1.1, room.width / width, room.height / height) * (1 - Math.min(0.25, 0.02 * odd));
}

function byName(a, b) {
  const [left, right] = [`${a.kind} ${a.label}`, `${b.kind} ${b.label}`];
  return left < right ? -1 : left > right ? 1 : 0;
}

/* The step of each node in its layer: its rank where the layer has ranks, else how many links lead to it. */
function stepsOf(own, nodes, links) {
  const last = 1 + Math.max(-1, ...own.map((index) => nodes[index].rank ?? -1));
  if (last) return new Map(own.map((index) => [index, nodes[index].rank ?? last]));
  const inside = new Set(own);
  const into = new Map(own.map((index) => [index, []]));
  for (const { from, to } of links) if (inside.has(from) && inside.has(to)) into.get(to).push(from);
  const steps = new Map();
  const depth = (index) => {
    if (!steps.has(index)) {
      steps.set(index, 0);
      steps.set(index, Math.min(STEPS, Math.max(0, ...into.get(index).map((from) => depth(from) + 1))));
    }
    return steps.get(index);
  };
  own.forEach(depth);
  return steps;
}

/* Tracks */

function hubOf(links) {
  if (!links.degree) {
    links.degree = new Map();
    for (const { from, to } of links) for (const end of [from, to]) links.degree.set(end, (links.degree.get(end) ?? 0) + 1);
  }
  return ({ from, to }) => (links.degree.get(from) >= links.degree.get(to) ? from : to);
}

/* The items that a link runs through, from its source to its target. */
function laid(link, items, columns, hub) {
  const [source, target] = [items[link.from], items[link.to]];
  const distance = target.column.number - source.column.number;
  const path = [source];
  const way = Math.sign(distance);
  for (let number = source.column.number + way; way && number !== target.column.number; number += way) {
    const column = columns[number];
    const key = hub(link);
    column.tracks ??= new Map();
    if (!column.tracks.has(key)) {
      const track = { index: -1, height: SIZE.track, column, before: [], after: [], beside: [] };
      column.tracks.set(key, track);
      column.items.push(track);
    }
    path.push(column.tracks.get(key));
  }
  path.push(target);
  for (let i = 1; i < path.length; i++) {
    const [left, right] = way < 0 ? [path[i], path[i - 1]] : [path[i - 1], path[i]];
    if (!way) {
      left.beside.push(right);
      right.beside.push(left);
    } else if (!(left.met ??= new Set()).has(right)) {
      left.met.add(right);
      left.after.push(right);
      right.before.push(left);
    }
  }
  return path;
}

/* Order and height */

const middle = (items) => items.reduce((sum, item) => sum + item.y, 0) / items.length;
const distanceOf = (a, b) => (a.height + b.height) / 2 + (a.index < 0 || b.index < 0 ? SIZE.gap / 2 : SIZE.gap);

function stack(column) {
  let y = 0;
  column.items.forEach((item, index) => {
    y += index ? distanceOf(column.items[index - 1], item) : 0;
    item.y = y;
  });
  for (const item of column.items) item.y -= y / 2;
}

function order(columns) {
  columns.forEach(stack);
  for (let sweep = 0; sweep < SWEEPS; sweep++) {
    const forward = sweep % 2 === 0;
    for (const column of forward ? columns : [...columns].reverse()) {
      const pull = new Map(column.items.map((item) => {
        const near = [...(forward ? item.before : item.after), ...item.beside];
        return [item, lonely(item) ? Infinity : near.length ? middle(near) : item.y];
      }));
      column.items = sorted(column, (a, b) => (pull.get(a) === pull.get(b) ? 0 : pull.get(a) - pull.get(b)));
      stack(column);
    }
  }
}

/* The items by their pull; where steps share a column, the nodes keep to their steps and the tracks go between them. */
function sorted(column, byPull) {
  if (!column.shared) return [...column.items].sort(byPull);
  const boxes = column.items.filter((item) => item.index >= 0).sort((a, b) => a.step - b.step || byPull(a, b));
  const tracks = column.items.filter((item) => item.index < 0).sort(byPull);
  const merged = [];
  for (const box of boxes) {
    while (tracks.length && byPull(tracks[0], box) < 0) merged.push(tracks.shift());
    merged.push(box);
  }
  return [...merged, ...tracks];
}

/* Moves each item towards what it is linked to, as far as order and distances allow: least squares by pooling. */
function rest(columns) {
  for (let sweep = 0; sweep < SWEEPS; sweep++) {
    const forward = sweep % 2 === 0;
    for (const column of forward ? columns : [...columns].reverse()) {
      const both = sweep >= SWEEPS - 4;
      const blocks = [];
      let offset = 0;
      column.items.forEach((item, index) => {
        offset += index ? distanceOf(column.items[index - 1], item) : 0;
        item.offset = offset;
        const aside = !item.before.length && !item.after.length;
        const near = aside ? item.beside : both ? [...item.before, ...item.after] : forward ? item.before : item.after;
        const weight = aside || !near.length ? 0.02 : item.index < 0 ? 2 : 1;
        const wanted = near.length ? middle(near) : Number.isFinite(item.y) ? item.y : 0;
        blocks.push({ sum: weight * (wanted - offset), weight, size: 1 });
        while (blocks.length > 1 && mean(blocks.at(-2)) > mean(blocks.at(-1))) {
          const last = blocks.pop();
          const pooled = blocks.at(-1);
          pooled.sum += last.sum;
          pooled.weight += last.weight;
          pooled.size += last.size;
        }
      });
      let index = 0;
      for (const block of blocks) {
        for (let held = 0; held < block.size; held++, index++) column.items[index].y = mean(block) + column.items[index].offset;
      }
    }
  }
}

/* What is tied to nothing stands right below the rest of its column, and above it where there is no room below. */
function settle(columns) {
  const tied = columns.flatMap(({ items }) => items.filter((item) => !lonely(item)));
  const [top, bottom] = tied.length ? [Math.min(...tied.map(topOf)), Math.max(...tied.map(bottomOf))] : [0, 0];
  for (const { items } of columns) {
    const free = items.filter(lonely);
    const held = items.filter((item) => !lonely(item));
    if (!free.length) continue;
    const step = free[0].height + SIZE.gap;
    let edge = (top + bottom - free.length * step) / 2;
    if (held.length) {
      const below = Math.floor(Math.max(0, bottom - bottomOf(held.at(-1))) / step);
      const above = Math.floor(Math.max(0, topOf(held[0]) - top) / step);
      const first = Math.max(0, Math.min(above, free.length - below));
      edge = topOf(held[0]);
      for (const item of free.splice(0, first).reverse()) {
        edge -= step;
        item.y = edge + item.height / 2;
      }
      edge = bottomOf(held.at(-1)) + SIZE.gap;
    }
    for (const item of free) {
      item.y = edge + item.height / 2;
      edge += step;
    }
  }
}

const topOf = (item) => item.y - item.height / 2;
const bottomOf = (item) => item.y + item.height / 2;
const lonely = (item) => !item.before.length && !item.after.length && !item.beside.length;
const mean = (block) => block.sum / block.weight;

/* Width */

function spread(columns, nodes, layers) {
  const bands = [];
  let x = 0;
  for (const column of columns) {
    const last = bands.at(-1);
    const previous = columns[column.number - 1];
    const lines = previous ? previous.items.reduce((sum, item) => sum + item.after.length, 0) : 0;
    const corridor = Math.min(SIZE.broad, SIZE.corridor + SIZE.crowd * lines);
    if (last?.layer === column.layer) x += corridor;
    else if (last) {
      const free = Math.max(SIZE.between, corridor - 2 * SIZE.margin);
      last.width = x - last.x + SIZE.margin;
      x += 2 * SIZE.margin + free;
      bands.push({ layer: column.layer, x: x - SIZE.margin });
    } else {
      x = SIZE.margin;
      bands.push({ layer: column.layer, x: 0 });
    }
    if (column.items.some((item) => item.beside.length)) x += SIZE.bow;
    column.x = x;
    column.width = Math.max(SIZE.narrow, ...column.items.filter((item) => item.index >= 0).map((item) => widthOf(nodes[item.index], item.height)));
    x += column.width;
  }
  if (bands.length) bands.at(-1).width = x - bands.at(-1).x + SIZE.margin;
  return bands;
}

function widthOf(node, height) {
  const extra = (node.worst ? SIZE.badge : 0) + (node.rank != null && node.kind !== "folded" ? SIZE.rank : 0);
  const longest = Math.max(node.label.length, ...namesOf(node).map((name) => name.length));
  const above = height > SIZE.low ? kindOf(node).length * SIZE.small : 0;
  return Math.min(SIZE.wide, Math.max(longest * SIZE.letter, above) + SIZE.padding + extra);
}

function heightOf(node, high) {
  const names = namesOf(node).length;
  return names ? SIZE.high + names * SIZE.line + SIZE.gap / 2 : high;
}

/* What a box that is not low says above its label. */
function kindOf(node) {
  if (node.kind !== "folded") return node.kind;
  return node.findings.length ? counted(node.findings.length, "finding") : "folded";
}

/* The names that a folded layer shows in its box. */
const namesOf = (node) => node.names ?? [];

/* A narrow room: boxes one below the other, and lines at their left. */
function stacked(nodes, links) {
  const width = Math.max(SIZE.narrow, ...nodes.map((node) => widthOf(node, SIZE.high)));
  const column = { x: 2 * SIZE.bow, width, number: 0 };
  const items = nodes.map((node, index) => ({ column, y: index * (SIZE.high + 2 * SIZE.gap) + SIZE.high / 2 }));
  return {
    high: SIZE.high,
    bands: [],
    width: column.x + width + SIZE.bow,
    height: nodes.length * (SIZE.high + 2 * SIZE.gap),
    boxes: items.map((item) => ({ x: column.x, y: item.y - SIZE.high / 2, width, height: SIZE.high })),
    routes: links.map(({ from, to }) => route([items[from], items[to]])),
  };
}

/* Lines */

function route(path) {
  const [source, target] = [path[0], path.at(-1)];
  const way = Math.sign(target.column.number - source.column.number);
  const left = (item) => item.column.x;
  const right = (item) => item.column.x + item.column.width;
  if (!way) {
    const x = left(source);
    const bow = x - 14 - Math.min(SIZE.bow, Math.abs(target.y - source.y) * 0.1);
    const end = `${num(bow)} ${num(target.y)} ${num(x - SIZE.arrow)} ${num(target.y)}`;
    return { d: `M${num(x)} ${num(source.y)}C${num(bow)} ${num(source.y)} ${end}`, arrow: arrowAt(x, target.y, 1) };
  }
  const [near, far] = way > 0 ? [left, right] : [right, left];
  let [x, y] = [far(source), source.y];
  let d = `M${num(x)} ${num(y)}`;
  for (const item of path.slice(1)) {
    const end = item === target ? near(item) - way * SIZE.arrow : near(item);
    const bend = num((x + end) / 2);
    d += `C${bend} ${num(y)} ${bend} ${num(item.y)} ${num(end)} ${num(item.y)}`;
    if (item !== target) d += `H${num(far(item))}`;
    [x, y] = [far(item), item.y];
  }
  return { d, arrow: arrowAt(near(target), target.y, way) };
}

function arrowAt(x, y, way) {
  return `M${num(x)} ${num(y)}l${-way * SIZE.arrow} -3.5v7z`;
}

function num(value) {
  return Math.round(value * 10) / 10;
}
