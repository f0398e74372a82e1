// The built page, served from a folder and opened in Debian's Chromium.
import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { type IncomingMessage, type Server, type ServerResponse, createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { type Browser, type BrowserContextOptions, type Page, chromium } from 'playwright-core';

const folder = process.env.STOSS_PAGE ?? fileURLToPath(new URL('../../../build/web', import.meta.url));
const executablePath = process.env.STOSS_CHROMIUM ?? '/usr/bin/chromium';

/** Why the page cannot be tested here; '' if it can. */
export const missing = !existsSync(join(folder, 'index.html')) ? 'the page is not built' :
  !existsSync(executablePath) ? 'there is no Chromium' : '';

/** What the page without a real ball begins with. */
export const disk = '?body=disk&nu=0.33&v=0.1';

const types: Record<string, string> = {
  '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.woff2': 'font/woff2',
  '.wasm': 'application/wasm',
};

export interface Site {
  /** A new page; what it logs as an error, or asks of the network beyond this site, is in `troubles`. */
  open(query?: string, options?: BrowserContextOptions, before?: (page: Page) => Promise<void>): Promise<Page>;
  readonly troubles: string[];
  readonly address: string;
  /** What was asked for so far, by its path: bytes after gzip. */
  readonly transferred: Map<string, number>;
  close(): Promise<void>;
}

/** What the core for this machine says, which a page without WebAssembly asks (tests/page_core). */
function answer(request: IncomingMessage, response: ServerResponse, question: string): void {
  const asked = spawn(process.env.STOSS_PAGE_CORE!, question === '' ? [] : [question]);
  request.pipe(asked.stdin);
  asked.stdout.pipe(response);
}

/** Serve the page as any static server would, from a folder inside the site. */
export async function startSite(root = folder): Promise<Site> {
  const transferred = new Map<string, number>();
  const server: Server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://x');
    if (pathname.startsWith('/page-core/')) return void answer(request, response, pathname.slice(11));
    const path = pathname.replace(/^\/some\/folder/, '').replace(/\/$/, '/index.html');
    readFile(join(root, normalize(path))).then(
      (body) => {
        transferred.set(path, gzipSync(new Uint8Array(body), { level: 9 }).length);
        response.writeHead(200, { 'content-type': types[extname(path)] ?? 'text/plain' }).end(body);
      },
      () => response.writeHead(404).end());
  }).listen(0, '127.0.0.1');
  await new Promise((resolve) => server.once('listening', resolve));
  const address = `http://127.0.0.1:${(server.address() as AddressInfo).port}/some/folder/`;
  const browser: Browser = await chromium.launch({
    executablePath,
    args: ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
      '--disable-background-networking', '--disable-component-update', '--disable-sync'],
  });
  const troubles: string[] = [];
  return {
    troubles,
    address,
    transferred,
    async open(query = '', options = {}, before = async () => {}) {
      const context = await browser.newContext({ acceptDownloads: true, ...options });
      await context.grantPermissions(['clipboard-read', 'clipboard-write']);
      const page = await context.newPage();
      page.on('pageerror', (error) => troubles.push(error.message));
      page.on('console', (message) => {
        if (message.type() === 'error') troubles.push(message.text());
      });
      page.on('request', (request) => {
        if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(address) && !/\/page-core\//.test(request.url())) troubles.push(request.url());
      });
      page.on('response', (response) => {
        if (response.status() >= 400) troubles.push(`${response.status()} ${response.url()}`);
      });
      await before(page);
      await page.goto(address + query);
      return page;
    },
    async close() {
      await browser.close();
      server.close();
    },
  };
}

/** Wait until ε is there at the final tolerance. */
export async function settled(page: Page): Promise<string> {
  await page.waitForFunction(() => {
    const result = document.getElementById('result')!;
    return result.dataset.stage === 'final' && result.dataset.stale === undefined;
  }, undefined, { timeout: 30_000 });
  return (await page.textContent('#epsilon')) ?? '';
}
