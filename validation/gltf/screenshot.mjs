// Pictures of GLB files or pages in headless Chromium: `node screenshot.mjs OUT_DIR FILE.glb|FILE.html[#STATE]...`.
//
// A GLB is shown by three.js at rest and at each morph target; a page is opened from its file:// address, a viewer page in
// the state named, for instance `#target=1&stretch=8&apart=0.6`.
// Chromium comes from the system (`apt-get install chromium`); CHROMIUM names another one.
import { spawn } from "node:child_process";
import { mkdir, readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { basename, dirname, extname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const [out, ...files] = process.argv.slice(2);
if (!out || files.length === 0) {
  console.error("usage: node screenshot.mjs OUT_DIR FILE.glb|FILE.html...");
  process.exit(2);
}
await mkdir(out, { recursive: true });

const types = { ".html": "text/html", ".js": "text/javascript", ".glb": "model/gltf-binary" };
const server = createServer(async (request, response) => {
  const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
  const index = /^\/glb\/(\d+)$/.exec(path)?.[1];
  try {
    const file = index === undefined ? join(here, path) : files[Number(index)];
    const body = await readFile(file);
    response.writeHead(200, { "content-type": types[extname(file)] ?? "application/octet-stream" }).end(body);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
const origin = `http://127.0.0.1:${server.address().port}`;

function shoot(address, picture) {
  const flags = [
    "--headless", "--no-sandbox", "--hide-scrollbars", "--enable-unsafe-swiftshader", "--use-angle=swiftshader",
    "--window-size=1000,700", "--virtual-time-budget=20000", `--screenshot=${picture}`, address,
  ];
  return new Promise((done, fail) => {
    const browser = spawn(process.env.CHROMIUM ?? "chromium", flags, { stdio: ["ignore", "ignore", "pipe"] });
    let said = "";
    browser.stderr.on("data", (text) => (said += text));
    browser.on("error", fail);
    browser.on("exit", (code) => (code === 0 ? done(picture) : fail(new Error(`chromium ended with ${code}\n${said}`))));
  });
}

for (const [index, asked] of files.entries()) {
  const [file, state] = asked.split("#");
  const name = basename(file, extname(file));
  if (extname(file) === ".html") {
    const address = pathToFileURL(resolve(file)).href + (state ? `#${state}` : "");
    const suffix = state ? `-${state.replace(/[^\w.]+/g, "-")}` : "";
    console.log(await shoot(address, resolve(out, `${name}-page${suffix}.png`)));
    continue;
  }
  for (const target of [-1, 0, 1]) {
    const address = `${origin}/three.html?file=/glb/${index}&target=${target}`;
    console.log(await shoot(address, resolve(out, `${name}-target${target}.png`)));
  }
}
server.close();
