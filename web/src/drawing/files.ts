// Pictures as files.
import { type Drawn, stacked } from './plot';
import { readTheme, type Theme } from './theme';

/** What can leave the page: as SVG or as PNG; as PNG only. */
export type Picture = { svg(): SVGSVGElement } | { canvas(): HTMLCanvasElement };

const WIDTH = 480; // the least that leaves the page

/** A chart as a picture with a title: as it stands in an element, but not too narrow, and on a ground of its own. */
export function pictureOf(host: HTMLElement, title: string, draw: (width: number, theme: Theme) => Drawn[]): Picture {
  return {
    svg() {
      const theme = readTheme(host);
      return stacked(draw(Math.max(WIDTH, host.clientWidth), theme), title, theme.background);
    },
  };
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
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the picture could not be written'))));
  });
}

async function canvasOf(svg: SVGSVGElement): Promise<HTMLCanvasElement> {
  const address = URL.createObjectURL(new Blob([textOf(svg)], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode().catch(() => {
      throw new Error('the picture could not be drawn');
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
