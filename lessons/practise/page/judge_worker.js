'use strict';
// Judges a learner's program. Told { id, start: { judge, archive } } first, and after it { id, request } with, to judge, the
// bytes of the learner's `program` and the name of its `file`. It is ended from outside if nothing comes back.

// As judge_page.cpp has them.
const reasons = ['not_written', 'undefined', 'endless', 'no_memory', 'too_deep', 'crashed', 'aborted', 'exited', 'printed', 'system', 'answered',
  'no_room', 'foreign'];
const mostPrinted = 64 << 10, mostNumbers = 1e6;

class Stop extends Error {
  constructor(why, more = 0, line = undefined) { super(why); Object.assign(this, { why, more, line }); }
}

// The judge: `ask(request)` after `learner` was set, which has call(which, numbers), stopped() and printed().
function startJudge(module, files) {
  let answered, learner;
  const memory = () => judge.memory.buffer;
  const system = wasi(files, text => console.error(text));
  const page = {
    call(which, at, count) {
      answered = learner.call(which, new Float64Array(memory(), at, count).slice());
      return answered ? answered.length : -1;
    },
    take(at) { new Float64Array(memory(), at, answered.length).set(answered); },
    stop(at) { new Float64Array(memory(), at, 3).set(learner.stopped()); },
    printed_size: () => learner.printed().length,
    printed(at) { new Uint8Array(memory(), at).set(learner.printed()); },
  };
  const judge = new WebAssembly.Instance(module, { wasi_snapshot_preview1: system.calls, page }).exports;
  system.use(judge.memory);
  judge._initialize();
  return (request, program) => {
    if (program) learner = program;
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    const at = judge.request(bytes.length);
    new Uint8Array(memory(), at, bytes.length).set(bytes);
    const answer = judge.answer();
    const told = JSON.parse(new TextDecoder().decode(new Uint8Array(memory(), answer, judge.answer_size())));
    if (told.error) throw new Error(told.error);
    return told;
  };
}

// A learner's program in a memory of its own. What stops it is kept: after it nothing is called.
function startLearner(bytes, file) {
  const parts = [], find = lineFinder(bytes, file);
  let size = 0, stopped, code;
  const because = why => (...numbers) => { throw new Stop(why, ...numbers); };
  const page = {
    __proto__: null,  // or a program could import what every object inherits
    not_written: because('not_written'), endless: because('endless'), no_memory: because('no_memory'),
    undefined(kind, line) { throw new Stop('undefined', kind, line); },
  };
  const keep = part => {
    parts.push(part.slice());
    size += part.length;
    if (size > mostPrinted) throw new Stop('printed');
  };
  const attempt = work => {
    if (stopped) return undefined;
    try { return work(); } catch (error) { stopped = reasonOf(error, find); }
  };
  const begin = () => {
    const imports = { wasi_snapshot_preview1: printing(() => code.memory.buffer, keep), page };
    try {
      return new WebAssembly.Instance(new WebAssembly.Module(bytes), imports).exports;
    } catch (error) {
      throw new Stop(hasNoRoom(error) ? 'no_room' : 'foreign');
    }
  };
  attempt(() => {
    code = begin();
    code._initialize();
  });
  return {
    call: (which, numbers) => attempt(() => {
      // What is called may enlarge the memory, which then has another buffer.
      const given = code.arguments(numbers.length);
      new Float64Array(code.memory.buffer, given, numbers.length).set(numbers);
      const length = code.call(which);
      if (length < 0 || length > mostNumbers) throw new Stop('answered');
      const answers = code.answers();
      return new Float64Array(code.memory.buffer, answers, length).slice();
    }),
    stopped: () => stopped,
    printed() {
      const all = new Uint8Array(Math.min(size, mostPrinted));
      let at = 0;
      for (const part of parts) {
        all.set(part.subarray(0, all.length - at), at);
        at = Math.min(all.length, at + part.length);
      }
      return all;
    },
  };
}

const wordsOf = error => String(error?.message ?? error);

// The engine could not allocate. Neither a trap nor a full stack, which V8 calls a RangeError too.
const hasNoRoom = error => error?.name === 'RangeError' && /out of memory|allocat/i.test(wordsOf(error));

// [index of the reason, line, more]. Engines have their own words for a trap.
function reasonOf(error, find) {
  const said = wordsOf(error), stack = String(error?.stack ?? '');
  let { why, more = 0, line } = error;
  why ??= /recursion|call stack/i.test(said) ? 'too_deep' : hasNoRoom(error) ? 'no_room' : /unreachable/i.test(said) ? 'aborted' : 'crashed';
  // A stack is full where a function begins, or in what it calls first; the call that brought it there is to blame.
  const [innermost = 0, before = innermost] = find(stack);
  return [reasons.indexOf(why), line ?? (why === 'too_deep' ? before : innermost), more];
}

// What the learner's program may ask of its system: to print, and to read nothing.
function printing(memory, keep) {
  const success = 0, badDescriptor = 8, noPipe = 70;
  const view = () => new DataView(memory());
  const put = (at, number) => { view().setUint32(at, number, true); return success; };
  const calls = {
    __proto__: null,
    fd_write(fd, at, count, written) {
      if (fd !== 1 && fd !== 2) return badDescriptor;
      const vectors = view();
      let total = 0;
      for (let i = 0; i < count; ++i) {
        const from = vectors.getUint32(at + 8 * i, true), length = vectors.getUint32(at + 8 * i + 4, true);
        if (length === 0) continue;  // a program may write millions of them, and so never more than it may
        keep(new Uint8Array(memory(), from, length));
        total += length;
      }
      return put(written, total);
    },
    fd_read: (_fd, _at, _count, got) => put(got, 0),
    fd_fdstat_get(fd, at) {
      if (fd > 2) return badDescriptor;
      new Uint8Array(memory(), at, 24).fill(0);
      view().setUint8(at, 2);
      view().setBigUint64(at + 8, 64n, true);
      return success;
    },
    fd_prestat_get: () => badDescriptor,
    fd_close: () => success,
    fd_seek: () => noPipe,
    environ_sizes_get(count, size) { put(count, 0); return put(size, 0); },
    environ_get: () => success,
    proc_exit(status) { throw new Stop('exited', status); },
  };
  return new Proxy(calls, { get: (own, name) => own[name] ?? (() => { throw new Stop('system'); }) });
}

if (globalThis.onmessage !== undefined) {
  let ask;
  onmessage = ({ data: { id, start, request, program, file } }) => {
    try {
      if (start) ask = startJudge(start.judge, untar(start.archive));
      postMessage({ id, answer: start ? true : ask(request, program && startLearner(program, file)) });
    } catch (error) {
      postMessage({ id, failure: String(error?.stack ?? error) });
    }
  };
}
