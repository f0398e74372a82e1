// Before every file of tests: the page asks the core for units, ranges and numbers.
import { setLocal } from '../src/core/local';
import { core } from './core/wasm';

setLocal(core);
