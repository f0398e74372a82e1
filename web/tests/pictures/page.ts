// Draws docs/images/page.png, the page as the documentation shows it: npx vite-node tests/pictures/page.ts
import { fileURLToPath } from 'node:url';
import { settled, startSite } from '../page/browser';

const path = fileURLToPath(new URL('../../../docs/images/page.png', import.meta.url));
const site = await startSite();
const page = await site.open('?body=sphere&nu=0.3&v=0.1&against=body&nu2=0.3&E2=1&rho2=1&R2=2', {
  viewport: { width: 1000, height: 780 }, colorScheme: 'light', reducedMotion: 'reduce',
});
await settled(page);
await page.waitForFunction(() => document.body.dataset.impact === 'current' &&
  !document.querySelector<HTMLInputElement>('.scene-time')!.disabled);
await page.fill('.scene-time', '130');
await page.locator('.scene-time').blur();
await page.waitForTimeout(1000);
await page.screenshot({ path });
await site.close();
