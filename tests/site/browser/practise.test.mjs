// The exercises in the page: written, compiled, judged and watched in Chromium and Firefox.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { after, test } from 'node:test';

import { excerpt, exercises, expected, text, variants } from '../live/practise.mjs';
import { axe, launchFirefox, open, pages, quick, quit, url } from './browser.mjs';

after(quit);

const skip = !pages.includes('practise.html') && 'this site has no exercises';
const at = exercise => url('practise.html', `#${exercise}`);
const write = (tab, code) => tab.$eval('#code', (sheet, code) => { sheet.value = code; sheet.dispatchEvent(new Event('input')); }, code);
// Checks what is in the sheet; the sentence.
async function checked(tab) {
  await tab.$eval('#sentence', sentence => { sentence.textContent = ''; });
  await tab.$eval('#check', button => button.click());
  await tab.waitForFunction(() => document.getElementById('sentence').textContent && !document.getElementById('state').textContent, { timeout: 120_000, polling: 20 });
  return tab.$eval('#sentence', sentence => sentence.textContent);
}

test('a solution is typed, checked, watched, kept, and solved', { skip, timeout: 300_000 }, async () => {
  const tab = await open(at('08_bias'));
  assert.equal(await tab.$eval('#code', sheet => sheet.value), text('08_bias', 'stub.cpp'));
  await tab.focus('#code');
  await tab.keyboard.down('Control');
  await tab.keyboard.press('a');
  await tab.keyboard.up('Control');
  await tab.keyboard.type('#include "practise.hpp"\n\ndouble bias(double C, double beta, double h) {\nreturn beta / h * C;\n}\n');
  assert.match(await tab.$eval('#code', sheet => sheet.value), /\n {2}return/, 'no indent');
  assert.equal(await checked(tab), 'Right, on all 24 probes.');
  assert.ok(await tab.$('#film svg'), 'no picture');
  const first = await tab.$eval('#film .picture', picture => picture.innerHTML);
  await tab.$eval('#time', time => { time.value = 5; time.dispatchEvent(new Event('input')); });
  await tab.waitForFunction(first => document.querySelector('#film .picture').innerHTML !== first, {}, first);
  assert.match(await tab.$eval('#solution', part => part.textContent), /beta \/ h \* C/);
  await tab.reload();
  assert.match(await tab.$eval('#code', sheet => sheet.value), /beta \/ h \* C/, 'the draft is lost');
  assert.equal(await tab.$$eval('.exercises .solved', all => all.length), 1);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('a wrong line is selected', { skip, timeout: 300_000 }, async () => {
  const tab = await open(at('08_bias'));
  await write(tab, '#include "practise.hpp"\n\ndouble bias(double C, double beta, double h) {\n  return beta / h * D;\n}\n');
  assert.equal(await checked(tab), 'It does not compile.');
  assert.equal(await tab.$eval('#code', sheet => sheet.value.slice(sheet.selectionStart, sheet.selectionEnd)), '  return beta / h * D;');
  await tab.close();
});

test("lesson 3's sweep runs in its page, and Reset brings ours back", { skip: skip || !pages.includes('03_iterations.html') && 'this site has no lesson 3', timeout: 300_000 }, async () => {
  const tab = await open(url('03_iterations.html'));
  const picture = () => tab.$eval('#figure-plain_sweep .picture', picture => picture.innerHTML), ours = await picture();
  const press = words => tab.$$eval('.excerpt button', (all, words) => all.find(one => one.textContent === words).click(), words);
  const run = async change => {
    await tab.$eval('.excerpt textarea', (code, [from, to]) => { code.value = code.value.replace(from, to); }, change);
    await tab.$eval('.excerpt .state', state => { state.textContent = ''; });
    await press('Run');
    await tab.waitForFunction(() => /yours beside|^(Your|It|Excerpts)/.test(document.querySelector('.excerpt .state').textContent), { timeout: 120_000 });
    return tab.$eval('.excerpt .state', state => state.textContent);
  };
  await press('Change it and run it');
  assert.equal(await tab.$eval('.excerpt textarea', code => code.value.trim()), excerpt('lessons/03_iterations/plain_sweep.cpp', 'sweep').trim());
  assert.match(await run(['-JV / K', '-1.6 * JV / K']), /^Drawn/);
  assert.match(await picture(), /10 links, yours/);
  assert.equal(await run(['JV / K', 'JV / X']), 'It does not compile.');
  assert.match(await tab.$eval('.excerpt textarea', code => code.value.slice(code.selectionStart, code.selectionEnd)), /JV \/ X/);
  await press('Reset');
  assert.equal(await picture(), ours);
  assert.equal(await tab.$('.excerpt textarea'), null);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('a phone is asked first', { skip }, async () => {
  const tab = await open(at('08_bias'), { width: 390, height: 844, touch: true,
    before: page => page.evaluateOnNewDocument(() => { const real = matchMedia; globalThis.matchMedia = query => query === '(pointer: coarse)' ? { matches: true } : real(query); }) });
  await write(tab, text('08_bias', 'solution.cpp'));
  await tab.click('#check');
  assert.equal(await tab.$eval('#ask', ask => ask.hidden), false);
  await tab.click('#refuse');
  assert.equal(await tab.$eval('#sentence', sentence => sentence.textContent), '');
  assert.equal(await tab.$$eval('script[src^="practise/compiler"]', scripts => scripts.length), 0);
  assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth));
  await tab.close();
});

const firefox = process.env.FIREFOX ?? '/usr/bin/firefox-esr';
for (const browser of ['Chromium', 'Firefox'])
  test(`stubs, solutions and mutants get the terminal's sentence in ${browser}`,
    { skip: skip || browser === 'Firefox' && !existsSync(firefox) && `${firefox} is not installed`, timeout: 1_800_000 }, async context => {
      let tab;
      if (browser === 'Firefox') {
        const own = await launchFirefox(firefox);
        context.after(() => own.close());
        tab = await own.newPage();
        await tab.goto(url('practise.html'), { waitUntil: 'load' });
      } else tab = await open(url('practise.html'));
      for (const exercise of quick ? exercises.slice(6, 8) : exercises) {
        await tab.evaluate(name => { location.hash = name; }, exercise);
        await tab.waitForFunction(name => !document.getElementById(name).hidden, {}, exercise);
        for (const file of variants(exercise)) {
          await write(tab, text(exercise, file));
          assert.equal(await checked(tab), expected(exercise, file), `${exercise}/${file}`);
        }
      }
      await tab.close();
    });

for (const dark of [false, true])
  test(`axe-core finds nothing on the page of the exercises, ${dark ? 'dark' : 'light'}`, { skip, timeout: 300_000 }, async () => {
    const tab = await open(at('08_bias'), { dark, width: dark ? 390 : 1440 });
    await write(tab, text('08_bias', 'mutants/minus.cpp'));
    await checked(tab);
    await tab.addScriptTag({ path: axe });
    const { violations } = await tab.evaluate(() => axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice'] }));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(node => node.html.slice(0, 160)).join(' | ')}`), []);
    await tab.close();
  });
