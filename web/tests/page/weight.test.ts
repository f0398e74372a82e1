// What a page loads before its first value, which is what one waits for.
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { type Site, missing, settled, startSite } from './browser';

const most = 650e3; // bytes after gzip

describe.skipIf(missing !== '')(`the page${missing && ` (${missing})`}`, () => {
  let site: Site;
  beforeAll(async () => void (site = await startSite()));
  afterAll(() => site.close());

  it.each([
    ['of a ball on glass', '?body=sphere&units=SI&nu=0.3&E=2.1e11&rho=7810&R=0.005&v=1&against=half-space&nu2=0.22&E2=7e10&rho2=2500'],
    ['as it opens', ''],
  ])('has little to load before its first value: %s', async (_, query) => {
    site.transferred.clear();
    const page = await site.open(query);
    await settled(page);
    const { after, loaded } = await page.evaluate(() => {
      const [first] = performance.getEntriesByName('first-value');
      const before = performance.getEntriesByType('resource').filter(({ startTime }) => startTime < first!.startTime);
      return { after: first!.startTime, loaded: before.map(({ name }) => name) };
    });
    const paths = loaded.filter((name) => name.startsWith(site.address)).map((name) => name.slice(site.address.length - 1));
    const bytes = ['/index.html', ...paths].map((path) => site.transferred.get(path)!);
    const sum = bytes.reduce((all, each) => all + each, 0);
    console.info(`first value after ${after.toFixed(0)} ms, ${(sum / 1e3).toFixed(0)} kB after gzip: ${paths.join(' ')}`);
    expect(paths.filter((path) => path.endsWith('.wasm'))).toEqual([expect.stringMatching(/\/first-[^/]*\.wasm$/)]);
    expect(sum).toBeLessThan(most);
    // The rest follows by itself.
    await page.waitForFunction(() => performance.getEntriesByType('resource').some(({ name }) => /\/page-[^/]*\.wasm$/.test(name)));
    await page.context().close();
  });
});
