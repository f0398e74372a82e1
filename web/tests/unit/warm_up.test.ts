// The core warms up once, after its first answer.
import { expect, it } from 'vitest';
import type { Core, Encounter } from '../../src/core/protocol';
import { withWarmUp } from '../../src/core/warm_up';
import { meetingOf } from '../../src/inputs/document';
import { cases } from './cases';

it('computes values of half-spaces after the first answer, once, and says so before', async () => {
  const log: string[] = [];
  const core = withWarmUp((async (question: string, encounter: Encounter) => {
    const { kind, against } = meetingOf(encounter);
    log.push(question === 'curve' ? `${kind} ${against}` : question);
    if (question === 'curve') throw new Error('no worker');
  }) as unknown as Core, () => void log.push('answered'));
  expect(log).toEqual([]);
  for (const { encounter, speed } of cases.slice(0, 2)) {
    await core('restitution', encounter, { speed, tolerance: 1e-2 });
  }
  expect(log).toEqual(['restitution', 'answered', 'sphere half-space', 'disk half-space', 'restitution']);
});
