// The judge of the exercises in the page says what the terminal's says. BYHAND_SITE: a site with exercises;
// BYHAND_PRACTISE: the native program.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { setFlagsFromString } from 'node:v8';
import vm from 'node:vm';

import { bias, excerpt, exercises, expected, packed, page, text, variants } from './practise.mjs';

const skip = !packed && 'this site has no exercises';
const judge = packed && await page();

// What the terminal says of solutions and mutants. A film's numbers may differ by their last digits, and by what the code makes of
// these: told_exercises shakes it.
const told = new Map(packed && process.env.BYHAND_PROGRAMS
  ? execFileSync(join(process.env.BYHAND_PROGRAMS, 'told_exercises'), { encoding: 'utf8', maxBuffer: 1 << 28 }).trim().split('\n')
    .map(line => JSON.parse(line)).map(one => [`${one.exercise}/${one.file}`, one])
  : []);

function sameAsTold(verdict, { exercise, file, sentence, details, film = [], tolerance = [] }) {
  assert.equal(verdict.sentence, sentence, `${exercise}/${file}`);
  assert.equal(verdict.details.split('The compiler warns')[0], details, `${exercise}/${file}`);
  const own = judge.ask({ ask: 'film' });
  assert.equal(own.length, film.length, `${exercise}/${file}`);
  const sizes = film[0]?.map((_, k) => Math.max(1e-3, ...film.map(frame => Math.abs(frame[k] ?? 0))));
  own.forEach((frame, i) => frame.forEach((number, k) => {
    const right = film[i][k];
    // JSON has null for what is not finite: a film that a shake changes without a bound, and its numbers then.
    const near = tolerance[i] === null || Math.abs(number - right) <= tolerance[i] * sizes[k];
    assert.ok(near, `${exercise}/${file}, frame ${i}, number ${k}: ${number}, ${right} at the terminal`);
  }));
}

for (const exercise of exercises)
  test(`${exercise}: stub, solution and mutants get the terminal's verdict, its details and its film`, { skip }, () => {
    for (const file of variants(exercise)) {
      const verdict = judge.verdict(exercise, text(exercise, file));
      assert.equal(verdict.sentence, expected(exercise, file), file);
      if (told.size === 0 || file === 'stub.cpp') continue;
      assert.ok(told.has(`${exercise}/${file}`), file);
      sameAsTold(verdict, told.get(`${exercise}/${file}`));
    }
  });

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

// Of each: a change that is drawn, and an unknown name.
for (const [name, file, [from, to], ours] of [
  ['step', 'lessons/02_single_constraint/plain_step.cpp', ['-JV / K', '-0.9 * JV / K'], /ΔE\/\(m·g·L\), yours/],
  ['sweep', 'lessons/03_iterations/plain_sweep.cpp', ['-JV / K', '-1.6 * JV / K'], /10 links, yours/],
  ['bias', 'lessons/04_baumgarte/plain_bias.cpp', ['beta / h * C', 'beta * C'], /β = 1.5, yours/],
  ['clamp', 'lessons/05_contact/plain_clamp.cpp', ['std::fmax(0.0, lambda + change) - lambda', 'std::fmax(0.0, change)'], /second row, yours/],
])
  test(`the lesson's ${name} is drawn as its reader changes it`, { skip }, () => {
    const written = excerpt(file, name), run = code => judge.verdict(name, code, 'excerpt');
    assert.ok(written.includes(from));
    const drawn = run(written).svg, changed = run(written.replace(from, to)).svg;
    assert.match(drawn, /^<svg[^]*<\/svg>\s*$/);
    assert.match(drawn.replaceAll(/<[^>]*>/g, ''), ours);
    assert.notEqual(changed, drawn);
    const unknown = run(written.replace(from, 'nothing'));
    assert.equal(unknown.sentence, 'It does not compile.');
    assert.equal(unknown.line, written.slice(0, written.indexOf(from)).split('\n').length);
    assert.match(unknown.details, new RegExp(`^${name}\\.cpp:\\d+:\\d+: error: use of undeclared identifier 'nothing'`));
  });

