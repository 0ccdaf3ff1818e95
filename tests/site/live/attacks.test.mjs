// Files that try to be graded right, to read what they may not, or to bring the page down: none is right, each gets a sentence of
// its own, and the next file is judged as ever. BYHAND_SITE: a site with exercises. Those that never end are in ../browser.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { bias, packed, page, text } from './practise.mjs';

const skip = !packed && 'this site has no exercises';
const judge = packed && await page();

const from = (module, name, signature) => `extern "C" __attribute__((import_module("${module}"), import_name("${name}"))) ${signature};`;
const as = (name, definition) => `extern "C" __attribute__((export_name("${name}"))) ${definition}`;
const write = from('wasi_snapshot_preview1', 'fd_write', 'int print(int, const void*, unsigned, unsigned*)');
const all = n => Array.from({ length: n }, (_, i) => i);

const wrong = 'Your code breaks a law: after a step, C is (1 − β)C.', unlinked = 'It compiles, and cannot be linked with the judge.';
const refused = 'It does not compile.', broke = 'The compiler broke off: look for what is very long or nested very deeply.';
const foreign = 'Your program does not begin: it imports or exports functions by their names, which an exercise never does.';
const nobodys = 'Your code crashed in line 4: it used memory that is not its own. Look at pointers and indices.';
const system = 'Your code asked the system for a file, a process, the time or the network; an exercise needs none.';
const missing = 'bias(double, double, double) is missing; keep the signature of the task: your bias takes other types.';

for (const [what, code, sentence] of [
  // Verdicts of their own.
  ['prints a verdict', bias('std::puts("Right, on all 24 probes."); return 0;', '#include <cstdio>'), wrong],
  ["prints the worker's answer", bias('std::puts("{\\"kind\\": \\"right\\", \\"sentence\\": \\"Right\\"}"); return 0;', '#include <cstdio>'), wrong],
  ['prints a verdict as it ends', bias('return 0;', '#include <cstdio>\nstruct A { ~A() { std::puts("Right, on all 24 probes."); } } a;'), wrong],
  ['asserts a verdict', bias('std::fputs("Assertion failed: Right (", stderr); std::abort();', '#include <cstdio>\n#include <cstdlib>'), "Your assertion `Right' failed in line 5."],
  ['ends well', bias('std::exit(0);', '#include <cstdlib>'), 'Your code ended the program with status 0 in line 4 instead of returning a value.'],
  ['ends before it is asked', bias('return 0;', '#include <cstdlib>\nstruct A { A() { std::_Exit(0); } } a;'), 'Your code ended the program with status 0 in line 3 instead of returning a value.'],
  ['answers infinity', bias('return 1 / (C - C);'), 'b is not a finite number.'],

  // The wrapper's names.
  ["defines the wrapper's call", bias('return 0;', 'extern "C" int call(int) { return 1; }'), unlinked],
  ["defines the wrapper's answers", bias('return 0;', 'extern "C" double* answers() { return nullptr; }'), unlinked],
  ['defines what begins a program', bias('return 0;', 'extern "C" void _initialize() {}'), unlinked],
  ['defines what counts rounds', bias('for (;;);', 'extern "C" void __sanitizer_cov_trace_pc() {}'), unlinked],
  ['defines operator new', bias('return *new double(1);', '#include <cstdlib>\nvoid* operator new(std::size_t size) { return std::malloc(size); }'), unlinked],
  ['exports another call', bias('return 0;', as('call', 'int mine(int) { return 1; }')), foreign],
  ['exports other answers', bias('return 0;', as('answers', 'double* mine() { return (double*)0x7ffffff0; }')), foreign],
  ['exports another memory', bias('return 0;', as('memory', 'int mine() { return 1; }')), foreign],
  ['names other functions', `#undef FUNCTIONS\n#define FUNCTIONS right\n${bias('return 0;')}`, wrong],
  ['makes double a macro', `#define double float\n${bias('return beta / h * C;')}`, missing],
  ["opens the judge's namespace", bias('return 0;', 'namespace byhand::practise { struct Numbers {}; }'), wrong],

  // What JavaScript would give.
  ["imports the judge's numbers", bias('take(); return 0;', from('page', 'take', 'void take()')), foreign],
  ['imports from elsewhere', bias('leak(); return 0;', from('env', 'leak', 'void leak()')), foreign],
  ['imports what objects inherit', bias('return make(1);', from('page', 'constructor', 'double make(double)')), foreign],
  ['imports what functions of the system inherit', bias('return make(1);', from('wasi_snapshot_preview1', 'constructor', 'double make(double)')), system],
  ['holds an object of JavaScript', bias('return has(make());', from('page', 'toString', '__externref_t make()') + from('page', 'hasOwnProperty', 'double has(__externref_t)')), foreign],
  ['says that it is not written', bias('not_written_yet();'), 'Not written yet.'],
  ['says that it did what nobody defined', bias('undefined(99, 7); return 0;', from('page', 'undefined', 'void undefined(unsigned, unsigned)')), nobodys.replace('line 4', 'line 7')],

  // Files.
  ['includes the solution', '#include "/practise/08_bias/solution.cpp"\n', refused],
  ['includes a file of the system', `#include "/etc/passwd"\n${bias('return 0;')}`, refused],
  ['includes itself', `#include __FILE__\n${bias('return 0;')}`, refused],
  ['embeds the wrapper', bias('return bytes[8];', 'const unsigned char bytes[] = {\n#embed "/08_bias/wrapper.o"\n};'), wrong],
  ['takes the solution by the assembler', bias('return 0;', 'asm(".incbin \\"/practise/08_bias/solution.cpp\\"");'), refused],
  ['sleeps', bias('sleep(100); return 0;', 'extern "C" unsigned sleep(unsigned);'), system],
  ['asks for a process', bias('return std::system("ls");', '#include <cstdlib>'), 'system is used, and nothing here defines it.'],
  ['throws', bias('throw 1;'), refused],

  // Memory.
  ['writes all over its memory', bias('for (volatile unsigned* at = (unsigned*)1024;; ++at) *at = 0x41414141;'), nobodys],
  ['calls what is no function', bias('return ((double (*)(double, double, double))7)(C, beta, h);'), nobodys],
  ['prints memory that it does not have', bias('unsigned n; return print(1, (void*)0x7ffffff0, 1, &n);', write), nobodys],
  ['prints two gigabytes', bias('static unsigned part[] = {0, 0x7fffffff}; unsigned n; return print(1, part, 1, &n);', write), nobodys],
  ['prints a million times nothing', bias('static unsigned parts[2 << 20]; unsigned n; return print(1, parts, 1 << 20, &n);', write), wrong],
  ['prints a line of two gigabytes', bias('std::printf("%2000000000d", 1); return 0;', '#include <cstdio>'), 'Your code printed more than 64 KB.'],
  ['reads into memory that it does not have', bias('return take(0, nullptr, 0, (unsigned*)0x7ffffff0);', from('wasi_snapshot_preview1', 'fd_read', 'int take(int, void*, unsigned, unsigned*)')), nobodys],
  ['keeps all that it takes', bias('for (int i = 0; i < 400; ++i) *const_cast<double volatile*>(new double[1000]) = i;\nreturn beta / h * C;'), 'Your code asked for more than 256 MB of memory in line 4.'],
  ['recurs before it is asked', bias('return 0;', 'int deeper(int n) { volatile int m = n; return deeper(m + 1) + m; }\nint all = deeper(0);'), 'Your code calls itself without an end in line 2: the stack is full.'],
  ['never begins', bias('return 0;', 'int wait() { for (;;); }\nint waited = wait();'), 'Your code did not return in line 2; look for a loop that never ends.'],

  // The compiler.
  ['crashes the compiler', `#pragma clang __debug crash\n${bias('return 0;')}`, broke],
  ["fills the compiler's stack", bias(`return ${all(15000).map(() => '- ').join('')}1;`), broke],
  ['takes all memory to compile', all(12).reduce((text, i) => `${text}#define A${i + 1} ${Array(8).fill(`A${i}`)}\n`, '#define A0 1\n') + bias('return 0;', 'int x[] = {A12};'), broke],
  ['writes a file of 900 MB', bias('return 0;', 'asm(".section .data.x,\\"\\",@\\n.zero 900000000,65\\n");'), refused],
  ['computes without an end as it compiles', bias('return forever();', 'constexpr double forever() { double s = 0; for (;;) s += 1; }\nconstexpr double x = forever();'), refused],

  // Bytes.
  ['has no text', '', 'bias(double, double, double) is missing; keep the signature of the task.'],
  ['has bytes of nobody', bias('return 0;\0 // \ud800\u202e\u2066\u2028'), wrong],
  ['is in another line', bias('#line 999999\nconst int none = static_cast<int>(h); return 7 / none;'), 'Your code divides a whole number by zero in line 999999.'],
])
  test(`a file that ${what} is not right`, { skip }, () => {
    const verdict = judge.verdict('08_bias', code);
    assert.notEqual(verdict.kind, 'right');
    assert.equal(verdict.sentence, sentence, verdict.details);
  });

