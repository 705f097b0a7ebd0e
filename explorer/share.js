// Exports: the command and the scene for the same numbers, tables, pictures.
import { PARAMETERS, numberOf } from "./core.js";
import { USUAL } from "./state.js";

const tidy = (text) => text.replace(/[\x00-\x1f\x7f]/g, " ");
const word = (text) => (/^[A-Za-z0-9_.,:+\/-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
const quoted = (text) => `"${text.replaceAll("\\", "\\\\").replaceAll('"', '\\"')}"`;
const gaitOf = (state) => (state.gait === "measured" ? `measured:${tidy(state.table_name)}` : state.gait);
const startOf = (state) => (state.start === "velocity" ? String(numberOf(state.v0)) : state.start);

/** Returns the command line of a state. */
export function commandOf(state) {
  const measured = state.gait === "measured", options = [];
  for (const name of PARAMETERS)
    if (state[name] !== USUAL[name] || (measured && ["L", "T", "alpha"].includes(name))) options.push(`--${name} ${word(state[name])}`);
  if (state.gait !== USUAL.gait) options.push(`--gait ${word(gaitOf(state))}`);
  if (state.start !== "steady") options.push(`--start ${word(startOf(state))}`, `--periods ${word(state.periods)}`);
  return ["scallop", state.start === "steady" ? "steady" : "trajectory", ...options].join(" ");
}

/** Returns a state as a scene for `scallop run`. */
export function sceneOf(state) {
  const crawler = [...PARAMETERS.map((name) => `${name} = ${numberOf(state[name])}`), `gait = ${quoted(gaitOf(state))}`];
  const steady = state.start === "steady";
  const start = state.start === "rest" ? 'start = "rest";\n' : steady ? "" : `start = ${numberOf(state.v0)};\n`;
  const want = steady
    ? 'kind = "steady";\n  columns = [ "froude", "v_start", "v_mid", "displacement", "mean_velocity", "multiplier", "friction_work", "regime", "modes" ];'
    : `kind = "trajectory"; periods = ${numberOf(state.periods)}; samples = 40;\n  columns = [ "t", "x1", "x2", "xC", "v1", "v2", "l" ];`;
  return `title = "a crawler of the explorer";\ncrawler = { ${crawler.join("; ")}; };\n${start}tables = ( {\n  ${want}\n  file = "explorer.tsv";\n} );\n`;
}

/** Returns a table as TSV; numbers read back to the same doubles. */
export function tsvOf({ names, rows }, command, version) {
  const cell = (x) => (x === null || x === undefined || Number.isNaN(x) ? "nan" : String(x));
  const lines = rows[0].map((_, i) => rows.map((row) => cell(row[i])).join("\t"));
  return `# scallop ${version}, the explorer\n# of the crawler of: ${tidy(command)}\n${names.join("\t")}\n${lines.join("\n")}\n`;
}

/** Offers a file as a download. */
export function save(name, content, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const STYLED = ["fill", "stroke", "stroke-width", "stroke-dasharray", "font", "opacity", "font-weight"];

/** Returns the drawing of the crawler, including its styles. */
function standalone(svg) {
  const copy = svg.cloneNode(true), from = [svg, ...svg.querySelectorAll("*")], to = [copy, ...copy.querySelectorAll("*")];
  from.forEach((node, i) => {
    const style = getComputedStyle(node);
    to[i].setAttribute("style", STYLED.map((name) => `${name}:${style.getPropertyValue(name)}`).join(";"));
  });
  return copy;
}

/** Returns the view as one SVG: the crawler in lines, plots as pictures, a title on top. plots: { title, canvas } */
export function pictureOf(svg, plots, title) {
  const width = 900, paper = getComputedStyle(document.body).backgroundColor, ink = getComputedStyle(document.body).color;
  const space = "http://www.w3.org/2000/svg", all = document.createElementNS(space, "svg");
  const put = (tag, attributes, text) => {
    const made = document.createElementNS(space, tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    if (text) made.textContent = text;
    all.append(made);
    return made;
  };
  const ground = put("rect", { width, fill: paper });
  const label = (y, text) => put("text", { x: 12, y, fill: ink, style: "font:15px sans-serif" }, text);
  label(22, title);
  const crawler = standalone(svg);
  for (const [name, value] of Object.entries({ x: 0, y: 30, width, height: 360 })) crawler.setAttribute(name, value);
  all.append(crawler);
  let y = 400;
  for (const { title: name, canvas } of plots) {
    const height = (canvas.height / canvas.width) * width;
    label(y + 14, name);
    put("image", { href: canvas.toDataURL(), x: 0, y: y + 20, width, height });
    y += height + 40;
  }
  ground.setAttribute("height", y);
  for (const [name, value] of Object.entries({ xmlns: space, width, height: y, viewBox: `0 0 ${width} ${y}` })) all.setAttribute(name, value);
  return new XMLSerializer().serializeToString(all);
}

/** Converts this SVG to PNG. */
export async function pngOf(picture) {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(picture)}`;
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: 2 * image.width, height: 2 * image.height });
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}
