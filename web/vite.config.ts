import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import { equations } from './plugins/equations';

// The page is served from any folder: all addresses are relative. STOSS_DOCUMENTATION is the address of the manual,
// which may be relative too; without it the page has no link to one.
export default defineConfig({
  base: './',
  // What scripts/web.sh has built of web/core.
  resolve: { alias: { '@wasm': fileURLToPath(new URL('../build/wasm', import.meta.url)) } },
  plugins: [equations(process.env.STOSS_DOCUMENTATION ?? '')],
  build: { outDir: '../build/web', emptyOutDir: true, target: 'es2022', assetsInlineLimit: 0 },
  worker: { format: 'es' },
  test: { include: ['tests/{core,unit,native,page}/**/*.test.ts'] },
});
