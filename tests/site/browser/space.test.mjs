// Scenes in space: WebGL draws them in the page as OpenGL drew them for it.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';

import { lessons, live, quit, settled } from './browser.mjs';

after(quit);

const space = lessons.find(name => name.startsWith('07'));
const skip = !space && 'the site is without lesson 7';

test('without a change WebGL draws each scene as the page has it', { skip }, async context => {
  const tab = await live(space);
  const compared = await tab.evaluate(async () => {
    const images = step => [...step.section.querySelectorAll(':is(image, foreignObject img)')].map(image => image.getAttribute('href') ?? image.src);
    const pixels = async href => {
      const image = new Image();
      image.src = href;
      await image.decode();
      const sheet = new OffscreenCanvas(image.width, image.height).getContext('2d', { willReadFrequently: true });
      sheet.drawImage(image, 0, 0);
      return sheet.getImageData(0, 0, image.width, image.height);
    };
    // Both smooth edges in their own way, so means of 8 × 8 pixels are compared.
    const difference = (a, b) => {
      if (a.width !== b.width || a.height !== b.height) return { most: Infinity, mean: Infinity };
      let most = 0, sum = 0, count = 0;
      for (let y = 0; y + 8 <= a.height; y += 8)
        for (let x = 0; x + 8 <= a.width; x += 8)
          for (let channel = 0; channel < 3; ++channel, ++count) {
            let block = 0;
            for (let i = 0; i < 64; ++i) {
              const at = 4 * ((y + (i >> 3)) * a.width + x + (i & 7)) + channel;
              block += a.data[at] - b.data[at];
            }
            most = Math.max(most, Math.abs(block) / 64);
            sum += Math.abs(block) / 64;
          }
      return { most, mean: sum / count };
    };
    const all = [];
    for (const step of byhandPage.steps) {
      const written = images(step);
      if (!written.length) continue;
      step.section.querySelectorAll(':is(image, foreignObject img)').forEach(image => image.remove());  // so what is there is drawn anew
      await step.tell(true);
      const drawn = images(step);
      for (let i = 0; i < written.length; ++i)
        all.push({ place: `${step.label}.${i}`, anew: drawn[i] !== undefined && drawn[i] !== written[i], said: step.state.textContent,
          ...(drawn[i] ? difference(await pixels(written[i]), await pixels(drawn[i])) : {}) });
    }
    return all;
  });
  assert.ok(compared.length >= 8, `${compared.length} scenes in space`);
  context.diagnostic(compared.map(({ place, most, mean }) => `${place}: ${most?.toFixed(1)}, ${mean?.toFixed(2)}`).join('; ') + ' of 255, most and mean');
  for (const { place, anew, said, most, mean } of compared) {
    assert.ok(anew, `${place} is drawn by the browser: ${said}`);
    assert.ok(most < 48 && mean < 0.5, `${place}: ${most} at most, ${mean} in the mean, of 255`);
  }
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('while a slider moves a scene is drawn with fewer pixels, and in full once it rests', { skip }, async () => {
  const tab = await live(space);
  const figure = await tab.evaluateHandle(() => document.querySelector('figure[data-figure]:has(foreignObject)'));
  const width = () => figure.evaluate(async figure => {
    const image = new Image();
    image.src = figure.querySelector('image').getAttribute('href');
    await image.decode();
    return image.naturalWidth;
  });
  await figure.evaluate(figure => {
    figure.scrollIntoView();
    const step = byhandPage.steps.find(step => step.section.contains(figure)), slider = figure.querySelector('.knobs input[type=range]');
    const told = new Promise(resolve => { step.show = html => { delete step.show; step.show(html); resolve(); }; });
    slider.value = slider.max / 3;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    return told;
  });
  const small = await width();
  await settled(tab);
  const full = await width();
  assert.ok(full >= 4 * small - 4 && full <= 4 * small + 4 && small > 50, `${small} and ${full} pixels wide`);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('a film in space moves', { skip }, async () => {
  const tab = await live(space);
  const frames = await tab.evaluate(async () => {
    const step = byhandPage.steps.find(step => [...step.films.values()].some(film => film.figure.querySelector('foreignObject, image')));
    const film = [...step.films.values()].find(film => film.figure.querySelector('foreignObject, image'));
    const pictures = [];
    for (const index of [0, 10, 0]) {
      await film.show(index);
      pictures.push(film.figure.querySelector('image').getAttribute('href'));
    }
    return pictures;
  });
  assert.ok(frames[1] !== frames[0], 'frames differ');
  assert.ok(frames[2] === frames[0], 'the same frame is the same picture');
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});

test('without WebGL a picture says why its window is empty', { skip }, async () => {
  const tab = await live(space, { before: page => page.evaluateOnNewDocument(() => {
    const { createObjectURL } = URL;  // of the worker's program
    URL.createObjectURL = blob => createObjectURL.call(URL, new Blob(['OffscreenCanvas.prototype.getContext = () => null;', blob]));
  }) });
  const words = await tab.evaluate(async () => {
    const step = byhandPage.steps.find(step => step.section.querySelector('foreignObject, image'));
    step.section.querySelectorAll(':is(image, foreignObject img)').forEach(image => image.remove());
    await step.tell(true);
    return step.section.textContent;
  });
  assert.match(words, /This browser has no WebGL/);
  assert.deepEqual(tab.complaints, []);
  await tab.close();
});
