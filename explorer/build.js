// Builds the page as one file: node build.js CORE.wasm OUT.html. It contains modules, styles and the core, and loads nothing else.
import { readFile, writeFile } from "node:fs/promises";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const [core, out] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const common = { bundle: true, write: false, minify: true, target: "es2022", charset: "utf8", logLevel: "warning", absWorkingDir: here };
const [script, style] = await Promise.all([
  build({ ...common, entryPoints: ["page.js"], format: "esm", legalComments: "inline", alias: { "core.wasm": resolve(core) }, loader: { ".wasm": "binary" } }),
  build({ ...common, entryPoints: ["page.css"] }),
]);
const parts = { SCRIPT: script.outputFiles[0].text.replaceAll("</script", "<\\/script"), STYLE: style.outputFiles[0].text };
const licence = await readFile(`${here}/node_modules/uplot/LICENSE`, "utf8");
parts.LICENCES = `uPlot. ${licence.trim()}\n\nThe core has parts of wasi-libc (Apache-2.0 with LLVM exception; MIT), of musl in it (MIT, Copyright 2005-2020 Rich Felker, et al.) and of LLVM's\ncompiler-rt (Apache-2.0 with LLVM exception).`.replaceAll("--", "- -");
const page = (await readFile(`${here}/index.html`, "utf8")).replace(/\/\*(SCRIPT|STYLE|LICENCES)\*\//g, (_, name) => parts[name]);
await writeFile(out, page);
