// @ts-check

import { say } from "../../../format/words.js";
import { brief, significant } from "../../../format/number.js";
import { find } from "../../../widgets/find.js";
import { write, writeAttribute } from "../../../widgets/write.js";
import { cameraAt, closenessAt, timeOf } from "./clock.js";
import { contactScene } from "./contact-drawing.js";
import { angleOf } from "./motions.js";
import { marksOf } from "./marks.js";

/**
 * @typedef {object} Shown
 * @property {import("./course.js").Course} course
 * @property {(import("./contact-motion.js").Motion | null)[]} contacts null for one that is not drawn
 * @property {boolean} isWall
 * @property {ReturnType<typeof import("./clock.js").phaseAt>} phase
 * @property {import("./course.js").Size} size
 */

/** Degrees to these digits fit beside an arc. */
const ANGLE_DIGITS = 3;

let views = 0;

/**
 * One look at the bounce: the flight, and the contact that the camera goes into.
 * @param {SVGSVGElement} picture that it becomes a part of
 * @param {DocumentFragment} template
 */
export function mountView(picture, template) {
  picture.append(template.cloneNode(true));
  const view = /** @type {SVGSVGElement} */ (picture.lastElementChild);
  const part = (/** @type {string} */ name) => find(`.${name}`, view);
  const [flight, bodies, path, ghosts, ball, other, wall, marks, contact] = [
    ...["flight", "bodies", "flight-path", "ghosts", "ball", "other", "wall", "marks", "contact"],
  ].map(part);
  const contactPart = contactParts(part);
  const arounds = [part("bodies .around"), marks];
  const body = part("body");
  views += 1;
  bodies.id = `bodies-${views}`;
  body.id = `body-${views}`;
  writeAttribute(other, "href", `#${bodies.id}`);

  let isCourseDrawn = false;

  /** What does not change while the clock goes. @param {Shown} shown */
  function drawCourse({ course, isWall, size }) {
    isCourseDrawn = true;
    const { radius, ground, touches } = course;
    writeAttribute(path, "d", course.path);
    fill(ghosts, course.ghosts, "use", (element, ghost) => {
      writeAttribute(element, "href", `#${body.id}`);
      writeAttribute(element, "transform", standing(ghost, radius));
    });
    wall.toggleAttribute("hidden", !isWall);
    place(wall, { x: -9 * size.width, y: ground, width: 19 * size.width, height: 9 * size.height });
    other.toggleAttribute("hidden", isWall);
    writeAttribute(other, "transform", `rotate(180,${touches[0]},${ground})`);
    drawMarks(course);
  }

  /** @param {import("./course.js").Course} course */
  function drawMarks(course) {
    const drawn = marksOf(course).map(({ lines, label }, i) => ({
      lines,
      label: { ...label, text: degreesOf(course.marked[i].motion) },
    }));
    fill(marks, drawn, "g", (group, { lines, label }) => {
      fill(group, [...lines, label], (item) => ("path" in item ? "path" : "text"), drawMark);
    });
  }

  /** Where the clock stands. @param {Shown} shown */
  function drawInstant(shown) {
    const { course, contacts, isWall, phase, size } = shown;
    const times = contacts.length;
    const { closeness, touch, isEnd } = closenessAt(phase, times);
    const motion = contacts[touch];
    const scene =
      motion &&
      contactScene(motion, phase.kind === "contact" ? phase.progress : Number(isEnd), size, isWall);
    const close = scene && { x: scene.anchor.x, y: scene.ground, radius: scene.radius };
    const camera = close ? cameraAt(course, touch, close, closeness) : STILL;
    show(flight, camera.contact < 1 ? 1 : 0);
    show(contact, camera.contact);
    if (camera.contact < 1) {
      if (!isCourseDrawn) {
        drawCourse(shown);
      }
      const isFlying = phase.kind === "flight";
      const at = course.at(phase.index, isFlying ? timeOf(phase.progress, phase.index, times) : 1);
      writeAttribute(ball, "transform", standing(at, course.radius));
      writeAttribute(flight, "transform", camera.transform);
      arounds.forEach((around) => show(around, camera.around));
    }
    if (scene && camera.contact > 0) {
      contactPart.draw(scene, size);
    }
  }

  return {
    element: view,
    drawInstant,

    /** All of it; of a flight that the contact hides only once it shows. @param {Shown} shown */
    draw(shown) {
      isCourseDrawn = false;
      drawInstant(shown);
    },

    /** Its place in the whole picture. @param {number} x @param {import("./course.js").Size} size */
    lay(x, { width, height }) {
      place(view, { x, y: 0, width, height });
      writeAttribute(view, "viewBox", `0 0 ${width} ${height}`);
    },
  };
}

/**
 * @param {Element} element
 * @param {{name: string, path: string} | {text: string, x: number, y: number, isLeft: boolean}} mark
 */
function drawMark(element, mark) {
  if ("path" in mark) {
    writeAttribute(element, "class", `mark-${mark.name}`);
    writeAttribute(element, "d", mark.path);
  } else {
    writeAttribute(element, "class", "mark-angle");
    writeAttribute(element, "text-anchor", mark.isLeft ? "end" : "start");
    place(element, { x: mark.x, y: mark.y + 4 });
    write(element, mark.text);
  }
}

