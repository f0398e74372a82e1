// Lines to copy and files to download.
import type { Curve } from '../charts/curve_picture';
import type { Core, Encounter } from '../core/protocol';
import { find, messageOf } from '../drawing/dom';
import { type Picture, download, pngOf, textOf } from '../drawing/pictures';
import { say } from '../drawing/words';
import { toAddress } from '../inputs/address';
import { type Inputs, defaults } from '../inputs/inputs';
import { commandLine, curveCsv, pythonLines, ruleArguments } from '../inputs/lines';
import { endsOf } from '../inputs/units';

/** Maximum error of ε that the C header may have. */
const headerError = 1e-3;

/** Wire the buttons of index.html; `pictures` by the values of the select. The result shows the lines of inputs. */
export function createShare(
  core: Core, curveOf: (encounter: Encounter) => Curve, pictures: Readonly<Record<string, Picture>>,
): (inputs: Inputs) => void {
  let inputs = defaults;
  const line = find('command-line', HTMLElement);
  const python = find('python-lines', HTMLElement);
  const done = find('done', HTMLElement);
  const tell = (text: string): void => void (done.textContent = text);

  const on = (id: string, act: () => Promise<string> | string): void =>
    find(id, HTMLButtonElement).addEventListener('click', async () => {
      try {
        tell(await act());
      } catch (error) {
        tell(messageOf(error));
      }
    });

  on('copy-command', () => copy(line, say('share.command_copied')));
  on('copy-python', () => copy(python, say('share.python_copied')));
  on('copy-link', async () => {
    await navigator.clipboard.writeText(new URL(`?${toAddress(inputs)}`, location.href).href);
    return say('share.link_copied');
  });
  on('download-csv', () => {
    const { encounter, points, planned } = curveOf(inputs.encounter);
    if (points.length === 0) return say('share.no_point');
    download('stoss-restitution.csv', curveCsv(encounter, points), 'text/csv');
    return points.length < planned.length ? say('share.csv_part', { count: points.length }) : say('share.csv_done');
  });
  on('download-header', async () => {
    const button = find('download-header', HTMLButtonElement);
    const { encounter } = inputs;
    button.disabled = true;
    tell(say('share.header_computing'));
    try {
      const [slowest, fastest] = endsOf(encounter);
      const text = await core('header', encounter, { slowest, fastest, error: headerError });
      download('restitution.h', text, 'text/x-c');
      return say('share.header_done', { error: headerError });
    } finally {
      button.disabled = false;
    }
  });
  const picture = find('picture', HTMLSelectElement);
  const chosen = (): [string, Picture] => [picture.value, pictures[picture.value]!];
  on('download-png', async () => {
    const [name, its] = chosen();
    download(`stoss-${name}.png`, await pngOf(its));
    return say('share.png_done');
  });
  on('download-svg', () => {
    const [name, its] = chosen();
    if (!('svg' in its)) throw new Error(say('share.png_only'));
    download(`stoss-${name}.svg`, textOf(its.svg()), 'image/svg+xml');
    return say('share.svg_done');
  });
  picture.onchange = () => (find('download-svg', HTMLButtonElement).disabled = !('svg' in chosen()[1]));

  return (next) => {
    inputs = next;
    line.textContent = commandLine(ruleArguments(inputs));
    python.textContent = pythonLines(inputs).trimEnd();
  };
}

/** Copy the text of an element; where the page may not, select it, so that the user can. */
async function copy(element: HTMLElement, success: string): Promise<string> {
  try {
    await navigator.clipboard.writeText(element.textContent ?? '');
    return success;
  } catch {
    getSelection()?.selectAllChildren(element);
    return say('share.selected');
  }
}
