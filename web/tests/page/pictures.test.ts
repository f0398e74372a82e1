// The pictures of the page, linked with each other and with the inputs.
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { type Site, disk, missing, settled, startSite } from './browser';

/** Wait until the film can be played, and stop it. */
async function film(page: Page): Promise<void> {
  await settled(page);
  await page.waitForFunction(() => !document.querySelector<HTMLInputElement>('.scene-time')!.disabled &&
    document.body.dataset.impact === 'current', undefined, { timeout: 30_000 });
}

const time = (page: Page): Promise<string | null> => page.getAttribute('.scene-time', 'aria-valuetext');

describe.skipIf(missing !== '')(`the pictures of the page${missing && ` (${missing})`}`, () => {
  let site: Site;
  beforeAll(async () => void (site = await startSite()));
  afterAll(() => site.close());
  afterEach(() => expect(site.troubles.splice(0)).toEqual([]));

  it('share one cursor: the film and the charts in time', async () => {
    const page = await site.open(disk, { viewport: { width: 1400, height: 1800 }, reducedMotion: 'reduce' });
    await film(page);
    const charts = (): Promise<string> => page.innerText('#time-charts');
    const [before, shown] = [await time(page), await charts()];
    await page.click('button[aria-label="Step forward"]');
    await page.click('button[aria-label="Step forward"]');
    expect(await time(page)).not.toBe(before);
    await page.waitForFunction((text) => document.getElementById('time-charts')!.innerText !== text, shown);
    const stepped = await time(page);
    const box = (await page.locator('#time-charts .chart-time').first().boundingBox())!;
    await page.mouse.click(box.x + 0.25 * box.width, box.y + 0.5 * box.height);
    await page.waitForFunction(
      (text) => document.querySelector('.scene-time')!.getAttribute('aria-valuetext') !== text, stepped);
    await page.context().close();
  });

  it('give the speed that is chosen in the curve', async () => {
    const page = await site.open(disk, { viewport: { width: 1400, height: 1800 } });
    await film(page);
    const box = (await page.locator('#curve-chart').boundingBox())!;
    await page.mouse.click(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
    const speed = Number(await page.inputValue('#field-speed'));
    expect(speed).toBeGreaterThan(1e-5);
    expect(speed).toBeLessThan(1e-2);
    await page.waitForURL(new RegExp(`v=${speed}$`));
    await settled(page);
    await page.context().close();
  });

  it('have legends whose labels are whole, on a phone too', async () => {
    const ball = 'body=sphere&units=SI&nu=0.3&E=2.1e11&rho=7850&R=0.005&v=1';
    const block = 'against=half-space&nu2=0.22&E2=7e10&rho2=2500&keep=body:disk,nu:0.33';
    const page = await site.open(`?${ball}&${block}`, { viewport: { width: 390, height: 844 } });
    await settled(page);
    await page.waitForFunction(() => document.querySelectorAll('#curve-chart svg tspan').length > 0);
    const beyond = await page.evaluate(() => {
      const { right } = document.querySelector('#curve-chart svg')!.getBoundingClientRect();
      return [...document.querySelectorAll('#curve-chart svg text')]
        .filter((each) => each.getBoundingClientRect().right > right + 1).map((each) => each.textContent);
    });
    expect(beyond).toEqual([]);
    await page.context().close();
  });

  it('are there for every kind of encounter', async () => {
    for (const query of [
      '?body=disk&nu=0.33&v=0.1&against=body&nu2=0.2&R2=0.5&E2=2&rho2=1',
      '?body=disk&nu=0.33&v=0.1&against=half-space&nu2=0.3&E2=1&rho2=1',
      '?body=sphere&nu=0.3&v=0.1&against=same', '?body=rod&v=0.1&against=body&E2=1&rho2=1&R2=2.5&A2=1&eta=0.01',
    ]) {
      const page = await site.open(query);
      await film(page);
      expect(await page.textContent('#notice'), query).toBe('');
      expect((await page.innerText('#mode-bars')).length, query).toBeGreaterThan(20);
      await page.context().close();
    }
  });
});
