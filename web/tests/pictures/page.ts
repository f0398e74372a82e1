// Draws the page as the documentation shows it, docs/images/page.png and page_oblique.png:
// npx vite-node tests/pictures/page.ts
import { fileURLToPath } from 'node:url';
import { startSite } from '../page/browser';

const site = await startSite();
for (const [name, query, time, width, height] of [
  ['page.png', '', '130', 1200, 780],
  ['page_oblique.png', '?body=disk&nu=0.33&v=0.1&mu=0.3&angle=30', '150', 1000, 760],
] as const) {
  const page = await site.open(query, {
    viewport: { width, height }, colorScheme: 'light', reducedMotion: 'reduce',
  });
  await page.waitForFunction(() => document.body.dataset.impact === 'current' &&
    !document.querySelector<HTMLInputElement>('.scene-time')!.disabled);
  await page.fill('#scene .scene-time', time);
  await page.locator('#scene .scene-time').blur();
  await page.evaluate(() => scrollTo(0, 0));
  await page.waitForTimeout(1000);
  await page.screenshot({ path: fileURLToPath(new URL(`../../../docs/images/${name}`, import.meta.url)) });
}
await site.close();
