import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";

const ROOT = new URL("../../frontend/", import.meta.url);
const files = readdirSync(ROOT, { recursive: true }).filter((file) => file.endsWith(".js"));
const sources = Object.fromEntries(
  files.map((file) => [file, readFileSync(new URL(file, ROOT), "utf8")]),
);

/** The page and its parts. */
const markup = readdirSync(ROOT, { recursive: true })
  .filter((file) => file.endsWith(".html"))
  .map((file) => readFileSync(new URL(file, ROOT), "utf8"))
  .join("");

/** What each room may import from besides itself; types don't count, they are comments. */
const ARROWS = {
  api: [],
  kernel: ["api"],
  format: [],
  state: ["format"],
  figures: ["format"],
  widgets: ["figures", "state", "format"],
  pictures: ["widgets", "figures", "state", "format"],
  page: ["widgets", "figures", "state", "format", "api"],
};
const SCENE_ARROWS = ["widgets", "figures", "state", "format", "api"];

/** The room of a file: its folder, and each scene is one. */
function roomOf(file) {
  return file
    .split("/")
    .slice(0, file.startsWith("scenes/") ? 2 : 1)
    .join("/");
}

const withoutComments = (source) => source.replaceAll(/\/\*[\s\S]*?\*\//g, "");

test("imports follow the arrows: from a scene down to the formats, never to another scene", () => {
  for (const [file, source] of Object.entries(sources)) {
    const room = roomOf(file);
    const allowed = room.startsWith("scenes/") ? SCENE_ARROWS : ARROWS[room];
    for (const [, path] of source.matchAll(/^(?:import|} from|export .* from).*"(\.[^"]+)"/gm)) {
      const target = roomOf(new URL(path, new URL(file, ROOT)).href.slice(ROOT.href.length));
      assert.ok(
        file === "main.js" || target === room || allowed.includes(target),
        `${file} imports ${path}`,
      );
    }
  }
});

test("no module, no style sheet and no room is more than one takes in", () => {
  for (const file of readdirSync(ROOT, { recursive: true })) {
    if (/\.(js|css|html)$/.test(file)) {
      const lines = readFileSync(new URL(file, ROOT), "utf8").split("\n").length;
      assert.ok(lines <= 400, `${file} has ${lines} lines`);
    }
  }
  const all = readdirSync(ROOT, { recursive: true, withFileTypes: true });
  const counts = Map.groupBy(all, ({ parentPath }) => parentPath);
  for (const [room, entries] of counts) {
    assert.ok(entries.length <= 20, `${room} has ${entries.length} entries`);
  }
});

test("only the client fetches, and only widgets, pictures, the page and the scenes draw", () => {
  for (const [file, source] of Object.entries(sources)) {
    const code = withoutComments(source);
    assert.ok(
      file === "api/client.js" || !/\bfetch\(|XMLHttpRequest|sendBeacon/.test(code),
      `${file} fetches`,
    );
    const mayDraw = /^(widgets|pictures|page|scenes)\//.test(file) && !/-figure\.js$/.test(file);
    assert.ok(mayDraw || !/\bPlotly\b|\bdocument\b/.test(code), `${file} draws`);
  }
});

test("the page holds no inline script and no inline style", () => {
  assert.doesNotMatch(markup, /<style|\sstyle=|\son\w+=|<script(?![^>]*\ssrc=)|javascript:/i);
});

test("nothing is loaded from another host", () => {
  // below whatever path of a proxy the page stands
  assert.doesNotMatch(markup, /(?:src|href)="(?:\/|\w+:)/);
  for (const file of readdirSync(ROOT, { recursive: true })) {
    if (/\.(js|css|html)$/.test(file)) {
      const source = readFileSync(new URL(file, ROOT), "utf8");
      assert.doesNotMatch(source, /https?:\/\//, file);
      assert.doesNotMatch(source, /^(?:import|\} from|export [*{])[^;"\n]*"(?!\.)/m, file);
    }
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

/** What a module imports only when it is needed. */
const deferred = Object.entries(sources).flatMap(([file, source]) =>
  [...withoutComments(source).matchAll(/\bimport\("(\.[^"]+)"\)/g)].map(([, path]) =>
    new URL(path, new URL(file, ROOT)).href.slice(ROOT.href.length),
  ),
);

test("every module is needed, and what the first view does without waits until it is asked for", () => {
  const first = loadedWith("main.js");
  const later = new Set(deferred.flatMap((file) => [...loadedWith(file)]));
  assert.deepEqual(
    files.filter((file) => !first.has(file) && !later.has(file)),
    [],
  );
  assert.deepEqual(
    deferred.filter((file) => first.has(file)),
    [],
  );
  const scenes = [...first].filter((file) => file.startsWith("scenes/")).map(roomOf);
  assert.deepEqual([...new Set(scenes)], ["scenes/explorer"]);
});
