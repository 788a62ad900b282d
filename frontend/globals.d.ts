/** What this page uses of plotly.js, which the server hands out as a classic script. */
declare const Plotly: {
  react(
    element: HTMLElement,
    data: Record<string, any>[],
    layout: Record<string, any>,
    config: Record<string, any>,
  ): Promise<void>;
  toImage(
    figure: Record<string, any>,
    options: { format: "svg"; width: number; height: number; imageDataOnly: boolean },
  ): Promise<string>;
  purge(element: HTMLElement): void;
};
