// The derivation desk in the page: typed by keyboard, judged line by line, run and drawn.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { after, test } from 'node:test';

import { axe, launchFirefox, lessons, live, open, pages, quit, url } from './browser.mjs';

after(quit);

const skip = !pages.includes('desk.html') && 'this site has no desk';
const rod = ['C = |p2 - p1|^2/2 - L^2/2', 'dC = (p2 - p1) . (v2 + w2 x r2 - v1 - w1 x r1)', 'J = [-d, -(r1 x d), d, r2 x d]'];
const at = lines => url('desk.html', '#' + encodeURIComponent(lines.join('\n')));
const verdict = tab => tab.$eval('#verdict', element => element.textContent);
const judged = (tab, words) => tab.waitForFunction(words => document.getElementById('verdict').textContent.includes(words),
  { timeout: 20_000, polling: 50 }, words);

for (const { name, width, height, touch } of [{ name: 'wide', width: 1440, height: 900 }, { name: 'on a phone', width: 390, height: 844, touch: true }])
  test(`a derivation is typed and judged by the keyboard alone, ${name}`, { skip }, async () => {
    const tab = await open(url('desk.html'), { width, height, touch });
    await judged(tab, 'right');
    const focused = () => tab.evaluate(() => document.activeElement.id);
    for (let i = 0; i < 20 && await focused() !== 'sheet'; ++i) await tab.keyboard.press('Tab');
    assert.equal(await focused(), 'sheet');
    await tab.keyboard.down('Control');
    await tab.keyboard.press('a');
    await tab.keyboard.up('Control');
    await tab.keyboard.type(`${rod[0]}\ndC = (p2 - p1) . (v2 + r2 x w2 - v1 - w1 x r1)`);
    await judged(tab, 'you wrote r × ω');
    assert.equal(await tab.$eval('#verdict', element => element.getAttribute('role')), 'status');
    assert.equal(await tab.$$eval('#said .formula', formulas => formulas.length), 2);
    // From the wrong line to its hint and to its place in the sheet.
    await tab.focus('#said .wrong .where');
    // A formula that is wider than the page takes the focus, so that keys scroll it.
    do await tab.keyboard.press('Tab'); while (await tab.evaluate(() => document.activeElement.matches('.formula')));
    await tab.keyboard.press('Enter');
    assert.equal(await tab.$$eval('#said .hints li', hints => hints.length), 1);
    await tab.focus('#said .wrong .where');
    await tab.keyboard.press('Enter');
    assert.equal(await tab.$eval('#sheet', sheet => sheet.value.slice(sheet.selectionStart, sheet.selectionEnd)),
      '(p2 - p1) . (v2 + r2 x w2 - v1 - w1 x r1)');
    await tab.keyboard.type(`(p2 - p1) . (v2 + w2 x r2 - v1 - w1 x r1)\n${rod[2]}`);
    await judged(tab, 'J stands');
    assert.deepEqual(await tab.evaluate(() => decodeURIComponent(location.hash.slice(1)).split('\n')), rod);
    assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth));
    const small = await tab.$$eval('main button, main input', controls => controls.map(control => control.getBoundingClientRect())
      .filter(box => box.height > 0 && (box.height < 24 || box.width < 24)).length);
    assert.equal(small, 0, 'controls below 24 pixels');
    assert.deepEqual(tab.complaints, []);
    await tab.close();
  });

test('LaTeX is read as it is pasted', { skip }, async () => {
  const tab = await open(url('desk.html'));
  await judged(tab, 'right');
  await tab.$eval('#sheet', sheet => { sheet.value = ''; sheet.focus(); });
  await tab.keyboard.sendCharacter('C = \\frac{1}{2} |\\mathbf{p}_2 - \\mathbf{p}_1|^2 - \\frac{L^2}{2}\n\\dot C = (p_2 - p_1) \\cdot (v_2 + \\omega_2 \\times r_2 - v_1 - \\omega_1 \\times r_1)');
  await judged(tab, 'All lines are right');
  await tab.close();
});

