// @ts-check

/** Whether nothing is to move by itself. */
export const calm = matchMedia("(prefers-reduced-motion: reduce)");
