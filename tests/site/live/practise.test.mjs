// The judge of the exercises in the page says what the terminal's says. BYHAND_SITE: a site with exercises;
// BYHAND_PRACTISE: the native program.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { excerpt, exercises, expected, packed, page, text, variants } from './practise.mjs';

const skip = !packed && 'this site has no exercises';
const judge = packed && await page();

for (const exercise of exercises)
  test(`${exercise}: stub, solution and mutants get the terminal's verdict`, { skip }, () => {
    for (const file of variants(exercise)) assert.equal(judge.verdict(exercise, text(exercise, file)).sentence, expected(exercise, file), file);
  });

const bias = (body, before = '') => `#include "practise.hpp"\n${before}\ndouble bias(double C, double beta, double h) {\n${body}\n}\n`;
for (const [what, code, sentence] of [
  ['an unknown name', bias('return beta / h * D;'), 'It does not compile.'],
  ['a missing function', '#include "practise.hpp"\n', 'bias(double, double, double) is missing; keep the signature of the task.'],
  ['other types', bias('return 0;').replace('(double C', '(float C'), 'bias(double, double, double) is missing; keep the signature of the task: your bias takes other types.'],
  ['a main', bias('return 0;') + 'int main() {}\n', 'Remove your main: the judge calls your functions from its own.'],
  ['an endless loop', bias('while (C != 7) h += 1;\nreturn h;'), 'Your code did not return in line 4; look for a loop that never ends.'],
  ['recursion', bias('volatile double b = 1;\nreturn bias(C + b, beta, h) + b;'), 'Your code calls itself without an end in line 5: the stack is full.'],
  ['a division by zero', bias('const int none = static_cast<int>(h);\nreturn 7 / none;'), 'Your code divides a whole number by zero in line 5.'],
  ['an index', bias('const double a[3] = {};\nreturn a[static_cast<int>(h) + 5];'), 'Your code uses an index beyond the end of an array in line 5.'],
  ['memory of nobody', bias('return *(volatile double*)(1u << 30);'), 'Your code crashed in line 4: it used memory that is not its own. Look at pointers and indices.'],
  ['too much memory', bias('double* const many = new double[1u << 28]();\nreturn many[static_cast<int>(h)];'), 'Your code asked for more than 256 MB of memory in line 4.'],
  ['abort()', bias('std::abort();', '#include <cstdlib>'), 'Your code called abort() in line 4.'],
  ['an assertion', bias('assert(h > 1);\nreturn 0;', '#include <cassert>'), "Your assertion `h > 1' failed in line 4."],
  ['an end', bias('std::exit(3);', '#include <cstdlib>'), 'Your code ended the program with status 3 in line 4 instead of returning a value.'],
  ['much printed', bias('for (int i = 0; i < 100000; ++i) std::puts("much");\nreturn 0;', '#include <cstdio>'), 'Your code printed more than 64 KB.'],
  ['a file', bias('return std::fopen("/etc/passwd", "r") ? 1 : 0;', '#include <cstdio>'), undefined],
  ['no number', bias('return beta / h * C * std::nan("");'), 'b is not a finite number.'],
])
  test(`${what} has its sentence`, { skip }, () => {
    const verdict = judge.verdict('08_bias', code);
    if (sentence) assert.equal(verdict.sentence, sentence, verdict.details);
    assert.notEqual(verdict.kind, 'right');
  });

// A stack may be full where a function begins or in what it calls first: which of them, its depth decides.
test('recursion is named by its call, wherever the stack is full', { skip }, () => {
  const program = judge.program('08_bias', bias('volatile double b = 1;\nreturn bias(C + b, beta, h) + b;'));
  const deeper = (left, ...filled) => left > 0 ? deeper(left - 1, left, ...filled) : program().sentence;
  for (let depth = 0; depth < 60; ++depth) assert.match(deeper(depth), / in line 5: the stack is full\.$/, `depth ${depth}`);
});

test('what is printed is shown, and the compiler names the line', { skip }, () => {
  assert.match(judge.verdict('08_bias', bias('std::puts("score: 100");\nreturn 0;', '#include <cstdio>')).printed, /^score: 100\n/);
  const { line, details } = judge.verdict('08_bias', bias('return beta / h * D;'));
  assert.equal(line, 4);
  assert.match(details, /^08_bias\.cpp:4:\d+: error: use of undeclared identifier 'D'/);
});

test("lesson 3's sweep is drawn as its reader changes it", { skip }, () => {
  const sweep = excerpt('lessons/03_iterations/plain_sweep.cpp', 'sweep');
  const run = (from, to) => {
    assert.ok(sweep.includes(from));
    return judge.verdict('sweep', sweep.replace(from, to), 'excerpt');
  };
  const ours = run('-JV / K', '-JV / K').svg, relaxed = run('-JV / K', '-1.6 * JV / K').svg;
  assert.match(ours, /^<svg[^]*10 links, yours[^]*<\/svg>\s*$/);
  assert.notEqual(relaxed, ours);
  assert.match(run('-JV / K', '-9 * JV / K').svg, /^<svg/);
  const unknown = run('-JV / K', '-JV / X');
  assert.equal(unknown.sentence, 'It does not compile.');
  assert.equal(unknown.line, 1 + sweep.slice(0, sweep.indexOf('-JV / K')).split('\n').length - 1);
  assert.match(unknown.details, /^sweep\.cpp:\d+:\d+: error: use of undeclared identifier 'X'/);
  assert.match(run('++i', 'i += 0').sentence, /^Your code did not return in line \d; look for a loop that never ends\.$/);
  // Optimised code may check an index at the head of its loop, so the line may be that.
  assert.match(run('v[i - 1];', 'v[i + 1];').sentence, /^Your code crashed in line [23]: .*index out of range\.$/);
  assert.match(run('plain_sweep', 'sweep').sentence, /plain_sweep\(.*\) is missing/);
});

// Built by two compilers, one judge gives what the other gives, so that a key serves both.
test('the page, by clang, and the terminal, by g++, draw the same probes', { skip: skip || !process.env.BYHAND_PRACTISE && 'no native program' }, () => {
  const folder = mkdtempSync(join(tmpdir(), 'keys-'));
  try {
    for (const seed of [1, 7]) {
      const to = join(folder, String(seed));
      execFileSync(process.env.BYHAND_PRACTISE, ['--export', 'junit', '--seed', String(seed), '--to', to]);
      for (const exercise of exercises) {
        const { right } = JSON.parse(readFileSync(join(to, 'keys', `${exercise}.json`), 'utf8'));
        const given = right.flat().filter(([kind]) => kind === 0).map(([, name, , values]) => [name, values]);
        assert.ok(given.length > 0);
        assert.deepEqual(judge.ask({ ask: 'given', exercise, seed }), given, `${exercise}, seed ${seed}`);
      }
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});
