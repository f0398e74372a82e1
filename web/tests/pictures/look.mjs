// Takes pictures of the pictures: node tests/pictures/look.mjs ADDRESS FOLDER. Look at each.
import { mkdirSync } from 'node:fs';
import { chromium } from 'playwright-core';

const [address, folder, ...queries] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const browser = await chromium.launch({
  executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-sync'],
});
for (const query of queries) {
  for (const [width, scheme] of [[1000, 'light'], [1000, 'dark'], [360, 'light']]) {
    if (process.env.ONLY && !process.env.ONLY.includes(`${width}${scheme}`)) continue;
    const page = await browser.newPage({
      viewport: { width, height: 700 }, colorScheme: scheme, deviceScaleFactor: width === 360 ? 2 : 1,
      reducedMotion: 'reduce',
    });
    page.on('console', (message) => message.type() === 'error' && console.log(query, message.text()));
    page.on('pageerror', (error) => console.log(query, String(error)));
    await page.goto(`${address}?${query}`);
    await page.waitForFunction(() => window.pictures?.ready, null, { timeout: 60000 }).catch(() => console.log('slow'));
    await page.waitForTimeout(300);
    const name = `${query.replace(/[^a-z0-9.-]+/gi, '_')}_${width}_${scheme}.png`;
    await page.screenshot({ path: `${folder}/${name}`, fullPage: true });
    await page.close();
  }
}
await browser.close();
