// The page of the cradle: balls that hang in a row, or fall one on the other, as the core computes all their contacts.
import './drawing/pictures.css';
import { createRowCore } from './core/row_client';
import type { ModeEnergy, RowCollision } from './core/protocol';
import { cradleFilm, dropFilm, inWords } from './cradle/film';
import { createForm } from './cradle/form';
import {
  type CradleInputs, floorOf, fromAddress, pairOf, rowOf, speedAt, speedsOf, string, toAddress,
} from './cradle/inputs';
import { halfPeriod } from './cradle/swing';
import { type Epsilons, accountsOf, createPanel, velocitiesOf } from './cradle/view';
import { find, messageOf } from './drawing/dom';
import { loadPlot } from './drawing/library';
import { say } from './drawing/words';
import { fine, pause, settle } from './page/session';
import { createSpeaker, heard, pace } from './page/sound';
import { createPlayer } from './scene/player';

void loadPlot();
const loading = createRowCore();
const player = createPlayer(find('scene', HTMLElement), say('cradle.film'));
const after = createPanel('after', say('cradle.after'));
const again = createPanel('again', say('cradle.again'));
const button = find('play-sound', HTMLButtonElement);
const soundNote = find('sound-note', HTMLElement);
const speak = createSpeaker();
const half = halfPeriod(string);

let { inputs, problem } = fromAddress(location.search);
let control = new AbortController();
let ready = false;
/** What is computed, or under way; '' after a failure. */
let computed = '';
/** What is heard. */
let now: { inputs: CradleInputs; cutoff: number } | undefined;

const form = createForm(inputs, {
  changed(next, settled) {
    write(next, settled);
    tell('notice', '');
    if (!ready) inputs = next;
    else if (toAddress(next) !== computed) void compute(next, settle);
  },
  wrong(): void {
    control.abort();
    computed = '';
    stale();
  },
});

function tell(id: 'notice' | 'state', line: string): void {
  const element = find(id, HTMLElement);
  element.textContent = line;
  element.hidden = line === '';
}

function stale(): void {
  after.stale();
  again.stale();
  button.disabled = true;
  soundNote.textContent = '';
}

let inChange = false;

/** Keeps the address up to date: one entry of the history for each change. */
function write(next: CradleInputs, settled: boolean): void {
  const address = `?${toAddress(next)}`;
  if (address !== location.search) {
    if (inChange) history.replaceState(null, '', address);
    else history.pushState(null, '', address);
    inChange = true;
  }
  if (settled) inChange = false;
}

addEventListener('popstate', () => {
  ({ inputs, problem } = fromAddress(location.search));
  form.show(inputs);
  tell('notice', problem);
  if (ready) void compute(inputs, 0);
});

/** Computes the collision, and of the cradle the next one. @param wait ms in which nothing else is wanted */
async function compute(next: CradleInputs, wait: number): Promise<void> {
  inputs = next;
  computed = toAddress(next);
  control.abort();
  const { signal } = (control = new AbortController());
  stale();
  tell('state', say('result.computing'));
  try {
    if (wait > 0) await pause(wait, signal);
    const { rows, pairs } = await loading;
    const [row, speeds] = [rowOf(next), speedsOf(next)];
    const epsilon = async (of: ReturnType<typeof pairOf>, speed: number): Promise<number> =>
      (await pairs('restitution', of, { speed, tolerance: fine }, { signal })).quantities.restitution?.value ?? NaN;
    const isDrop = next.scene === 'drop';
    const floor = isDrop ? epsilon(floorOf(next), speedAt(next)) : undefined;
    const [collision, pair] = await Promise.all([
      rows('row', row, { speeds, tolerance: fine }, signal), epsilon(pairOf(next), speedAt(next) * (isDrop ? 2 : 1)),
    ]);
    const epsilons: Epsilons = { pair, ...(floor ? { floor: await floor } : {}) };
    signal.throwIfAborted();
    show(next, collision, epsilons);
    if (isDrop) return;
    const { cutoff } = collision;
    const second = await rows('rowAgain', row,
      { speeds, cutoff, pause: next.vibration === 'fades' ? half : 0, tolerance: fine }, signal);
    signal.throwIfAborted();
    const { values } = velocitiesOf(next, collision);
    again.show(next, second, accountsOf(next, second, epsilons, values.map((each) => -each)), second.left);
    film(next, [values, velocitiesOf(next, second).values], true);
  } catch (error) {
    if (signal.aborted) return;
    computed = '';
    stale();
    tell('state', '');
    tell('notice', messageOf(error));
  }
}

/** Shows a first collision. */
function show(next: CradleInputs, collision: RowCollision, epsilons: Epsilons): void {
  const { values } = velocitiesOf(next, collision);
  after.show(next, collision, accountsOf(next, collision, epsilons));
  if (next.scene === 'drop') again.hide();
  film(next, [values]);
  tell('state', say('cradle.done', { velocities: inWords(values.map((each) => each / speedAt(next))) }));
  now = { inputs: next, cutoff: collision.cutoff };
  button.disabled = false;
  document.body.dataset.shown = toAddress(next);
}

function film(next: CradleInputs, velocities: readonly (readonly number[])[], longer = false): void {
  const over = (each: readonly number[]): number[] => each.map((velocity) => velocity / speedAt(next));
  player.show(next.scene === 'drop'
    ? dropFilm({ speed: speedAt(next), after: velocities[0]! }, [next.radius, next.radius2])
    : cradleFilm({ half, velocities: [speedsOf(next), ...velocities].map(over) }, next.lift, next.gap > 0), longer);
}

/** Plays what still vibrates after the collision; returns how. */
async function play({ inputs: its, cutoff }: NonNullable<typeof now>): Promise<string> {
  const { rows } = await loading;
  const [row, speeds] = [rowOf(its), speedsOf(its)];
  const omega = await rows('rowPitch', row, { speeds, cutoff });
  const played = pace(pairOf(its), [{ omega, after: 1 } as ModeEnergy], 1);
  if (!played) return say('sound.nothing');
  speak(await Promise.all(speeds.map((_, body) =>
    rows('rowSound', row, { speeds, cutoff, body, interval: played.interval, ...heard }))));
  return played.words;
}

button.addEventListener('click', async () => {
  if (!now) return;
  button.disabled = true;
  soundNote.textContent = await play(now).catch(messageOf);
  button.disabled = now === undefined;
});

tell('notice', problem);
loading.then(() => {
  ready = true;
  performance.mark('core');
  void compute(inputs, 0);
}, (error: unknown) => tell('notice', say('page.no_core', { why: messageOf(error) })));
