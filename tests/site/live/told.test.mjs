// The lessons in WebAssembly say what the native program says, byte for byte: texts, formulas, numbers, claims, pictures,
// grades. BYHAND_PROGRAMS: folder of the native programs told_*; BYHAND_WASM: of the .wasm. BYHAND_QUICK: some of it.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { test } from 'node:test';

import { lesson } from './lesson.mjs';

const { BYHAND_PROGRAMS: programs, BYHAND_WASM: modules, BYHAND_QUICK: quick } = process.env;
const slugs = readdirSync(modules).filter(name => /^\d\d_.*\.wasm$/.test(name)).map(name => name.slice(0, -5)).sort();
assert.ok(slugs.length > 0, `${modules} holds no lessons`);

function native(slug) {
  const child = spawn(join(programs, `told_${slug}`), { stdio: ['pipe', 'pipe', 'inherit'] });
  const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
  return {
    async ask(request) {
      child.stdin.write(JSON.stringify(request) + '\n');
      const { value, done } = await lines.next();
      assert.ok(!done, `${slug} ended`);
      return JSON.parse(value);
    },
    end: () => child.stdin.end(),
  };
}

// Scenes in space are drawn by another OpenGL, and measured running times differ. Lesson 9 measures errors down to
// 10⁻¹⁵, beside which the last bit of a sine counts, in which glibc and musl differ: its charts are not compared, and its
// numbers to four digits.
const withoutFigures = { '01_jacobian': /^7a$/, '09_what_accuracy_costs': /./ };
const fourDigits = number => String(+(+number).toPrecision(4));
const comparable = (text, slug, label) => {
  if (withoutFigures[slug]?.test(label)) text = text.replace(/<figure[^]*?<\/figure>/g, '');
  if (slug === '09_what_accuracy_costs') text = text.replace(/\d+\.\d+/g, fourDigits);
  return text.replace(/href="data:image\/[a-z]+;base64,[^"]*"/g, 'href=""');
};

// Where the two first differ, with what stands around it.
function difference(a, b) {
  if (a === b) return '';
  let at = 0;
  while (a[at] === b[at]) ++at;
  return `…${a.slice(Math.max(0, at - 80), at + 80)}… but …${b.slice(Math.max(0, at - 80), at + 80)}…`;
}

for (const slug of slugs.filter(slug => !quick || existsSync(join(programs, `told_${slug}`))))
  test(`${slug} tells in WebAssembly what it tells natively`, { timeout: 3_600_000 }, async context => {
    const here = native(slug), there = await lesson(join(modules, `${slug}.wasm`));
    context.after(() => here.end());
    const about = there({ ask: 'describe' });
    assert.deepEqual(about, await here.ask({ ask: 'describe' }));
    const differing = [];
    for (const { label } of about.steps) {
      const [a, b] = [await here.ask({ ask: 'tell', step: label }), there({ ask: 'tell', step: label })];
      assert.deepEqual(b.error, a.error, `step ${label}`);
      assert.deepEqual(b.reads, a.reads, `step ${label}`);
      const found = difference(comparable(a.html, slug, label), comparable(b.html, slug, label));
      if (found) differing.push(`step ${label}: ${found}`);
    }
    assert.deepEqual(differing, []);

    // A scene that is held goes the same way.
    for (const { label } of about.steps) {
      const hold = (...acts) => ({ ask: 'hold', step: label, acts, part: 3.5 });
      const { bodies, error } = there(hold());
      if (error) continue;  // nothing to hold in this step
      const { x, y } = bodies.at(-1);
      for (const request of [hold(), hold(['grab', x, y], ['move', x + 90, y - 60], ['step', 40]), hold(['release'], ['step', 40])])
        assert.deepEqual(there(request), await here.ask(request), `step ${label}`);
    }

    // Off the defaults, at steps that answer quickly.
    for (const parameter of about.parameters.filter(({ choices }) => !choices.length)) {
      const value = parameter.low + 0.37 * (parameter.high - parameter.low);
      const settings = { [parameter.name]: parameter.whole ? String(Math.round(value)) : String(value) };
      const [a, b] = [await here.ask({ ask: 'check', settings }), there({ ask: 'check', settings })];
      assert.deepEqual(b, a);
    }
    const refused = { ask: 'check', settings: { [about.parameters[0].name]: 'many' } };
    assert.deepEqual(there(refused), await here.ask(refused));
    assert.ok(there(refused).refused.includes('many'));
  });
