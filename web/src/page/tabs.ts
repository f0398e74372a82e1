// The two ways in, a real ball and all numbers: links, which without another window change only what is shown.
import { find } from '../drawing/dom';
import { type Inputs, type View, firstBall, isBall } from '../inputs/inputs';
import { withoutSi } from '../inputs/units';

const tabs = { ball: find('to-ball', HTMLAnchorElement), full: find('to-full', HTMLAnchorElement) };

/** Show what belongs to a view. */
export function showView(view: View): void {
  document.body.dataset.view = view;
  tabs.ball.ariaCurrent = view === 'ball' ? 'page' : null;
  tabs.full.ariaCurrent = view === 'ball' ? null : 'page';
  find('skip', HTMLAnchorElement).hash = view === 'ball' ? 'prediction' : 'reading';
}

/** Wire the links of index.html; `take` gets the inputs of the other view: the same impact, where it has such. */
export function createTabs(now: () => Inputs, take: (next: Inputs) => void): void {
  let ball = firstBall; // the last one that was shown
  const wire = (tab: HTMLAnchorElement, other: (inputs: Inputs) => Inputs): void =>
    tab.addEventListener('click', (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      const inputs = now();
      if (tab.ariaCurrent) return;
      if (inputs.view === 'ball') ball = inputs;
      take({ ...other(inputs), kept: inputs.kept });
    });
  wire(tabs.ball, (inputs) => (isBall(inputs.encounter) ? { ...inputs, view: 'ball' } : ball));
  wire(tabs.full, (inputs) => ({ ...withoutSi(inputs), view: 'full' }));
}