test('what is derived runs in three scenes, with the parts of J on the bodies', { skip }, async () => {
  const tab = await open(at(rod));
  await judged(tab, 'J stands');
  const drawn = () => tab.evaluate(() => ({
    bodies: document.querySelectorAll('#stage .body').length, fixed: document.querySelectorAll('#stage .fixed').length,
    parts: document.querySelectorAll('#stage .part').length, told: document.getElementById('told').textContent,
  }));
  const pendulum = await drawn();
  assert.deepEqual([pendulum.bodies, pendulum.fixed], [2, 1]);
  assert.ok(pendulum.parts >= 4, `${pendulum.parts} strokes of arrows`);
  assert.match(pendulum.told, /1 row: \|C\| was at most .* m²\. At 0\.00 s J's parts on body 1 are/);
  for (const [scene, bodies, fixed] of [['chain', 3, 1], ['box', 2, 0]]) {
    await tab.focus(`#scenes [data-scene=${scene}]`);
    await tab.keyboard.press('Enter');
    const seen = await drawn();
    assert.deepEqual([seen.bodies, seen.fixed], [bodies, fixed], scene);
    assert.notEqual(seen.told, pendulum.told);
  }
  const before = await drawn();
  await tab.focus('#time');
  await tab.keyboard.press('End');
  const after = await drawn();
  assert.match(after.told, /At 5\.00 s/);
  assert.notEqual(after.told, before.told);
  await tab.focus('#play');
  await tab.keyboard.press('Enter');
  await tab.waitForFunction(() => { const seconds = parseFloat(document.getElementById('clock').textContent); return seconds > 0.1 && seconds < 4; }, { timeout: 5000 });
  await tab.keyboard.press('Enter');
  assert.equal(await tab.$eval('#play', button => button.textContent), 'Play');
  // A line that spoils the derivation takes the scene away.
  await tab.focus('#sheet');
  await tab.keyboard.type('C = |');
  await judged(tab, 'wrong');
  assert.ok(await tab.$eval('#run', section => section.hidden));
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('a task and a link bring their lines', { skip }, async () => {
  const tab = await open(url('desk.html', '#task-4'));
  await judged(tab, 'right');
  assert.match(await tab.$eval('#sheet', sheet => sheet.value), /C = p2 - p1/);
  await tab.click('#task-7');
  await judged(tab, 'right');
  assert.match(await tab.$eval('#sheet', sheet => sheet.value), /θ1 \+ k θ2/);
  await tab.close();
});

// The derivations that tests/desk/transcripts.cpp judges natively.
const transcripts = new URL('../../desk/transcripts/', import.meta.url);
for (const file of readdirSync(transcripts))
  test(`${file} is judged in the page as at a terminal`, { skip }, async () => {
    const tab = await open(url('desk.html'));
    await judged(tab, 'right');
    const judge = lines => tab.evaluate(text => {
      const sheet = document.getElementById('sheet');
      sheet.value = text;
      sheet.dispatchEvent(new Event('input'));
      return new Promise(done => setTimeout(() => done([...document.querySelectorAll('#said strong')].map(strong => strong.textContent)), 600));
    }, lines.join('\n'));
    const right = [];
    for (const line of readFileSync(new URL(file, transcripts), 'utf8').trim().split('\n').filter(line => !line.startsWith('#'))) {
      const [, name, wrong] = /^wrong \((.*?)\): (.*)$/.exec(line) ?? [];
      if (name) assert.equal((await judge([...right, wrong])).at(-1), `wrong: ${name}`);
      else right.push(line);
    }
    assert.ok((await judge(right)).every(word => word === 'right'));
    await judged(tab, 'J stands');
    assert.ok(await tab.$$eval('#stage .part', parts => parts.length) > 0, 'no arrows');
    await tab.close();
  });

test('lesson 1 leads to the desk with its constraint', { skip: skip || !lessons.includes('01_jacobian') && 'this site has no lesson 1' }, async () => {
  const tab = await live('01_jacobian');
  const links = () => tab.$$eval('a.desk', links => links.map(link => link.getAttribute('href')));
  assert.deepEqual((await links()).sort(), [2, 3, 5].map(task => `desk.html#task-${task}`));
  await tab.click('a.desk[href$="task-2"]');
  await judged(tab, 'right');
  assert.match(await tab.$eval('#sheet', sheet => sheet.value), /C = \|p2 - p1\|\^2\/2 - L\^2\/2/);
  await tab.close();
});

for (const dark of [false, true])
  for (const [what, lines] of [['a wrong line', [rod[0], 'dC = (p2 - p1) . (v2 - v1)']], ['a constraint that runs', rod]])
    test(`axe-core finds nothing on the desk with ${what}, ${dark ? 'dark' : 'light'}`, { skip }, async () => {
      const tab = await open(at(lines), { dark, width: dark ? 390 : 1440 });
      await tab.waitForFunction(() => document.getElementById('verdict').textContent);
      await tab.evaluate(() => document.querySelectorAll('details').forEach(fold => { fold.open = true; }));
      await tab.addScriptTag({ path: axe });
      const { violations } = await tab.evaluate(() => axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice'] }));
      assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(node => node.html.slice(0, 160)).join(' | ')}`), []);
      await tab.close();
    });

const firefox = process.env.FIREFOX ?? '/usr/bin/firefox-esr';
test('Firefox judges and runs the same', { skip: skip || !existsSync(firefox) && `${firefox} is not installed`, timeout: 300_000 }, async context => {
  const browser = await launchFirefox(firefox);
  context.after(() => browser.close());
  const tab = await browser.newPage();
  await tab.goto(at(rod), { waitUntil: 'load' });
  await judged(tab, 'J stands');
  const chromium = await open(at(rod));
  await judged(chromium, 'J stands');
  const words = page => page.$$eval('#verdict, #said, #report, #told', parts => parts.map(part => part.textContent));
  assert.deepEqual(await words(tab), await words(chromium));
  await chromium.close();
});
