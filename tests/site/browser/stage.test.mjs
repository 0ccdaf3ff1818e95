// A page is a stage: what a reader moves and what it changes are on one screen, nothing shifts when the page becomes
// live, and films begin at their beginning.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';

import { lessons, live, move, quit, settled } from './browser.mjs';

after(quit);

const screens = [{ width: 1440, height: 900 }, { width: 390, height: 844 }];
const usual = lessons.find(name => name.startsWith('04'));  // with scenes to hold, and films that are told at once
const pictures = 'figure:is([data-figure], [data-film], [data-hold])';

for (const lesson of lessons)
  for (const { width, height } of screens) {
    test(`${lesson}: under each figure a slider is on one screen with it at ${width} × ${height}`, async context => {
      const tab = await live(lesson, { width, height });
      const spans = await tab.$$eval(pictures, figures => figures.map(figure => {
        // On a phone three quarters of the figure are enough.
        const { top: edge, height: whole } = figure.querySelector('.picture').getBoundingClientRect(), top = edge + (innerWidth < 480 ? whole / 4 : 0), last = [...figure.querySelectorAll('.knobs .setting')].pop();
        // Parameters that do not change the picture stand at the foot of the step.
        const knobs = +figure.querySelector('.controls').dataset.count;
        return { id: figure.id, knobs, span: last && last.getBoundingClientRect().bottom - top };
      }));
      // What stays in view takes its part: the bar of changes and, on a narrow page, the contents.
      const room = height - 56 - await tab.$eval('.beside', beside => innerWidth < 1440 ? beside.getBoundingClientRect().height : 0);
      const offered = spans.filter(({ knobs }) => knobs > 0);
      assert.deepEqual(offered.filter(({ span }) => !span).map(({ id }) => id), [], 'figures without a slider');
      context.diagnostic(`from a figure's top to its last slider at most ${Math.max(...offered.map(({ span }) => span)).toFixed()} of ${room.toFixed()} pixels`);
      assert.deepEqual(offered.filter(({ span }) => span > room), []);
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

for (const lesson of lessons)
  test(`${lesson}: every step begins with its first item, right below its title`, async () => {
    const tab = await live(lesson);
    const between = await tab.$$eval('.step', steps => steps.map(step =>
      step.querySelector(':scope > [data-item]').getBoundingClientRect().top - step.querySelector('h2').getBoundingClientRect().bottom));
    assert.ok(between.length > 4 && Math.max(...between) < 60, `${between.map(Math.round)} pixels`);
    await tab.close();
  });

test('under no figure a slider asks how finely a map is drawn', { skip: !lessons.some(name => name.startsWith('08')) && 'without lesson 8' }, async () => {
  const tab = await live(lessons.find(name => name.startsWith('08')));
  assert.deepEqual(await tab.$$eval('.controls', all => all.map(one => one.dataset.knobs).filter(knobs => knobs.includes('resolution'))), []);
  assert.ok(await tab.$$eval('.others .setting', all => all.some(one => one.dataset.name === 'resolution')), 'but at the foot of the step');
  await tab.close();
});

test('lesson 1 begins with a bob in the reader\'s hand: C, its rate and J follow it', { skip: !lessons.some(name => name.startsWith('01')) && 'without lesson 1' }, async () => {
  const tab = await live(lessons[0]);
  const figure = '#step-1 figure[data-hold]';
  assert.equal(await tab.$eval('#step-1', step => step.querySelector('figure').dataset.hold), 'bob_in_hand', 'before every other figure');
  await tab.$eval(figure, figure => figure.scrollIntoView({ block: 'center' }));
  await tab.waitForSelector(`${figure} .hand`);
  const said = () => tab.$eval(`${figure} .reading`, reading => reading.textContent);
  const C = async () => +(await said()).match(/C = (\S+) m²/)[1].replace('−', '-');
  assert.ok(Math.abs(await C() - 0.205) < 1e-9, await said());
  assert.match(await said(), /Ċ = JV = 0 m²\/s: C does not change/);
  const hand = await tab.$eval(`${figure} .hand`, hand => { const { x, y, width, height } = hand.getBoundingClientRect(); return { x: x + width / 2, y: y + height / 2 }; });
  const stage = await tab.$eval(`${figure} .stage`, stage => { const { x, y, width, height } = stage.getBoundingClientRect(); return { x: x + width / 2, y: y + height / 2 }; });
  await tab.mouse.move(hand.x, hand.y);
  await tab.mouse.down();
  await tab.mouse.move((hand.x + stage.x) / 2, (hand.y + stage.y) / 2, { steps: 8 });
  await tab.waitForFunction(figure => / C falls\.$/.test(document.querySelector(`${figure} .reading`).textContent), {}, figure);
  await tab.waitForFunction(figure => /too close to/.test(document.querySelector(`${figure} .reading`).textContent), {}, figure);
  await tab.mouse.up();
  assert.ok(await C() < 0, await said());
  assert.equal(await tab.$eval(`${figure} .player`, player => [...player.children].filter(button => !button.hidden && button.textContent.startsWith('Slow')).length), 0, 'no parts of a step');
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('on a phone sliders and films draw for its page', async () => {
  const tab = await live(usual, { width: 390, height: 844 });
  const widths = () => tab.$$eval(':is([data-figure], [data-film]) .picture:not([data-sideways]) svg', all => [...new Set(all.map(svg => svg.viewBox.baseVal.width))]);
  const before = await tab.$$eval('[data-figure] .picture', all => all.map(one => one.innerHTML));
  await move(tab, 'beta', 0.8);
  assert.notDeepEqual(await tab.$$eval('[data-figure] .picture', all => all.map(one => one.innerHTML)), before);
  assert.deepEqual(await widths(), [490]);
  await tab.$eval('figure[data-film] .player [aria-label="one frame on"]', button => button.click());
  await tab.waitForFunction(() => +document.querySelector('figure[data-film] .player input').value === 1);
  assert.deepEqual(await widths(), [490]);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('at 360 pixels the letters of a scene to hold are 11 pixels high', async () => {
  const tab = await live(usual, { width: 360 });
  const figure = 'figure[data-hold]';
  await tab.$eval(figure, figure => figure.scrollIntoView({ block: 'center' }));
  await tab.waitForSelector(`${figure} .hand`);
  await tab.click(`${figure} .player [aria-label^="Slow"]`);
  await tab.waitForSelector(`${figure} .picture svg text`);
  const letters = await tab.$$eval(`${figure} .picture svg text`, texts => texts.map(text => parseFloat(getComputedStyle(text).fontSize) * text.ownerSVGElement.getBoundingClientRect().width / text.ownerSVGElement.viewBox.baseVal.width));
  assert.ok(letters.length > 0 && Math.min(...letters) >= 11, letters.join());
  await tab.close();
});

test('a film fills the screen and comes back', async () => {
  const tab = await live(lessons.at(-1));
  const film = await tab.$('figure[data-film]');
  await film.$eval('.player', player => player.scrollIntoView({ block: 'center' }));
  const button = await film.$('.player [aria-label="full screen"]');
  await button.click();
  await tab.waitForFunction(film => document.fullscreenElement === film, {}, film);
  const { picture, player } = await film.evaluate(film => ({ picture: film.querySelector('.picture svg').getBoundingClientRect().toJSON(), player: film.querySelector('.player').getBoundingClientRect().toJSON() }));
  assert.ok(picture.top >= 0 && player.bottom <= 901 && picture.width > 1000, JSON.stringify({ picture, player }));
  await button.click();
  await tab.waitForFunction(() => !document.fullscreenElement);
  await tab.close();
});

test('a film begins at its first frame, tells how long it is, and goes on in a loop', async () => {
  const tab = await live(usual);
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
  const tab = await live(usual);
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
