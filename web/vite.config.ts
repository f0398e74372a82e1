import { readFileSync } from 'node:fs';
import { defineConfig } from 'vitest/config';
import { equations } from './plugins/equations';

const project = readFileSync(new URL('../CMakeLists.txt', import.meta.url), 'utf8');
const version = /project\(stoss VERSION ([0-9.]+)/.exec(project)?.[1];
if (version === undefined) throw new Error('CMakeLists.txt: the version of the project is not where it was');
const read = (file: string | URL) => JSON.parse(readFileSync(file, 'utf8')) as Record<string, string>;
// Words that a translation does not have are English.
const words = { ...read(new URL('words.json', import.meta.url)), ...(process.env.STOSS_WORDS ? read(process.env.STOSS_WORDS) : {}) };

// The page is served from any folder: all addresses are relative. STOSS_DOCUMENTATION is the address of the manual,
// which may be relative too; without it the page has no link to one. The mode `cradle` builds the page of the cradle
// beside the first one, which by itself has less to load. Of words, those of `how` stand in index.html only.
export default defineConfig(({ mode }) => ({
  define: { STOSS_VERSION: JSON.stringify(version) },
  base: './',
  plugins: [equations(process.env.STOSS_DOCUMENTATION ?? '', words, mode === 'production' ? ['how', 'cradle'] : ['how'])],
  build: {
    outDir: '../build/web', emptyOutDir: mode !== 'cradle', target: 'es2022', assetsInlineLimit: 0,
    rollupOptions: { input: mode === 'cradle' ? 'cradle.html' : 'index.html' },
  },
  worker: { format: 'es' },
  server: { host: '127.0.0.1' }, // a machine without a hosts file knows no localhost
  // No test is one of speed: what takes 1 s alone takes 5 beside a compiler. CTest ends what hangs.
  test: {
    include: ['tests/{core,unit,native,page,smoke}/**/*.test.ts'], setupFiles: ['tests/setup.ts'],
    testTimeout: 300_000, hookTimeout: 300_000,
  },
}));
