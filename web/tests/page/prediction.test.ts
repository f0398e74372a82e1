// The panel of real materials, and the curve of the model.
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { type Site, missing, settled, startSite } from './browser';

const steel = 'body=sphere&units=SI&nu=0.3&E=2.1e11&rho=7810&R=0.005&Q=3000';
const glass = 'nu2=0.22&E2=7e10&rho2=2500&Q2=1000';

describe.skipIf(missing !== '')(`real materials${missing && ` (${missing})`}`, () => {
  let site: Site;
  beforeAll(async () => void (site = await startSite()));
  afterAll(() => site.close());
  afterEach(() => expect(site.troubles.splice(0)).toEqual([]));

  it('have a prediction with its channels, and a curve of the model', async () => {
    const page = await site.open(`?${steel}&v=1`);
    await settled(page);
    await page.waitForSelector('.channels', { timeout: 30_000 });
    await page.waitForFunction(() => /yield strength × 1\.2/.test(document.getElementById('prediction')!.textContent!));
    const text = (await page.textContent('#prediction'))!;
    expect(await page.textContent('#predicted')).toMatch(/^0\.\d+$/);
    expect(text).toMatch(
      /Numerical error\s*± \S+\s*Spread of the models\s*± 0\.\d+\s*Uncertainty of the constants\s*± 0\.\d+\s*Height/);
    expect(await page.locator('.channels tr').allTextContents()).toEqual([
      expect.stringMatching(/^\s*ringing[\s\S]*computed/), expect.stringMatching(/^\s*radiation[\s\S]*computed/),
      expect.stringMatching(/^\s*material[\s\S]*computed/), expect.stringMatching(/^\s*yield[\s\S]*model/),
      expect.stringMatching(/^\s*adhesion[\s\S]*model/),
    ]);
    expect(await page.textContent('.channels [data-dominant]')).toContain('yield');
    expect(text).toMatch(/Height of rebound\s*[\d.]+\scm\s*of a drop from 5\.1\scm/);
    expect(text).toContain('yields above 0.13 m/s');
    expect(text).toContain("stoss predict --body sphere --material 'bearing steel' --radius 0.005 --speed 1");
    await page.waitForFunction(() => document.getElementById('curve-chart')!.textContent!.includes('model'));
    await page.locator('#curve-chart .chart-area').hover({ position: { x: 300, y: 100 } });
    expect(await page.textContent('#curve-chart .chart-note')).toMatch(/model, v = .* m\/s: ε = 0\.\d+, models 0\.\d+ to /);
    await page.context().close();
  });

  it.each([
    ['body=disk&nu=0.33&v=0.1', false], ['body=sphere&nu=0.3&v=0.01', false], [`${steel}&v=1`, true],
    [`${steel.replace('2.1e11', '2.2e11')}&v=1`, false], [`${steel}&v=1&mu=0.3&angle=20`, false],
    [`${steel}&v=1&against=half-space&${glass}`, true], [`${steel}&v=1&against=plate&h2=0.01&${glass}`, true],
    [`${steel}&v=1&against=body&R2=0.01&${glass}`, true], [`${steel}&v=1&against=same`, true],
  ] as const)('are those of balls of a named material only: %s', async (query, there) => {
    const page = await site.open(`?${query}`);
    await settled(page);
    expect(await page.isVisible('#prediction')).toBe(there);
    if (there) await page.waitForSelector('.channels', { timeout: 30_000 });
    await page.context().close();
  });

  it('go as soon as the inputs are of no real material', async () => {
    const page = await site.open(`?${steel}&v=1`);
    await settled(page);
    await page.waitForFunction(() => document.getElementById('curve-chart')!.textContent!.includes('model'),
      undefined, { timeout: 30_000 });
    await page.fill('#field-friction', '0.2');
    await page.waitForSelector('#prediction', { state: 'hidden' });
    await page.waitForFunction(() => !document.getElementById('curve-chart')!.textContent!.includes('model'));
    await page.context().close();
  });
});
