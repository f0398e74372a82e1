// Built in addition to the page: the native command and the Python package.
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const build = fileURLToPath(new URL('../../../build/', import.meta.url));

/** The command, undefined where it is not built. */
export const command = there(process.env.STOSS_COMMAND ?? `${build}release/cli/stoss`);

/** A Python that has stoss, undefined where it is not built. */
export const python = there(process.env.STOSS_PYTHON ?? `${build}venv/bin/python`);

function there(path: string): string | undefined {
  return existsSync(path) ? path : undefined;
}
