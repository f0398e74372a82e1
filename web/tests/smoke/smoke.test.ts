// The page in a browser: it shows a value, follows an input, and asks nothing of the network. All else is tested without
// a browser (tests/unit) or takes long (tests/page).
import { afterAll, beforeAll, expect, it } from 'vitest';
import { type Site, missing, settled, startSite } from '../page/browser';

let site: Site;
beforeAll(async () => {
  expect(missing).toBe('');
  site = await startSite();
});
afterAll(() => site?.close());

it('shows a value, and another one for another speed', async () => {
  const page = await site.open('?body=disk&nu=0.33&v=0.1');
  const first = await settled(page);
  expect(Number(/0\.\d+/.exec(first)?.[0])).toBeGreaterThan(0.8);
  const second = await site.open('?body=disk&nu=0.33&v=0.4');
  expect(await settled(second)).not.toBe(first);
  await second.waitForFunction(() => document.querySelectorAll('#curve-chart path').length > 0);
  expect(site.troubles).toEqual([]);
});
