// What the page computes, and what can be taken from it.
import { readFile } from 'node:fs/promises';
import { execFileSync } from 'node:child_process';
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { command } from '../native/build';
import { type Site, disk, missing, settled, startSite } from './browser';

async function downloaded(page: Page, button: string): Promise<{ name: string; content: Buffer }> {
  const [file] = await Promise.all([page.waitForEvent('download', { timeout: 50_000 }), page.click(button)]);
  return { name: file.suggestedFilename(), content: await readFile((await file.path())!) };
}

/** The CSV of the curve once it is complete: before its first point nothing is downloaded. */
async function wholeCurve(page: Page): Promise<string> {
  for (;;) {
    await page.click('#download-csv');
    if ((await page.textContent('#done')) === 'CSV downloaded.') break;
    await page.waitForTimeout(500);
  }
  return (await downloaded(page, '#download-csv')).content.toString();
}

/** The rows of a CSV file by the names of its columns. */
function rowsOf(csv: string): Record<string, string>[] {
  const lines = csv.trim().split('\n').filter((line) => !line.startsWith('#'));
  const [names, ...rows] = lines.map((line) => line.split(','));
  return rows.map((row) => Object.fromEntries(names!.map((name, index) => [name, row[index] ?? ''])));
}

describe.skipIf(missing !== '')(`the results of the page${missing && ` (${missing})`}`, () => {
  let site: Site;
  beforeAll(async () => void (site = await startSite()));
  afterAll(() => site.close());
  afterEach(() => expect(site.troubles.splice(0)).toEqual([]));

  it('are told to screen readers once they stay', async () => {
    const page = await site.open(disk);
    await settled(page);
    await page.waitForFunction(() => document.getElementById('spoken')!.textContent !== '');
    const line = /^Restitution 0\.\d+ plus or minus 0\.\d+ at 0\.1 c\. Lost share/;
    expect(await page.textContent('#spoken')).toMatch(line);
    await page.context().close();
  });

  it('say what is beyond small strain, and what is not as accurate as asked for', async () => {
    const page = await site.open('?body=disk&nu=0.33&v=0.8');
    await settled(page);
    expect(await page.textContent('#flags')).toContain('Beyond small strain');
    await page.context().close();
    const rod = await site.open('?body=rod&v=0.1&against=body&E2=1&rho2=1&R2=2.5&A2=1');
    await settled(rod);
    const flag = await rod.textContent('#flags');
    expect(flag).toContain('Not as accurate as asked for: did not reach the tolerance');
    expect(flag).not.toContain('; try a tolerance');
    await rod.context().close();
  });

  it('have numbers on a logarithmic axis of less than a decade', async () => {
    const page = await site.open('?body=rod&v=0.1&against=body&E2=1&rho2=1&R2=2.5&A2=1&eta=0.01');
    await settled(page);
    await page.check('#curve-chart input');
    await page.waitForFunction(() => [...document.querySelectorAll('#curve-chart g text')]
      .filter((each) => /^0\.[89]\d*$/.test(each.textContent ?? '')).length > 2);
    await page.context().close();
  });

  it('can be copied as lines and as a link', async () => {
    const page = await site.open('?body=disk&nu=0.4&v=0.2');
    await settled(page);
    const python = 'import stoss\n\ndisk = stoss.Disk(poisson=0.4)\nprint(stoss.restitution(disk, speed=0.2))';
    for (const [button, said, text] of [
      ['#copy-command', 'Command line copied.', 'stoss restitution --body disk --poisson 0.4 --speed 0.2'],
      ['#copy-python', 'Python lines copied.', python],
      ['#copy-link', 'Link copied.', `${site.address}?body=disk&nu=0.4&v=0.2`],
    ] as const) {
      await page.click(button);
      await page.waitForFunction((line) => document.getElementById('done')!.textContent === line, said);
      expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(text);
    }
    await page.context().close();
  });

  it('can be downloaded: CSV, C header, PNG, SVG', async () => {
    const page = await site.open(disk);
    await settled(page);
    await page.waitForTimeout(1000);
    const csv = await downloaded(page, '#download-csv');
    expect(csv.name).toBe('stoss-restitution.csv');
    expect(csv.content.toString()).toMatch(/^# stoss [\d.]+: restitution\n/);
    expect(csv.content.toString()).toContain('\npoisson,speed[c],restitution,restitution_error,converged\n0.33,');
    const header = await downloaded(page, '#download-header');
    expect(header.name).toBe('restitution.h');
    const words: Record<string, string[]> = {
      curve: ['speed of the impact v (c)', 'coefficient of restitution ε', 'disk ν 0.33'],
      time: ['Force (πRE)', 'Velocity (c)', 'time since first contact (R/c)', 'translation'],
      modes: ['order n', 'share of the energy, after the impact', 'l = 0'],
    };
    for (const picture of ['curve', 'time', 'modes', 'collision']) {
      await page.selectOption('#picture', picture);
      const png = await downloaded(page, '#download-png');
      expect(png.content.subarray(1, 4).toString(), picture).toBe('PNG');
      if (picture === 'collision') continue;
      const svg = await downloaded(page, '#download-svg');
      expect(svg.content.toString(), picture).toMatch(/^<svg[\s\S]*<\/svg>\s*$/);
      expect(svg.content.toString(), picture).not.toMatch(/NaN|Infinity|undefined/);
      for (const each of words[picture]!) expect(svg.content.toString(), picture).toContain(each);
    }
    expect(await page.isDisabled('#download-svg')).toBe(true);
    await page.context().close();
  });

  it('with friction are those along the surface too, of a ball that hops under a table', async () => {
    const page = await site.open('?body=disk&nu=0.33&v=0.1', { reducedMotion: 'reduce' });
    await settled(page);
    expect(await page.isVisible('#tangential')).toBe(false);
    expect(await page.isVisible('#field-angle')).toBe(false);
    await page.selectOption('#preset', { label: 'Superball under a table' });
    await page.waitForFunction(() => /^0\.\d+ ± /.test(document.getElementById('tangential')!.textContent!));
    await settled(page);
    expect(page.url()).toMatch(/&v=4\.95\d+&mu=1&angle=25&spin=40$/);
    expect(await page.textContent('#command-line')).toContain('stoss oblique --body sphere');
    expect(await page.textContent('#afterwards')).toMatch(/Spin of the first body after the impact-\d+\.\d+ ± \d+\.\d+\srad\/s/);
    await page.waitForSelector('#hops canvas[aria-label*="2, table: ε 0.871"]');
    await page.waitForSelector('#scene canvas[aria-label*="% sticks"]');
    await page.locator('#angle-chart .chart-area').press('ArrowRight');
    await page.waitForFunction(() => location.search.includes('&angle=26'));
    await page.fill('#field-friction', '7');
    expect(await page.textContent('#field-friction-problem')).toContain('Friction: got 7, allowed 0 to 5');
    await page.fill('#field-friction', '0');
    await page.waitForSelector('#tangential', { state: 'hidden' });
    expect(await page.isVisible('#hops')).toBe(false);
    await page.context().close();
  });

  it('are at the speeds that are typed, as the command reads them', async () => {
    const page = await site.open(disk);
    await settled(page);
    await page.fill('#series', 'lin:0.1:0.3:nine');
    await page.press('#series', 'Tab');
    expect(await page.textContent('#series-problem')).toContain("speeds: got 'lin:0.1:0.3:nine'");
    await page.fill('#series', 'lin:0.1:0.3:9');
    await page.press('#series', 'Tab');
    expect(await page.isVisible('#series-problem')).toBe(false);
    const rows = rowsOf(await wholeCurve(page));
    expect(rows.map((row) => row['speed[c]'])).toEqual(
      ['0.1', '0.125', '0.15', '0.175', '0.2', '0.225', '0.25', '0.275', '0.3']);
    await page.context().close();
  });

  it.skipIf(command === undefined)('are those of the native command to 1e-12, for a whole curve', async () => {
    const page = await site.open(disk);
    await settled(page);
    const csv = await wholeCurve(page);
    const line = /^# command: stoss (.*)$/m.exec(csv)![1]!.split(' ');
    const native = execFileSync(command!, line, { encoding: 'utf8', stdio: 'pipe' });
    const [ours, theirs] = [rowsOf(csv), rowsOf(native)];
    expect(ours.length).toBe(49);
    expect(theirs.length).toBe(49);
    ours.forEach((row, index) => {
      for (const column of ['speed[c]', 'restitution', 'restitution_error']) {
        const value = Number(theirs[index]![column]);
        expect(Math.abs(Number(row[column]) - value), `${column} ${row['speed[c]']}`).toBeLessThanOrEqual(1e-12);
      }
    });
    await page.context().close();
  });

  it('need no network once the page is there', async () => {
    const page = await site.open(disk);
    await settled(page);
    await page.context().setOffline(true);
    await page.check('input[name=body][value=sphere]', { force: true });
    await page.selectOption('#against', 'same');
    expect(await settled(page)).toMatch(/±/);
    expect((await downloaded(page, '#download-header')).content.toString()).toContain('restitution');
    await page.context().close();
  });

  it('go on when workers are killed in the middle', async () => {
    const page = await site.open(disk);
    await settled(page);
    const header = downloaded(page, '#download-header');
    await page.waitForTimeout(50);
    for (const worker of page.workers()) {
      await worker.evaluate(() => void setTimeout(() => {
        throw new Error('killed by the test');
      }));
    }
    expect((await header).content.toString()).toContain('restitution');
    await page.fill('#field-speed', '0.3');
    expect(await settled(page)).toMatch(/±/);
    const killed = site.troubles.splice(0).filter((line) => !line.includes('killed by the test'));
    expect(killed).toEqual([]);
    await page.context().close();
  });

  it('can be kept for comparison, up to five', async () => {
    const page = await site.open(disk);
    for (const poisson of ['0.1', '0.2', '0.3', '0.4', '0.5']) {
      await page.fill('#field-poisson', poisson);
      await page.click('#keep');
    }
    expect(await page.locator('#kept li').count()).toBe(5);
    expect(await page.isDisabled('#keep')).toBe(true);
    await page.locator('#kept button').first().click();
    expect(await page.locator('#kept li').count()).toBe(4);
    await page.waitForURL(/keep=body:disk,nu:0\.5$/);
    await page.context().close();
  });

  it('of the latest input win, however fast the inputs change', async () => {
    const page = await site.open(disk);
    await settled(page);
    const slider = page.locator('#speed-slider');
    for (const place of [100, 900, 200, 800, 300, 700, 878]) await slider.fill(String(place));
    await settled(page);
    const dragged = await page.textContent('#epsilon');
    const speed = await page.inputValue('#field-speed');
    const alone = await site.open(`?body=disk&nu=0.33&v=${speed}`);
    expect(await settled(alone)).toBe(dragged);
    await page.context().close();
    await alone.context().close();
  });

  it('that take long are announced, and do not hold up the next', async () => {
    const ball = 'body=sphere&units=SI&nu=0.3&E=2.1e11&rho=7850&R=0.005&against=half-space&nu2=0.22&E2=7e10&rho2=2500';
    const page = await site.open(`?${ball}&v=1`);
    const before = await settled(page);
    await page.fill('#field-speed', '0.001');
    // Read at once: the value may come a moment later.
    const seen = await page.waitForFunction(() => {
      const text = (id: string): string | null => document.getElementById(id)!.textContent;
      return document.getElementById('result')!.dataset.slow !== undefined && [text('result-state'), text('epsilon')];
    });
    expect(await seen.jsonValue()).toEqual(['computing; this is the last value', before]);
    await page.fill('#field-speed', '2');
    expect(await settled(page)).toMatch(/^0\.99\d+ ± /);
    expect(await page.textContent('#epsilon')).not.toBe(before);
    await page.context().close();
  });

  it('take less than 1.5 MB to transfer', () => {
    const bytes = [...site.transferred.values()].reduce((sum, its) => sum + its, 0);
    expect([...site.transferred.keys()].some((path) => path.endsWith('.wasm'))).toBe(true);
    expect(bytes).toBeLessThan(1.5e6);
  });
});