/** @param {import("./motions.js").Motion} motion */
function degreesOf(motion) {
  return `${significant(Math.abs(angleOf(motion)), ANGLE_DIGITS)}°`;
}

/** About as wide is a letter of the words in the contact, in pixels. */
const LETTER = 6.2;

const STILL = { transform: "", contact: 0, around: 1 };

/** @param {(name: string) => HTMLElement} part */
function contactParts(part) {
  const own = (/** @type {string} */ name) => part(`contact-${name}`);
  const [ball, spring, shoe, wall, other, trackGroup, anchor, teeth, chip, word, enlarged] = [
    ...["ball", "spring", "shoe", "wall", "other", "tracks", "anchor", "teeth", "chip", "word"],
    "enlarged",
  ].map(own);
  const group = part("contact");
  const arrows = { normal: own("normal"), tangential: own("tangential") };
  const labels = { normal: own("normal-label"), tangential: own("tangential-label") };

  return {
    /**
     * @param {ReturnType<typeof contactScene>} scene
     * @param {import("./course.js").Size} size
     */
    draw(scene, size) {
      const { x, y, width } = scene.shoe;
      group.dataset.regime = scene.regime;
      writeAttribute(ball, "d", scene.ball);
      wall.toggleAttribute("hidden", scene.other !== "");
      writeAttribute(wall, "y", String(scene.ground));
      writeAttribute(other, "d", scene.other);
      writeAttribute(spring, "d", scene.spring);
      place(anchor, { cx: scene.anchor.x, cy: scene.anchor.y });
      place(shoe, { x: x - width / 2, y });
      writeAttribute(teeth, "transform", `translate(${x.toFixed(2)},${scene.ground})`);
      const { normalArrow, tangentialArrow } = scene;
      writeAttribute(arrows.normal, "d", normalArrow.path);
      writeAttribute(arrows.tangential, "d", tangentialArrow.path);
      labels.normal.toggleAttribute("hidden", normalArrow.path === "");
      labels.tangential.toggleAttribute("hidden", tangentialArrow.path === "");
      // Each on its own side, so that they are apart where the forces are small.
      const isLeft = scene.tangentialForce < 0;
      place(labels.normal, { x: normalArrow.tip.x + (isLeft ? 8 : -20), y: normalArrow.tip.y + 6 });
      place(labels.tangential, {
        x: tangentialArrow.tip.x + (isLeft ? -34 : 7),
        y: tangentialArrow.tip.y + 4,
      });
      fill(trackGroup, scene.tracks, "line", (line, { regime, from, to, y: depth }) => {
        writeAttribute(line, "class", regime);
        place(line, { x1: from, x2: to, y1: depth, y2: depth });
      });
      const regime = say(REGIME_KEYS[scene.regime]);
      const drawn =
        scene.enlarged > 1.5 && scene.enlarged < 1e6
          ? say("bounce.stretchDrawn", { factor: brief(Number(scene.enlarged.toPrecision(1))) })
          : "";
      write(word, regime);
      write(enlarged, drawn);
      const chipWidth = Math.max(100, 16 + LETTER * regime.length);
      place(chip, { y: size.height - 28, width: chipWidth });
      place(word, { x: 8 + chipWidth / 2, y: size.height - 14 });
      const isBeside = chipWidth + LETTER * drawn.length + 26 <= size.width;
      writeAttribute(enlarged, "text-anchor", isBeside ? "end" : "middle");
      place(enlarged, {
        x: isBeside ? size.width - 10 : size.width / 2,
        y: isBeside ? size.height - 10 : 11,
      });
    },
  };
}

/** What a regime is called. */
export const REGIME_KEYS = {
  forward: "regimes.forward",
  backward: "bounce.slidesBack",
  sticking: "regimes.sticks",
};

/**
 * As many elements as there are items, each drawn by its own.
 * @template Item
 * @param {Element} group
 * @param {Item[]} items
 * @param {string | ((item: Item) => string)} name of the elements
 * @param {(element: Element, item: Item, i: number) => void} draw
 */
function fill(group, items, name, draw) {
  const elements = [...group.children];
  elements.slice(items.length).forEach((element) => element.remove());
  for (const [i, item] of items.entries()) {
    const own = typeof name === "string" ? name : name(item);
    draw(
      elements[i] ?? group.appendChild(document.createElementNS(group.namespaceURI, own)),
      item,
      i,
    );
  }
}

/** @param {import("./course.js").Place} place @param {number} radius */
function standing({ x, y, turn }, radius) {
  return `translate(${x.toFixed(2)},${y.toFixed(2)})rotate(${turn.toFixed(1)})scale(${radius.toFixed(2)})`;
}

/** @param {HTMLElement} element @param {number} opacity */
function show(element, opacity) {
  element.toggleAttribute("hidden", opacity === 0);
  writeAttribute(element, "opacity", opacity.toFixed(3));
}

/**
 * @param {Element} element
 * @param {Record<string, number>} attributes
 */
function place(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    writeAttribute(element, name, value.toFixed(2));
  }
}
