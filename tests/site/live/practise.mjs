// The exercises' compiler and judge under node, from the scripts that the page loads: the same workers' code.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import vm from 'node:vm';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const folder = join(process.env.BYHAND_SITE ?? '', 'practise');
export const packed = existsSync(join(folder, 'compiler.js'));
export const practise = join(root, 'lessons/practise');
export const exercises = readdirSync(practise).filter(name => /^\d\d_/.test(name)).sort();
export const text = (exercise, file) => readFileSync(join(practise, exercise, file), 'utf8');
export const variants = exercise => ['stub.cpp', 'solution.cpp', ...readdirSync(join(practise, exercise, 'mutants')).sort().map(file => `mutants/${file}`)];

// Exercise 8's function with this body, which begins in line 4.
export const bias = (body, before = '') => `#include "practise.hpp"\n${before}\ndouble bias(double C, double beta, double h) {\n${body}\n}\n`;

// The sentence that a file begins with.
export const firstComment = text => {
  const lines = text.split('\n');
  return lines.slice(0, lines.findIndex(line => !line.startsWith('// '))).map(line => line.slice(3)).join(' ');
};
// What a lesson shows of a file.
export const excerpt = (file, tag) => readFileSync(join(root, file), 'utf8').split(`//! [${tag}]\n`)[1];
// What the judge says of a file of the course.
export const expected = (exercise, file) => file === 'solution.cpp' ? 'Right, on all 24 probes.'
  : file !== 'stub.cpp' ? firstComment(text(exercise, file))
  : /FUNCTIONS .*,/.test(text(exercise, 'signature.hpp')) ? `${/FUNCTIONS (\w+),/.exec(text(exercise, 'signature.hpp'))[1]} is not written yet.` : 'Not written yet.';

// { verdict(exercise, text, what to ask), program(exercise, text), ask(request), reasonOf(error), memories() } of the page's own
// code; a program is compiled once and gives its verdict each time that it is called. memories() has the bytes of each memory of
// WebAssembly that nothing has let go of: the judge's, and of what ran last.
export async function page() {
  const begun = [];
  class Instance extends WebAssembly.Instance {
    constructor(...of) {
      super(...of);
      begun.push(new WeakRef(this));
    }
  }
  const counted = Object.create(WebAssembly, { Instance: { value: Instance } });
  const context = vm.createContext({ ...globalThis, WebAssembly: counted, TextEncoder, TextDecoder, Blob, Response, DecompressionStream, console, performance });
  context.globalThis = context;
  const run = (path, name) => vm.runInContext(readFileSync(path, 'utf8'), context, name);
  for (const name of ['wasi', 'program']) run(join(root, `lessons/site/live/${name}.js`), name);
  for (const name of ['toolchain', 'commands', 'compiler_worker', 'lines', 'judge_worker']) run(join(practise, `page/${name}.js`), name);
  for (const name of ['compiler', 'headers', 'judge', 'texts']) run(join(folder, `${name}.js`), name);
  const parts = vm.runInContext('byhandParts', context);
  const compile = await context.startCompiler(parts.compiler, parts.headers);
  const ask = context.startJudge(await WebAssembly.compile(await context.unpacked(parts.judge)), context.untar(await context.unpacked(parts.texts)));
  const program = (exercise, text, what = 'judge') => {
    const { program, by, said } = compile(exercise, text);
    return () => structuredClone(program ? ask({ ask: what, exercise, said }, context.startLearner(program, `${exercise}.cpp`))
      : ask({ ask: 'refused', exercise, said, text, by }));
  };
  return {
    ask: request => structuredClone(ask(request)), program,
    reasonOf: error => vm.runInContext('reasons', context)[context.reasonOf(error, () => [])[0]], verdict: (...of) => program(...of)(),
    memories: () => begun.map(one => one.deref()).filter(one => one).map(one => one.exports.memory.buffer.byteLength),
  };
}
