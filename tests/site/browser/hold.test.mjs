// A scene that a reader holds: by mouse, by finger, by keys, step by step, and what it does by itself: nothing.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';

import { axe, lessons, live, quick, quit, settled } from './browser.mjs';

after(quit);

const holding = lessons.filter(name => /^0[2-8]/.test(name));
const [bob, rod] = ['02', '04'].map(number => lessons.find(name => name.startsWith(number)));
const figure = 'figure[data-hold]';

// The page of a lesson with its scene in view and its program started.
async function withScene(lesson, more) {
  const tab = await live(lesson, more);
  await tab.$eval(figure, figure => figure.scrollIntoView({ block: 'center' }));
  await tab.waitForSelector(`${figure} .hand`);
  return tab;
}
const press = (tab, label) => tab.click(`${figure} .player button[aria-label^="${label}"]`);
const reading = tab => tab.$eval(`${figure} .reading`, reading => reading.textContent);
const picture = tab => tab.$eval(`${figure} .picture`, picture => picture.innerHTML);
const holds = (tab, held) => tab.waitForFunction((figure, held) => !!document.querySelector(`${figure} .hand[aria-pressed=true]`) === held, {}, figure, held);
const moves = tab => tab.evaluate(() => { const { hold } = byhandPage.steps.find(step => step.hold); return !!hold.playing; });
const middle = tab => tab.$eval(`${figure} .hand`, hand => { const { x, y, width, height } = hand.getBoundingClientRect(); return { x: x + width / 2, y: y + height / 2 }; });
// In metres, kilograms and seconds, as the reading has them.
const numbers = words => [...words.matchAll(/−?\d+(?:\.\d+)?(?:·10[⁻⁰¹²³⁴-⁹]+)?/g)].map(([number]) => number);
const time = async tab => +(await reading(tab)).match(/Time (\S+) s/)[1];
const wait = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds));

for (const lesson of quick ? [bob, rod] : holding)
  test(`${lesson}: nothing moves before it is held or played`, async () => {
    const tab = await withScene(lesson);
    const before = await picture(tab);
    await wait(600);
    assert.equal(await picture(tab), before);
    assert.equal(await time(tab), 0);
    assert.deepEqual(tab.complaints, []);
    await tab.close();
  });

// Every scene of lessons 7 and 8: a body of it is pulled and let go, then one step is watched part by part.
for (const name of ['book_in_hand', 'gyroscope_in_hand', 'stack_in_hand', 'chain_in_hand']) {
  const lesson = lessons.find(lesson => lesson.startsWith(/^(book|gyro)/.test(name) ? '07' : '08'));
  test(`${name} is pulled, let go and watched within a step`, { skip: !lesson && 'without its lesson' }, async () => {
    const tab = await live(lesson), figure = `#hold-${name}`;
    const told = () => tab.$eval(`${figure} .reading`, reading => reading.textContent);
    const press = label => tab.$eval(`${figure} .player [aria-label^="${label}"]`, button => button.click());
    await tab.$eval(figure, figure => figure.scrollIntoView({ block: 'center' }));
    await tab.waitForSelector(`${figure} .hand`);
    const before = await told(), hand = await (await tab.$$(`${figure} .hand`)).at(-1).boundingBox();
    await tab.mouse.move(hand.x + hand.width / 2, hand.y + hand.height / 2);
    await tab.mouse.down();
    await tab.waitForSelector(`${figure} .hand[aria-pressed=true]`);
    await tab.mouse.move(hand.x + hand.width / 2 + 40, hand.y + hand.height / 2 + 15, { steps: 6 });
    await tab.waitForFunction(figure => +document.querySelector(`${figure} .reading`).textContent.match(/Time (\S+) s/)[1] > 0.2, {}, figure);
    await tab.mouse.up();
    await tab.waitForSelector(`${figure} .hand[aria-pressed=true]`, { hidden: true });
    assert.notEqual(await told(), before);
    assert.doesNotMatch(await told(), /NaN|∞/);
    await press('Slow');
    await tab.waitForFunction(figure => document.querySelector(`${figure} .reading`).textContent.startsWith('V. '), {}, figure);
    await press('next part');
    await tab.waitForFunction(figure => document.querySelector(`${figure} .reading`).textContent.startsWith('V + gh'), {}, figure);
    assert.deepEqual(tab.complaints, []);
    await tab.close();
  });
}

