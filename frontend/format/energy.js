// @ts-check

/**
 * The share of the tangential energy that is lost; of none, nothing. The energies themselves may
 * be beyond the numbers of the page.
 * @param {{limit: boolean, energy: {dissipated_share: number}}} result
 */
export function lostShare({ limit, energy }) {
  return limit ? 0 : energy.dissipated_share;
}
