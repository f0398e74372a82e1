// Bodies that a user has from a file: any body by its modes at a point. The address can only name them.
import { requireDocument, unitsOf } from '../core/local';
import { type Body, type BodyFile, CoreError, type Encounter } from '../core/protocol';
import { documentOf } from './document';
import { defaults, type Inputs, unitBody, withKind } from './inputs';
import { withSi } from './units';

const loaded = new Map<string, BodyFile>();

/** The body of a file that was opened on this page. */
export function fileNamed(name: string): BodyFile | undefined {
  return loaded.get(name);
}

/** The body in a file. Throws CoreError with one line for what is none. */
export function openFile(name: string, text: string): BodyFile {
  let document: unknown;
  try {
    document = JSON.parse(text);
  } catch (error) {
    throw new CoreError(`${name}: got no JSON document, allowed one (${(error as Error).message})`);
  }
  const title = (document as { name?: unknown } | null)?.name;
  // The name stands in links and in command lines.
  const file: BodyFile = {
    name: name.replace(/[^\w.-]+/g, '_'), title: typeof title === 'string' ? title : name, document,
  };
  requireDocument(documentOf(alone(file)).replace(JSON.stringify(document), () => text));
  loaded.set(file.name, file);
  return file;
}

const alone = (file: BodyFile): Encounter =>
  ({ ...defaults.encounter, kind: 'sphere', si: true, first: unitBody, firstFile: file });

/** A sphere of the curvature and the material of the body, for what asks for numbers. */
export function standIn(file: BodyFile): Body {
  const { speed, time } = unitsOf(alone(file));
  const { young, poisson, density, loss_time = 0 } = file.document as Record<string, number>;
  return { ...unitBody, young: young!, poisson: poisson!, density: density!, loss_time, radius: speed * time };
}

/** A body of a file as the first, or as what it meets. */
export function withFile(inputs: Inputs, second: boolean, file: BodyFile): Inputs {
  const { encounter, ...how } = withSi(inputs);
  const ball = encounter.kind === 'sphere' ? encounter : withKind(encounter, 'sphere');
  const changed: Encounter = second ? { ...ball, against: 'body', second: standIn(file), secondFile: file }
    : { ...ball, first: standIn(file), firstFile: file };
  return { ...how, encounter: changed };
}
