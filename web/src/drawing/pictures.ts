// Pictures: charts as they stand on the page and leave it, and files.
import { onResize } from './dom';
import { hasPlot } from './library';
import { type Drawn, stacked } from './plot';
import { readTheme, type Theme } from './theme';
import { say } from './words';

/** What can leave the page: as SVG or as PNG; as PNG only. */
export type Picture = { svg(): SVGSVGElement } | { canvas(): HTMLCanvasElement };

const WIDTH = 480; // the least that leaves the page

/** A chart in an element. `draw` makes its parts, which stand below each other, for the page or for a picture that
 *  leaves it; none while there is nothing to show. `show` gets those for the page, and anew when its width or the theme
 *  changes. A picture is as wide, but not too narrow, and has a title and a ground of its own. */
export function chartIn(
  host: HTMLElement, title: string, draw: (width: number, theme: Theme, leaving: boolean) => Drawn[],
  show: (parts: Drawn[]) => void,
) {
  const update = (): void => {
    if (!hasPlot(update)) return;
    const parts = host.clientWidth ? draw(host.clientWidth, readTheme(host), false) : [];
    if (parts.length > 0) show(parts);
  };
  const svg = (): SVGSVGElement => {
    const theme = readTheme(host);
    const parts = hasPlot(update) ? draw(Math.max(WIDTH, host.clientWidth), theme, true) : [];
    if (parts.length === 0) throw new Error(say('share.nothing'));
    return stacked(parts, title, theme.background);
  };
  return { update, updateSoon: onResize(host, update), picture: { svg } };
}

const SCALE = 2; // pixels of a PNG for each of an SVG

/** An SVG as a document of its own. */
export function textOf(svg: SVGSVGElement): string {
  return new XMLSerializer().serializeToString(svg);
}

/** A picture as a PNG. */
export async function pngOf(picture: Picture): Promise<Blob> {
  const canvas = 'canvas' in picture ? picture.canvas() : await canvasOf(picture.svg());
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error(say('share.unwritten')))));
  });
}

async function canvasOf(svg: SVGSVGElement): Promise<HTMLCanvasElement> {
  const address = URL.createObjectURL(new Blob([textOf(svg)], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode().catch(() => {
      throw new Error(say('share.undrawn'));
    });
    const canvas = document.createElement('canvas');
    canvas.width = Math.round(image.width * SCALE);
    canvas.height = Math.round(image.height * SCALE);
    canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
    return canvas;
  } finally {
    URL.revokeObjectURL(address);
  }
}

/** Offer a file to the user. */
export function download(name: string, content: Blob | string, type = 'text/plain'): void {
  const blob = typeof content === 'string' ? new Blob([content], { type }) : content;
  const address = URL.createObjectURL(blob);
  Object.assign(document.createElement('a'), { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
