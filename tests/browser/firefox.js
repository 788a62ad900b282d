// Drives Debian's Firefox; prints what it saw as JSON. Arguments: the program, the address of the page.

import process from "node:process";

import { launched, pageOf } from "./driven.js";

const [, , executablePath, base] = process.argv;
const PATHS = [
  "",
  "?scene=spheres",
  "?scene=accuracy",
  "?scene=paper",
  "?scene=lesson&step=2",
  "?embed=force",
  "docs",
  "redoc",
];
/** What is told of a page: the text of ε_t, where it has come to. */
const TOLD = `() => document.querySelector('[data-testid="epsilon-t"]')?.textContent ?? ""`;

const browser = await launched("firefox", executablePath);
/** @type {string[]} */
const words = [];
/** @type {string[]} */
const failed = [];

/** @param {{width: number, height: number}} size */
async function pageIn(size) {
  const page = await pageOf(browser, words);
  await page.setViewport(size);
  page.on(
    "response",
    (answer) => answer.status() < 400 || failed.push(`${answer.status()} ${answer.url()}`),
  );
  return page;
}

/**
 * Wait until the strip says a number, and no answer is on its way.
 * @param {import("puppeteer-core").Page} page
 */
async function settled(page) {
  await page.waitForNetworkIdle({ idleTime: 500 });
  await page.waitForFunction(
    () => {
      const told = document.querySelector('[data-testid="epsilon-t"]');
      const strip = document.querySelector('[data-testid="result"]');
      return !told || (/\d/.test(told.textContent ?? "") && !strip?.matches("[data-stale]"));
    },
    { polling: 100 },
  );
}

const page = await pageIn({ width: 1280, height: 720 });
const seen = [];
for (const path of PATHS) {
  await page.goto(base + path);
  await settled(page);
  const wide = await page.evaluate("document.documentElement.scrollWidth - innerWidth");
  seen.push({ path, told: await page.evaluate(`(${TOLD})()`), wide });
}

// a drag of a slider, in steps, and what the strip says when the hand rests
await page.goto(base);
await settled(page);
const slider = await page.$('[data-parameter="kappa"] .parameter-slider');
const box = await slider?.boundingBox();
if (!box) {
  throw new Error("there is no slider");
}
const y = box.y + box.height / 2;
await page.mouse.move(box.x + 0.7 * box.width, y);
await page.mouse.down();
for (let share = 0.7; share > 0.4; share -= 0.02) {
  await page.mouse.move(box.x + share * box.width, y);
}
await page.mouse.up();
await settled(page);
const dragged = { address: page.url(), told: await page.evaluate(`(${TOLD})()`) };

const phone = await pageIn({ width: 390, height: 844 });
await phone.goto(base);
await settled(phone);
const wideOnPhone = await phone.evaluate("document.documentElement.scrollWidth - innerWidth");

// the hand-out of the lesson and the explorer, as far as a printer goes
const printed = [];
for (const path of ["", "?scene=lesson&step=2"]) {
  await page.goto(base + path);
  await settled(page);
  printed.push((await page.pdf({ format: "A4" })).length);
}
await browser.close();
process.stdout.write(JSON.stringify({ words, failed, seen, dragged, wideOnPhone, printed }));
