// Parts of the page that are made when it is built: its words, and equations in MathML, which browsers draw themselves.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import katex from 'katex';
import type { Plugin } from 'vite';

/** Replace <tex>…</tex>, and <tex display>…</tex>, by MathML. */
export function renderEquations(html: string): string {
  return html.replace(/<tex( display)?>([\s\S]*?)<\/tex>/g, (_, display: string | undefined, source: string) =>
    katex.renderToString(source.trim().replaceAll('&amp;', '&').replaceAll('&lt;', '<'), {
      displayMode: display !== undefined, throwOnError: true, strict: true, output: 'mathml',
    }).replace(/<\/?span[^>]*>|<annotation[\s\S]*?<\/annotation>/g, ''),
  );
}

/** A text with the words of a table in place of their {{names}}. */
export function withWords(text: string, words: Readonly<Record<string, string>>): string {
  return text.replace(/\{\{([\w.]+)\}\}/g, (_, name: string) => {
    if (words[name] === undefined) throw new Error(`words.json has no “${name}”`);
    return words[name];
  });
}

/** The plugin: {{words}}, `%ICON%` and `%DOCUMENTATION%` in index.html and its like, and equations. The icon is in the page, since
 *  browsers ask for it again whenever the address changes. `documentation` is the address of the manual, '' for none:
 *  then what stands between <!-- documentation --> and its end is left out. Of the words, code does without the groups
 *  `elsewhere`. */
export function equations(
  documentation: string, words: Readonly<Record<string, string>>, elsewhere: readonly string[],
): Plugin {
  return {
    name: 'stoss-equations',
    enforce: 'pre',
    resolveId: (id) => (id === '#words' ? '\0words' : null),
    load: (id) => (id === '\0words' ? `export default ${JSON.stringify(
      Object.fromEntries(Object.entries(words).filter(([name]) => !elsewhere.includes(name.split('.')[0]!))))}` : null),
    transformIndexHtml: {
      order: 'pre',
      handler(html, { filename }) {
        const folder = resolve(filename, '..');
        const whole = withWords(html.replace('<html lang="en">', '<html lang="{{language}}">'), words);
        const linked = whole.replace(/<!-- documentation -->([\s\S]*?)<!-- end -->/g, (_, text: string) =>
          documentation === '' ? '' : text.replaceAll('%DOCUMENTATION%', documentation));
        const icon = encodeURIComponent(readFileSync(resolve(folder, 'src/icon.svg'), 'utf8'));
        return renderEquations(linked.replace('%ICON%', `data:image/svg+xml,${icon}`));
      },
    },
  };
}
