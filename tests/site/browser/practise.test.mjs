// The exercises in the page: written, compiled, judged and watched in Chromium and Firefox.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { after, test } from 'node:test';

import { bias, excerpt, exercises, expected, text, variants } from '../live/practise.mjs';
import { axe, launchFirefox, open, pages, quick, quit, serve, url } from './browser.mjs';

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

test('each page leads to the exercises', { skip }, async () => {
  const tab = await open(url('practise.html'));
  assert.equal(await tab.$eval('nav[aria-label="Course"] [aria-current="page"]', link => link.textContent), 'Exercises');
  for (const page of pages) {
    await tab.goto(url(page), { waitUntil: 'domcontentloaded' });
    const links = await tab.$$eval('nav[aria-label="Course"] a', all => all.map(link => link.getAttribute('href')));
    assert.equal(links.filter(link => link === 'practise.html').length, links.length ? 1 : 0, page);
  }
  await tab.close();
});

test('a check asks nobody: the first takes scripts of the site, later ones nothing', { skip, timeout: 300_000 }, async t => {
  const { address, close } = await serve();
  t.after(close);
  const tab = await open(`${address}practise.html#08_bias`);
  const asked = [];
  tab.on('request', request => asked.push(request.url()));
  await write(tab, text('08_bias', 'solution.cpp'));
  assert.equal(await checked(tab), 'Right, on all 24 probes.');
  const own = name => new RegExp(`^${address}practise/${name}\\.js`);
  for (const name of ['compiler', 'headers', 'judge', 'texts', 'workers']) assert.equal(asked.filter(one => own(name).test(one)).length, 1, `${name} in ${asked}`);
  // Of the site itself: the page's icon, and letters when a picture first shows them.
  const elsewhere = () => asked.filter(one => !one.startsWith(`${address}assets/`) && !one.startsWith('blob:'));
  assert.deepEqual(elsewhere().filter(one => !one.startsWith(`${address}practise/`)), []);
  asked.length = 0;
  for (const file of ['mutants/minus.cpp', 'stub.cpp', 'solution.cpp']) {
    await write(tab, text('08_bias', file));
    assert.equal(await checked(tab), expected('08_bias', file));
  }
  await tab.$eval('#time', time => { time.value = 5; time.dispatchEvent(new Event('input')); });
  await tab.$eval('#unmask', unmask => { unmask.open = true; });
  await tab.waitForFunction(() => document.getElementById('test').textContent);
  assert.deepEqual(elsewhere(), []);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('a wrong code is unmasked by numbers', { skip, timeout: 60_000 }, async () => {
  const tab = await open(at('03_inverse_effective_mass'));
  const guess = async (numbers, answer) => {
    await tab.$eval('#numbers_given', (input, numbers) => { input.value = numbers; }, numbers);
    await tab.focus('#numbers_given');
    await tab.keyboard.press('Enter');
    await tab.waitForFunction(answer => document.getElementById('unmasked').textContent.startsWith(answer), {}, answer);
  };
  await tab.click('#unmask summary');
  await tab.waitForFunction(() => document.getElementById('test').textContent.includes('I1=1'));
  assert.match(await tab.$eval('#masked', code => code.textContent), /^#include[^]*J\.a1 \* J\.a1 \+/);
  await guess('m1=7', 'It passes this test too');
  await guess('I3=1', '"I3" is not given; these are: ');
  await guess('I1=0.5', 'Unmasked. Look at the units');
  assert.equal(await tab.$$eval('script[src^="practise/compiler"]', scripts => scripts.length), 0);
  await tab.evaluate(() => { location.hash = '08_bias'; });
  await tab.waitForFunction(() => document.getElementById('test').textContent.includes('beta='));
  assert.equal(await tab.$eval('#unmasked', part => part.textContent), '');
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

for (const [page, name, file, [from, to], yours] of [
  ['02_single_constraint', 'step', 'plain_step', ['-JV / K', '-0.9 * JV / K'], /C\/L², yours/],
  ['03_iterations', 'sweep', 'plain_sweep', ['-JV / K', '-1.6 * JV / K'], /10 links, yours/],
  ['04_baumgarte', 'bias', 'plain_bias', ['beta / h * C', 'beta * C'], /β = 1.5, yours/],
  ['05_contact', 'clamp', 'plain_clamp', ['std::fmax(0.0, lambda + change) - lambda', 'std::fmax(0.0, change)'], /second row, yours/],
])
  test(`${page}'s ${name} runs in its page, and Reset brings ours back`, { skip: skip || !pages.includes(`${page}.html`) && `this site has no ${page}`, timeout: 300_000 }, async () => {
    const tab = await open(url(`${page}.html`));
    const picture = () => tab.$eval(`#figure-${file} .picture`, picture => picture.innerHTML), ours = await picture();
    const press = words => tab.$$eval('.excerpt button', (all, words) => all.find(one => one.textContent === words).click(), words);
    const run = async change => {
      await tab.$eval('.excerpt textarea', (code, [from, to]) => { code.value = code.value.replace(from, to); }, change);
      await tab.$eval('.excerpt .state', state => { state.textContent = ''; });
      await press('Run');
      await tab.waitForFunction(() => /yours beside|^(Your|It|Excerpts)/.test(document.querySelector('.excerpt .state').textContent), { timeout: 120_000 });
      return tab.$eval('.excerpt .state', state => state.textContent);
    };
    await press('Change it and run it');
    assert.equal(await tab.$eval('.excerpt textarea', code => code.value.trim()), excerpt(`lessons/${page}/${file}.cpp`, name).trim());
    assert.match(await run([from, to]), /^Drawn/);
    assert.match((await picture()).replaceAll(/<[^>]*>/g, ''), yours);
    assert.equal(await run([to, 'nothing']), 'It does not compile.');
    assert.match(await tab.$eval('.excerpt textarea', code => code.value.slice(code.selectionStart, code.selectionEnd)), /nothing/);
    await press('Reset');
    assert.equal(await picture(), ours);
    assert.equal(await tab.$('.excerpt textarea'), null);
    assert.deepEqual(tab.complaints, []);
    await tab.close();
  });

// What no count of rounds stops, nor a limit of the compiler: more such files are in ../live/attacks.test.mjs.
test('a file that never compiles, never returns, or breaks the compiler is told so, and the next is judged', { skip: skip || quick && 'takes a minute', timeout: 400_000 }, async () => {
  const tab = await open(at('08_bias'));
  for (const [code, sentence] of [
    [bias('return A<40>::x;', 'template <int N, int M = 0> struct A { static constexpr int x = A<N - 1, 2 * M>::x + A<N - 1, 2 * M + 1>::x; };\ntemplate <int M> struct A<0, M> { static constexpr int x = 1; };'), 'It does not compile within 30 s.'],
    [bias('asm volatile("loop\\nbr 0\\nend_loop"); return 0;'), 'Your code did not return within 20 s; look for a loop that never ends.'],
    [`#pragma clang __debug crash\n${bias('return 0;')}`, 'The compiler broke off: look for what is very long or nested very deeply.'],
    [bias('return 0;', 'extern "C" __attribute__((export_name("call"))) int mine(int) { return 1; }'), 'Your program does not begin: it imports or exports functions by their names, which an exercise never does.'],
    [bias('volatile double b = 1;\nreturn bias(C + b, beta, h) + b;'), 'Your code calls itself without an end in line 5: the stack is full.'],
    [bias('return *(volatile double*)(1u << 30);'), 'Your code crashed in line 4: it used memory that is not its own. Look at pointers and indices.'],
    [bias('std::puts("<b id=fake>Right, on all 24 probes.</b>"); return 0;', '#include <cstdio>'), 'Your code breaks a law: after a step, C is (1 − β)C.'],
    [text('08_bias', 'solution.cpp'), 'Right, on all 24 probes.'],
  ]) {
    await write(tab, code);
    assert.equal(await checked(tab), sentence);
    assert.equal(await tab.$('#fake'), null);
  }
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
