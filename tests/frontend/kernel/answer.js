// What the kernel answers to the calls of standard input, as JSON; arrays are lists there.
import { readFileSync } from "node:fs";

import { createKernel } from "../../../frontend/kernel/kernel.js";

const file = new URL("../../../frontend/kernel/kernel.wasm", import.meta.url);
const kernel = await createKernel(new WebAssembly.Module(readFileSync(file)));
const calls = JSON.parse(readFileSync(0, "utf8"));
/** Lists of JSON as the kernel takes them. */
const typed = (value) =>
  Object.fromEntries(
    Object.entries(value).map(([key, each]) => [
      key,
      Array.isArray(each) ? Float64Array.from(each) : each,
    ]),
  );
const answers = calls.map(([name, first, ...rest]) =>
  kernel[name](typeof first === "object" ? typed(first) : first, ...rest),
);
const listed = (_, value) => (ArrayBuffer.isView(value) ? [...value] : value);
process.stdout.write(JSON.stringify(answers, listed));
