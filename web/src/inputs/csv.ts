// A curve as CSV, as `stoss restitution --format csv` writes it: the columns the page knows, in its order.
import { unitsOf } from '../core/local';
import type { CurvePoint, Encounter } from '../core/protocol';
import { commandArguments } from './command_line';
import { shortest } from './number';

// The build takes it from CMakeLists.txt.
declare const STOSS_VERSION: string;

export const version = STOSS_VERSION;

/** The text of the file: comments that say what it is, one line of columns, one row for each speed, slowest first. */
export function curveCsv(encounter: Encounter, points: readonly CurvePoint[], tolerance = 1e-3): string {
  const sorted = [...points].sort((a, b) => a.speed - b.speed);
  const speeds = sorted.map((point) => shortest(point.speed)).join(',');
  const { kind, si } = encounter;
  const { speed: c, first: { poisson } } = unitsOf(encounter);
  const head = [
    `# stoss ${version}: restitution`,
    `# command: stoss ${commandArguments(encounter, speeds, tolerance).join(' ')} --format csv`,
    `# body: ${kind}`,
    `# tolerance: ${shortest(tolerance)}`,
  ];
  const columns = [
    ...(poisson === undefined ? [] : ['poisson']), 'speed[c]', ...(si ? ['speed_si[m/s]'] : []),
    'restitution', 'restitution_error', 'converged',
  ];
  const rows = sorted.map((point) => [
    ...(poisson === undefined ? [] : [shortest(poisson)]),
    shortest(point.speed / c),
    ...(si ? [shortest(point.speed)] : []),
    shortest(point.restitution),
    Number.isFinite(point.error) ? shortest(point.error) : 'unknown',
    String(point.converged),
  ]);
  return [...head, columns.join(','), ...rows.map((row) => row.join(','))].join('\n') + '\n';
}
