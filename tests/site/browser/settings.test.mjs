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
    await tab.waitForFunction(() => document.querySelector('.setting[data-name="beta"] .refused').textContent);
    assert.match(await tab.$eval('.setting[data-name="beta"] .refused', refused => refused.textContent), sentence);
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

