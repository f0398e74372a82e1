// Bodies that a user has from a file: any body by its modes at a point. The address can only name them.
import { requireDocument } from '../core/local';
import { CoreError, type Encounter } from '../core/protocol';
import { documentOf, meetingOf, ofFile } from './document';
import { type Inputs, withKind } from './inputs';
import { withSi } from './units';
import { say } from '../drawing/words';

const loaded = new Map<string, object>();
const names = new WeakMap<object, string>();

/** The body of a file that was opened on this page. */
export function fileNamed(name: string): object | undefined {
  return loaded.get(name);
}

/** The name of such a file, and of its body. */
export function nameOf(file: object): string {
  return names.get(file)!;
}

export function titleOf(file: object): string {
  const { name } = file as { name?: unknown };
  return typeof name === 'string' ? name : nameOf(file);
}

/** The body in a file. Throws CoreError with one line for what is none. */
export function openFile(name: string, text: string): object {
  let body: object;
  try {
    body = JSON.parse(text) as object;
  } catch (error) {
    throw new CoreError(say('form.no_json', { name, why: (error as Error).message }));
  }
  const alone = documentOf({ first: ofFile(body), against: 'wall' } as Encounter);
  requireDocument(alone.replace(JSON.stringify(body), () => text));
  const short = name.replace(/[^\w.-]+/g, '_'); // which stands in links and in command lines
  loaded.set(short, body);
  names.set(body, short);
  return body;
}

/** A body of a file as the first, or as what it meets. */
export function withFile(inputs: Inputs, second: boolean, file: object): Inputs {
  const { encounter, ...how } = withSi(inputs);
  const sphere = meetingOf(encounter).kind === 'sphere' ? encounter : withKind(encounter, 'sphere');
  return { ...how, encounter: { ...sphere, [second ? 'against' : 'first']: ofFile(file) } };
}
