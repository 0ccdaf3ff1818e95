'use strict';
// The worker of a page. It is told { id, start: { lesson, files } } first and { id, request } after it, and says
// { id, answer } or { id, failure }; { id, done, total } while a step takes its time. One request at a time.

let ask, busy = Promise.resolve();

async function answer({ id, start: packed, request }) {
  if (packed) {
    const [program, files] = await Promise.all([unpacked(packed.lesson), unpacked(packed.files)]);
    ask = await start({ program, files: untar(files), progress: report, canvas: webgl });
    return ask({ ask: 'describe' });
  }
  working = id;
  return ask(request);
}

// Scenes in space, where the browser can draw them.
const webgl = globalThis.OffscreenCanvas && new OffscreenCanvas(1, 1).getContext('webgl2') ? () => new OffscreenCanvas(16, 16) : undefined;

let working, spoken = 0;
function report(done, total) {
  if (performance.now() - spoken < 100) return;
  spoken = performance.now();
  postMessage({ id: working, done, total });
}

onmessage = ({ data }) => {
  busy = busy.then(() => answer(data)).then(
    answer => postMessage({ id: data.id, answer, memory: ask.memory() }),
    error => postMessage({ id: data.id, failure: String(error?.message ?? error) }));
};
