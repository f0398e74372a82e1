// The sound of what still vibrates after the impact: the velocities of the struck points, played.
import { sum } from 'd3-array';
import { unitsOf } from '../core/local';
import type { Collision, Core, Encounter, ModeEnergy } from '../core/protocol';
import { find, messageOf } from '../drawing/dom';
import { significant } from '../drawing/numbers';
import { say } from '../drawing/words';
import { meetingOf } from '../inputs/document';

const rate = 44100;
const seconds = 2;

/** How much of a sound is asked for; the quality is that of modes of a material without loss. */
export const heard = { count: seconds * rate, quality: 1000 };

/** A lowest mode above this, in Hz, is played at concert pitch. */
const highest = 8000;
const pitch = 440;

/** Time of an impact between two samples, in units.time, and in words how much slower it is played. Undefined where
 *  nothing vibrates. */
export function pace(encounter: Encounter, modes: readonly ModeEnergy[], frequency: number) {
  const { si } = meetingOf(encounter);
  const lowest = Math.min(...modes.filter(({ after }) => after > 0).map(({ omega }) => omega * frequency));
  if (!Number.isFinite(lowest)) return undefined;
  if (si && lowest <= 2 * Math.PI * highest) return { interval: 1 / rate, words: say('sound.as_it_is') };
  const interval = (2 * Math.PI * pitch) / (rate * lowest);
  const times = significant(1 / (rate * interval), 3);
  return { interval, words: si ? say('sound.slower', { times, pitch }) : say('sound.pitch', { pitch }) };
}

/** Several sounds at once, as loud as it can be. */
export function mixed(parts: readonly Float32Array[]): Float32Array<ArrayBuffer> {
  const all = Float32Array.from({ length: seconds * rate }, (_, i) => sum(parts, (part) => part[i] ?? 0));
  const loudest = all.reduce((most, each) => Math.max(most, Math.abs(each)), 0) || 1;
  return all.map((each) => (0.9 * each) / loudest);
}

/** Makes what plays several sounds at once. */
export function createSpeaker() {
  let context: AudioContext | undefined;
  return (parts: readonly Float32Array[]): void => {
    context ??= new AudioContext();
    const source = new AudioBufferSourceNode(context, {
      buffer: new AudioBuffer({ length: seconds * rate, sampleRate: rate }),
    });
    source.buffer!.copyToChannel(mixed(parts), 0);
    source.connect(context.destination);
    source.start();
  };
}

/** Wire the button of index.html. The result shows the collision that is heard. */
export function createSound(core: Core) {
  let now: { encounter: Encounter; speed: number; cutoff: number; collision: Collision } | undefined;
  const speak = createSpeaker();
  const button = find('play-sound', HTMLButtonElement);
  const note = find('sound-note', HTMLElement);

  async function play(): Promise<string> {
    const { encounter, speed, cutoff, collision: { modes } } = now!;
    const played = pace(encounter, modes, unitsOf(encounter).frequency);
    if (!played) return say('sound.nothing');
    const bodies = [...new Set(modes.filter(({ after }) => after > 0).map(({ body }) => body))];
    const given = { speed, cutoff, interval: played.interval, ...heard };
    const parts = await Promise.allSettled(bodies.map((body) => core('sound', encounter, { ...given, body })));
    const there = parts.flatMap((part) => (part.status === 'fulfilled' ? [part.value] : []));
    if (there.length === 0) throw (parts[0] as PromiseRejectedResult).reason; // of a large body only a part is there
    speak(there);
    return played.words;
  }

  button.addEventListener('click', async () => {
    button.disabled = true;
    note.textContent = await play().catch(messageOf);
    button.disabled = now === undefined;
  });

  return (encounter: Encounter, speed: number, cutoff: number, collision: Collision): void => {
    now = { encounter, speed, cutoff, collision };
    button.disabled = false;
    note.textContent = '';
  };
}
