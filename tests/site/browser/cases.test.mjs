// The casebook: its list, a page for each case with its numbers, its films, and its scene in the playground.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { open, pages, quit, site, url } from './browser.mjs';

after(quit);

const folders = readdirSync(new URL('../../../lessons/cases', import.meta.url)).filter(name => /^\d\d_/.test(name)).sort();
const skip = !pages.includes('cases.html') && 'this site has no casebook';

test('the list leads to a page for each case', { skip }, async () => {
  const tab = await open(url('cases.html'));
  const links = await tab.$$eval('main ol a', all => all.map(link => link.getAttribute('href')));
  assert.deepEqual(links, folders.map(name => `case_${name.slice(0, 2)}.html`));
  await tab.close();
});

test('each page has its report, its numbers, two films and its scene in the playground', { skip }, async () => {
  for (const name of folders) {
    const tab = await open(url(`case_${name.slice(0, 2)}.html`));
    const { links, verdicts, width } = await tab.evaluate(() => ({
      links: [...document.querySelectorAll('main a')].map(link => link.getAttribute('href')),
      verdicts: [...document.querySelectorAll('[data-verdict]')].map(row => row.dataset.verdict),
      width: document.documentElement.scrollWidth - document.documentElement.clientWidth,
    }));
    assert.ok(verdicts.length >= 2 && verdicts.every(verdict => verdict === 'holds'), `${name}: ${verdicts}`);
    assert.ok(links.includes(`playground.html#${name}`), name);
    const films = links.filter(link => link.endsWith('.svg'));
    assert.equal(films.length, 2, name);
    for (const film of films) {
      assert.ok(existsSync(join(site, film)), film);
      const frames = readFileSync(join(site, film), 'utf8').match(/<svg style="animation-delay:/g) ?? [];
      assert.ok(frames.length > 1 && frames.length <= 12, `${film}: ${frames.length} pictures`);
    }
    assert.ok(width <= 0, name);
    assert.match(await tab.$eval('#step-1', step => step.textContent), /https:\/\/github\.com\//);
    await tab.close();
  }
});