test("lesson 3's sweep diverges, never ends, or leaves its chain, and is told so", { skip }, () => {
  const sweep = excerpt('lessons/03_iterations/plain_sweep.cpp', 'sweep');
  const run = (from, to) => judge.verdict('sweep', sweep.replace(from, to), 'excerpt');
  assert.match(run('-JV / K', '-9 * JV / K').svg, /^<svg/);
  assert.match(run('++i', 'i += 0').sentence, /^Your code did not return in line \d; look for a loop that never ends\.$/);
  // Optimised code may check an index at the head of its loop, so the line may be that.
  assert.match(run('v[i - 1];', 'v[i + 1];').sentence, /^Your code crashed in line [23]: .*index out of range\.$/);
  assert.match(run('plain_sweep', 'sweep').sentence, /plain_sweep\(.*\) is missing/);
});

test("a wrong code is unmasked as at the terminal", { skip: skip || !process.env.BYHAND_PRACTISE && 'no native program' }, () => {
  const terminal = (...of) => {
    try { return execFileSync(process.env.BYHAND_PRACTISE, of, { encoding: 'utf8', env: { ...process.env, XDG_STATE_HOME: tmpdir() } }); } catch (ended) { return ended.stdout; }
  };
  const words = text => text.split(/\s+/).join(' ');
  for (const exercise of exercises) {
    const number = String(parseInt(exercise)), { code, test } = judge.ask({ ask: 'masked', exercise }), shown = words(terminal(number, '--unmask'));
    assert.ok(test.includes('=') && shown.includes(words(test)), `${exercise}: ${test}`);
    assert.ok(shown.includes(words(code).trim()), exercise);
    assert.deepEqual(judge.ask({ ask: 'unmask', exercise, numbers: test }).unmasked, false, exercise);
  }
  for (const numbers of ['I1=0.5', 'm1=7'])
    assert.equal(judge.ask({ ask: 'unmask', exercise: exercises[2], numbers }).report, terminal('3', '--unmask', numbers));
  for (const [numbers, why] of [['I3=1', /"I3" is not given; these are: /], ['I1=much', /no NAME=NUMBER/], ['J.l1=1', /J.l1 has 2 number/]])
    assert.match(judge.ask({ ask: 'unmask', exercise: exercises[2], numbers }).report, why);
});

test('fifty verdicts keep no more memory than ten', { skip }, async () => {
  setFlagsFromString('--expose-gc');
  const collect = vm.runInNewContext('gc'), kept = async () => {
    await new Promise(setImmediate);  // what a job has seen of a WeakRef lives until its end
    collect();
    return judge.memories().sort((a, b) => a - b);
  };
  const programs = ['solution.cpp', 'mutants/minus.cpp'].map(file => judge.program('08_bias', text('08_bias', file)));
  programs.push(judge.program('08_bias', bias('double* const many = new double[1u << 20]();\nreturn many[static_cast<int>(h)];')),
    judge.program('08_bias', bias('volatile double b = 1;\nreturn bias(C + b, beta, h) + b;')));
  const verdicts = count => { for (let i = 0; i < count; ++i) programs[i % programs.length](); };
  verdicts(10);
  for (let i = 0; i < 3; ++i) judge.verdict('08_bias', text('08_bias', 'stub.cpp'));
  const ten = await kept();
  verdicts(40);
  for (let i = 0; i < 3; ++i) judge.verdict('08_bias', text('08_bias', 'stub.cpp'));
  const fifty = await kept();
  assert.ok(ten.length <= 3, `${ten.length} memories of WebAssembly are alive: the judge's, and ${ten}`);
  assert.deepEqual(fifty, ten);
});

test('the exercises add at most 32 MB to the site', { skip }, () => {
  const folder = join(process.env.BYHAND_SITE, 'practise');
  const bytes = readdirSync(folder).reduce((sum, file) => sum + statSync(join(folder, file)).size, 0);
  assert.ok(bytes <= 32e6, `${bytes} bytes`);
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
