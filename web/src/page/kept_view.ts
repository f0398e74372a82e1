// The curves kept for comparison, each with a button that lets it go.
import { html, render } from 'lit-html';
import type { Encounter } from '../core/protocol';
import { find } from '../drawing/dom';
import { say } from '../drawing/words';
import { description } from '../inputs/lines';
import { equal } from '../inputs/document';
import { mostKept, type Inputs } from '../inputs/inputs';

const button = find('keep', HTMLButtonElement);
const list = find('kept', HTMLUListElement);

/** Show those of inputs; `change` gets another selection. */
export function showKept({ kept, encounter }: Inputs, change: (kept: readonly Encounter[]) => void): void {
  const there = kept.some((other) => equal(other, encounter));
  const drop = (other: Encounter): void => {
    change(kept.filter((item) => item !== other));
    button.focus();
  };
  button.disabled = there || kept.length >= mostKept;
  button.title = there ? say('kept.already') : kept.length >= mostKept ? say('kept.most', { most: mostKept }) : '';
  button.onclick = () => change([...kept, encounter]);
  list.hidden = kept.length === 0;
  render(kept.map(description).map((name, k) => html`<li>${name}<button type="button" title=${say('kept.drop')}
    aria-label=${say('kept.drop_one', { name })} @click=${() => drop(kept[k]!)}>×</button></li>`), list);
}
