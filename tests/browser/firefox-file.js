// Opens the page as one file in Debian's Firefox; prints what it saw as JSON. Arguments: the program, the
// address of the file, the options of each state to be seen.

import process from "node:process";

import { launched, pageOf } from "./driven.js";

const [, , executablePath, address, ...states] = process.argv;

const browser = await launched("firefox", executablePath);
/** @type {string[]} */
const words = [];
/** @type {string[]} */
const asked = [];
const page = await pageOf(browser, words);
await page.setViewport({ width: 1280, height: 720 });
page.on("request", (request) => asked.push(request.url()));

/** Wait until all is drawn: Plotly comes last, and what the scene is about is told. */
async function settled() {
  await page.waitForFunction(
    () => {
      const told = document.querySelector('[data-testid="epsilon-t"]');
      const isComing = document.documentElement
        .getAttributeNames()
        .some((name) => name.endsWith("-coming"));
      return "Plotly" in globalThis && !isComing && /\d/.test(told?.textContent ?? "");
    },
    { polling: 100 },
  );
}

const seen = [];
for (const state of states) {
  await page.goto(`${address}?${state}`);
  await settled();
  const wide = await page.evaluate("document.documentElement.scrollWidth - innerWidth");
  const plots = await page.evaluate("document.querySelectorAll('.plot .main-svg').length");
  seen.push({ state, wide, plots });
}

await page.goto(address);
await settled();
await page.select('[data-testid="language"]', "de");
await page.waitForFunction("document.documentElement.lang === 'de'", { polling: 100 });
await settled();
const told = await page.evaluate(`document.querySelector('[data-testid="epsilon-t"]').textContent`);
await browser.close();
const elsewhere = asked.filter((url) => !url.startsWith("data:") && !url.startsWith(address));
process.stdout.write(JSON.stringify({ words, elsewhere, seen, told }));
