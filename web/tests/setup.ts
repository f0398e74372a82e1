// Before every file of tests: the page asks the core for units, ranges and numbers, and draws its charts.
import { afterEach } from 'vitest';
import { setLocal } from '../src/core/local';
import { loadPlot } from '../src/drawing/library';
import { core } from './core/wasm';

setLocal(core);
await loadPlot();

// What computes without a pause must let the runner be heard; tests that hold the clock replace its timers.
const soon = setImmediate;
afterEach(() => new Promise((done) => soon(done)));
