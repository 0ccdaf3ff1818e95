// Every page of the site, as a reader opens it: from the disk, from a server, without JavaScript, narrow and wide, light
// and dark.
import assert from 'node:assert/strict';
import { readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { axe, lessons, live, open, pages, quick, quit, serve, site, url } from './browser.mjs';

after(quit);

for (const page of pages)
  test(`${page} loads from the disk without a complaint, and asks for nothing outside the site`, async () => {
    const asked = [];
    const tab = await open(url(page), { before: tab => tab.on('request', request => asked.push(request.url())) });
    if (lessons.includes(page.slice(0, -5))) await tab.waitForSelector('html[data-ready]', { timeout: 60_000 });
    const folder = url('').replace(/\/?$/, '/');
    assert.deepEqual(asked.filter(address => !address.startsWith(folder) && !/^(blob|data):/.test(address)), []);
    assert.deepEqual(tab.complaints, []);
    await tab.close();
  });

for (const page of pages.filter(page => /^\d\d_/.test(page) && !lessons.includes(page.slice(0, -5))))
  test(`${page} says why it has no sliders`, async () => {
    const tab = await open(url(page));
    assert.match(await tab.$eval('header.lesson', header => header.textContent), /This page has no sliders: the engines are native libraries/);
    await tab.close();
  });

// The maps of lesson 1 and the bitmaps of lesson 7 made pages of a megabyte.
for (const lesson of lessons.filter(name => /^0[1-478]/.test(name)))
  test(`${lesson}.html is at most 400 KB`, () => assert.ok(statSync(join(site, `${lesson}.html`)).size <= 400e3));

test('the whole site is at most 16 MB without what a reader downloads', { skip: quick && 'only of the whole course' }, context => {
  const size = path => statSync(path).isDirectory()
    ? readdirSync(path).filter(name => name !== 'data')  // tables behind Save
      .reduce((sum, name) => sum + size(join(path, name)), 0) : statSync(path).size;
  const read = readdirSync(site).filter(name => !['downloads', 'slides', 'practise', 'constraints_by_hand.epub'].includes(name))
    .reduce((sum, name) => sum + size(join(site, name)), 0);
  context.diagnostic(`${(read / 1e6).toFixed(1)} MB`);
  assert.ok(read <= 16e6, `${read} bytes`);
});

test('the lessons are live from a server too', async () => {
  const server = await serve();
  for (const lesson of quick ? lessons.slice(0, 1) : lessons) {
    const tab = await live(lesson, { address: `${server.address}${lesson}.html` });
    assert.deepEqual(tab.complaints, []);
    await tab.close();
  }
  server.close();
});

test('a strict content security policy stops nothing', async () => {
  const server = await serve(site, { 'content-security-policy': "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src blob:; img-src 'self' data:" });
  const tab = await live(lessons[0], { address: `${server.address}${lessons[0]}.html`, hash: '#h=1/120' });
  await tab.$eval('figure[data-hold], figure[data-film]', figure => figure.scrollIntoView());
  await tab.$eval('figure[data-film] .player [aria-label="one frame on"]', button => button.click());
  await tab.waitForFunction(() => +document.querySelector('figure[data-film] .player input').value === 1);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
  server.close();
});

for (const page of pages)
  test(`${page} is complete without JavaScript`, async () => {
    const tab = await open(url(page), { script: false });
    assert.deepEqual(tab.complaints, []);
    const seen = await tab.evaluate(() => {
      const visible = element => element.checkVisibility?.() ?? element.offsetParent !== null;
      return {
        heading: document.querySelector('h1')?.textContent.trim(),
        steps: document.querySelectorAll('section.step').length,
        // A hidden one waits for a script.
        pictures: [...document.querySelectorAll('.picture')].filter(picture => !picture.closest('[hidden]') && !picture.querySelector('svg, img')).length,
        dead: [...document.querySelectorAll('main button, main input')].filter(visible).length,
      };
    });
    assert.ok(seen.heading);
    if (lessons.includes(page.slice(0, -5))) assert.ok(seen.steps >= 5, `${seen.steps} steps`);
    assert.equal(seen.pictures, 0, 'figures without a picture');
    assert.equal(seen.dead, 0, 'buttons and fields that do nothing');
    await tab.close();
  });

for (const page of pages)
  for (const width of [360, 768, 1440])
    test(`${page} needs no horizontal bar at ${width} pixels`, async () => {
      const tab = lessons.includes(page.slice(0, -5)) ? await live(page.slice(0, -5), { width }) : await open(url(page), { width });
      const wide = await tab.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.ok(wide <= 0, `${wide} pixels too wide`);
      await tab.close();
    });

// Of the figures that are drawn in the page: the least height of a letter of 15 points, and those that keys cannot scroll.
for (const page of pages)
  for (const width of [360, 768, 1280, 1440])
    test(`${page} has letters of 11 pixels in its figures at ${width} pixels, and keys reach what is out of sight`, async () => {
      const tab = await open(url(page), { width });
      await tab.evaluate(() => globalThis.byhandLayout?.done);
      const { letters, unreached } = await tab.$$eval(':is(.figure:not(.hold), .film) .picture', pictures => ({
        letters: pictures.flatMap(picture => [...picture.querySelectorAll('svg')]).map(svg => 15 * svg.getBoundingClientRect().width / svg.viewBox.baseVal.width),
        unreached: pictures.filter(picture => picture.scrollWidth > picture.clientWidth + 1 && picture.tabIndex !== 0).length,
      }));
      assert.ok(letters.every(height => height >= 11), `${Math.min(...letters)} pixels`);
      assert.equal(unreached, 0);
      await tab.close();
    });

test('a first visit is set in the letters of the course', async () => {
  const tab = await open(url(`${lessons[0]}.html`));
  const session = await tab.createCDPSession();
  await session.send('DOM.enable');
  await session.send('CSS.enable');
  const { root } = await session.send('DOM.getDocument');
  for (const [selector, family] of [['h1', 'Course Serif'], ['.summary', 'Course Serif'], ['.formula mi', 'Course Math']]) {
    const { nodeId } = await session.send('DOM.querySelector', { nodeId: root.nodeId, selector });
    const { fonts } = await session.send('CSS.getPlatformFontsForNode', { nodeId });
    assert.deepEqual(fonts.map(font => font.familyName), [family], selector);
  }
  await tab.close();
});

// A phone's page has pictures of its own; only tables of small letters scroll, and say so.
for (const page of pages)
  test(`at 390 × 844 ${page} hides nothing of its figures, formulas and listings, and its header is one row`, async () => {
    const tab = await open(url(page), { width: 390, height: 844 });
    await tab.evaluate(() => byhandLayout.done);
    const seen = await tab.evaluate(() => {
      document.querySelectorAll('details').forEach(fold => { fold.open = true; });
      const wide = box => box.scrollWidth > box.clientWidth + 1;
      const outside = svg => {
        const { left, right } = svg.getBoundingClientRect();
        return [...svg.querySelectorAll('text')].filter(text => { const box = text.getBoundingClientRect(); return box.left < left - 1 || box.right > right + 1; })
          .map(text => text.textContent);
      };
      return {
        scroll: [...document.querySelectorAll('.picture:not([data-sideways]), .formula, pre')].filter(wide).map(box => box.closest('[id]').id + ': ' + box.textContent.slice(0, 60)),
        sideways: document.querySelectorAll('.picture[data-sideways]').length,
        letters: [...document.querySelectorAll(':is(.figure:not(.hold), .film) .picture:not([data-sideways]) svg')].flatMap(outside),
        header: document.querySelector('.top').getBoundingClientRect().height,
      };
    });
    assert.deepEqual(seen.scroll, []);
    assert.deepEqual(seen.letters, [], 'letters beyond the edge of their picture');
    assert.ok(seen.sideways <= 2, `${seen.sideways} scroll`);
    assert.ok(seen.header <= 56, `${seen.header} pixels`);
    await tab.close();
  });

test('a phone that is turned has the wide pictures, and the narrow ones when it is turned back; what was changed stays', async () => {
  const tab = await live(lessons.at(0), { width: 390, height: 844 });
  const shapes = () => tab.$$eval(':is(.figure:not(.hold), .film) .picture:not([data-sideways]) svg', all => new Set(all.map(svg => svg.viewBox.baseVal.width)).size === 1 && all[0].viewBox.baseVal.width);
  assert.equal(await shapes(), 490);
  await tab.setViewport({ width: 844, height: 390 });
  await tab.waitForFunction(() => document.querySelector('.figure:not(.hold) .picture svg').viewBox.baseVal.width === 1280);
  assert.equal(await shapes(), 1280);
  await tab.setViewport({ width: 390, height: 844 });
  await tab.waitForFunction(() => document.querySelector('.figure:not(.hold) .picture svg').viewBox.baseVal.width === 490);
  assert.equal(await shapes(), 490);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

for (const lesson of lessons)
  test(`${lesson} shows whole lines of code at 1440 pixels`, async () => {
    const tab = await open(url(`${lesson}.html`));
    assert.deepEqual(await tab.$$eval('.excerpt pre', all => all.filter(pre => pre.scrollWidth > pre.clientWidth).map(pre => pre.textContent)), []);
    await tab.close();
  });

for (const page of quick ? pages.filter(page => page.startsWith('04')) : pages)
  for (const dark of [false, true])
    test(`axe-core finds nothing on ${page}, ${dark ? 'dark' : 'light'}`, async () => {
      const lesson = page.slice(0, -5);
      const tab = lessons.includes(lesson) ? await live(lesson, { dark }) : await open(url(page), { dark });
      await tab.evaluate(() => document.querySelectorAll('details').forEach(fold => { fold.open = true; }));
      await tab.addScriptTag({ path: axe });
      const { violations } = await tab.evaluate(() => axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice'] }));
      assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(node => node.html.slice(0, 160)).join(' | ')}`), []);
      await tab.close();
    });

// Chromium writes one object of this type for each page.
const printed = async tab => Buffer.from(await tab.pdf({ format: 'A4' })).toString('latin1').match(/\/Type *\/Page\b(?!s)/g).length;

test('a phone shows all of every law without scrolling sideways', { skip: !pages.includes('laws.html') && 'only of the whole course' }, async () => {
  const tab = await open(url('laws.html'), { width: 390, height: 844 });
  const cells = await tab.$$eval('.all-laws tbody :is(th, td)', cells => cells.map(cell => { const { left, right } = cell.getBoundingClientRect(); return { left, right, words: cell.textContent.slice(0, 30) }; }));
  assert.ok(cells.length > 60, `${cells.length}`);
  assert.deepEqual(cells.filter(({ left, right }) => left < 0 || right > 390), []);
  await tab.close();
});

test('the table of all laws is one printed page', { skip: !pages.includes('laws.html') && 'only of the whole course' }, async () => {
  const tab = await open(url('laws.html'));
  await tab.$eval('.derivations', rest => rest.remove());
  assert.equal(await printed(tab), 1);
  await tab.close();
});

test('paper is white, says where the page is from, and shows no stubs of what is folded or held', async () => {
  const tab = await open(url(`${lessons.at(-1)}.html`));
  await tab.emulateMediaType('print');
  const seen = await tab.evaluate(() => ({
    paper: getComputedStyle(document.documentElement).getPropertyValue('--paper'),
    address: document.querySelector('.printed').textContent,
    shown: document.querySelector('.printed').checkVisibility(),
    stubs: [...document.querySelectorAll('details.goals, details.parameters, details.hint, details.solution, .hold, .beside')].filter(one => one.checkVisibility()).length,
    wide: [...document.querySelectorAll('.picture svg')].filter(svg => svg.getBoundingClientRect().right > document.documentElement.clientWidth + 1).length,
  }));
  assert.equal(seen.paper.trim(), '#fff');
  assert.ok(seen.shown && seen.address.includes(lessons.at(-1)), seen.address);
  assert.deepEqual([seen.stubs, seen.wide], [0, 0]);
  await tab.close();
});
