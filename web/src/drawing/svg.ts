// A writer of SVG: pictures that are downloaded, and those that stand on the page.

type Attributes = Record<string, string | number | undefined>;

const SPECIAL: Record<string, string> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };

/** Text as it may stand in a document. */
export function escaped(text: string): string {
  return text.replace(/[&<>"]/g, (each) => SPECIAL[each]!);
}

function number(value: number): string {
  return String(Math.round(value * 100) / 100);
}

/** One element; children are elements already written. */
export function element(name: string, attributes: Attributes, ...children: string[]): string {
  const written = Object.entries(attributes)
    .filter(([, value]) => value !== undefined)
    .map(([key, value]) => ` ${key}="${typeof value === 'number' ? number(value) : escaped(String(value))}"`)
    .join('');
  return children.length ? `<${name}${written}>${children.join('')}</${name}>` : `<${name}${written}/>`;
}

/** A text element. */
export function text(x: number, y: number, words: string, attributes: Attributes = {}): string {
  return element('text', { x, y, ...attributes }, escaped(words));
}

/** A straight line. */
export function line(x1: number, y1: number, x2: number, y2: number, attributes: Attributes): string {
  return element('line', { x1, y1, x2, y2, ...attributes });
}

/** The data of a path through points, in pieces where a coordinate is not finite. */
export function pathThrough(x: ArrayLike<number>, y: ArrayLike<number>): string {
  let data = '';
  let drawn = false;
  for (let k = 0; k < x.length; ++k) {
    const there = Number.isFinite(x[k]) && Number.isFinite(y[k]);
    if (there) data += `${drawn ? 'L' : 'M'}${number(x[k]!)} ${number(y[k]!)}`;
    drawn = there;
  }
  return data;
}

/** A whole document of some size in pixels, with a title for those who do not see it. */
export function svgDocument(width: number, height: number, title: string, background: string, body: string): string {
  return element(
    'svg',
    {
      xmlns: 'http://www.w3.org/2000/svg', width, height, viewBox: `0 0 ${number(width)} ${number(height)}`,
      'font-family': 'system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif', 'font-size': 12,
      role: 'img', 'aria-label': title,
    },
    element('title', {}, escaped(title)),
    background === 'none' ? '' : element('rect', { width, height, fill: background }),
    body,
  );
}

/** The same picture as a PNG, `scale` pixels for each of its own. */
export async function pngOf(svg: string, scale = 2): Promise<Blob> {
  const address = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    await new Promise((resolve, reject) => {
      image.onload = resolve;
      image.onerror = () => reject(new Error('the picture could not be drawn'));
      image.src = address;
    });
    const canvas = document.createElement('canvas');
    canvas.width = Math.round(image.width * scale);
    canvas.height = Math.round(image.height * scale);
    canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await pngOfCanvas(canvas);
  } finally {
    URL.revokeObjectURL(address);
  }
}

/** A canvas as a PNG. */
export function pngOfCanvas(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the picture could not be written'))));
  });
}
