// Drawing on a canvas, in CSS pixels.
/** Gives a canvas a size in CSS pixels and as many of the device's as that is, at least `least` for one; returns how
 *  many that are. */
export function fitCanvas(canvas: HTMLCanvasElement, width: number, height: number, least = 1): number {
  const density = Math.min(3, Math.max(least, window.devicePixelRatio));
  const wide = Math.max(1, Math.round(width * density));
  const high = Math.max(1, Math.round(height * density));
  if (canvas.width !== wide) canvas.width = wide;
  if (canvas.height !== high) canvas.height = high;
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  return density;
}

/** A canvas of so many pixels of the device for one, with nothing on it but its ground. */
export function cleared(
  canvas: HTMLCanvasElement, density: number, width: number, height: number, ground: string,
): CanvasRenderingContext2D {
  const context = canvas.getContext('2d')!;
  context.setTransform(density, 0, 0, density, 0, 0);
  box(context, ground, 0, 0, width, height);
  return context;
}

export function box(
  context: CanvasRenderingContext2D, color: string, x: number, y: number, width: number, height: number,
): void {
  context.fillStyle = color;
  context.fillRect(x, y, width, height);
}

export function write(
  context: CanvasRenderingContext2D, words: string, x: number, y: number, color: string,
  align: CanvasTextAlign = 'left', size = 13,
): void {
  context.font = `${size}px system-ui, sans-serif`;
  context.textAlign = align;
  context.fillStyle = color;
  context.fillText(words, x, y);
}

/** A line through some places. */
export function trace(
  context: CanvasRenderingContext2D, way: readonly (readonly [x: number, y: number])[], color: string, width = 1.6,
  dash: number[] = [],
): void {
  context.beginPath();
  way.forEach(([x, y], k) => (k === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
  context.setLineDash(dash);
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
  context.setLineDash([]);
}
