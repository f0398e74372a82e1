// Lines to copy and files to download.
import type { Curve } from '../charts/curve_picture';
import type { Core, Encounter } from '../core/protocol';
import { find, messageOf } from '../drawing/dom';
import { type Picture, download, pngOf, textOf } from '../drawing/pictures';
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
  const say = (text: string): void => void (done.textContent = text);

  const on = (id: string, act: () => Promise<string> | string): void =>
    find(id, HTMLButtonElement).addEventListener('click', async () => {
      try {
        say(await act());
      } catch (error) {
        say(messageOf(error));
      }
    });

  on('copy-command', () => copy(line, 'Command line copied.'));
  on('copy-python', () => copy(python, 'Python lines copied.'));
  on('copy-link', async () => {
    await navigator.clipboard.writeText(new URL(`?${toAddress(inputs)}`, location.href).href);
    return 'Link copied.';
  });
  on('download-csv', () => {
    const { encounter, points, planned } = curveOf(inputs.encounter);
    if (points.length === 0) return 'The curve has no point yet.';
    download('stoss-restitution.csv', curveCsv(encounter, points), 'text/csv');
    return points.length < planned.length ? `CSV with the ${points.length} points computed so far.` : 'CSV downloaded.';
  });
  on('download-header', async () => {
    const button = find('download-header', HTMLButtonElement);
    const { encounter } = inputs;
    button.disabled = true;
    say('Computing the table of the C header.');
    try {
      const [slowest, fastest] = endsOf(encounter);
      const text = await core('header', encounter, { slowest, fastest, error: headerError });
      download('restitution.h', text, 'text/x-c');
      return `C header downloaded: ε(v) to an error of ${headerError}.`;
    } finally {
      button.disabled = false;
    }
  });
  const picture = find('picture', HTMLSelectElement);
  const chosen = (): [string, Picture] => [picture.value, pictures[picture.value]!];
  on('download-png', async () => {
    const [name, its] = chosen();
    download(`stoss-${name}.png`, await pngOf(its));
    return 'PNG downloaded.';
  });
  on('download-svg', () => {
    const [name, its] = chosen();
    if (!('svg' in its)) throw new Error('This picture is there as PNG only.');
    download(`stoss-${name}.svg`, textOf(its.svg()), 'image/svg+xml');
    return 'SVG downloaded.';
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
    return 'The browser does not let pages copy here: the text is selected, copy it with Ctrl+C.';
  }
}
