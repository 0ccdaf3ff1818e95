// The first page: a scene that moves, is dragged and has one slider, a picture for each lesson, and links to the rest.
// And one figure or scene alone, for a frame in another page.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { live, lessons, open, pages, quit, serve, site, url } from './browser.mjs';

after(quit);

const cover = pages.includes('index.html') && lessons.some(name => name.startsWith('03'));
const only = { skip: !cover && 'only of the whole course' };
const scene = 'figure[data-hold]';
const ready = async more => {
  const tab = await open(url('index.html'), more);
  await tab.waitForSelector('html[data-ready]', { timeout: 60_000 });
  await tab.waitForSelector(`${scene} .hand`);
  return tab;
};
const stretch = tab => tab.$eval(`${scene} .reading`, reading => reading.textContent.match(/worst link is (\S+) cm/)?.[1]);

for (const { width, height } of [{ width: 1440, height: 900 }, { width: 390, height: 844 }])
  test(`the cover's scene, its slider and its number are on the first screen at ${width} × ${height}`, only, async () => {
    const tab = await ready({ width, height });
    const places = await tab.evaluate(scene => ['.stage', '.knobs .setting', '.reading'].map(part => document.querySelector(`${scene} ${part}`).getBoundingClientRect().toJSON()), scene);
    for (const { top, bottom, left, right } of places) assert.ok(top >= 0 && bottom <= height && left >= 0 && right <= width, JSON.stringify(places));
    assert.equal((await tab.$$('.setting')).length, 1, 'one slider');
    await tab.close();
  });

test('something moves on the cover by itself, and rests where a reader wants less motion', only, async () => {
  const tab = await ready({ before: tab => tab.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'no-preference' }]) });
  const picture = () => tab.$eval(`${scene} .picture`, picture => picture.innerHTML);
  const before = await picture();
  await tab.waitForFunction((scene, before) => document.querySelector(`${scene} .picture`).innerHTML !== before, { timeout: 10_000 }, scene, before);
  await tab.click(`${scene} .player [aria-label=pause]`);
  await tab.close();

  const still = await ready();
  const first = await still.$eval(`${scene} .picture`, picture => picture.innerHTML);
  await new Promise(resolve => setTimeout(resolve, 600));
  assert.equal(await still.$eval(`${scene} .picture`, picture => picture.innerHTML), first);
  await still.close();
});

test('fewer sweeps stretch the chain of the cover more', only, async () => {
  const tab = await ready();
  const after = async sweeps => {
    await tab.$eval('.setting input[type=text]', (field, sweeps) => { field.value = sweeps; field.dispatchEvent(new Event('change')); }, String(sweeps));
    await tab.waitForFunction(sweeps => location.hash.includes(`sweeps=${sweeps}`), {}, sweeps);
    await tab.click(`${scene} .player [aria-label^="reset"]`);
    for (let i = 0; i < 20; ++i) {
      const before = await tab.$eval(`${scene} .reading`, reading => reading.textContent);
      await tab.click(`${scene} .player [aria-label="one step"]`);
      await tab.waitForFunction((scene, before) => document.querySelector(`${scene} .reading`).textContent !== before, {}, scene, before);
    }
    return +(await stretch(tab)).replace('−', '-');
  };
  const few = await after(2), many = await after(60);
  assert.ok(few > 2 * many && many > 0, `${few} cm with 2 sweeps, ${many} cm with 60`);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('each lesson has a picture of its own, and no summary cites an equation', only, async () => {
  const tab = await open(url('index.html'));
  const cards = await tab.$$eval('.card', cards => cards.map(card => ({ source: card.querySelector('img')?.getAttribute('src'), summary: card.querySelector('.summary').textContent })));
  assert.equal(cards.length, pages.filter(page => /^\d\d_/.test(page)).length);
  assert.equal(new Set(cards.map(({ source }) => source)).size, cards.length);
  for (const { source, summary } of cards) {
    assert.ok(existsSync(join(site, source)), source);
    assert.doesNotMatch(summary, /\(\d+\)/);
  }
  const links = await tab.$$eval('.ways a', all => all.map(link => link.getAttribute('href')));
  assert.ok(links.includes('constraints_by_hand.epub') && links.some(link => link.startsWith('https://')), links.join());
  const image = await tab.$eval('meta[property="og:image"]', meta => meta.content);
  assert.ok(existsSync(join(site, image)), image);
  await tab.close();
});

const embedding = lessons.find(name => name.startsWith('04'));
for (const [kind, width] of [['figure', 700], ['film', 700], ['hold', 360]])
  test(`?only= shows one ${kind} alone and tells the page around it its height`, async () => {
    const server = await serve();
    const whole = await open(`${server.address}${embedding}.html`);
    const name = await whole.$eval(`figure[data-${kind}]`, (figure, kind) => figure.dataset[kind], kind);
    await whole.close();
    const tab = await open(`${server.address}assets/icon.svg`, { width, height: 500 });
    await tab.goto(`${server.address}404`).catch(() => {});
    await tab.setContent(`<iframe style="width: 100%; border: 0" src="${server.address}${embedding}.html?only=${name}"></iframe><script>
      addEventListener('message', ({ data }) => { if (data.byhand) { document.querySelector('iframe').height = data.height; document.body.dataset.told = data.byhand; } });
    </script>`);
    await tab.waitForSelector('body[data-told]', { timeout: 30_000 });
    assert.equal(await tab.$eval('body', body => body.dataset.told), name);
    const frame = await (await tab.$('iframe')).contentFrame();
    await frame.waitForSelector('html[data-ready]', { timeout: 60_000 });
    await frame.waitForFunction(() => document.documentElement.scrollHeight <= innerHeight + 1, { timeout: 10_000 });
    const seen = await frame.$$eval('main *', all => all.filter(one => one.checkVisibility() && !one.closest('.alone') && !one.contains(document.querySelector('.alone'))).map(one => one.outerHTML.slice(0, 80)));
    assert.deepEqual(seen, []);
    assert.ok(await frame.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth));
    assert.ok(await frame.$eval('.alone .setting, .alone .player', control => control.checkVisibility()));
    await tab.close();
    server.close();
  });
