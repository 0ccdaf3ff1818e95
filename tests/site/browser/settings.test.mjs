// Sliders: at both ends and in between, the page's claims hold, and what depends on a setting is told again.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';

import { axe, lessons, live, move, quick, quit, settled } from './browser.mjs';

after(quit);

const chosen = quick ? lessons.filter(name => /^0[24]/.test(name)) : lessons;
const somewhere = (() => { let state = 20131; return () => (state = (state * 48271) % 2147483647) / 2147483647; })();

const falseClaims = tab => tab.evaluate(() => [...document.querySelectorAll('[data-verdict="false"]')].map(row => row.textContent));

for (const lesson of chosen)
  test(`${lesson}: at the ends of every slider and between them every claim holds`, { timeout: 1_800_000 }, async () => {
    const tab = await live(lesson);
    const names = await tab.evaluate(() => [...new Set([...document.querySelectorAll('.setting input[type=range]')].map(slider => slider.closest('.setting').dataset.name))]);
    assert.ok(names.length > 0, 'the page offers sliders');
    for (const name of names) {
      for (const share of [0, 1, ...Array.from({ length: quick ? 1 : 10 }, somewhere)]) {
        await move(tab, name, share);
        assert.deepEqual(await falseClaims(tab), [], `${name} at ${share} of its range`);
        assert.deepEqual(tab.complaints, []);
      }
      await tab.evaluate(() => document.querySelector('.changes .reset')?.click());
      await settled(tab);
    }
    await tab.close();
  });

const baumgarte = lessons.find(name => name.startsWith('04'));

test('an exact value can be typed, and the address keeps it', async () => {
  const tab = await live(baumgarte);
  const type = async (name, value) => {
    const field = await tab.$(`.setting[data-name="${name}"] input[type=text]`);
    await field.evaluate(field => { field.value = ''; });
    await field.type(value);
    await field.press('Enter');
    await tab.waitForFunction((name, value) => decodeURIComponent(location.hash).includes(`${name}=`), {}, name, value);
    await settled(tab);
  };
  await type('h', '1/120');
  await type('beta', '1.9');
  assert.equal(await tab.evaluate(() => decodeURIComponent(location.hash)), '#h=1/120&beta=1.9');
  const address = await tab.evaluate(() => location.href);
  const words = await tab.$eval('#step-2', step => step.innerText);
  await tab.close();

  const again = await live(baumgarte, { address });
  await settled(again);
  await again.evaluate(() => document.querySelector('#step-2').scrollIntoView());
  await settled(again);
  assert.equal(await again.$eval('.setting[data-name="h"] input[type=text]', field => field.value), '1/120');
  assert.equal(await again.$eval('#step-2', step => step.innerText), words, 'a link shows what its author saw');
  await again.close();
});

test('a link to a step with settings opens it there', async () => {
  const tab = await live(baumgarte, { hash: '#step-3&beta=1.9' });
  await settled(tab);
  assert.ok(Math.abs(await tab.$eval('#step-3', step => step.getBoundingClientRect().top)) < 100);
  assert.equal(await tab.$eval('#step-3 .setting[data-name="beta"] input[type=text]', field => field.value), '1.9');
  await tab.close();
});

test('a value out of range is refused at its slider in the lesson\'s own sentence', async () => {
  const tab = await live(baumgarte);
  const field = await tab.$('.setting[data-name="beta"] input[type=text]');
  for (const [typed, sentence] of [['7', /beta|7.*(0\.01|3)/], ['many', /"many" is not a number/]]) {
    await field.evaluate(field => { field.value = ''; });
    await field.type(typed);
    await field.press('Enter');
    await tab.waitForFunction(sentence => new RegExp(sentence).test(document.querySelector('.setting[data-name="beta"] .refused').textContent), {}, sentence.source);
    assert.equal(await field.evaluate(field => field.getAttribute('aria-invalid')), 'true');
  }
  assert.equal(await tab.evaluate(() => location.hash), '', 'the setting stays as it was');
  await tab.close();
});

