'use strict';
// Compiles a learner's file. Told { id, start: { compiler, headers } } first and { id, exercise, text } after it; says
// { id, answer: { program, said } }, or { by: 'clang', 'lld' or 'nobody', said } of what it refused, or broke off at. It keeps
// the compiler until it is ended from outside.

async function startCompiler(compiler, headers) {
  const [module, archive] = await Promise.all([unpacked(compiler).then(bytes => WebAssembly.compile(limitMemory(bytes, mostPages))), unpacked(headers)]);
  return compilerOf(module, untar(archive));
}

// A function of an exercise and a text, on these files.
function compilerOf(module, files) {
  return (exercise, text) => {
    const own = new Map(files), source = `learner/${exercise}.cpp`;
    own.set(source, new TextEncoder().encode(placed(exercise, text)));
    const compiled = runTool(module, ['llvm', ...compileCommand(exercise, `/${source}`, '/learner/object.o')], own);
    if (compiled.status !== 0) return { by: compiled.status > 0 ? 'clang' : 'nobody', said: compiled.said };
    const linked = runTool(module, ['llvm', ...linkCommand(exercise, '/learner/object.o', '/learner/program.wasm')], own);
    if (linked.status !== 0) return { by: 'lld', said: linked.said };
    return { program: own.get('learner/program.wasm').slice(), said: compiled.said };
  };
}

if (globalThis.onmessage !== undefined) {
  let compile, busy = Promise.resolve();
  const answer = async ({ start, exercise, text }) => {
    if (!start) return compile(exercise, text);
    compile = await startCompiler(start.compiler, start.headers);
    return true;
  };
  onmessage = ({ data }) => {
    busy = busy.then(() => answer(data)).then(
      answer => postMessage({ id: data.id, answer }), error => postMessage({ id: data.id, failure: String(error?.message ?? error) }));
  };
}
