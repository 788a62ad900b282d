/**
 * What a kernel answers to calls, each a name and its arguments, both as JSON; arrays are lists there.
 * A page evaluates its text, too: it takes nothing from around itself.
 */
export function answered(kernel, calls) {
  /** Lists of JSON as the kernel takes them. */
  const typed = (value) =>
    Object.fromEntries(
      Object.entries(value).map(([key, each]) => [
        key,
        Array.isArray(each) ? Float64Array.from(each) : each,
      ]),
    );
  const answers = JSON.parse(calls).map(([name, first, ...rest]) =>
    kernel[name](typeof first === "object" ? typed(first) : first, ...rest),
  );
  const listed = (_, value) => (ArrayBuffer.isView(value) ? [...value] : value);
  return JSON.stringify(answers, listed);
}
