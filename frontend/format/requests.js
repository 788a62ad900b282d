// @ts-check

/**
 * A request as the API takes it.
 * @typedef {object} Request
 * @property {string} call as in `/trace`, without the slash
 * @property {Record<string, string>} query
 * @property {Record<string, any>} [body] of what is posted
 */

/** Marks of a URL's query that need no escaping there and read better without. */
const PLAIN_MARKS = /%2C/g;

/**
 * Where the server is, as the address of its page says: it may be below a path of a proxy.
 * @param {string} page
 */
export function serverOf(page) {
  return new URL(".", page).href;
}

/**
 * The address of a request.
 * @param {Request} request
 * @param {string} [server] with a slash at its end; nothing for this page's own
 */
export function addressOf({ call, query }, server = "") {
  const marks = String(new URLSearchParams(query)).replace(PLAIN_MARKS, ",");
  return `${server}api/v1/${call}${marks && "?"}${marks}`;
}

/**
 * The request as a line for a shell.
 * @param {Request} request
 * @param {string} server
 */
export function curlOf(request, server) {
  const address = `curl "${addressOf(request, server)}"`;
  return request.body
    ? `${address} -H "Content-Type: application/json" -d '${JSON.stringify(request.body)}'`
    : address;
}

/**
 * The request as a Python program that needs no package.
 * @param {Request} request
 * @param {string} server
 */
export function pythonOf({ call, query, body }, server) {
  if (body) {
    return `import json
from urllib.request import Request, urlopen

body = json.loads("""
${JSON.stringify(body, null, 2)}
""")
request = Request(
    "${server}api/v1/${call}",
    json.dumps(body).encode(),
    {"Content-Type": "application/json"},
)
with urlopen(request) as answer:
    result = json.load(answer)
print(list(result))`;
  }
  const lines = Object.entries(query).map(
    ([key, value]) => `    "${key}": ${isNumber(value) ? value : JSON.stringify(value)},`,
  );
  return `import json
from urllib.parse import urlencode
from urllib.request import urlopen

parameters = {
${lines.join("\n")}
}
with urlopen("${server}api/v1/${call}?" + urlencode(parameters)) as answer:
    result = json.load(answer)
print(list(result))`;
}

/**
 * A file name that says what is in it and for which numbers: `restitution-force-kappa-63-….csv`.
 * @param {string} what
 * @param {Record<string, number | string>} parameters
 * @param {string} extension
 */
export function fileName(what, parameters, extension) {
  const parts = Object.entries(parameters).flatMap(([key, value]) => [key, String(value)]);
  const words = ["restitution", what, ...parts].map((part) => part.replace(/[^\w.+-]+/g, ""));
  return `${words.join("-")}.${extension}`;
}

/** @param {string} text */
function isNumber(text) {
  return /^[+-]?\d+(\.\d+)?(e[+-]?\d+)?$/i.test(text);
}
