// What the page shows of a prediction, and when it asks for it.
import { describe, expect, it } from 'vitest';
import { barOf, endsOfSpread, modelInWords, modelPoints } from '../../src/charts/model_picture';
import type { Core, Encounter, Prediction } from '../../src/core/protocol';
import { bandInWords } from '../../src/drawing/numbers';
import { meetingOf } from '../../src/inputs/document';
import { defaults, gravity, presets } from '../../src/inputs/inputs';
import { influenceInWords, isPredicted, shareInWords, uncertaintiesInWords } from '../../src/page/prediction_view';
import { createPredictions } from '../../src/page/background';
import { cases, like, made } from './cases';

const marble = presets[0]!.encounter;

function predicted(speed: number, restitution: number, more: Partial<Prediction> = {}): Prediction {
  const of = (value: number) => ({ value, unit: '', help: '' });
  const quantities = {
    restitution: { ...of(restitution), error: 2e-6 }, models_low: of(restitution - 0.1),
    models_high: of(restitution + 0.1), by_models: of(0.1), by_constants: of(0.123),
    rebound_height: of((restitution * speed) ** 2 / (2 * gravity)),
  };
  return { speed, quantities, channels: [], dominant: 'yield', influences: [], warnings: [], ...more };
}

describe('real materials', () => {
  const is = (encounter: Encounter, friction = 0): boolean => isPredicted({ encounter, friction });
  it('are those of balls of a named material, without friction', () => {
    for (const against of ['wall', 'same', 'body', 'half-space', 'plate'] as const) {
      expect(is(like(marble, { against }))).toBe(true);
    }
    expect(is(marble, 0.1)).toBe(false);
    expect(is(like(marble, { si: false }))).toBe(false);
    expect(is(like(marble, { first: { ...made('glass', 0.01), young: 1.23e11 } }))).toBe(false);
    expect(is(defaults.encounter)).toBe(false);
    const kinds = cases.filter(({ encounter }) => is(encounter)).map(({ encounter }) => meetingOf(encounter).kind);
    expect(new Set(kinds)).toEqual(new Set(['sphere', 'hollow-sphere']));
  });
  it('are said with the digits of the band, and of shares with few', () => {
    expect(bandInWords(0.8135, 0.6976, 0.9994)).toEqual({ value: '0.81', band: '0.70 to 1.00' });
    expect(bandInWords(0.984493, 0.98448, 0.984505)).toEqual({ value: '0.984493', band: '0.984480 to 0.984505' });
    expect(bandInWords(0, 0, 0)).toEqual({ value: '0.00', band: '0.00 to 0.00' });
    expect(bandInWords(NaN, NaN, NaN).value).toBe('–');
    expect([0, 1e-7, 0.33718, NaN].map(shareInWords)).toEqual(['0\u00a0%', '< 0.001\u00a0%', '33.7\u00a0%', '–\u00a0%']);
  });
  it('have three uncertainties side by side', () => {
    expect(uncertaintiesInWords(predicted(1, 0.8135))).toEqual({
      value: '0.81', rebound: '3.4\u00a0cm', numerical: '± 2×10⁻⁶', byModels: '± 0.1', byConstants: '± 0.12',
    });
    const { quantities } = predicted(1, 0.8135);
    const exact = { ...quantities, by_models: { value: 0, unit: '', help: '' }, by_constants: { value: 0, unit: '', help: '' } };
    const { byModels, byConstants } = uncertaintiesInWords(predicted(1, 0.8135, { quantities: exact }));
    expect([byModels, byConstants]).toEqual(['± 0', 'taken as exact']);
  });
  it('name the constant that matters most', () => {
    expect(influenceInWords(predicted(1, 0.8))).toBe('');
    const influences = [{ constant: 'against.loss', uncertainty: 2, change: -0.02 }];
    expect(influenceInWords(predicted(1, 0.8, { influences }))).toBe(
      'The constants are not known exactly: ± 0.12 in all; loss in the material of what it meets × 3: −0.02 of ε.');
  });
});

describe('the curve of the model', () => {
  it('goes from slow to fast, without what has no number', () => {
    const points = modelPoints([predicted(2, 0.6), predicted(1, 0.8), predicted(3, NaN)]);
    expect(points.map(({ speed }) => speed)).toEqual([1, 2]);
    expect(modelInWords(points[0]!)).toBe('model, v = 1 m/s: ε = 0.80, models 0.70 to 0.90');
    expect(endsOfSpread(points).map(({ restitution }) => barOf('restitution', restitution, 0).value)).toEqual(
      [0.8 - 0.1, 0.8 + 0.1, 0.6 - 0.1, 0.6 + 0.1]);
  });
});

describe('predictions', () => {
  /** A core that answers at once, and says what it was asked. */
  function recorded() {
    const asked: { speeds: number[]; constants: boolean }[] = [];
    const core = (async (_question: string, _encounter: Encounter, given: (typeof asked)[0],
      { deliver, signal }: { deliver: (each: Prediction, index: number) => void; signal: AbortSignal }) => {
      asked.push(given);
      for (const [index, speed] of given.speeds.entries()) {
        await Promise.resolve();
        signal.throwIfAborted();
        deliver(predicted(speed, 0.8), index);
      }
    }) as unknown as Core;
    return { asked, core };
  }
  const [speeds, fastFirst] = [[1, 0.1, 10, 0.3], [10, 1, 0.3, 0.1]];

  it('are first at the speed of the inputs, then at those of the curve that are missing', async () => {
    const { asked, core } = recorded();
    let [shown, changed] = [0, 0];
    const all = createPredictions(core, { one: () => ++shown, curve: () => ++changed, failed: expect.unreachable });
    await all.want(marble, 0.5, speeds);
    expect(asked.map((each) => [each.speeds, each.constants])).toEqual(
      [[[0.5], false], [[0.5], true], [fastFirst, false]]);
    expect([shown, changed]).toEqual([2, 4]);
    expect(all.of(marble).map(({ speed }) => speed)).toEqual(fastFirst);
    await all.want(marble, 0.6, [...speeds, 0.2]);
    expect(asked.at(-1)!.speeds).toEqual([0.2]);
  });
  it('of what is no longer wanted end without a word', async () => {
    const { asked, core } = recorded();
    const shown: number[] = [];
    const all = createPredictions(core,
      { one: (_, { speed }) => shown.push(speed), curve: () => {}, failed: expect.unreachable });
    const first = all.want(marble, 0.5, speeds);
    await Promise.all([first, all.want(marble, 0.7, speeds)]);
    expect(shown).toEqual([0.7, 0.7]);
    const third = all.want(marble, 0.9, []);
    all.stop();
    await third;
    expect(shown).toEqual([0.7, 0.7]);
    expect(asked.filter((each) => each.speeds.length > 1)).toHaveLength(1);
  });
  it('that the core refuses say why', async () => {
    const lines: string[] = [];
    const core = (() => Promise.reject(new Error('body: got a disk'))) as unknown as Core;
    const failed = (line: string): void => void lines.push(line);
    await createPredictions(core, { one: () => expect.unreachable(), curve: () => expect.unreachable(), failed })
      .want(marble, 1, []);
    expect(lines).toEqual(['body: got a disk']);
  });
});
