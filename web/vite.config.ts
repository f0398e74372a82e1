import { defineConfig } from 'vitest/config';

// The page is served from any folder: all addresses are relative.
export default defineConfig({
  base: './',
  build: { outDir: '../build/web', emptyOutDir: true, target: 'es2022' },
  worker: { format: 'es' },
  test: { include: ['tests/unit/**/*.test.ts'] },
});
