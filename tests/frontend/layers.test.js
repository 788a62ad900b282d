import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";

const ROOT = new URL("../../frontend/", import.meta.url);
const files = readdirSync(ROOT, { recursive: true }).filter((file) => file.endsWith(".js"));
const sources = Object.fromEntries(
  files.map((file) => [file, readFileSync(new URL(file, ROOT), "utf8")]),
);

/** What each folder may import from; types don't count, they are comments. */
const ARROWS = {
  api: ["api"],
  format: ["format"],
  state: ["state", "format"],
  figures: ["figures", "format"],
  panels: ["panels", "figures", "state", "format"],
};

test("imports follow the arrows: panels to figures and state, nothing back", () => {
  for (const [file, source] of Object.entries(sources)) {
    const folder = file.split("/")[0];
    for (const [, path] of source.matchAll(/^(?:import|} from|export .* from).*"(\.[^"]+)"/gm)) {
      const target = new URL(path, new URL(file, ROOT)).href.slice(ROOT.href.length).split("/")[0];
      assert.ok(file === "main.js" || ARROWS[folder].includes(target), `${file} imports ${path}`);
    }
  }
});

test("only the client fetches, and only the panels and the address bar touch the page", () => {
  for (const [file, source] of Object.entries(sources)) {
    const code = source.replaceAll(/\/\*[\s\S]*?\*\//g, "");
    assert.ok(file === "api/client.js" || !/\bfetch\(/.test(code), `${file} fetches`);
    assert.ok(file.startsWith("panels/") || !/\bPlotly\b|\bdocument\b/.test(code), `${file} draws`);
  }
});

test("the page holds no inline script and no inline style", () => {
  const page = readFileSync(new URL("index.html", ROOT), "utf8");
  assert.doesNotMatch(page, /<style|\sstyle=|\son\w+=|<script(?![^>]*\ssrc=)|javascript:/i);
});

test("nothing is loaded from another host", () => {
  const page = readFileSync(new URL("index.html", ROOT), "utf8");
  assert.doesNotMatch(page, /(?:src|href)="(?!\/|#)/);
  for (const [file, source] of Object.entries(sources)) {
    assert.doesNotMatch(source, /https?:\/\//, file);
  }
});

/** What is loaded along with a module; what it imports only when it is needed is not. */
function loadedWith(file, loaded = new Set()) {
  loaded.add(file);
  for (const [, path] of sources[file].matchAll(
    /^(?:import|} from|export .* from) .*"(\.[^"]+)"/gm,
  )) {
    const target = new URL(path, new URL(file, ROOT)).href.slice(ROOT.href.length);
    if (!loaded.has(target)) {
      loadedWith(target, loaded);
    }
  }
  return loaded;
}

test("only what the lesson needs waits until it is opened", () => {
  const first = loadedWith("main.js");
  const later = loadedWith("panels/lesson-scene.js");
  assert.deepEqual(
    files.filter((file) => !first.has(file) && !later.has(file)),
    [],
  );
  assert.ok(later.has("state/translation.js") && !first.has("state/translation.js"));
});
