// Questions, films, the keyboard, and a page whose program is damaged.
import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { lessons, live, open, quick, quit, settled, site } from './browser.mjs';

after(quit);

const chosen = quick ? lessons.filter(name => name.startsWith('04')) : lessons;
const baumgarte = lessons.find(name => name.startsWith('04'));

for (const lesson of chosen)
  test(`${lesson}: right answers are right, wrong ones are not, and each gets the lesson's reply`, { timeout: 600_000 }, async () => {
    const tab = await live(lesson);
    const replies = await tab.evaluate(async () => {
      const all = [];
      for (const form of document.querySelectorAll('form[data-question]')) {
        const reply = form.querySelector('.reply'), name = form.dataset.question;
        const answered = async act => {
          reply.textContent = '';
          act();
          for (let i = 0; i < 1200 && !reply.textContent; ++i) await new Promise(resolve => setTimeout(resolve, 50));
          return { right: reply.classList.contains('right'), wrong: reply.classList.contains('wrong'), words: reply.textContent };
        };
        if (form.dataset.kind === 'number') {
          const type = words => answered(() => { form.elements.typed.value = words; form.requestSubmit(); });
          const solution = form.querySelector('.solution strong').textContent;
          all.push({ name, kind: 'number', right: await type(solution), wrong: await type('-123456789'), odd: await type('many') });
        } else {
          const options = [...form.querySelectorAll('input[type=radio]')], given = [];
          for (const option of options) given.push(await answered(() => option.click()));
          all.push({ name, kind: 'choice', given });
        }
      }
      return all;
    });
    assert.ok(replies.length > 0, 'there are questions');
    for (const { name, kind, right, wrong, odd, given } of replies) {
      if (kind === 'choice') {
        assert.equal(given.filter(reply => reply.right).length, 1, `${name} has one right option`);
        assert.ok(given.every(reply => reply.right ? reply.words.startsWith('Yes.') : reply.words.startsWith('No.')), name);
      } else {
        assert.ok(right.right && !right.wrong, `${name}: the printed answer is accepted: ${right.words}`);
        assert.ok(wrong.wrong && !wrong.right, `${name}: ${wrong.words}`);
        assert.ok(!odd.right && !odd.wrong && odd.words.includes('not a number'), `${name}: ${odd.words}`);
      }
    }
    assert.deepEqual(tab.complaints, []);
    await tab.close();
  });

