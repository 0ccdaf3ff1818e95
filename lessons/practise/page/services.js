'use strict';
// Scripts that are loaded when they are needed, and workers that answer.

const parts = globalThis.byhandParts ??= {};
const loading = {};

// What practise/NAME.js packs, once it was loaded.
const load = name => loading[name] ??= new Promise((resolve, reject) => {
  const script = document.createElement('script');
  script.src = `practise/${name}.js`;
  script.onload = () => { resolve(parts[name]); delete parts[name]; };
  script.onerror = () => { delete loading[name]; reject(new Error(`practise/${name}.js cannot be loaded.`)); };
  document.head.append(script);
});

// A worker of this packed source. It answers { id, answer } or { id, failure }.
async function service(packed) {
  const text = new TextDecoder().decode(await unpackedLetters(packed));
  const worker = new Worker(URL.createObjectURL(new Blob([text], { type: 'text/javascript' })));
  const waiting = new Map();
  let next = 0;
  worker.onmessage = ({ data: { id, answer, failure } }) => {
    const { resolve, reject } = waiting.get(id);
    waiting.delete(id);
    failure === undefined ? resolve(answer) : reject(new Error(failure));
  };
  worker.onerror = ({ message }) => { for (const { reject } of waiting.values()) reject(new Error(message)); };
  return {
    ask: message => new Promise((resolve, reject) => {
      waiting.set(next, { resolve, reject });
      worker.postMessage({ id: next++, ...message });
    }),
    end: () => worker.terminate(),
  };
}

// Of gzip in base64, as workers are packed.
async function unpackedLetters(letters) {
  const bytes = Uint8Array.from(atob(letters), letter => letter.charCodeAt(0));
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
}

async function workers() {
  await load('workers');
  return globalThis.byhandParts;
}

// The compiler, which is kept until a file keeps it from coming back.
let compiling;
const compiler = () => compiling ??= (async () => {
  const [{ compiling: source }, compiler, headers] = await Promise.all([workers(), load('compiler'), load('headers')]);
  const started = await service(source);
  await started.ask({ start: { compiler, headers } });
  delete loading.compiler;  // 26 MB of letters
  return started;
})().catch(error => { compiling = undefined; throw error; });

// The judge, which is ended when a learner's code does not come back, and then begins again.
let judging, judgeFiles;
const judge = () => judging ??= (async () => {
  judgeFiles ??= Promise.all([workers(), load('judge').then(unpacked).then(bytes => WebAssembly.compile(bytes)), load('texts').then(unpacked)]);
  const [{ judging: source }, module, archive] = await judgeFiles;
  const started = await service(source);
  await started.ask({ start: { judge: module, archive } });
  return started;
})().catch(error => { judging = undefined; throw error; });

// What a service answers, or, after so many seconds, nothing: then it was ended.
function answerWithin(seconds, service, message) {
  let timer;
  const late = new Promise(resolve => {
    timer = setTimeout(() => { service.end(); resolve(undefined); }, 1000 * seconds);
  });
  return Promise.race([service.ask(message), late]).finally(() => clearTimeout(timer));
}
const plainVerdict = (kind, sentence) => ({ kind, sentence, details: '', printed: '', line: 0, frames: 0 });

// Most loops are stopped by the number of their rounds, long before, and most of what a compiler finds hard by its own limits.
const longestToJudge = 20, longestToCompile = 30;  // s
async function judged(message) {
  const answer = await answerWithin(longestToJudge, await judge(), message);
  if (answer !== undefined) return answer;
  judging = undefined;
  return plainVerdict('stopped', `Your code did not return within ${longestToJudge} s; look for a loop that never ends.`);
}
async function compiled(message) {
  const answer = await answerWithin(longestToCompile, await compiler(), message);
  if (answer === undefined) compiling = undefined;
  return answer;
}

// The verdict on a text, as the terminal gives it, or what else is asked of its program; `tell` hears what is being done.
async function verdictOn(exercise, text, tell = () => {}, ask = 'judge') {
  const begin = performance.now();
  if (!compiling) tell('Loading the compiler, 23 MB …');
  await compiler();
  const loaded = performance.now();
  tell('Compiling …');
  const made = new TextEncoder().encode(text).length > 64 << 10 ? { by: 'clang', said: '' } : await compiled({ exercise, text });
  if (!made) return plainVerdict('does_not_compile', `It does not compile within ${longestToCompile} s.`);
  const { program, by, said } = made, done = performance.now();
  tell('Judging …');
  const verdict = await judged(program ? { request: { ask, exercise, said }, program, file: `${exercise}.cpp` }
    : { request: { ask: 'refused', exercise, said, text, by } });
  verdict.took = { load: loaded - begin, compile: done - loaded, judge: performance.now() - done };
  return verdict;
}
