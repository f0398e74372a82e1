// The address follows the inputs: one entry of the history for each change, however long a drag takes.
import { fromAddress, toAddress } from '../inputs/address';
import type { Inputs } from '../inputs/inputs';

/** Browsers refuse to change the address more often than some 100 times in 30 s. */
const pause = 300;

/** Keep the address up to date; `go` gets the inputs of an entry that the user goes back or forward to. The result
 *  writes inputs into the address, soon; `settled` ends a drag or typing. */
export function createAddressBar(
  go: (inputs: Inputs, problem: string) => void,
): (inputs: Inputs, settled: boolean) => void {
  let inChange = false;
  let timer: number | undefined;
  let waiting: string | undefined;

  function flush(): void {
    clearTimeout(timer);
    timer = undefined;
    if (waiting === undefined) return;
    const address = `?${waiting}`;
    waiting = undefined;
    if (address === location.search) return;
    if (inChange) history.replaceState(null, '', address);
    else history.pushState(null, '', address);
    inChange = true;
  }

  addEventListener('popstate', () => {
    waiting = undefined;
    inChange = false;
    const { inputs, problem } = fromAddress(location.search);
    go(inputs, problem);
  });

  return (inputs, settled) => {
    waiting = toAddress(inputs);
    if (!settled) {
      timer ??= window.setTimeout(flush, pause);
      return;
    }
    flush();
    inChange = false;
  };
}
