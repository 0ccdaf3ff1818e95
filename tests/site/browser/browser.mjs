// Opens pages of the site in Debian's Chromium. BYHAND_SITE: the folder of the site; BYHAND_MODULES: where npm put
// puppeteer-core and axe-core.
import assert from 'node:assert/strict';
import { createReadStream, existsSync, readdirSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const require = createRequire(join(resolve(process.env.BYHAND_MODULES), 'package.json'));
const puppeteer = require('puppeteer-core');
export const axe = require.resolve('axe-core/axe.min.js');

export const site = resolve(process.env.BYHAND_SITE);
export const quick = !!process.env.BYHAND_QUICK;
// Those that are live: lesson 10 needs engines that no browser has.
export const lessons = readdirSync(join(site, 'live')).filter(name => /^\d\d_.*\.js$/.test(name)).map(name => name.slice(0, -3)).sort();
export const pages = readdirSync(site).filter(name => name.endsWith('.html')).sort();
assert.ok(lessons.length > 0, `${site} holds no live lessons`);

export const url = (page, hash = '') => pathToFileURL(join(site, page)).href + hash;

let browser;
export const launch = () => browser ??= puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--allow-file-access-from-files=false', '--hide-scrollbars=false'],
  protocolTimeout: 600_000,
});
export const quit = async () => { await (await browser)?.close(); browser = undefined; };

export const launchFirefox = executablePath => puppeteer.launch({ browser: 'firefox', executablePath });

// A page with what its console complained of, and every request that left the folder.
export async function open(address, { width = 1440, height = 900, dark = false, script = true, touch = false, before } = {}) {
  const page = await (await launch()).newPage();
  page.complaints = [];
  page.on('console', message => { if (['error', 'warn'].includes(message.type())) page.complaints.push(message.text()); });
  page.on('pageerror', error => page.complaints.push(error.message));
  page.on('requestfailed', request => page.complaints.push(`${request.url()}: ${request.failure()?.errorText}`));
  await page.setViewport({ width, height, hasTouch: touch });
  await page.emulateMediaFeatures([
    { name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' },
    { name: 'prefers-reduced-motion', value: 'reduce' },  // a smooth scroll moves what a click aims at
  ]);
  await page.setJavaScriptEnabled(script);
  await before?.(page);
  await page.goto(address, { waitUntil: 'load' });
  return page;
}

// The page of a lesson once its program answers.
export async function live(lesson, { hash, address = url(`${lesson}.html`, hash), ...more } = {}) {
  const page = await open(address, more);
  await page.waitForSelector('html[data-ready]', { timeout: 60_000 });
  return page;
}

// Waits until every step that is stale and in reach has been told again.
export const settled = (page, timeout = 120_000) => page.waitForFunction(() => byhandPage.settled(), { timeout, polling: 50 });

// Moves the slider of a parameter beside the first step that offers it, as the keyboard or a finger would.
export async function move(tab, name, share) {
  await tab.evaluate((name, share) => {
    const slider = document.querySelector(`.setting[data-name="${name}"] input[type=range]`);
    slider.closest('section').scrollIntoView();
    slider.value = Math.round(slider.max * share);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  }, name, share);
  await settled(tab);
}

const types = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.png': 'image/png', '.woff2': 'font/woff2' };
// `more`: further headers.
export async function serve(folder = site, more = {}) {
  const server = createServer((request, response) => {
    const path = join(folder, decodeURIComponent(new URL(request.url, 'http://x').pathname));
    if (path.endsWith('favicon.ico')) return response.writeHead(204).end();  // browsers ask for it by themselves
    if (!path.startsWith(folder) || !existsSync(path) || !extname(path)) return response.writeHead(404).end();
    response.writeHead(200, { 'content-type': types[extname(path)] ?? 'application/octet-stream', ...more });
    createReadStream(path).pipe(response);
  });
  await new Promise(done => server.listen(0, '127.0.0.1', done));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => { server.close(); server.closeAllConnections(); } };
}
