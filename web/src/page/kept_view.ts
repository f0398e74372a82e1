// The curves kept for comparison, each with a button that lets it go.
import type { Encounter } from '../core/protocol';
import { description } from '../inputs/description';
import { equal, mostKept, type Inputs } from '../inputs/inputs';
import { find, make } from './dom';

/** Wire the button and the list; `change` gets the new selection. Returns what shows that of other inputs. */
export function createKeptView(change: (kept: readonly Encounter[]) => void): (inputs: Inputs) => void {
  const button = find('keep', HTMLButtonElement);
  const list = find('kept', HTMLUListElement);
  let inputs: Inputs | undefined;

  button.addEventListener('click', () => {
    if (inputs !== undefined) change([...inputs.kept, inputs.encounter]);
  });

  return (next) => {
    inputs = next;
    const { kept, encounter } = next;
    const there = kept.some((other) => equal(other, encounter));
    button.disabled = there || kept.length >= mostKept;
    button.title = there ? 'This curve is kept already' : kept.length >= mostKept ? `At most ${mostKept} are kept` : '';
    list.hidden = kept.length === 0;
    list.replaceChildren(...kept.map((other) => {
      const name = description(other);
      const drop = make('button', { type: 'button', 'aria-label': `Do not keep ${name}`, title: 'Do not keep' }, '×');
      drop.addEventListener('click', () => {
        change(kept.filter((item) => item !== other));
        button.focus();
      });
      return make('li', {}, name, drop);
    }));
  };
}
