// The search finds what it is asked for as people type it.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { deflateRawSync } from 'node:zlib';

import { lessons, open, quit, url } from './browser.mjs';

after(quit);

const course = [['03_iterations.html', '3. Iterations', [['step-2', '2 Gauss–Seidel', 'Sweeps in the order of Gauss–Seidel.']]],
  ['04_baumgarte.html', '4. Baumgarte', [['step-2', '2 A share', 'A share β of the error; λ stays. Gräfe wrote so.']]]];

test('dashes, Greek letters and their names, accents and other names of methods are folded', async () => {
  const tab = await open(url(`${lessons[0]}.html`), { before: tab => tab.evaluateOnNewDocument(packed => {
    let take;
    Object.defineProperty(globalThis, 'byhandSearch', { get: () => () => take(packed), set(given) { take = given; } });
  }, deflateRawSync(JSON.stringify(course)).toString('base64')) });
  const results = async words => {
    await tab.$eval('.search input', (input, words) => { input.value = words; input.dispatchEvent(new Event('input')); }, words);
    await tab.waitForFunction(() => document.querySelector('.search .none').textContent);
    return tab.$$eval('.search li a', links => links.map(link => link.getAttribute('href')));
  };
  await results('anything');  // the index is loaded
  for (const words of ['Gauss-Seidel', 'gauss–seidel', 'PGS']) assert.deepEqual(await results(words), ['03_iterations.html#step-2'], words);
  for (const words of ['beta', 'β', 'lambda', 'Grafe', 'ERP']) assert.deepEqual(await results(words), ['04_baumgarte.html#step-2'], words);
  assert.deepEqual(await results('Coulomb'), []);
  assert.match(await tab.$eval('.search .none', said => said.textContent), /No step has coulomb/);
  await tab.close();
});
