// Serves the page with the core of the tests: npx vite -c tests/fake/vite.config.ts
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { equations } from '../../plugins/equations';

const here = (file: string): string => fileURLToPath(new URL(file, import.meta.url));
const fake: Plugin = {
  name: 'fake-core',
  enforce: 'pre',
  resolveId: (id) => (id.endsWith('core/client') ? here('core.ts') : null),
};

export default defineConfig({
  root: here('../..'),
  base: './',
  define: { STOSS_VERSION: '"0"' },
  plugins: [fake, equations('')],
  server: { host: '127.0.0.1' }, // as in web/vite.config.ts
  build: { outDir: here('../../../build/web-fake'), emptyOutDir: true, target: 'es2022', assetsInlineLimit: 0 },
});
