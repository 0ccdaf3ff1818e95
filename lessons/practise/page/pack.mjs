// What clang needs in a page, as files in FOLDER: headers, libraries, and for each exercise its signature and a wrapper.
//   node pack.mjs PACKAGE FOLDER
// PACKAGE: @yowasp/clang, unpacked.
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import vm from 'node:vm';

const [yowasp, folder] = process.argv.slice(2);
const root = fileURLToPath(new URL('../../..', import.meta.url)), practise = join(root, 'lessons/practise');
const tools = vm.createContext({ ...globalThis, WebAssembly, TextEncoder, TextDecoder });
for (const script of ['lessons/site/live/wasi.js', 'lessons/practise/page/toolchain.js', 'lessons/practise/page/commands.js'])
  vm.runInContext(readFileSync(join(root, script), 'utf8'), tools, script);
const { untar, runTool, compileCommand, wrapperCommand } = tools;

// An archive's folders are files of no bytes to untar.
const entries = [...untar(readFileSync(join(yowasp, 'gen/llvm-resources.tar')))];
const folders = new Set(entries.map(([name]) => dirname(name)));
const system = new Map(entries.filter(([name]) => !folders.has(name)).map(([name, bytes]) => [`usr/${name}`, bytes]));
const inSystem = new Set(system.keys());

const module = new WebAssembly.Module(readFileSync(join(yowasp, 'gen/llvm.core.wasm')));
function run(command) {
  const { status, said, read } = runTool(module, ['llvm', ...command], system);
  if (status !== 0) throw new Error(`${command.at(-1)}: ${said.slice(-2000)}`);
  return read;
}
const bring = (from, to) => system.set(to, readFileSync(join(root, from)));
const kept = [];
const keep = (from, to) => { bring(from, to); kept.push(to); };

keep('lessons/practise/learner/practise.hpp', 'practise.hpp');
for (const header of ['undefined', 'wire']) bring(`lessons/practise/judge/${header}.hpp`, `lessons/practise/judge/${header}.hpp`);
bring('lessons/practise/page/learner_page.cpp', 'learner_page.cpp');
const exercises = readdirSync(practise).filter(name => /^\d\d_/.test(name)).sort();
const excerpts = readdirSync(join(practise, 'excerpts')).map(file => file.replace('.hpp', '')).sort();
for (const name of excerpts) {
  const signature = `lessons/practise/excerpts/${name}.hpp`;
  keep(signature, `${name}/signature.hpp`);
  for (const [, header] of readFileSync(join(root, signature), 'utf8').matchAll(/#include "(lessons\/[^"]*)"/g)) keep(header, header);
}
// Lessons know it by its path; here it is one file.
const types = 'lessons/practise/learner/practise.hpp';
system.set(types, new TextEncoder().encode('#include "/practise.hpp"\n'));
kept.push(types);
for (const name of exercises) keep(`lessons/practise/${name}/signature.hpp`, `${name}/signature.hpp`);
for (const name of [...exercises, ...excerpts]) {
  run(wrapperCommand(name, '/learner_page.cpp', `/${name}/wrapper.o`));
  kept.push(`${name}/wrapper.o`);
}

// Headers that a learner may name: those of the library of C++ that need no files, threads or locales.
const offered = `algorithm array cassert cfloat climits cmath cstddef cstdint cstdio cstdlib cstring functional initializer_list limits
  numbers numeric optional span string tuple type_traits utility vector`.split(/\s+/);
system.set('offered.cpp', new TextEncoder().encode(offered.map(name => `#include <${name}>\n`).join('')));
const read = run(compileCommand(exercises[0], '/offered.cpp', '/offered.o'));

const library = 'usr/lib/wasm32-wasip1', runtime = 'usr/lib/wasm32-unknown-wasip1';
for (const name of [...kept, ...[...read].filter(name => inSystem.has(name)), `${library}/crt1-reactor.o`, `${library}/libc.a`,
  `${library}/libc++.a`, `${library}/libc++abi.a`, `${runtime}/libclang_rt.builtins.a`]) {
  const to = join(folder, name);
  mkdirSync(dirname(to), { recursive: true });
  writeFileSync(to, system.get(name));
}
