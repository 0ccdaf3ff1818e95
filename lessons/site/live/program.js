'use strict';
// The lesson's C++: starts it, hands it requests and reads its answers (see program.hpp).

async function unpacked(packed) {
  const bytes = Uint8Array.from(atob(packed), letter => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// `program`: the bytes of the .wasm. `files`: those that the lesson reads, by path. `progress(done, total)` hears of
// work that takes its time.
// `canvas()` makes one for WebGL; without it nothing is drawn in space.
async function start({ program, files, progress = () => {}, canvas, complain = console.error }) {
  const system = wasi(files, complain);
  let memory;
  const { instance } = await WebAssembly.instantiate(program,
    { wasi_snapshot_preview1: system.calls, page: { progress, has_webgl: () => canvas ? 1 : 0 }, env: openGl(canvas, () => memory.buffer) });
  const lesson = instance.exports;
  memory = lesson.memory;
  system.use(memory);
  lesson._initialize();
  const ask = request => {
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    const at = lesson.request(bytes.length);
    new Uint8Array(lesson.memory.buffer, at, bytes.length).set(bytes);
    const answer = lesson.answer();
    return JSON.parse(new TextDecoder().decode(new Uint8Array(lesson.memory.buffer, answer, lesson.answer_size())));
  };
  ask.memory = () => lesson.memory.buffer.byteLength;
  return ask;
}
