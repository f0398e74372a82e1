// All words of the page: those of one table, words.json, of which another one is a translation.
import table from '#words';

export type Word = keyof typeof table;

/** A text of the table with values in place of their {names}. */
export function say(word: Word, values: Readonly<Record<string, string | number>> = {}): string {
  return table[word].replace(/\{(\w+)\}/g, (whole, name: string) => String(values[name] ?? whole));
}
