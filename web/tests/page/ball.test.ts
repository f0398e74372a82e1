// The drop test of a real ball, with which the page opens.
import { execFileSync } from 'node:child_process';
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { command } from '../native/build';
import { type Site, disk, missing, startSite } from './browser';

/** Wait for the prediction with its uncertain constants; ε as it is shown. */
async function predicted(page: Page): Promise<string> {
  await page.waitForFunction(() => {
    const content = document.getElementById('prediction-content')!;
    return content.dataset.stale === undefined && /± [^±]*± [^±]*± /.test(content.querySelector('.uncertainties')?.textContent ?? '');
  }, undefined, { timeout: 30_000 });
  return (await page.textContent('#predicted'))!;
}

describe.skipIf(missing !== '')(`a real ball${missing && ` (${missing})`}`, () => {
  let site: Site;
  beforeAll(async () => void (site = await startSite()));
  afterAll(() => site.close());
  afterEach(() => expect(site.troubles.splice(0)).toEqual([]));

  it('is what the page opens with: ε, its three uncertainties, the rebound, where the energy goes', async () => {
    const page = await site.open();
    expect(await predicted(page)).toMatch(/^0\.98\d*$/);
    expect(await page.title()).toBe('stoss: the coefficient of restitution');
    expect(await page.locator('.uncertainties dt').allTextContents()).toEqual(
      ['Numerical error', 'Spread of the models', 'Uncertainty of the constants']);
    expect(await page.textContent('#predicted-height')).toMatch(/^29\.1\scm$/);
    expect(await page.textContent('#energy-back')).toMatch(/^97\s% of the energy comes back$/);
    expect(await page.locator('.channels tr').count()).toBe(5);
    expect(await page.isVisible('#curves')).toBe(false);
    expect(await page.isVisible('#result')).toBe(false);
    await page.waitForFunction(() => document.body.dataset.impact === 'current');
    await page.waitForFunction(() => document.getElementById('spoken')!.textContent !== '');
    expect(await page.textContent('#spoken')).toMatch(
      /^Restitution 0\.98\d*: numerical error plus or minus \S+, .*, uncertainty of the constants plus or minus 0\.\d+\. Height of rebound 29\.1\scm\.$/);
    await page.click('#play-sound');
    await page.waitForFunction(() => document.getElementById('sound-note')!.textContent !== '');
    await page.context().close();
  });

  it.skipIf(command === undefined)('has the numbers of the command that it shows', async () => {
    const page = await site.open();
    await predicted(page);
    const line = (await page.textContent('#prediction code'))!;
    expect(line).toBe('stoss predict --body sphere --material glass --radius 0.008 --against half-space,material=granite --height 0.3');
    const text = execFileSync(command!, [...line.split(' ').slice(1), '--format', 'json'], { encoding: 'utf8' });
    const { restitution } = (JSON.parse(text) as { records: { restitution: number }[] }).records[0]!;
    expect(restitution.toFixed(3)).toBe(await page.textContent('#predicted'));
    await page.context().close();
  });

  it('is asked for by what a class measures', async () => {
    const page = await site.open();
    await predicted(page);
    await page.selectOption('#preset', { label: 'Bearing ball on a window pane' });
    await page.waitForURL(/view=ball&material=bearing%20steel&R=0\.005&against=plate&material2=glass&h2=0\.004&drop=0\.2$/);
    const thin = await predicted(page);
    expect(await page.inputValue('#field-thickness2')).toBe('4');
    await page.fill('#field-thickness2', '20');
    await page.fill('#field-radius', '12');
    await page.fill('#field-speed', '15');
    await page.press('#field-speed', 'Tab');
    await page.waitForURL(/R=0\.006&.*h2=0\.02&drop=0\.15$/);
    await page.waitForFunction((before) => document.getElementById('predicted')!.textContent !== before, thin);
    expect(Number(await predicted(page))).toBeGreaterThan(Number(thin));
    await page.fill('#field-speed', '-3');
    expect(await page.textContent('#field-speed-problem')).toContain('got -0.76');
    expect(await page.isDisabled('#print')).toBe(true);
    expect(await page.getAttribute('#prediction-content', 'data-stale')).toBe('');
    await page.fill('#field-speed', '');
    expect(await page.textContent('#field-speed-problem')).toContain('Drop height: got');
    await page.context().close();
  });

  it('has friction, spin and loss where a reader asks for more', async () => {
    const page = await site.open();
    await predicted(page);
    expect(await page.isVisible('#field-friction')).toBe(false);
    await page.click('#more summary');
    await page.fill('#field-friction', '0.3');
    await page.waitForFunction(() => /^0\.\d+ ± |^-0\.\d+ ± /.test(document.getElementById('tangential')!.textContent!));
    expect(await page.isVisible('#prediction')).toBe(true);
    await page.fill('#field-quality', '0');
    await page.press('#field-quality', 'Tab');
    await page.waitForURL(/eta=0&.*&mu=0\.3$/);
    await page.context().close();
  });

  it('is one of two views, whose links hold both', async () => {
    const page = await site.open();
    await predicted(page);
    await page.click('#to-full');
    await page.waitForURL(/\?body=sphere&nu=0\.22&.*&against=half-space&/);
    expect(await page.isChecked('input[name=units][value=c]')).toBe(true);
    expect(await page.isVisible('#curves')).toBe(true);
    await page.goBack();
    await page.waitForFunction(() => document.body.dataset.view === 'ball');
    await page.goForward();
    await page.click('#to-ball');
    await page.waitForURL(/view=ball&material=glass/);
    await page.context().close();
    const old = await site.open(disk);
    expect(await old.isChecked('input[name=body][value=disk]')).toBe(true);
    expect(await old.isVisible('#prediction')).toBe(false);
    await old.context().close();
  });

  it('can be chosen before the core is there, and buttons wait for it', async () => {
    let release = (): void => undefined;
    const held = new Promise<void>((resolve) => (release = resolve));
    const page = await site.open('', {}, async (fresh) => {
      await fresh.route(/\.wasm$/, async (route) => {
        await held;
        await route.continue();
      });
    });
    expect(await page.textContent('#prediction-state')).toMatch(/^The program is loading/);
    await page.selectOption('#material', 'brass');
    await page.fill('#field-speed', '12');
    expect(await page.isDisabled('#print')).toBe(true);
    const waiting = await page.$$eval('button:not(#scene *, #hops *), input[type=file]', (all) =>
      all.filter((each) => !(each as HTMLButtonElement).disabled).map((each) => each.id));
    expect(waiting).toEqual([]);
    release();
    await predicted(page);
    expect(await page.textContent('#prediction code')).toContain('--material brass --radius 0.008');
    expect(await page.textContent('#prediction code')).toContain('--height 0.12');
    expect(await page.isEnabled('#print')).toBe(true);
    await page.context().close();
  });

  it('prints a worksheet: inputs, room for measurements, the prediction, questions, and no controls', async () => {
    const page = await site.open();
    await predicted(page);
    expect(await page.isVisible('#worksheet')).toBe(false);
    await page.emulateMedia({ media: 'print' });
    const seen = await page.innerText('body');
    for (const words of ['A ball of glass, Ø 16 mm, falls on a thick block of granite.', 'Drop height: 30\u00a0cm', 'Height of rebound h′', 'Mean of ε',
      'Numerical error', 'Questions', '?']) expect(seen).toContain(words);
    expect(await page.locator('button:visible, input:visible, select:visible, canvas:visible').count()).toBe(0);
    await page.emulateMedia({ media: 'screen' });
    const printed = page.evaluate(() => new Promise<void>((done) => {
      window.print = () => done();
    }));
    await page.click('#print');
    await printed;
    await page.context().close();
  });
});
