// A page is a stage: what a reader moves and what it changes are on one screen, nothing shifts when the page becomes
// live, and films begin at their beginning.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';

import { lessons, live, quit, settled } from './browser.mjs';

after(quit);

const screens = [{ width: 1440, height: 900 }, { width: 390, height: 844 }];
const pictures = 'figure:is([data-figure], [data-film], [data-hold])';

for (const lesson of lessons)
  for (const { width, height } of screens) {
    test(`${lesson}: under each figure a slider is on one screen with it at ${width} × ${height}`, async context => {
      const tab = await live(lesson, { width, height });
      const spans = await tab.$$eval(pictures, figures => figures.map(figure => {
        const { top } = figure.querySelector('.picture').getBoundingClientRect(), last = [...figure.querySelectorAll('.knobs .setting')].pop();
        const reads = byhandPage.steps.find(step => step.section.contains(figure)).read.size;
        return { id: figure.id, reads, span: last && last.getBoundingClientRect().bottom - top };
      }));
      const offered = spans.filter(({ reads }) => reads > 0);
      assert.deepEqual(offered.filter(({ span }) => !span).map(({ id }) => id), [], 'figures without a slider');
      context.diagnostic(`from a figure's top to its last slider at most ${Math.max(...offered.map(({ span }) => span)).toFixed()} of ${height} pixels`);
      assert.deepEqual(offered.filter(({ span }) => span > height), []);
      assert.equal((await tab.$$('.step > h2 ~ .settings')).length, 0);
      await tab.close();
    });

    test(`${lesson}: nothing moves when the page becomes live at ${width} × ${height}`, async context => {
      const tab = await live(lesson, { width, height, before: tab => tab.evaluateOnNewDocument(() => {
        globalThis.shift = 0;
        new PerformanceObserver(list => { for (const { value } of list.getEntries()) shift += value; }).observe({ type: 'layout-shift', buffered: true });
      }) });
      await settled(tab);
      await tab.evaluate(() => document.fonts.ready.then(() => new Promise(requestAnimationFrame)));
      const shift = await tab.evaluate(() => globalThis.shift);
      context.diagnostic(`layout shift ${shift.toFixed(4)}`);
      assert.ok(shift <= 0.02, `${shift}`);
      await tab.close();
    });
  }

test('a step begins with its first sentence', async () => {
  const tab = await live(lessons[0]);
  const between = await tab.$$eval('.step', steps => steps.map(step => {
    const text = step.querySelector(':scope > .text');
    return text ? text.getBoundingClientRect().top - step.querySelector('h2').getBoundingClientRect().bottom : 0;
  }));
  assert.ok(Math.max(...between.slice(0, 1)) < 40, `${between} pixels`);
  await tab.close();
});

test('a film begins at its first frame, tells how long it is, and goes on in a loop', async () => {
  const tab = await live(lessons.at(-1));
  const figure = await tab.$('figure[data-film]');
  const slider = () => figure.$eval('.player input', input => [+input.value, +input.max]);
  assert.equal((await slider())[0], 0);
  const before = await figure.$eval('.picture', picture => picture.textContent);
  await figure.$eval('.player [aria-label="one frame on"]', button => button.click());
  await tab.waitForFunction(figure => +figure.querySelector('.player input').value === 1, {}, figure);
  assert.match(await figure.$eval('output', time => time.textContent), /^\S+ of \S+( s)?$/);
  await figure.$eval('.player [aria-label="one frame back"]', button => button.click());
  await tab.waitForFunction(figure => +figure.querySelector('.player input').value === 0, {}, figure);
  assert.equal(await figure.$eval('.picture', picture => picture.textContent), before, 'the page shows the first frame');

  const last = (await slider())[1];
  await figure.evaluate((figure, last) => {
    [...figure.querySelectorAll('.player button')].find(button => button.textContent === 'Loop').click();
    const input = figure.querySelector('.player input');
    input.value = last - 1;
    input.dispatchEvent(new Event('input'));
  }, last);
  await tab.waitForFunction((figure, last) => +figure.querySelector('.player input').value === last - 1, {}, figure, last);
  await figure.$eval('.player [aria-label="play"]', button => button.click());
  await tab.waitForFunction((figure, last) => { const { value } = figure.querySelector('.player input'); return +value > 0 && +value < last - 1; }, {}, figure, last);
  await figure.$eval('.player [aria-label="pause"]', button => button.click());
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('"to try" sets the sliders and leads to the step that it is about', async () => {
  const tab = await live(lessons.at(-1));
  const [href, command] = await tab.$eval('#to-try .try', link => [link.getAttribute('href'), link.parentElement.nextElementSibling.textContent]);
  await tab.$eval('#to-try .try', link => link.click());
  await tab.waitForSelector('.changes .change');
  await settled(tab);
  const [place, ...settings] = href.slice(1).split('&');
  for (const setting of settings) assert.ok(command.includes(`--set ${setting}`), `${command} has ${setting}`);
  assert.deepEqual(await tab.$$eval('.changes .change', all => all.map(one => one.firstChild.data.replaceAll(' ', ''))), settings);
  assert.ok(Math.abs(await tab.$eval(`#${place}`, step => step.getBoundingClientRect().top)) < 100);
  await tab.close();
});
