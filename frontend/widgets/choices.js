// @ts-check

/**
 * Fills a fieldset with one button for each of several choices.
 * @param {HTMLElement} fieldset
 * @param {string} name
 * @param {{id: string, title: string}[]} items
 */
export function choices(fieldset, name, items) {
  fieldset.append(
    ...items.map(({ id, title }) => {
      const label = document.createElement("label");
      const input = document.createElement("input");
      const text = document.createElement("span");
      Object.assign(input, { type: "radio", name, value: id });
      text.textContent = title;
      label.append(input, text);
      return label;
    }),
  );
}
