// Two settings side by side: one is pinned, the other goes on changing.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';

import { lessons, live, move, quit, settled } from './browser.mjs';

after(quit);

const baumgarte = lessons.find(name => name.startsWith('04'));
const step = '#step-2', figures = `${step} > figure:is([data-figure], [data-film])`;

const hash = tab => tab.evaluate(() => decodeURIComponent(location.hash));
const compared = tab => tab.waitForFunction(figures => [...document.querySelectorAll(figures)].every(figure => figure.querySelector('.twin svg')), {}, figures);
async function inView(tab) {
  await tab.$eval(step, step => step.scrollIntoView());
  await settled(tab);
}
// Of each figure: what its two pictures are called, and their letters.
const seen = tab => tab.$$eval(figures, figures => figures.map(figure => ({
  there: figure.querySelector('.there')?.textContent,
  here: figure.querySelector('.here')?.textContent,
  twin: figure.querySelector('.twin')?.textContent,
  picture: figure.querySelector('.picture').textContent,
})));

test('settings that are pinned stay beside those that change, in figures and numbers, and in the address', async () => {
  const tab = await live(baumgarte);
  await move(tab, 'beta', 0.5);
  await inView(tab);
  const sentences = () => tab.$$eval(`${step} .text :is(p, li)`, all => all.map(one => one.textContent).join(' '));
  const pinned = await seen(tab), told = await sentences(), value = (await hash(tab)).match(/beta=([^&]*)/)[1];
  await tab.click('.changes .compare-with-this');
  assert.equal(await hash(tab), `#beta=${value}&versus=beta:${value}`);
  assert.equal((await tab.$$('.versus')).length, 0, 'nothing differs yet');

  await move(tab, 'beta', 0.1);
  await inView(tab);
  await compared(tab);
  const now = await seen(tab), other = (await hash(tab)).match(/beta=([^&]*)/)[1];
  assert.ok(now.length > 0);
  assert.ok(now.every(({ there, here }) => there === `beta = ${value}` && here === `beta = ${other}`), JSON.stringify(now));
  assert.deepEqual(now.map(({ twin }) => twin), pinned.map(({ picture }) => picture), 'the pinned pictures are those of before');
  assert.ok(now.some(({ twin, picture }) => twin !== picture));
  const numbers = await tab.$$eval(`${step} .measures > div`, rows => rows.map(row => row.querySelector('dd.versus')?.textContent));
  assert.ok(numbers.every(number => number?.endsWith(`with beta = ${value}`)), numbers.join());
  const others = await tab.$$eval(`${step} .text > .versus`, all => all.map(one => one.textContent));
  const here = await sentences();
  assert.ok(others.length > 0);
  for (const words of others) {
    assert.ok(words.startsWith(`With beta = ${value}: `), words);
    const said = words.slice(words.indexOf(':') + 2);
    assert.ok(told.includes(said.split(/(?<=[.:;?!]) /)[0]), `${said} was said with that setting`);
    assert.ok(!here.includes(said), `${said} is not said with this one`);
  }
  assert.equal(await hash(tab), `#beta=${other}&versus=beta:${value}`);
  const address = await tab.evaluate(() => location.href);

  const ids = await tab.$$eval('[id]', all => all.map(({ id }) => id));
  assert.equal(new Set(ids).size, ids.length, 'no id is there twice');
  await tab.click('.changes .stop-comparing');
  await tab.waitForFunction(() => !document.querySelector('.versus'));
  assert.equal(await hash(tab), `#beta=${other}`);
  assert.deepEqual(tab.complaints, []);
  await tab.close();

  const again = await live(baumgarte, { address });
  await settled(again);
  await inView(again);
  await compared(again);
  assert.deepEqual(await seen(again), now, 'a link shows what its author saw');
  await again.close();
});

test('the defaults stand beside what changed, and questions keep their words', async () => {
  const tab = await live(baumgarte);
  const questions = await tab.$$eval('.question .before', all => all.length);
  await move(tab, 'beta', 0.95);
  await tab.click('.changes .beside-defaults');
  await inView(tab);
  await compared(tab);
  assert.match(await hash(tab), /&versus=defaults$/);
  assert.ok((await seen(tab)).every(({ there }) => there === 'beta = 0.2'));
  await tab.click('.changes .beside-defaults');
  await tab.waitForFunction(() => !document.querySelector('.versus'));
  assert.equal(await tab.$$eval('.question .before', all => all.length), questions);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('a film shows both settings at the same moment', async () => {
  const tab = await live(baumgarte, { hash: '#beta=1.5&versus=beta:0.1' });
  await inView(tab);
  await compared(tab);
  const film = `${step} > figure[data-film]`;
  const pictures = () => tab.$eval(film, film => [film.querySelector('.twin').innerHTML, film.querySelector('.picture').innerHTML]);
  const before = await pictures();
  await tab.$eval(`${film} .player input`, slider => { slider.value = 5; slider.dispatchEvent(new Event('input')); });
  await tab.waitForFunction((film, twin) => document.querySelector(`${film} .twin`).innerHTML !== twin, {}, film, before[0]);
  const [twin, picture] = await pictures();
  assert.notEqual(picture, before[1]);
  assert.notEqual(twin.replaceAll('versus-', ''), picture);
  await tab.close();
});

for (const width of [360, 1440, 2560])
  test(`the two lie ${width > 2304 ? 'side by side' : 'one over the other, with a wipe between them,'} at ${width} pixels, legible and without a horizontal bar`, async () => {
    const tab = await live(baumgarte, { width, hash: '#beta=1.5&versus=defaults' });
    await inView(tab);
    await compared(tab);
    const places = () => tab.$eval(figures, figure => ['.twin', '.picture'].map(part => {
      const svg = figure.querySelector(`${part} svg`);
      return { ...figure.querySelector(part).getBoundingClientRect().toJSON(), clip: getComputedStyle(figure.querySelector(part)).clipPath, letters: 15 * svg.getBoundingClientRect().width / svg.viewBox.baseVal.width };
    }));
    const [twin, picture] = await places();
    assert.ok(Math.abs(twin.y - picture.y) < 2 && Math.abs(twin.width - picture.width) < 2, JSON.stringify([twin, picture]));
    for (const { letters } of [twin, picture]) assert.ok(letters >= 11, `${letters}`);
    if (width > 2304) {
      assert.ok(twin.right <= picture.left, JSON.stringify([twin, picture]));
    } else {
      assert.ok(Math.abs(twin.x - picture.x) < 2);
      await tab.$eval(`${figures} .wipe`, wipe => { wipe.value = 20; wipe.dispatchEvent(new Event('input')); });
      assert.match((await places())[0].clip, /inset\(0px (80%|calc\(80%\)) 0px 0px\)|inset\(0px calc\(100% - 20%\) 0px 0px\)/);
    }
    assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth));
    await tab.close();
  });

test('pinned settings that the lesson refuses are left out, in its own sentence', async () => {
  const tab = await live(baumgarte, { hash: '#beta=1.5&versus=beta:9' });
  await inView(tab);
  assert.match(await tab.$eval('.changes .refused', refused => refused.textContent), /beta = 9 is out of range/);
  assert.equal((await tab.$$('.versus')).length, 0);
  await tab.close();
});
