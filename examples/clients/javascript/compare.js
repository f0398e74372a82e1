// What all clients here do: they drop a body at several speeds, in two steps of time, and compare.
import { stoss_restitution } from "./restitution.mjs";

// `drop(speed, step)` returns the speeds before and after an impact; their ratio must be that of the table.
export function compare(drop, accuracy) {
  console.log(" step/s  before/(m/s)  after/before  eps of the table  difference");
  for (const speed of [0.02, 0.1, 0.5, 2, 8]) {
    for (const step of [1e-3, 1 / 60]) {
      const [before, after] = drop(speed, step);
      const [found, wanted] = [after / before, stoss_restitution(before)];
      const numbers = [before.toFixed(7).padStart(13), found.toFixed(9).padStart(13), wanted.toFixed(9).padStart(17)];
      console.log(step.toFixed(5), ...numbers, (found - wanted).toExponential(1).padStart(11));
      if (!(Math.abs(found - wanted) <= accuracy)) process.exitCode = 1;
    }
  }
}
