// A film that a teacher takes along is a file that plays by itself.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { lessons, open, quit, site } from './browser.mjs';

after(quit);

for (const lesson of lessons)
  test(`each film of ${lesson} shows one picture at a time, one after the other`, async context => {
    const folder = mkdtempSync(join(tmpdir(), 'films-'));
    execFileSync('/usr/bin/python3', ['-m', 'zipfile', '-e', join(site, 'downloads', `${lesson}_figures.zip`), folder]);
    const films = readdirSync(folder).filter(name => name.startsWith('film-'));
    for (const film of films) {
      const tab = await open(pathToFileURL(join(folder, film)).href);
      const { pictures, shown } = await tab.evaluate(async () => {
        const pictures = [...document.querySelectorAll('svg > svg')], shown = [];
        const animations = document.getAnimations();
        for (const share of [0, 0.5, 0.9]) {
          for (const animation of animations) {
            animation.pause();
            animation.currentTime = share * animation.effect.getTiming().duration + 1;
          }
          shown.push(pictures.flatMap((one, i) => getComputedStyle(one).visibility === 'visible' ? [i] : []));
        }
        return { pictures: pictures.length, shown };
      });
      assert.ok(pictures > 1, `${film} has ${pictures} picture`);
      assert.deepEqual(shown.map(each => each.length), [1, 1, 1], `${film}: ${JSON.stringify(shown)}`);
      assert.ok(shown[0][0] < shown[1][0] && shown[1][0] <= shown[2][0], `${film}: ${JSON.stringify(shown)}`);
      await tab.close();
    }
    context.diagnostic(`${films.length} films`);
    rmSync(folder, { recursive: true });
  });
