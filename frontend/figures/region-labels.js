// @ts-check

/**
 * Where the areas of equal cells of a map have room for a label: for each of them the place that is
 * farthest from its border, if a circle of the label's size fits in there.
 * @param {ArrayLike<number>[]} cells rows from the bottom up
 * @param {import("./plot-area.js").Size} size of the map, in any unit
 * @param {number} diameter of a label, in the same unit
 * @param {{x: number, y: number}[]} taken places that no label may cover, as shares
 * @returns {{x: number, y: number, value: number}[]} shares from the left and from the bottom
 */
export function regionLabels(cells, size, diameter, taken) {
  const [rows, columns] = [cells.length, cells[0].length];
  const step = { x: size.width / (columns - 1), y: size.height / (rows - 1) };
  const distances = distancesToBorders(cells, step);
  for (const { x, y } of taken) {
    keepFree(distances, columns, step, { x: x * size.width, y: y * size.height });
  }
  const order = Array.from(distances.keys())
    .filter((i) => distances[i] >= diameter / 2)
    .sort((a, b) => distances[b] - distances[a]);
  const labelled = new Uint8Array(rows * columns);
  const labels = [];
  for (const i of order) {
    if (labelled[i] === 0) {
      const [row, column] = [Math.floor(i / columns), i % columns];
      labels.push({ x: column / (columns - 1), y: row / (rows - 1), value: cells[row][column] });
      fillArea(cells, i, labelled);
    }
  }
  return labels;
}

/**
 * How far each cell is from one of another value and from the frame, along the axes of the map.
 * @param {ArrayLike<number>[]} cells
 * @param {{x: number, y: number}} step between two cells
 */
function distancesToBorders(cells, step) {
  const [rows, columns] = [cells.length, cells[0].length];
  const distances = new Float64Array(rows * columns);
  const shorten = (
    /** @type {number} */ row,
    /** @type {number} */ column,
    /** @type {-1 | 1} */ way,
  ) => {
    const value = cells[row][column];
    const beside = (
      /** @type {number} */ r,
      /** @type {number} */ c,
      /** @type {number} */ length,
    ) => (cells[r]?.[c] === value ? distances[r * columns + c] + length : 0);
    return Math.min(beside(row, column + way, step.x), beside(row + way, column, step.y));
  };
  for (let i = 0; i < distances.length; i += 1) {
    distances[i] = shorten(Math.floor(i / columns), i % columns, -1);
  }
  for (let i = distances.length - 1; i >= 0; i -= 1) {
    distances[i] = Math.min(distances[i], shorten(Math.floor(i / columns), i % columns, 1));
  }
  return distances;
}

/**
 * @param {Float64Array} distances
 * @param {number} columns
 * @param {{x: number, y: number}} step
 * @param {{x: number, y: number}} place
 */
function keepFree(distances, columns, step, place) {
  for (const i of distances.keys()) {
    const away = Math.hypot(
      (i % columns) * step.x - place.x,
      Math.floor(i / columns) * step.y - place.y,
    );
    // Half of it is the other's.
    distances[i] = Math.min(distances[i], away / 2);
  }
}

/**
 * Notes all cells of one value around one of them.
 * @param {ArrayLike<number>[]} cells
 * @param {number} start
 * @param {Uint8Array} noted
 */
function fillArea(cells, start, noted) {
  const columns = cells[0].length;
  const valueAt = (/** @type {number} */ i) => cells[Math.floor(i / columns)]?.[i % columns];
  const value = valueAt(start);
  const open = [start];
  noted[start] = 1;
  for (let i = open.pop(); i !== undefined; i = open.pop()) {
    const column = i % columns;
    const beside = [
      ...(column > 0 ? [i - 1] : []),
      ...(column < columns - 1 ? [i + 1] : []),
      i - columns,
      i + columns,
    ];
    for (const next of beside) {
      if (noted[next] === 0 && valueAt(next) === value) {
        noted[next] = 1;
        open.push(next);
      }
    }
  }
}