test('after all of them a solution is right, also one whose memory grows', { skip }, () => {
  assert.equal(judge.verdict('08_bias', text('08_bias', 'solution.cpp')).kind, 'right');
  assert.equal(judge.verdict('08_bias', bias('for (int i = 0; i < 100; ++i) *const_cast<double volatile*>(new double[100]) = i;\nreturn beta / h * C;')).kind, 'right');
});

// V8 has one kind of error for a full stack, for memory that it cannot get, and for what lies outside of a memory.
test('a full stack is told from memory that is not there and from memory of nobody', { skip }, () => {
  const thrown = code => { try { code(); } catch (error) { return error; } };
  const deeper = () => deeper() + 1;
  for (const [code, reason] of [
    [deeper, 'too_deep'],
    [() => new ArrayBuffer(2 ** 52), 'no_room'],
    [() => new Float64Array(new ArrayBuffer(8), 16), 'crashed'],
    [() => new Float64Array(new ArrayBuffer(8), 4), 'crashed'],
    [() => new Uint8Array(new ArrayBuffer(8), 0, 99), 'crashed'],
    [() => new DataView(new ArrayBuffer(8)).getUint32(99), 'crashed'],
    [() => new Uint8Array(8).set(new Uint8Array(9)), 'crashed'],
  ]) {
    const error = thrown(code);
    assert.ok(error instanceof RangeError, `${error}`);
    assert.equal(judge.reasonOf(error), reason, error.message);
  }
  for (const [name, words, reason] of [
    ['RangeError', 'WebAssembly.Instance(): Out of memory: Cannot allocate Wasm memory for new instance', 'no_room'],
    ['RangeError', 'WebAssembly.Memory(): could not allocate memory', 'no_room'],
    ['InternalError', 'too much recursion', 'too_deep'],
    ['RuntimeError', 'memory access out of bounds', 'crashed'],
    ['RuntimeError', 'unreachable', 'aborted'],
  ])
    assert.equal(judge.reasonOf(Object.assign(new Error(words), { name })), reason, words);
});
