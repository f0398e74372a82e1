// The page of the cradle: other numbers of balls, the second swing, the address, and two balls that fall.
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { type Site, missing, startSite } from './browser';
import { violations } from './axe';

/** Wait for what belongs to an address; the first column of numbers. */
async function shown(page: Page, address: RegExp): Promise<number[]> {
  await page.waitForFunction((source) => new RegExp(source).test(document.body.dataset.shown ?? '') &&
    document.getElementById('after')!.dataset.stale === undefined, address.source, { timeout: 60_000 });
  const cells = await page.locator('#after-table tbody td:nth-child(2)').allTextContents();
  return cells.map((each) => Number.parseFloat(each.replace('−', '-').replace('(', '')));
}

const rects = (page: Page, host: string): Promise<number> => page.locator(`${host} svg rect`).count();

describe.skipIf(missing !== '')(`the cradle${missing && ` (${missing})`}`, () => {
  let site: Site;
  beforeAll(async () => void (site = await startSite()));
  afterAll(() => site.close());
  afterEach(() => expect(site.troubles.splice(0)).toEqual([]));

  it('is reached by a link, and shows other balls, their bars and the second swing', async () => {
    const page = await site.open('', { reducedMotion: 'reduce' });
    await page.click('nav a[href="cradle.html"]');
    const five = await shown(page, /balls=5&lift=1/);
    expect(five.length).toBe(5);
    expect(five[4]).toBeGreaterThan(0.97);
    await page.waitForSelector('#after-bars svg');
    const bars = await rects(page, '#after-bars');
    await page.click('#cradle-inputs input[name="balls"][value="3"]');
    expect((await shown(page, /balls=3&lift=1/)).length).toBe(3);
    await page.waitForFunction(([host, before]) => {
      const now = document.querySelectorAll(`${host} svg rect`).length;
      return now > 0 && now < (before as number);
    }, ['#after-bars', bars] as const);
    await page.click('#cradle-inputs input[name="lift"][value="2"]');
    const [first, second, third] = await shown(page, /balls=3&lift=2/);
    expect(first).toBeLessThan(0.2);
    expect(second).toBeGreaterThan(0.8);
    expect(third).toBeGreaterThan(0.9);
    expect(page.url()).toContain('cradle.html?material=bearing%20steel&balls=3&lift=2&R=0.01&drop=0.0025&gap=0');
    await page.waitForSelector('#again:not([hidden]):not([data-stale]) #again-bars svg', { timeout: 60_000 });
    expect(await page.locator('#again-table tbody tr').count()).toBe(3);
    await page.goBack();
    expect((await shown(page, /balls=3&lift=1/)).length).toBe(3);
    await page.context().close();
  });

  it('refuses what is no number, and what the core refuses', async () => {
    const page = await site.open('cradle.html', { reducedMotion: 'reduce' });
    await shown(page, /balls=5/);
    await page.fill('#field-radius', 'x');
    expect(await page.textContent('#field-radius-problem')).toContain("got 'x', allowed one decimal number");
    await page.fill('#field-radius', '0');
    await page.press('#field-radius', 'Tab');
    await page.waitForFunction(() => document.getElementById('notice')!.textContent!.includes('radius: '));
    await page.fill('#field-radius', '16');
    await page.press('#field-radius', 'Tab');
    await shown(page, /R=0\.008/);
    expect(await page.isHidden('#notice')).toBe(true);
    await page.context().close();
  });

  it('drops two balls, is heard, and says what is wrong with a link', async () => {
    const page = await site.open('cradle.html?scene=drop&material=bearing%20steel&R=0.005&R2=0.02&drop=0.0025&gap=0.0001&x=1',
      { reducedMotion: 'reduce' });
    expect(await page.textContent('#notice')).toContain('x: got an unknown key');
    const [upper] = await shown(page, /scene=drop/);
    expect(upper).toBeGreaterThan(2.5);
    expect(await page.isHidden('#again')).toBe(true);
    await page.click('#play-sound');
    await page.waitForFunction(() => document.getElementById('sound-note')!.textContent!.includes('slower'));
    await page.context().close();
  });

  it.each([
    ['', { width: 1280, height: 900 }, 'light'], ['?balls=7&lift=3', { width: 360, height: 740 }, 'dark'],
    ['?scene=drop', { width: 360, height: 740 }, 'light'],
  ] as const)('keeps the rules of axe-core: %s', async (query, viewport, colorScheme) => {
    const page = await site.open(`cradle.html${query}`, { viewport, colorScheme, reducedMotion: 'reduce' });
    await shown(page, /./);
    await page.waitForSelector('#after-bars svg');
    if (!query.includes('drop')) await page.waitForSelector('#again-bars svg', { timeout: 60_000 });
    expect(await violations(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    await page.context().close();
  });
});
