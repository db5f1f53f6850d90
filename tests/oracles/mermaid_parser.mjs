// Reads flowcharts with Mermaid itself. Arguments: the folder that holds node_modules, then the files.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, ...files] = process.argv.slice(2);
const require = createRequire(join(resolve(folder), "parser.js"));
const { JSDOM } = require("jsdom");
const { window } = new JSDOM("<body></body>");
Object.assign(globalThis, { window, document: window.document });

const home = join(resolve(folder), "node_modules", "mermaid");
const main = JSON.parse(readFileSync(join(home, "package.json"), "utf-8")).module;
const { default: mermaid } = await import(pathToFileURL(join(home, main)));
mermaid.initialize({ maxTextSize: 50_000_000, maxEdges: 1_000_000 });

for (const file of files) {
  const { db } = await mermaid.mermaidAPI.getDiagramFromText(readFileSync(file, "utf-8"));
  const nodes = [...db.getVertices().entries()].map(([id, node]) => [id, node.text]);
  const edges = db.getEdges().map((edge) => [edge.start, edge.end, edge.text]);
  const groups = db.getSubGraphs().map((group) => [group.title, group.nodes]);
  console.log(JSON.stringify({ nodes, edges, groups }));
}
