'use strict';
// The lesson's C++: starts it, hands it requests and reads its answers (see program.hpp).

// The bytes of a text with seven bits a letter (see seven_bits).
function bytesOf(letters) {
  const bytes = new Uint8Array(7 * letters.length >> 3);
  for (let i = 0, at = 0, held = 0, bits = 0; i < letters.length; ++i) {
    held = (held << 7 | letters.charCodeAt(i)) & 0x3fff;
    bits += 7;
    if (bits >= 8) bytes[at++] = held >> (bits -= 8);
  }
  return bytes;
}

async function unpacked(packed) {
  const stream = new Blob([bytesOf(packed)]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// `program`: the bytes of the .wasm. `files`: those that the lesson reads, by path. `progress(done, total)` hears
// of work that takes its time. `canvas()` makes one for WebGL; without it nothing is drawn in space.
async function start({program, files, progress = () => {}, canvas, complain = console.error}) {
  const system = wasi(files, complain);
  let memory;
  const {instance} = await WebAssembly.instantiate(program, {
    wasi_snapshot_preview1: system.calls,
    page: {progress, has_webgl: () => canvas ? 1 : 0},
    env: openGl(canvas, () => memory.buffer)
  });
  const lesson = instance.exports;
  memory = lesson.memory;
  system.use(memory);
  lesson._initialize();
  const ask = request => {
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    const at = lesson.request(bytes.length);
    new Uint8Array(lesson.memory.buffer, at, bytes.length).set(bytes);
    const answer = lesson.answer();
    return JSON.parse(
        new TextDecoder().decode(new Uint8Array(lesson.memory.buffer, answer, lesson.answer_size())));
  };
  ask.program = lesson;  // its other functions
  ask.memory = () => lesson.memory.buffer.byteLength;
  return ask;
}
