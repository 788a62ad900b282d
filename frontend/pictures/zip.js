// @ts-check

/** Names are in UTF-8; what is in a file is deflated; a reader has to know no more than version 2.0. */
const [UTF_8, DEFLATED, VERSION] = [0x0800, 8, 20];
const [ENTRY, DIRECTORY, END] = [0x04034b50, 0x02014b50, 0x06054b50];

/** Of what gzip puts around deflated bytes. */
const [GZIP_HEAD, GZIP_TAIL] = [10, 8];

/**
 * A ZIP of some files: the browser deflates and sums up, what is written here is where each begins.
 * @param {{name: string, content: Blob | string}[]} files of together less than 4 GB
 * @param {Date} time
 * @returns {Promise<Blob>}
 */
export async function zipOf(files, time) {
  const [entries, directory] = [/** @type {BlobPart[]} */ ([]), /** @type {BlobPart[]} */ ([])];
  let offset = 0;
  for (const { name, content } of files) {
    const { deflated, sum, size } = await deflate(new Blob([content]));
    const path = new TextEncoder().encode(name);
    const told = [
      ...[shorts(VERSION, UTF_8, DEFLATED, ...dosTime(time)), longs(sum, deflated.size, size)],
      shorts(path.length, 0),
    ];
    const entry = new Blob([longs(ENTRY), ...told, path, deflated]);
    // No comment, the first disk, no attributes.
    const rest = [shorts(0, 0, 0), longs(0, offset), path];
    directory.push(new Blob([longs(DIRECTORY), shorts(VERSION), ...told, ...rest]));
    entries.push(entry);
    offset += entry.size;
  }
  const list = new Blob(directory);
  const count = shorts(0, 0, files.length, files.length);
  const end = [longs(END), count, longs(list.size, offset), shorts(0)];
  return new Blob([...entries, list, ...end], { type: "application/zip" });
}

/**
 * A file as gzip has it, without what it puts around it but for the sum and the size, which are those of a ZIP.
 * @param {Blob} file
 */
async function deflate(file) {
  const packed = file.stream().pipeThrough(new CompressionStream("gzip"));
  const gzip = await new Response(packed).arrayBuffer();
  const tail = new DataView(gzip, gzip.byteLength - GZIP_TAIL);
  return {
    deflated: new Blob([gzip.slice(GZIP_HEAD, -GZIP_TAIL)]),
    sum: tail.getUint32(0, true),
    size: tail.getUint32(4, true),
  };
}

/**
 * Time and date as DOS had them: every other second, from 1980 on.
 * @param {Date} time
 */
function dosTime(time) {
  return [
    (time.getHours() << 11) | (time.getMinutes() << 5) | (time.getSeconds() >> 1),
    ((time.getFullYear() - 1980) << 9) | ((time.getMonth() + 1) << 5) | time.getDate(),
  ];
}

/** @param {number[]} values of two bytes each, the lower one first */
function shorts(...values) {
  const view = new DataView(new ArrayBuffer(2 * values.length));
  values.forEach((value, i) => view.setUint16(2 * i, value, true));
  return view;
}

/** @param {number[]} values of four bytes each */
function longs(...values) {
  const view = new DataView(new ArrayBuffer(4 * values.length));
  values.forEach((value, i) => view.setUint32(4 * i, value, true));
  return view;
}
