// Hollow spheres, which the module of first values does not have.
import { execFileSync } from 'node:child_process';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { command } from '../native/build';
import { type Site, missing, settled, startSite } from './browser';

const shell = '?body=hollow-sphere&nu=0.3&b=0.8';
const block = '&against=half-space&nu2=0.3&E2=0.5&rho2=1';

describe.skipIf(missing !== '')(`a hollow sphere${missing && ` (${missing})`}`, () => {
  let site: Site;
  beforeAll(async () => void (site = await startSite()));
  afterAll(() => site.close());
  afterEach(() => expect(site.troubles.splice(0)).toEqual([]));

  it('is computed by the one module that a link to it loads', async () => {
    site.transferred.clear();
    const page = await site.open(`${shell}${block}&v=0.01`);
    expect(await settled(page)).toMatch(/^0\.\d+ ± /);
    const paths = [...site.transferred.keys()].filter((path) => path.endsWith('.wasm'));
    expect(paths).toEqual([expect.stringMatching(/\/page-[^/]*\.wasm$/)]);
    expect(await page.textContent('#who')).toBe('hollow sphere ν 0.3 b 0.8 at half-space ν 0.3 E 0.5');
    await page.waitForFunction(() => document.querySelector('#collision .scene-note')?.textContent?.includes('are drawn at rest'));
    await page.context().close();
  });

  it.skipIf(command === undefined)('is chosen in the form, has its link and the value of its command line', async () => {
    const page = await site.open('?body=sphere&nu=0.3&v=0.01');
    const solid = await settled(page);
    await page.check('input[name="body"][value="hollow-sphere"]', { force: true });
    expect(await page.getAttribute('.field:has(#field-inner)', 'title')).toBe('radius of its hole over that of the sphere, 0 to 0.99');
    await page.fill('#field-inner', '1');
    await page.waitForFunction(() =>
      document.getElementById('field-inner-problem')!.textContent!.startsWith('Inner radius: got 1, allowed 0 to 0.99'));
    await page.fill('#field-inner', '0.8');
    await page.press('#field-inner', 'Tab');
    await page.waitForURL(/\?body=hollow-sphere&nu=0\.3&b=0\.8&v=0\.01$/);
    const shown = await settled(page);
    expect(shown).not.toBe(solid);
    const line = await page.textContent('#command-line');
    expect(line).toBe('stoss restitution --body hollow-sphere --poisson 0.3 --inner 0.8 --speed 0.01');
    const native = execFileSync(command!, [...line!.split(' ').slice(1), '--format', 'json'], { encoding: 'utf8' });
    const [{ restitution }] = (JSON.parse(native) as { records: [{ restitution: number }] }).records;
    const [, digits] = /^0\.(\d+) ± /.exec(shown)!;
    expect(shown.startsWith(restitution.toFixed(digits!.length))).toBe(true);
    await page.context().close();
  });
});
