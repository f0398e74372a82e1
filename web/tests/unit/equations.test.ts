import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { renderEquations, withoutUnusedFonts, withWords } from '../../plugins/equations';

const page = readFileSync(new URL('../../index.html', import.meta.url), 'utf8');
const words = JSON.parse(readFileSync(new URL('../../words.json', import.meta.url), 'utf8')) as Record<string, string>;
const text = withWords(page, words);
const rendered = renderEquations(text);

describe('equations', () => {
  it('are all rendered, for the eye and for screen readers', () => {
    const count = text.match(/<tex/g)!.length;
    expect(count).toBeGreaterThan(10);
    expect(rendered).not.toContain('tex>');
    expect(rendered.match(/<math /g)!.length).toBe(count);
  });
  it('need no font but those that are shipped', () => {
    const others = ['mathbf', 'mathbb', 'mathcal', 'mathfrak', 'mathscr', 'mathsf', 'mathtt', 'mathit', 'boldsymbol',
      'amsrm', 'textbf', 'textit', 'delimsizing size3', 'delimsizing size4', 'delimsizing mult'];
    const used = others.filter((name) => new RegExp(`class="[^"]*\\b${name}\\b`).test(rendered));
    expect(used).toEqual([]);
  });
  it('that are wrong stop the build, and so do words that are not in the table', () => {
    expect(() => withWords('{{page.titel}}', words)).toThrow('words.json has no “page.titel”');
    expect(() => renderEquations('<tex>\\frac{1</tex>')).toThrow();
  });
  it('bring woff2 only', () => {
    const css = readFileSync(new URL('../../node_modules/katex/dist/katex.min.css', import.meta.url), 'utf8');
    const kept = withoutUnusedFonts(css);
    expect(kept.match(/url\([^)]*\)/g)!.length).toBe(4);
    expect(kept).not.toMatch(/\.(woff|ttf)\)/);
    expect(kept.replace(/@font-face\{[^}]*\}/g, '')).toBe(css.replace(/@font-face\{[^}]*\}/g, ''));
  });
});
