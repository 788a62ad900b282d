// What the kernel answers to the calls of standard input, as JSON.
import { readFileSync } from "node:fs";

import { createKernel } from "../../../frontend/kernel/kernel.js";
import { answered } from "./answered.js";

const file = new URL("../../../frontend/kernel/kernel.wasm", import.meta.url);
const kernel = await createKernel(new WebAssembly.Module(readFileSync(file)));
process.stdout.write(answered(kernel, readFileSync(0, "utf8")));
