// What readers with other means than the eye and the mouse get: the rules of axe-core, and the keyboard alone.
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { violations } from './axe';
import { type Site, disk, missing, startSite } from './browser';

describe.skipIf(missing !== '')(`the page${missing && ` (${missing})`}`, () => {
  let site: Site;
  beforeAll(async () => void (site = await startSite()));
  afterAll(() => site.close());
  afterEach(() => expect(site.troubles.splice(0)).toEqual([]));

  const marble = 'body=sphere&units=SI&nu=0.22&E=7e10&rho=2500&R=0.008&eta=1.5915494309189534e-8&v=1';
  const [desk, phone] = [{ width: 1280, height: 900 }, { width: 360, height: 740 }];
  it.each([
    ['of the real ball', '', desk, 'light'], ['of the real ball on a phone', '', phone, 'dark'],
    ['of the real ball with friction', 'view=ball&material=rubber&R=0.02&material2=granite&drop=0.5&mu=0.5', desk, 'light'],
    ['without dimensions', 'body=disk&nu=0.33&v=0.1', desk, 'light'], ['of a ball in SI', marble, desk, 'light'],
    ['in the dark', marble, desk, 'dark'], ['in the simple view', `${marble}&view=simple`, desk, 'light'],
    ['with friction', `${marble}&mu=0.3&angle=20`, desk, 'light'], ['on a phone', marble, phone, 'light'],
    ['in the simple view on a phone', `${marble}&view=simple`, phone, 'light'],
  ] as const)('keeps the rules of axe-core %s', async (_, query, viewport, colorScheme) => {
    const page = await site.open(`?${query}`, { viewport, colorScheme, reducedMotion: 'reduce' });
    await page.waitForFunction(() => document.body.dataset.impact === 'current');
    expect(await violations(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    await page.context().close();
  });

  it.each([
    ['of the real ball', 'view=ball&material=rubber&R=0.02&material2=granite&drop=0.5&mu=0.5'], ['without dimensions', disk.slice(1)],
  ])('can be used by the keyboard alone %s: every control in its order, seen, and the way out', async (_, query) => {
    const page = await site.open(`?${query}`, { reducedMotion: 'reduce' });
    await page.waitForFunction(() => document.body.dataset.impact === 'current');
    await page.waitForTimeout(1000);
    const controls = await page.evaluate(() => {
      const all = [...document.querySelectorAll<HTMLElement>('a[href], button, input, select, summary, [tabindex="0"]')]
        .filter((each) => each.checkVisibility({ visibilityProperty: true }) && !each.matches(':disabled, [tabindex="-1"]'))
        // Of radio buttons that belong together the keyboard reaches the one that is chosen.
        .filter((each) => !(each instanceof HTMLInputElement && each.type === 'radio' && !each.checked));
      all.forEach((each, index) => (each.dataset.order = String(index)));
      return all.length;
    });
    expect(controls).toBeGreaterThan(15);
    const seen: string[] = [];
    for (let count = 0; count < controls; ++count) {
      await page.keyboard.press('Tab');
      seen.push(await page.evaluate(() => {
        const focused = document.activeElement as HTMLElement;
        const marked = [focused, focused.nextElementSibling].some((each) => each && getComputedStyle(each).outlineStyle !== 'none');
        return `${focused.dataset.order ?? focused.outerHTML.slice(0, 80)}${marked ? '' : ', which does not show it'}`;
      }));
    }
    expect(seen).toEqual(Array.from({ length: controls }, (_each, index) => String(index)));
    await page.keyboard.press('Tab');
    expect(await page.evaluate(() => document.activeElement === document.body)).toBe(true);
    await page.context().close();
  });

  it('has its first value with little work, and marks it', async () => {
    const page = await site.open();
    const session = await page.context().newCDPSession(page);
    await session.send('Performance.enable');
    await page.waitForFunction(() => performance.getEntriesByName('first-value').length > 0);
    const { metrics } = await session.send('Performance.getMetrics');
    expect(metrics.find(({ name }) => name === 'ThreadTime')!.value).toBeLessThan(3); // s of the page's own thread
    await page.context().close();
  });
});
