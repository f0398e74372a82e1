// All words that a reader sees are in one table: none stands in the sources, and none in the table is unused.
import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import ts from 'typescript';
import { describe, expect, it } from 'vitest';
import words from '#words';
import { presets } from '../../src/inputs/inputs';
import { ask } from '../core/wasm';

const folder = fileURLToPath(new URL('../../src/', import.meta.url));
const pages = ['index.html', 'cradle.html'].map((name) =>
  ({ name, text: readFileSync(new URL(`../../${name}`, import.meta.url), 'utf8') }));
const sources = readdirSync(folder, { recursive: true, encoding: 'utf8' })
  .filter((name) => name.endsWith('.ts') && !name.startsWith('generated'))
  .map((name) => ({ name, text: readFileSync(folder + name, 'utf8') }));

/** Code, names of the core, and what only developers see. */
const others = [/^index\.html has no/, /^with the id/, /^there is no material/, /^\(prefers-/, /^px;? /, /^Infinity$/, /^bearing steel$/,
  /^import stoss$/, /^--format csv$/];

/** What a reader sees of HTML: its text, and what screen readers say. */
function shownOf(html: string): string[] {
  const spoken = [...html.matchAll(/\b(?:aria-label|aria-valuetext|title|alt|placeholder)="([^"]*)"/g)].map(([, text]) => text!);
  return [...html.replace(/<!--.*?-->|<(pre|tex|style)[\s\S]*?<\/\1>/g, '').split(/<[^>]*>/), ...spoken];
}

/** Strings of a source that a reader may see: text of templates of HTML, and others that look like words. */
function found(text: string): string[] {
  const all: string[] = [];
  const wordy = (each: string): boolean => /[A-Za-z’]{2,}[,;:]? [A-Za-z’]{2,}/.test(each) || /^[A-Z][a-z]{2,}\b/.test(each);
  const visit = (node: ts.Node): void => {
    if (ts.isTaggedTemplateExpression(node)) {
      const raw = ts.isNoSubstitutionTemplateLiteral(node.template) ? node.template.text
        : [node.template.head.text, ...node.template.templateSpans.map(({ literal }) => literal.text)].join('0');
      all.push(...shownOf(raw).filter((each) => /[A-Za-z]{2,}/.test(each)));
      if (!ts.isNoSubstitutionTemplateLiteral(node.template)) node.template.templateSpans.forEach(({ expression }) => visit(expression));
      return;
    }
    if (ts.isTypeNode(node) || ts.isImportDeclaration(node)) return;
    if (ts.isStringLiteralLike(node) || ts.isTemplateHead(node) || ts.isTemplateMiddleOrTemplateTail(node)) {
      if (wordy(node.text)) all.push(node.text);
    }
    ts.forEachChild(node, visit);
  };
  visit(ts.createSourceFile('x.ts', text, ts.ScriptTarget.ES2022, true));
  return all.map((each) => each.trim()).filter((each) => each !== '' && !others.some((other) => other.test(each)));
}

describe('words', () => {
  it.each(sources.map(({ name, text }) => [name, text]))('are not in %s', (_, text) => expect(found(text)).toEqual([]));
  it.each(pages.map(({ name, text }) => [name, text]))('are not in %s', (_, text) => {
    const own = shownOf(text!.replace(/\{\{[\w.]+\}\}/g, '')).filter((each) => /[A-Za-z]{2,}/.test(each));
    expect(own.map((each) => each.trim())).toEqual(['stoss']);
  });
  it('name each channel and constant of the core', () => {
    const { encounter, speed } = presets.find(({ name }) => name === 'preset.pane')!;
    const [answer] = ask('prediction', encounter, { speeds: [speed], tolerance: 1e-2, constants: true }).all;
    const names = [
      ...answer!.channels.flatMap(({ name }) => [`channel.${name}`, `where.${name}`]),
      ...answer!.influences.map(({ constant }) => `constant.${constant.replace('against.', '')}`),
    ];
    expect(names.length).toBeGreaterThan(15);
    expect(names.filter((name) => !(name in words))).toEqual([]);
  });
  it('are all used', () => {
    const code = [...sources, ...pages].map(({ text }) => text).join('\n');
    const named = new Set([...code.matchAll(/['"{]([a-z_]+\.[\w.]+)['"}]/g)].map(([, name]) => name));
    const made = new Set([...code.matchAll(/`([a-z_]+)\.\$\{/g)].map(([, group]) => group));
    const unused = Object.keys(words).filter((name) => !named.has(name) && !made.has(name.split('.')[0]) && name !== 'language');
    expect(unused).toEqual([]);
  });
});
