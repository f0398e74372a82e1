// A translation is one file: where all words of the table are marked, a reader finds no other words but those of the core.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { kinds, materials, ranges } from '../../src/generated/kinds';
import { type Site, disk, missing, startSite } from './browser';

const words = JSON.parse(readFileSync(new URL('../../words.json', import.meta.url), 'utf8')) as Record<string, string>;

/** Words of the core's tables, of units, of series and of names. */
const known = new Set(`stoss log rad kHz MHz GHz GPa MPa ${JSON.stringify([kinds, materials, ranges])}`.match(/[A-Za-z]{3,}/g));

/** All text and all names of elements, and what is written on canvases, but code and lines of the core. */
function texts(): string[] {
  const code = 'pre, script, style, annotation, noscript, #flags, #spoken, #yield, .warnings, #afterwards dt';
  const nodes = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  let whole = '';
  while (nodes.nextNode()) if (!nodes.currentNode.parentElement!.closest(code)) whole += ` ${nodes.currentNode.textContent}`;
  const names = ['aria-label', 'aria-valuetext', 'title', 'alt', 'placeholder'];
  const spoken = [...document.querySelectorAll('*')].flatMap((each) => names.map((name) => each.getAttribute(name) ?? ''));
  return [whole, document.title, ...spoken, ...(window as unknown as { drawn: string[] }).drawn];
}

/** What of a text stands outside of all marks. */
function unmarked(text: string): string {
  let [depth, rest] = [0, ''];
  for (const each of text) {
    if (each === '⟧') --depth;
    if (depth === 0) rest += each;
    if (each === '⟦') ++depth;
  }
  return rest;
}

describe.skipIf(missing !== '')(`a translation${missing && ` (${missing})`}`, () => {
  const folder = mkdtempSync(join(tmpdir(), 'stoss-'));
  let site: Site;
  beforeAll(async () => {
    const table = join(folder, 'words.json');
    writeFileSync(table, JSON.stringify(Object.fromEntries(Object.entries(words).map(([name, text]) =>
      [name, name === 'language' ? 'eo' : `⟦${text}⟧`]))));
    execFileSync('npx', ['vite', 'build', '--logLevel', 'error', '--outDir', join(folder, 'page')], {
      cwd: fileURLToPath(new URL('../../', import.meta.url)), env: { ...process.env, STOSS_WORDS: table },
    });
    site = await startSite(join(folder, 'page'));
  });
  afterAll(async () => {
    await site?.close();
    rmSync(folder, { recursive: true });
  });

  const friction = 'view=ball&material=rubber&R=0.02&material2=granite&drop=0.5&mu=0.5&angle=20';
  it.each([
    ['', '#predicted'], [`?${friction}`, '#hops output'], [disk, '.mode-bar'], [`${disk}&mu=0.3&angle=20&keep=body:sphere,nu:0.3`, '#kept li'],
    ['?body=sphere&units=SI&nu=0.3&E=2.1e11&rho=7810&R=0.005&eta=5.305164769729845e-9&v=1&colour=red', '.channels'],
    ['?body=rod&v=0.1&against=body&E2=1&rho2=1&R2=2.5&A2=1&view=simple', '#epsilon-short'],
  ])('shows no word beside the table: %s', async (query, there) => {
    const page = await site.open(query, { reducedMotion: 'reduce' }, async (fresh) => fresh.addInitScript(() => {
      const drawn: string[] = [];
      Object.assign(window, { drawn });
      const { fillText } = CanvasRenderingContext2D.prototype;
      CanvasRenderingContext2D.prototype.fillText = function write(words, ...rest) {
        drawn.push(words);
        fillText.call(this, words, ...rest);
      };
    }));
    await page.waitForSelector(there, { state: 'attached' });
    await page.waitForFunction(() => document.body.dataset.impact === 'current');
    await page.waitForTimeout(1000);
    const all = await page.evaluate(texts);
    expect(all.join().length).toBeGreaterThan(1000);
    expect(all.flatMap((each) => unmarked(each).match(/[A-Za-z’]{3,}/g) ?? []).filter((each) => !known.has(each.toLowerCase()) && !known.has(each))).toEqual([]);
    expect(await page.getAttribute('html', 'lang')).toBe('eo');
    await page.context().close();
  });
});