// A browser's clock ticks so seldom that a frame of lesson 9 takes no time by it.
test('the first thing asked of a step may be a grade, and its chart of times has times', { skip: !lessons.some(name => name.startsWith('09')) && 'without lesson 9', timeout: 600_000 }, async () => {
  const tab = await live(lessons.find(name => name.startsWith('09')));
  await tab.$eval('form[data-question="2.1"]', form => form.querySelector('input[type=radio]').click());
  await tab.waitForFunction(() => document.querySelector('form[data-question="2.1"] .reply').textContent, { timeout: 300_000 });
  assert.match(await tab.$eval('form[data-question="2.1"] .reply', reply => reply.textContent), /^(Yes|No)\. /);
  const told = await tab.evaluate(() => {
    const step = byhandPage.steps.find(({ label }) => label === '2');
    return step.lesson.ask(step.request({ ask: 'tell' }));
  });
  assert.equal(told.error, undefined);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('a film plays, pauses, is scrubbed and goes frame by frame', async () => {
  const tab = await live(baumgarte);
  const first = 'figure[data-film]';  // telling its step may replace the figure
  await tab.$eval(first, film => film.scrollIntoView());
  const press = label => tab.click(`${first} .player button[aria-label="${label}"]`);
  const offers = label => tab.waitForSelector(`${first} .player button[aria-label="${label}"]`);
  const time = () => tab.$eval(`${first} .player input`, slider => +slider.value);
  const reaches = at => tab.waitForFunction((first, at) => +document.querySelector(`${first} .player input`).value === at, {}, first, at);
  const picture = () => tab.$eval(`${first} .picture`, picture => picture.innerHTML);

  await press('play');
  await offers('pause');
  await tab.waitForFunction(first => { const { value, max } = document.querySelector(`${first} .player input`); return value > 3 && value < max; }, {}, first);
  const moving = await picture();
  await press('pause');
  await offers('play');
  await tab.waitForFunction(() => byhandPage.steps.every(({ films }) => [...films.values()].every(film => !film.drawing)));
  const stopped = await time(), still = await picture();
  assert.notEqual(still, moving, 'frames differ');
  await new Promise(resolve => setTimeout(resolve, 300));
  assert.equal(await time(), stopped, 'it stands still');

  await press('one frame on');
  await reaches(stopped + 1);
  await press('one frame back');
  await reaches(stopped);
  assert.equal(await picture(), still, 'the same frame is the same picture');

  await tab.$eval(`${first} .player input`, slider => { slider.value = 0; slider.dispatchEvent(new Event('input')); });
  await tab.waitForFunction((first, before) => document.querySelector(`${first} .picture`).innerHTML !== before, {}, first, still);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('no film moves by itself', async () => {
  const tab = await live(baumgarte);
  const pictures = () => tab.$$eval('figure[data-film] .picture', all => all.map(one => one.innerHTML).join());
  const before = await pictures();
  await new Promise(resolve => setTimeout(resolve, 1000));
  assert.equal(await pictures(), before);
  await tab.close();
});

test('films of this lesson play at 30 frames a second', { skip: quick }, async () => {
  const tab = await live(baumgarte);
  const rates = await tab.evaluate(async () => {
    const rates = [];
    for (const step of byhandPage.steps.filter(step => step.lesson === step.lesson)) for (const film of step.films.values()) {
      await film.ready();
      if (!film.rate || film.frames < 20) continue;
      await film.run();
      rates.push([film.name, film.perSecond]);
    }
    return rates;
  });
  assert.ok(rates.length > 0);
  for (const [name, perSecond] of rates) assert.ok(perSecond >= 24, `${name}: ${perSecond.toFixed(1)} frames/s`);
  await tab.close();
});

test('the keyboard alone suffices: to a slider, along it, into a film and a question', async () => {
  const tab = await live(baumgarte);
  const reach = async selector => {
    for (let i = 0; i < 600; ++i) {
      await tab.keyboard.press('Tab');
      if (await tab.evaluate(selector => document.activeElement.matches(selector), selector)) return;
    }
    assert.fail(`Tab never reaches ${selector}`);
  };
  await reach('.setting[data-name="beta"] input[type=range]');
  for (let i = 0; i < 5; ++i) await tab.keyboard.press('ArrowRight');
  await tab.waitForFunction(() => decodeURIComponent(location.hash).includes('beta='));
  await settled(tab);
  assert.ok(await tab.evaluate(() => document.activeElement.matches('.setting[data-name="beta"] input[type=range]')), 'the focus stays');
  await reach('.player button[aria-label="play"]');
  await tab.keyboard.press('Enter');
  await tab.waitForFunction(() => document.querySelector('.player button[aria-label="pause"]'));
  await tab.keyboard.press('Enter');
  await reach('form[data-kind="number"] input[name="typed"]');
  await tab.keyboard.type('1');
  await tab.keyboard.press('Enter');
  await tab.waitForFunction(() => document.activeElement.closest('form').querySelector('.reply').textContent);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

for (const lost of ['files.js', 'worker.js', 'hold.js', 'settings.js'])
  test(`a page without ${lost} says what it cannot do, and no more`, async () => {
    const folder = mkdtempSync(join(tmpdir(), 'site-'));
    cpSync(site, folder, { recursive: true });
    rmSync(join(folder, 'live', lost));
    const tab = await open(pathToFileURL(join(folder, `${baumgarte}.html`)).href);
    await tab.waitForSelector('.changes[role="alert"]', { timeout: 30_000 });
    assert.equal(await tab.$eval('.changes', bar => bar.textContent), 'This page could not load its program: you can read it, but not change it.');
    assert.ok(tab.complaints.every(words => words.includes(lost) || words.includes('ERR_FILE_NOT_FOUND')), tab.complaints.join());
    await tab.close();
    rmSync(folder, { recursive: true });
  });

test('a first wrong choice gets a hint and a second try, and what is not understood gets no words of a terminal', async () => {
  const tab = await live(baumgarte);
  const form = await tab.$('form[data-kind="choice"]');
  const hint = await form.evaluate(form => form.querySelector('.hint > p')?.textContent ?? 'Think it over and choose again.');
  const replies = await form.evaluate(async form => {
    const reply = form.querySelector('.reply'), replies = [];
    for (const option of form.querySelectorAll('input[type=radio]')) {
      reply.textContent = '';
      option.click();
      while (!reply.textContent) await new Promise(resolve => setTimeout(resolve, 20));
      if (reply.classList.contains('wrong')) replies.push(reply.textContent);
    }
    return replies;
  });
  assert.equal(replies[0], `No. ${hint}`);
  if (replies[1]) assert.notEqual(replies[1], replies[0]);
  const number = await tab.$('form[data-kind="number"]');
  await number.evaluate(form => { form.elements.typed.value = 'abc'; form.requestSubmit(); });
  await tab.waitForFunction(form => form.querySelector('.reply').textContent, {}, number);
  assert.doesNotMatch(await number.$eval('.reply', reply => reply.textContent), /`|what else can be typed/);
  await tab.close();
});

for (const [what, damage] of [
  ['cut short', text => text.slice(0, text.length / 2).replace(/\\+$/, '') + '";\n'],
  ['another file', () => '(globalThis.byhandParts ??= {}).lesson = "aGVsbG8=";\n'],
])
  test(`a page whose program is ${what} says so and stays readable`, async () => {
    const folder = mkdtempSync(join(tmpdir(), 'site-'));
    cpSync(site, folder, { recursive: true });
    const program = join(folder, 'live', `${baumgarte}.js`);
    writeFileSync(program, damage(readFileSync(program, 'utf8')));
    const tab = await open(pathToFileURL(join(folder, `${baumgarte}.html`)).href);
    await tab.waitForSelector('.changes[role="alert"]', { timeout: 30_000 });
    assert.match(await tab.$eval('.changes', bar => bar.textContent), /program .* (stays|stayed) /);
    assert.ok((await tab.$$('section.step')).length >= 5);
    assert.equal(await tab.$eval('html', html => html.classList.contains('live')), false, 'no dead sliders or buttons');
    assert.equal((await tab.$$('.player, .setting')).length, 0);
    await tab.close();
    rmSync(folder, { recursive: true });
  });
