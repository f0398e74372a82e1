import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { renderEquations, withWords } from '../../plugins/equations';

const page = readFileSync(new URL('../../index.html', import.meta.url), 'utf8');
const words = JSON.parse(readFileSync(new URL('../../words.json', import.meta.url), 'utf8')) as Record<string, string>;
const text = withWords(page, words);
const rendered = renderEquations(text);

describe('equations', () => {
  it('are all rendered, without anything to load', () => {
    const count = text.match(/<tex/g)!.length;
    expect(count).toBeGreaterThan(10);
    expect(rendered).not.toContain('tex>');
    expect(rendered.match(/<math /g)!.length).toBe(count);
    expect(rendered.match(/display="block"/g)!.length).toBe(text.match(/<tex display>/g)!.length);
    expect(rendered).not.toMatch(/katex|<annotation/);
  });
  it('that are wrong stop the build, and so do words that are not in the table', () => {
    expect(() => withWords('{{page.titel}}', words)).toThrow('words.json has no “page.titel”');
    expect(() => renderEquations('<tex>\\frac{1</tex>')).toThrow();
  });
});
