// Losses, roughness and coats of both bodies, under More.
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { type Site, missing, settled, startSite } from './browser';

const steel = 'body=sphere&units=SI&nu=0.3&E=2.1e11&rho=7810&R=0.005&Q=3000';

describe.skipIf(missing !== '')(`rough and coated faces${missing && ` (${missing})`}`, () => {
  let site: Site;
  beforeAll(async () => void (site = await startSite()));
  afterAll(() => site.close());
  afterEach(() => expect(site.troubles.splice(0)).toEqual([]));

  it('are typed under More, are refused there, and are in the link and the lines', async () => {
    const page = await site.open(`?${steel}&v=0.1`);
    const smooth = await settled(page);
    expect(await page.isVisible('#field-roughness')).toBe(false);
    await page.click('#more summary');
    await page.fill('#field-roughness', '0.02');
    expect(await page.textContent('#field-roughness-problem')).toMatch(/^Roughness: got 0\.02, allowed 0 to 0\.0111/);
    await page.fill('#field-roughness', '2.4e-8');
    await page.fill('#field-coat', '1e-6');
    expect(await page.inputValue('#field-coat_young')).toBe('2.1e9');
    await page.fill('#field-coat_poisson', '0.4');
    await page.press('#field-coat_poisson', 'Tab');
    await page.waitForURL(/&Q=3000&rough=2\.4e-8&coat=1e-6&Ec=2\.1e9&nuc=0\.4&v=0\.1$/);
    expect(await settled(page)).not.toBe(smooth);
    expect(await page.textContent('#command-line')).toBe("stoss restitution --body sphere --material 'bearing steel' " +
      '--radius 0.005 --roughness 2.4e-8 --coat 1e-6 --coat-young 2.1e9 --coat-poisson 0.4 --speed 0.1');
    await page.waitForFunction(() => document.querySelector('#collision .scene-note')?.textContent?.includes('Coats are not drawn'));
    await page.context().close();
  });

  it('are restored from a link, with a relaxation, and open More', async () => {
    const page = await site.open('?body=sphere&nu=0.3&relax=0.5:1+0.2:10&against=half-space&nu2=0.3&E2=1&rho2=1&rough2=0.001&v=0.05');
    expect(await settled(page)).toMatch(/^0\.\d+ ± /);
    expect(await page.isVisible('#field-relaxation')).toBe(true);
    expect(await page.inputValue('#field-relaxation')).toBe('0.5:1+0.2:10');
    expect(await page.inputValue('#field-roughness2')).toBe('0.001');
    await page.fill('#field-relaxation', '0.5:');
    expect(await page.textContent('#field-relaxation-problem')).toContain('allowed SHARE:TIME+SHARE:TIME');
    await page.fill('#field-relaxation', '0.5:1');
    await page.press('#field-relaxation', 'Tab');
    await page.waitForURL(/&relax=0\.5:1&/);
    await page.fill('#field-loss_time', '0.02');
    expect(await page.inputValue('#field-relaxation')).toBe('');
    expect(await settled(page)).toMatch(/^0\.\d+ ± /);
    await page.context().close();
  });
});
