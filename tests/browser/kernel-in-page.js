// What the kernel of a real page answers, under the policy that its server sends: to each line of
// standard input, calls as JSON, a line. Arguments: "chrome" or "firefox", the program, the address, the
// program's arguments.

import process from "node:process";
import { createInterface } from "node:readline";

import { answered } from "../frontend/kernel/answered.js";
import { launched, pageOf } from "./driven.js";

const [, , kind, executablePath, address, ...args] = process.argv;

const browser = await launched(kind, executablePath, args);
const page = await pageOf(browser);
const response = await page.goto(address);
const policy = response?.headers()["content-security-policy"] ?? "";
if (!policy.includes("script-src 'self' 'wasm-unsafe-eval';")) {
  throw new Error(`the policy is not the page's: ${policy}`);
}

// by the page's own modules, fetched and compiled as the page itself does
const refusal = await page.evaluate(`(async () => {
  const main = document.querySelector('script[type="module"]').src;
  const [{ createClient }, { createKernel }] = await Promise.all(
    ["api/client.js", "kernel/kernel.js"].map((path) => import(new URL(path, main).href)),
  );
  globalThis.kernelOfTest = await createKernel(await createClient().kernel());
})().catch(String)`);
if (refusal) {
  throw new Error(refusal);
}
for await (const calls of createInterface({ input: process.stdin })) {
  const told = await page.evaluate(`(${answered})(kernelOfTest, ${JSON.stringify(calls)})`);
  process.stdout.write(`${told}\n`);
}
await browser.close();
