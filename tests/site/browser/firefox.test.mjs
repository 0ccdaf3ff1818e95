// The site in a second engine.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { test } from 'node:test';

import { launchFirefox, lessons, pages, settled, url } from './browser.mjs';

const firefox = process.env.FIREFOX ?? '/usr/bin/firefox-esr';

test('Firefox', { skip: !existsSync(firefox) && `${firefox} is not installed`, timeout: 1_800_000 }, async context => {
  const browser = await launchFirefox(firefox);
  context.after(() => browser.close());
  const open = async page => {
    const tab = await browser.newPage();
    tab.complaints = [];
    tab.on('console', message => { if (message.type() === 'error') tab.complaints.push(message.text()); });
    tab.on('pageerror', error => tab.complaints.push(error.message));
    await tab.goto(url(page), { waitUntil: 'load' });
    return tab;
  };

  for (const page of pages.filter(page => !lessons.includes(page.slice(0, -5))))
    await context.test(`${page} loads without an error`, async () => {
      const tab = await open(page);
      assert.ok(await tab.$eval('h1', heading => heading.textContent.trim()));
      assert.deepEqual(tab.complaints, []);
      await tab.close();
    });

  for (const lesson of lessons)
    await context.test(`${lesson} is live, and a slider changes it`, async () => {
      const tab = await open(`${lesson}.html`);
      await tab.waitForSelector('html[data-ready]', { timeout: 60_000 });
      const words = () => tab.$$eval('section.step', steps => steps.map(step => step.querySelector('h2').parentElement.innerHTML).join());
      const before = await words();
      const name = await tab.evaluate(() => {
        const slider = document.querySelector('.setting input[type=range]');
        slider.closest('section').scrollIntoView();
        slider.value = Math.round(slider.max * 0.8);
        slider.dispatchEvent(new Event('input', { bubbles: true }));
        return slider.closest('.setting').dataset.name;
      });
      await settled(tab);
      assert.ok(await tab.evaluate(name => decodeURIComponent(location.hash).includes(`${name}=`), name));
      assert.notEqual(await words(), before);
      assert.deepEqual(await tab.$$eval('[data-verdict="false"]', rows => rows.map(row => row.textContent)), []);
      assert.deepEqual(tab.complaints, []);
      await tab.close();
    });
});