test('a body follows the mouse and goes on with its velocity when it is let go', async () => {
  const tab = await withScene(bob);
  await tab.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'no-preference' }]);
  const { x, y } = await middle(tab);
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await holds(tab, true);
  await tab.mouse.move(x - 150, y, { steps: 12 });
  await wait(300);
  const dragged = await middle(tab);
  assert.ok(dragged.x < x - 60, `from ${x} to ${dragged.x}`);
  await tab.mouse.up();
  await holds(tab, false);
  assert.ok(await moves(tab));
  await wait(300);
  await press(tab, 'pause');
  assert.notDeepEqual(await middle(tab), dragged);
  assert.ok(await time(tab) > 0.3);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('a pull beside every body takes nothing and starts nothing', async () => {
  const tab = await withScene(bob);
  const { x, y } = await middle(tab), before = await picture(tab);
  await tab.mouse.move(x + 120, y + 40);
  await tab.mouse.down();
  await tab.mouse.move(x, y, { steps: 4 });
  await tab.mouse.up();
  await wait(200);
  assert.equal(await picture(tab), before);
  assert.equal(await moves(tab), false);
  await tab.close();
});

test('a finger drags a body, and the page does not scroll meanwhile', async () => {
  const tab = await withScene(rod, { width: 360, touch: true });
  const { x, y } = await middle(tab), scrolled = await tab.evaluate(() => scrollY);
  await tab.touchscreen.touchStart(x, y);
  await holds(tab, true);
  for (let i = 1; i <= 10; ++i) await tab.touchscreen.touchMove(x - 5 * i, y + 4 * i);
  await wait(300);
  assert.ok((await middle(tab)).x < x - 15);
  assert.equal(await tab.evaluate(() => scrollY), scrolled);
  await tab.touchscreen.touchEnd();
  await holds(tab, false);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('keys alone pull a body and let it go', async () => {
  const tab = await withScene(bob);
  const { x } = await middle(tab);
  await tab.focus(`${figure} .player button`);
  for (let i = 0; i < 20 && !await tab.evaluate(() => document.activeElement.matches('.hand')); ++i) {
    await tab.keyboard.down('Shift');
    await tab.keyboard.press('Tab');
    await tab.keyboard.up('Shift');
  }
  assert.equal(await tab.evaluate(() => document.activeElement.getAttribute('aria-label')), 'bob');
  for (let i = 0; i < 4; ++i) await tab.keyboard.press('ArrowLeft');
  await holds(tab, true);
  await wait(500);
  assert.ok((await middle(tab)).x < x - 20);
  await tab.keyboard.press('Escape');
  await holds(tab, false);
  for (const held of [true, false]) {
    await tab.keyboard.press('Enter');
    await holds(tab, held);
  }
  assert.ok(await tab.evaluate(() => document.activeElement.matches('.hand')), 'the focus stays');
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('where motion is to be reduced, letting go stops the clock', async () => {
  const tab = await withScene(bob);
  await tab.focus(`${figure} .hand`);
  await tab.keyboard.press('Enter');
  await holds(tab, true);
  assert.ok(await moves(tab));
  await tab.keyboard.press('Enter');
  await holds(tab, false);
  assert.equal(await moves(tab), false);
  await tab.close();
});

test('one step is one h, and what it says is what the program says', async () => {
  const tab = await withScene(bob);
  for (let step = 1; step <= 3; ++step) {
    const before = await reading(tab);
    await press(tab, 'one step');
    await tab.waitForFunction((figure, before) => document.querySelector(`${figure} .reading`).textContent !== before, {}, figure, before);
    assert.ok(Math.abs(await time(tab) - step / 60) < 1e-4);
  }
  assert.match(await reading(tab), /^Time 0\.05 s: energy −?[\d.]+ J, \|C\| \S+ m², impulse λ\|l₂\| −?[\d.]+ N·s\.$/);
  await press(tab, 'reset');
  await tab.waitForFunction(figure => document.querySelector(`${figure} .reading`).textContent.startsWith('Time 0 s'), {}, figure);
  await tab.close();
});

test('slowed down a step shows its six parts, and then the next step begins', async () => {
  const tab = await withScene(bob);
  const rest = await reading(tab), parts = [];
  await press(tab, 'Slow ×100');
  for (let part = 0; part <= 6; ++part) {
    await tab.waitForFunction((figure, last) => ![last, ''].includes(document.querySelector(`${figure} .reading`).textContent), {}, figure, parts.at(-1) ?? rest);
    parts.push(await reading(tab));
    await press(tab, 'next part');
  }
  const [V, gravity, JV, lambda, after, poses, again] = parts;
  for (const [words, formula] of [[V, /^V\./], [gravity, /^V \+ gh/], [JV, /^JV/], [lambda, /^λ/], [after, /^V \+ M⁻¹Jᵀλ/], [poses, /^hV/], [again, /^V\./]])
    assert.match(words, formula);
  await press(tab, 'play');
  await wait(400);
  await press(tab, 'pause');
  await press(tab, 'Slow ×100');
  await tab.waitForFunction(figure => document.querySelector(`${figure} .reading`).textContent.startsWith('Time'), {}, figure);
  assert.ok(await time(tab) < 0.06, 'a hundred times slower');
  await tab.close();
});

test('a slider acts on the running scene, and one that moves the start begins anew', async () => {
  const tab = await withScene(bob);
  const set = (name, share) => tab.evaluate((name, share) => {
    const slider = document.querySelector(`#step-1 .setting[data-name="${name}"] input[type=range]`);
    slider.value = slider.max * share;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  }, name, share);
  for (let i = 0; i < 4; ++i) await press(tab, 'one step');
  await tab.waitForFunction(figure => document.querySelector(`${figure} .reading`).textContent.startsWith('Time 0.06667 s'), {}, figure);
  const energy = async () => +numbers(await reading(tab))[1].replace('−', '-');
  const before = await energy(), said = await reading(tab);
  await set('mass', 1);
  await tab.waitForFunction((figure, said) => document.querySelector(`${figure} .reading`).textContent !== said, {}, figure, said);
  assert.ok(Math.abs(await time(tab) - 4 / 60) < 1e-4, 'time goes on');
  assert.ok(await energy() < 100 * before, 'and the mass is another');
  await set('angle', 0.5);
  await tab.waitForFunction(figure => document.querySelector(`${figure} .reading`).textContent.startsWith('Time 0 s'), {}, figure);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('a scene that flies apart stops and says why', async () => {
  const tab = await withScene(rod, { hash: '#beta=2.5' });
  const { x, y } = await middle(tab);
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.mouse.move(x + 60, y + 60, { steps: 5 });
  await tab.waitForSelector(`${figure} .reading.stopped`, { timeout: 20_000 });
  await tab.mouse.up();
  assert.match(await reading(tab), /β = 2\.5 a step multiplies the error by 1 − β = −1\.5/);
  assert.equal(await moves(tab), false);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('it runs at the speed of the clock, and is drawn 30 times a second', { skip: quick }, async () => {
  for (const lesson of lessons.filter(name => /^0[2-6]/.test(name))) {
    const tab = await withScene(lesson);
    await tab.evaluate(figure => {
      globalThis.drawn = 0;
      new MutationObserver(() => ++drawn).observe(document.querySelector(`${figure} .picture`), { childList: true });
    }, figure);
    await press(tab, 'play');
    const rates = await tab.evaluate(async () => {
      const rates = [];
      for (let i = 0; i < 6; ++i) {
        const begin = performance.now();
        drawn = 0;
        await new Promise(resolve => setTimeout(resolve, 400));
        rates.push(1000 * drawn / (performance.now() - begin));
      }
      return rates;
    });
    await press(tab, 'pause');
    assert.ok(Math.max(...rates) >= 30, `${lesson}: ${rates.map(Math.round)} a second`);  // others may be at work on this machine
    assert.ok(await time(tab) > 2, `${lesson}: ${await time(tab)} s of 2.4 s`);
    await tab.close();
  }
});

for (const dark of [false, true])
  test(`axe-core finds nothing on a scene that is held beside settings that are compared, ${dark ? 'dark' : 'light'}`, async () => {
    const tab = await withScene(rod, { dark, hash: '#beta=1.5&versus=defaults' });
    await tab.focus(`${figure} .hand`);
    await tab.keyboard.press('Enter');
    await holds(tab, true);
    await tab.waitForSelector('.compared .twin');
    await settled(tab);
    await tab.addScriptTag({ path: axe });
    const { violations } = await tab.evaluate(() => axe.run('#step-2', { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice'] }));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(node => node.html.slice(0, 160)).join(' | ')}`), []);
    await tab.close();
  });
