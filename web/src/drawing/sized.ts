// Pictures follow the size of the element they stand in, and the reader's theme.

/** Calls back whenever the width of an element or the theme changes, once a frame; returns what asks for it too. */
export function onResize(host: HTMLElement, callback: () => void): () => void {
  let asked = 0;
  let width = -1;
  const ask = (): void => {
    cancelAnimationFrame(asked);
    asked = requestAnimationFrame(callback);
  };
  new ResizeObserver(() => {
    if (host.clientWidth === width) return; // a picture that sets its own height must not ask for itself again
    width = host.clientWidth;
    ask();
  }).observe(host);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', ask);
  return ask;
}

/** Gives a canvas a size in CSS pixels and as many of the device's as that is; returns the latter for one. */
export function fitCanvas(canvas: HTMLCanvasElement, width: number, height: number): number {
  const density = Math.min(3, window.devicePixelRatio || 1);
  const wide = Math.max(1, Math.round(width * density));
  const high = Math.max(1, Math.round(height * density));
  if (canvas.width !== wide) canvas.width = wide;
  if (canvas.height !== high) canvas.height = high;
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  return density;
}
