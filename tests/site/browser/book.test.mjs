// The e-book, as a reader of 375, 600 or 800 pixels shows its chapters.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { open, quick, quit, site } from './browser.mjs';

after(quit);

const book = join(site, 'constraints_by_hand.epub');

test('every figure of the e-book fits its page', { skip: !existsSync(book) && 'only of the whole course' }, async context => {
  const folder = mkdtempSync(join(tmpdir(), 'book-'));
  execFileSync('/usr/bin/python3', ['-m', 'zipfile', '-e', book, folder]);
  let figures = 0;
  for (const chapter of readdirSync(join(folder, 'book')).filter(name => name.endsWith('.xhtml')))
    for (const width of [375, 600, 800]) {
      const tab = await open(pathToFileURL(join(folder, 'book', chapter)).href, { width });
      const { wide, count } = await tab.evaluate(() => {
        const pictures = [...document.querySelectorAll('.picture > *')];
        const room = document.body.getBoundingClientRect();
        return { count: pictures.length, wide: pictures.filter(one => one.getBoundingClientRect().right > room.right + 1).map(one => one.closest('figure').id) };
      });
      assert.deepEqual(wide, [], `${chapter} at ${width} pixels`);
      figures += count;
      await tab.close();
    }
  context.diagnostic(`${figures / 3} figures`);
  assert.ok(figures > 0);
  rmSync(folder, { recursive: true });
});

const judge = '/usr/share/java/epubcheck.jar';
const missing = !existsSync(book) ? 'only of the whole course' : quick ? 'of some lessons, to whose others it leads' : !existsSync(judge) && 'epubcheck is not installed';

test('epubcheck finds nothing in the e-book', { skip: missing }, () => {
  const { stdout, stderr } = spawnSync('java', ['-jar', judge, book], { encoding: 'utf8' });
  assert.match(stdout + stderr, /0 fatals \/ 0 errors \/ 0 warnings/);
});