for (const dark of [false, true])
  test(`steps out of view that are not told again yet say so, and axe-core finds nothing on them, ${dark ? 'dark' : 'light'}`, async () => {
    const tab = await live(baumgarte, { dark, hash: '#beta=1.5' });
    await settled(tab);
    await new Promise(resolve => setTimeout(resolve, 600));
    const says = await tab.$$eval('.stale > .state', states => states.map(state => getComputedStyle(state, '::before').content));
    assert.ok(says.length > 0 && says.every(words => words.includes('settings before')), says.join());
    await tab.addScriptTag({ path: axe });
    const { violations } = await tab.evaluate(() => axe.run(document.querySelectorAll('.stale'), { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'] }));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 160)}`), []);
    await tab.close();
  });

test('reset restores the page as it was written', async () => {
  const tab = await live(baumgarte);
  const words = () => tab.$$eval('section.step', steps => steps.map(step => [...step.querySelectorAll('.text, .measures, .claims')].map(part => part.textContent)));
  const written = await words();
  await move(tab, 'beta', 0.9);
  assert.notDeepEqual(await words(), written);
  await tab.click('.changes .reset');
  await settled(tab);
  for (const step of await tab.$$('section.step')) {
    await step.evaluate(step => step.scrollIntoView());
    await settled(tab);
  }
  assert.deepEqual(await words(), written);
  await tab.close();
});


// A lesson with "h", whose default is 1/60, and "length", and two numbers of it.
const first = lessons[0];
const field = (tab, name) => tab.$eval(`.setting[data-name="${name}"] input[type=text]`, field => field.value);
const slide = (tab, name, place) => tab.$eval(`.setting[data-name="${name}"] input[type=range]`, (slider, place) => {
  slider.value = place;
  slider.dispatchEvent(new Event('input', { bubbles: true }));
}, place);
const barSays = tab => tab.$eval('.changes', bar => bar.hidden ? '' : bar.textContent);
const inAddress = (tab, hash) => tab.waitForFunction(hash => decodeURIComponent(location.hash) === hash, {}, hash);

test('a link within the page keeps the settings, and the address gets them too', async () => {
  const tab = await live(first, { hash: '#length=1.5' });
  await tab.$eval('.beside a[href="#step-3"]', link => link.click());
  await inAddress(tab, '#step-3&length=1.5');
  await settled(tab);
  assert.equal(await field(tab, 'length'), '1.5');
  assert.match(await barSays(tab), /length = 1\.5/);
  assert.ok(Math.abs(await tab.$eval('#step-3', step => step.getBoundingClientRect().top)) < 100);
  await tab.close();
});

test('a setting of the address that is refused is left out, named, and holds up no other', async () => {
  for (const bad of ['length=9999', 'length=nan', 'length=', 'length=1e-400', 'length=<img src=x>', 'stepsize=3']) {
    const tab = await live(first, { hash: `#${bad}&h=1/120` });
    await inAddress(tab, '#h=1/120');
    await settled(tab);
    assert.match(await barSays(tab), new RegExp(`Left out of the link: .*${bad.split('=')[0]}`));
    assert.deepEqual(await tab.$$eval('.changes .change', all => all.map(one => one.firstChild.data)), ['h = 1/120']);
    assert.equal(await field(tab, 'h'), '1/120');
    assert.deepEqual(tab.complaints, []);
    await tab.close();
  }
});

test('a stray percent sign in the address stops nothing', async () => {
  for (const hash of ['#%E0%A4%A', '#step-2&length=1.5%']) {
    const tab = await live(first, { hash });
    assert.deepEqual(tab.complaints, []);
    await tab.close();
  }
});

test('a slider that is moved away and back has its default again, and one key is the next value', async () => {
  const tab = await live(first);
  for (const name of ['h', 'length']) {
    const before = await field(tab, name);
    const [place, most] = await tab.$eval(`.setting[data-name="${name}"] input[type=range]`, slider => [+slider.value, +slider.max]);
    await slide(tab, name, 0);
    await slide(tab, name, place);
    await settled(tab);
    assert.equal(await field(tab, name), before);
    assert.equal(await barSays(tab), '');
    const values = [];
    for (let at = 0; at <= most; ++at) {
      await slide(tab, name, at);
      values.push(await field(tab, name));
    }
    assert.equal(new Set(values).size, values.length, `${name}: each place is another value`);
    assert.ok(values.every(value => value.length <= 8), `${name}: ${values.filter(value => value.length > 8)}`);
    if (name === 'h') for (const fraction of ['1/30', '1/60', '1/120']) assert.ok(values.includes(fraction), fraction);
    await tab.click('.changes .reset');
  }
  await tab.close();
});

test('each changed parameter is set back alone', async () => {
  const tab = await live(first, { hash: '#length=1.5&h=1/120' });
  await tab.click('.changes .undo[aria-label^="set length"]');
  await inAddress(tab, '#h=1/120');
  await settled(tab);
  assert.doesNotMatch(await barSays(tab), /length/);
  assert.match(await barSays(tab), /h = 1\/120/);
  await tab.close();
});

test('the address is written when a slider rests, and a browser that refuses it stops nothing', async () => {
  const tab = await live(first, { before: tab => tab.evaluateOnNewDocument(() => {
    globalThis.written = 0;
    const { replaceState } = History.prototype;
    History.prototype.replaceState = function (...all) {
      if (++globalThis.written === 2) throw new DOMException('too many calls', 'SecurityError');
      return replaceState.apply(this, all);
    };
  }) });
  await tab.$eval('.setting[data-name="length"] input[type=range]', slider => {
    for (slider.value = 1; slider.value < 20; ++slider.value) slider.dispatchEvent(new Event('input', { bubbles: true }));
  });
  await settled(tab);
  assert.equal(await tab.evaluate(() => written), 1);
  await slide(tab, 'length', 40);
  await settled(tab);
  assert.equal(await tab.evaluate(() => written), 2);
  assert.doesNotMatch(await barSays(tab), /stopped/);
  await tab.close();
});

test('without a clipboard the reader hears where the link is', async () => {
  const tab = await live(first, { hash: '#length=1.5', before: tab => tab.evaluateOnNewDocument(() => {
    Object.defineProperty(Navigator.prototype, 'clipboard', { get: () => undefined });
  }) });
  const copy = await tab.evaluateHandle(() => [...document.querySelectorAll('.changes button')].find(button => button.textContent === 'Copy link'));
  await copy.click();
  assert.equal(await copy.evaluate(button => button.textContent), 'The link is in the address bar');
  await tab.close();
});

test('beside a parameter that changed stands what sets it back', async () => {
  const tab = await live(baumgarte, { hash: '#beta=1.9&h=1/120' });
  await settled(tab);
  const undo = '#step-2 .setting[data-name="beta"] .undo';
  assert.equal(await tab.$eval(undo, button => button.ariaLabel ?? button.getAttribute('aria-label')), 'set beta back to 0.2');
  await tab.$eval(undo, button => button.click());
  await tab.waitForFunction(() => decodeURIComponent(location.hash) === '#h=1/120');
  await settled(tab);
  assert.equal(await tab.$eval('#step-2 .setting[data-name="beta"] input[type=text]', field => field.value), '0.2');
  assert.ok(await tab.$eval(undo, button => button.hidden));
  await tab.close();
});

test('a field is named with its unit and its symbol', async () => {
  const tab = await live(baumgarte);
  const names = await tab.$$eval('.setting', all => all.map(one => [one.dataset.name, one.querySelector('.name').textContent.trim()]));
  assert.deepEqual([...new Set(names.filter(([name]) => name === 'h').map(([, words]) => words))], ['h in s']);
  assert.deepEqual([...new Set(names.filter(([name]) => name === 'beta').map(([, words]) => words))], ['β beta']);
  await tab.close();
});
