// A scene goes in the playground as at a terminal, to the bit. BYHAND_WASM: folder of playground.wasm; BYHAND_PROGRAMS: of
// the native program watched_scene.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { firstDifference, playground, root, startScenes, watched } from './playground.mjs';

const steps = 300;
const page = await playground();
const text = file => readFileSync(join(root, file), 'utf8');

for (const file of startScenes)
  test(`${file} has the terminal's bits after ${steps} steps`, () => {
    const { failure } = page.ask({ ask: 'open', text: text(file) });
    assert.equal(failure, undefined);
    const [, , , ...here] = page.advance(steps), { stopped } = page.ask({ ask: 'stopped' }), native = watched(join(root, file), steps);
    assert.equal(stopped, native.stopped);
    assert.equal(firstDifference(here, native.numbers), -1);
  });

test('a moment is a file, from which the scene goes on as it would have', () => {
  page.ask({ ask: 'open', text: text('lessons/scenes/ragdoll.json') });
  page.advance(40);
  const { file } = page.ask({ ask: 'now' });
  const [, , , ...there] = page.advance(0);
  assert.equal(page.ask({ ask: 'open', text: file }).failure, undefined);
  const [time, , , ...here] = page.advance(0);
  assert.equal(time, 0);
  assert.equal(firstDifference(here, there), -1);
});

test('the hand pulls its body along and leaves nothing behind', () => {
  page.ask({ ask: 'open', text: text('lessons/scenes/stack.json') });
  page.ask({ ask: 'grab', body: 10, at: [0, 9.5] });
  page.ask({ ask: 'move', at: [3, 11] });
  const held = page.advance(60), x = held[3 + 4 * 10];
  assert.ok(x > 2.5 && x < 3.5, `${x} m`);
  const during = JSON.parse(page.ask({ ask: 'now' }).file);
  page.ask({ ask: 'release' });
  const after = JSON.parse(page.ask({ ask: 'now' }).file);
  assert.equal(during.bodies.length, 11);
  assert.deepEqual(after, during);
  // Thrown, it goes on with the hand's speed and falls.
  page.advance(120);
  assert.ok(page.advance(0)[4 + 4 * 10] < 9, 'it has fallen');
});

test('another method goes on from the same moment', () => {
  page.ask({ ask: 'open', text: text('lessons/scenes/pyramid.json') });
  const before = page.advance(10);
  const changed = { ...JSON.parse(text('lessons/scenes/pyramid.json')), method: { solver: 'gauss_seidel', sweeps: 1, warm_start: false, cure: 'none' } };
  assert.equal(page.ask({ ask: 'use', text: JSON.stringify(changed) }).failure, undefined);
  assert.equal(firstDifference(page.advance(0).slice(3), before.slice(3)), -1);
  assert.ok(page.advance(120)[2] > before[2] + 1e-3, 'one cold sweep lets the boxes sink into each other');
});

test('within a step it says what a lesson says of the same step', () => {
  page.ask({ ask: 'open', text: text('lessons/scenes/cover_chain.json') });
  page.advance(30);
  const part = at => page.ask({ ask: 'part', part: at, width: 960, camera: [0, -10, 20], longest: 3 });
  assert.match(part(1.5).formula, /^V \+ gh, gh = 0\.164 m\/s$/);
  assert.match(part(2.5).formula, /^JV\/\|l₂\| = .* m\/s, b\/\|l₂\| = .* m\/s$/);
  assert.match(part(3.5).formula, /^λ\|l₂\| = .* N·s$/);
  assert.ok((part(3.9).svg.match(/<path/g) ?? []).length > 5, 'arrows');
  // In the last part the bodies move by hV, which is where the next step takes them.
  const { moved } = part(5.999), next = page.advance(1);
  assert.equal(moved.length, 10);
  for (const { body, numbers } of moved) numbers.forEach((x, k) => assert.ok(Math.abs(x - next[3 + 4 * body + k]) < 1e-9));
});

// Seen from the right, along -x: to the right is -z.
const fromTheRight = [[0, 0, -1], [0, 1, 0]];
test('in space the hand pulls to the right and up in the picture, and the parts of a step are seen so', () => {
  page.ask({ ask: 'open', text: text('lessons/scenes/heavy_on_light_in_space.json') });
  const [x, y, z] = page.advance(30).slice(3 + 24, 3 + 27);
  page.ask({ ask: 'grab', body: 2, at: [x, y, z], seen: fromTheRight });
  page.ask({ ask: 'move', at: [x, y, z - 3] });
  const held = page.advance(120).slice(3 + 24, 3 + 27);
  assert.ok(held[2] < z - 2 && Math.abs(held[0] - x) < 0.5, held.join());
  page.ask({ ask: 'release' });
  const part = at => page.ask({ ask: 'part', part: at, width: 960, camera: [0, 1, 100], longest: 1, seen: fromTheRight });
  assert.match(part(1.5).formula, /^V \+ gh, gh = 0\.164 m\/s$/);
  const { moved } = part(5.999), next = page.advance(1);
  for (const { body, numbers } of moved) numbers.forEach((x, k) => assert.ok(Math.abs(x - next[3 + 12 * body + k]) < 1e-9));
});

for (const name of readdirSync(join(root, 'lessons/cases')).filter(name => /^\d\d_/.test(name)))
  test(`the doctor finds case ${name}`, () => {
    const { findings } = page.ask({ ask: 'doctor', text: text(`lessons/cases/${name}/scene.json`) });
    const source = text(`lessons/cases/${name}/case.cpp`), law = +/\.law = (\d+)/.exec(source)[1];
    assert.ok(findings.some(finding => finding.law === law && finding.number > 0 && finding.sentence.length > 0), `law ${law} of ${name}`);
  });

test('a knob of the doctor can be turned', () => {
  const heavy = text('lessons/cases/01_heavy_on_light/scene.json');
  const { findings: [worst] } = page.ask({ ask: 'doctor', text: heavy });
  assert.equal(worst.grade, 'fails');
  assert.ok(worst.bodies.length > 0 && worst.number > worst.limit);
  const { name, value } = worst.knobs[0], turned = JSON.parse(page.ask({ ask: 'turn', text: heavy, name, value }).file);
  assert.notDeepEqual({ ...turned.method, step: turned.step }, { ...JSON.parse(page.ask({ ask: 'open', text: heavy }).file).method, step: turned.step });
});

test('what is no scene gets one sentence, and the scene stays', () => {
  page.ask({ ask: 'open', text: text('lessons/scenes/stack.json') });
  for (const [given, sentence] of [
    ['{', /^line 1: this is not JSON/],
    ['{"model": "plane", "bodies": [{"mass": -1, "inertia": [1]}]}', /^line 1: bodies\[0\]\.mass is -1, but it must be/],
  ])
    assert.match(page.ask({ ask: 'open', text: given }).failure ?? '', sentence);
  assert.equal(page.advance(1).length, 3 + 4 * 11);
});
