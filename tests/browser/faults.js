// What is wrong with the boxes of the page as it stands: [] where nothing is.
() => {
  const faults = [];
  const round = ({ left, top, right, bottom }) =>
    [left, top, right, bottom].map((side) => Math.round(10 * side) / 10).join(" ");
  const name = (element) => {
    const near = element.closest("[data-testid], [id], [data-panel]");
    const { tagName, className } = element;
    const own = `${tagName.toLowerCase()}${typeof className === "string" && className ? `.${className.split(" ")[0]}` : ""}`;
    const place = near?.dataset.testid ?? (near?.id || near?.dataset.panel) ?? "";
    return `${place} ${own} “${(element.textContent || element.value || "").trim().slice(0, 24)}”`;
  };
  const say = (what, one, box, other, otherBox) =>
    faults.push(
      [
        what,
        name(one),
        `[${round(box)}]`,
        ...(other ? [name(other), `[${round(otherBox)}]`] : []),
      ].join(" "),
    );
  const seen = (element) =>
    element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) &&
    !element.closest(".unseen, .skip, [popover]:not(:popover-open), option, noscript");
  // Boxes that measure themselves, or lie over the page by their nature.
  const isLaidOver = (element) =>
    element.closest(
      ".crosshair, .cut-mark, .time-cursor, .place-mark, .reason, .bounce-stage svg, .bounce-ribbon",
    );

  const width = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth > width) {
    faults.push(`wider than the window: ${document.documentElement.scrollWidth}`);
  }

  // What is scrolled out of a wide table's frame is not seen.
  const inFrame = (element, { left, top, right, bottom }) => {
    const frame = element
      .closest(".table-frame, .compare-frame, .reading")
      ?.getBoundingClientRect();
    return {
      left: Math.max(left, frame?.left ?? left),
      right: Math.min(right, frame?.right ?? right),
      top,
      bottom,
    };
  };

  // Lines of text, as high as their letters.
  const lines = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const parent = node.parentElement;
    if (!node.data.trim() || parent.closest("script, style, svg, select") || !seen(parent)) {
      continue;
    }
    const range = document.createRange();
    range.selectNodeContents(node);
    for (const { left, top, right, bottom } of range.getClientRects()) {
      if (right - left < 1) {
        continue;
      }
      const box = inFrame(parent, {
        left,
        right,
        top: top + 0.2 * (bottom - top),
        bottom: bottom - 0.2 * (bottom - top),
      });
      if (box.right - box.left < 1) {
        continue;
      }
      lines.push({ element: parent, box });
      if (box.left < -0.5 || box.right > width + 0.5) {
        say("outside of the window", parent, box);
      }
    }
  }
  const controls = [
    ...document.querySelectorAll("a, button, input, select, summary, [role=slider]"),
  ]
    .filter(seen)
    .map((element) => {
      // The words beside a box to tick are part of the target.
      const target = element.matches("[type=checkbox]") ? element.closest("label") : null;
      const whole = (target ?? element).getBoundingClientRect();
      return { element, whole, box: inFrame(element, whole) };
    })
    .filter(({ whole }) => whole.width > 0);

  const meet = (a, b, by = 1) =>
    Math.min(a.right, b.right) - Math.max(a.left, b.left) > by &&
    Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > by;
  const all = [...lines, ...controls].filter(({ element }) => !isLaidOver(element));
  all.forEach(({ element, box }, i) => {
    for (const { element: other, box: otherBox } of all.slice(i + 1)) {
      if (!meet(box, otherBox) || element.contains(other) || other.contains(element)) {
        continue;
      }
      // A radio lies over the whole of its own label.
      const label = other.closest("label") ?? element.closest("label");
      if (!(label?.contains(element) && label.contains(other))) {
        say("overlap:", element, box, other, otherBox);
      }
    }
  });

  const ONE_LINE = [
    "button, .scenes a, .segmented span, .figures > :not(.energy-lost) dt, .figures dd, .epsilon-label, .epsilon-value, .legend li, .gauge-ends span, .parameter-ticks span, .chip, .legend-tick, .accuracy-scale, .menu a, .impact-result dd, .material label",
    // Other languages have names of parameters that take two.
    ...(document.documentElement.lang === "en" ? [".parameter-head label"] : []),
  ].join(", ");
  for (const element of document.querySelectorAll(ONE_LINE)) {
    const style = getComputedStyle(element);
    const { paddingTop, paddingBottom, lineHeight, fontSize } = style;
    const line = Number.parseFloat(lineHeight) || 1.4 * Number.parseFloat(fontSize);
    const least = Number.parseFloat(style.minHeight) || 0;
    const most =
      Math.max(
        least,
        1.6 * line + Number.parseFloat(paddingTop) + Number.parseFloat(paddingBottom),
      ) + 4;
    const box = element.getBoundingClientRect();
    if (seen(element) && box.height > most) {
      say("in more than one line:", element, box);
    }
  }

  // What a style sheet writes beside a text, as the sign beside ε_t, has no box to be asked for.
  for (const element of document.querySelectorAll("body *")) {
    const written = ["::before", "::after"].some((part) =>
      /^".*\\S/.test(getComputedStyle(element, part).content),
    );
    if (written && seen(element) && element.scrollWidth > element.clientWidth + 1) {
      say("more than its own width:", element, element.getBoundingClientRect());
    }
  }

  // Panels stand beside or below each other, and end after what is in them.
  const panels = [...document.querySelectorAll("[data-panel]")]
    .filter(seen)
    .map((element) => ({ element, box: element.getBoundingClientRect() }));
  panels.forEach(({ element, box }, i) => {
    for (const { element: other, box: otherBox } of panels.slice(i + 1)) {
      if (meet(box, otherBox) && !element.contains(other)) {
        say("overlap:", element, box, other, otherBox);
      }
    }
    const ends = [...element.querySelectorAll(".plot")]
      .filter(seen)
      .map((plot) => plot.getBoundingClientRect().bottom);
    if (Math.max(...ends, box.top) > box.bottom + 1) {
      say("ends before its picture:", element, box);
    }
  });

  // Choices of a picture are all beside its title or all below it.
  for (const group of document.querySelectorAll(".choices")) {
    const title = group.parentElement.querySelector("h2").getBoundingClientRect();
    const tops = [...group.children].filter(seen).map((child) => child.getBoundingClientRect().top);
    if (Math.min(...tops) < title.bottom && Math.max(...tops) > title.bottom) {
      say("in part beside the title:", group, group.getBoundingClientRect());
    }
  }

  for (const { element, whole: box } of controls) {
    if (
      element.matches("input:not([type=range]), select") &&
      !element.matches("[type=radio], [type=checkbox]")
    ) {
      const style = getComputedStyle(element);
      const pen = new OffscreenCanvas(1, 1).getContext("2d");
      pen.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
      pen.letterSpacing = style.letterSpacing === "normal" ? "0px" : style.letterSpacing;
      const text = element.matches("select")
        ? (element.selectedOptions[0]?.textContent ?? "")
        : element.value;
      const sides = ["paddingLeft", "paddingRight", "borderLeftWidth", "borderRightWidth"];
      // The arrow of a select takes 16 pixels.
      const room =
        box.width -
        sides.reduce((sum, side) => sum + Number.parseFloat(style[side]), 0) -
        (element.matches("select") ? 16 : 0);
      if (pen.measureText(text).width > room + 0.5) {
        say(
          `cut off (${pen.measureText(text).width.toFixed(1)} in ${room.toFixed(1)}):`,
          element,
          box,
        );
      }
    }
    // In a sentence a link is as high as the line.
    const inSentence =
      element.matches("p a, li a, dd a, figcaption a") && !element.matches(".scenes a, .menu a");
    if (!inSentence && !isLaidOver(element) && Math.min(box.width, box.height) < 23.99) {
      say("smaller than 24 pixels:", element, box);
    }
  }
  for (const element of document.querySelectorAll("body *")) {
    const clips = ["hidden", "clip"].includes(getComputedStyle(element).overflowX);
    if (
      clips &&
      seen(element) &&
      !isLaidOver(element) &&
      !element.closest("svg, .plot, input") &&
      element.scrollWidth > element.clientWidth + 1
    ) {
      say(
        `cut off (${element.scrollWidth} in ${element.clientWidth}):`,
        element,
        element.getBoundingClientRect(),
      );
    }
  }

  // A text of a picture without its line's room above and below the letters, upright or turned.
  const letters = (element) => {
    const { left, right, top, bottom } = element.getBoundingClientRect();
    const room = 0.2 * Number.parseFloat(getComputedStyle(element).fontSize);
    const isTurned = /rotate\(-?90/.test(element.getAttribute("transform") ?? "");
    const [x, y] = isTurned ? [room, 0] : [0, room];
    return { left: left + x, right: right - x, top: top + y, bottom: bottom - y };
  };
  for (const plot of document.querySelectorAll(".plot")) {
    if (!seen(plot)) {
      continue;
    }
    const frame = plot.getBoundingClientRect();
    const words = [...plot.querySelectorAll("text")]
      .filter((text) => text.textContent.trim() && seen(text))
      .map((element) => ({ element, box: letters(element) }))
      .filter(({ box }) => box.right > box.left);
    words.forEach(({ element, box }, i) => {
      // Of what a plot does not show.
      if (box.left > frame.right || box.right < frame.left) {
        return;
      }
      if (
        box.left < frame.left - 0.5 ||
        box.right > frame.right + 0.5 ||
        box.top < frame.top - 0.5 ||
        box.bottom > frame.bottom + 0.5
      ) {
        say("cut off:", element, box, plot, frame);
      }
      for (const { element: other, box: otherBox } of words.slice(i + 1)) {
        // Plotly at times sets the sign of a bar beside its middle by the sign's own width.
        const isSign = element.closest(".barlayer") && /^[→←]$/.test(element.textContent);
        if (!isSign && meet(box, otherBox, 0.5)) {
          say("overlap:", element, box, other, otherBox);
        }
      }
    });
  }
  return faults;
};
