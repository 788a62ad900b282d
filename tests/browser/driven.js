// A browser that Puppeteer drives: over WebDriver BiDi also Debian's Firefox, which Playwright does not.

import puppeteer from "puppeteer-core";

const LIMIT = 300_000;

/**
 * @param {"chrome" | "firefox"} kind
 * @param {string} executablePath
 * @param {string[]} [args]
 */
export function launched(kind, executablePath, args = []) {
  return puppeteer.launch({ browser: kind, executablePath, args, protocolTimeout: LIMIT });
}

/**
 * A page of it, whose words and errors are noted.
 * @param {import("puppeteer-core").Browser} browser
 * @param {string[]} words
 */
export async function pageOf(browser, words = []) {
  const page = await browser.newPage();
  page.setDefaultTimeout(LIMIT);
  page.on("console", (message) => words.push(message.text()));
  page.on("pageerror", (error) => words.push(String(error)));
  return page;
}
