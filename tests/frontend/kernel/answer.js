// What the kernel answers to the calls of standard input, as JSON; arrays become lists.
import { readFileSync } from "node:fs";

import { createKernel } from "../../../frontend/kernel/kernel.js";

const file = new URL("../../../frontend/kernel/kernel.wasm", import.meta.url);
const kernel = await createKernel(new WebAssembly.Module(readFileSync(file)));
const calls = JSON.parse(readFileSync(0, "utf8"));
const answers = calls.map(([name, ...given]) =>
  kernel[name](...given.map((each) => (each === "infinity" ? Infinity : each))),
);
const listed = (_, value) => (ArrayBuffer.isView(value) ? [...value] : value);
process.stdout.write(JSON.stringify(answers, listed));
