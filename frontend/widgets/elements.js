// @ts-check

import { typeset } from "./typeset.js";

/**
 * An element that this page makes.
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name
 * @param {string} className
 * @param {(Node | string)[]} content
 * @returns {HTMLElementTagNameMap[Name]}
 */
export function make(name, className, ...content) {
  const element = document.createElement(name);
  element.className = className;
  element.append(...content);
  return element;
}

/**
 * One that holds a text with its symbols set.
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name
 * @param {string} className
 * @param {string} text
 * @returns {HTMLElementTagNameMap[Name]}
 */
export function told(name, className, text) {
  const element = make(name, className);
  typeset(element, text);
  return element;
}

/**
 * The same in a language of its own, as what the server says has one.
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {string} language
 * @param {Name} name
 * @param {string} text
 * @returns {HTMLElementTagNameMap[Name]}
 */
export function toldIn(language, name, text) {
  const element = told(name, "", text);
  markLanguage(element, language);
  return element;
}

/**
 * Says in which language an element is, where that is not the page's own.
 * @param {HTMLElement} element
 * @param {string} language empty for that of the page
 */
export function markLanguage(element, language) {
  setOrRemove(element, "lang", language);
}

/**
 * @param {Element} element
 * @param {string} name of its attribute
 * @param {string} value
 * @param {string} [usual] the value for which the attribute is not there
 */
export function setOrRemove(element, name, value, usual = "") {
  if (value === usual) {
    element.removeAttribute(name);
  } else {
    element.setAttribute(name, value);
  }
}
