// A lesson's WebAssembly under node: the same wasi.js and program.js as in the page's worker.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import vm from 'node:vm';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const context = vm.createContext({ ...globalThis, WebAssembly, performance, TextEncoder, TextDecoder, console });
for (const name of ['wasi.js', 'webgl.js', 'program.js'])
  vm.runInContext(readFileSync(join(root, 'lessons/site/live', name), 'utf8'), context, name);

// The files a lesson reads: the checkout's, and the fonts that lessons/site/live/build made.
const files = {
  get(path) {
    const place = path.startsWith('fonts/') ? join(process.env.BYHAND_WASM, path) : join(root, path);
    try { return new Uint8Array(readFileSync(place)); } catch { return undefined; }
  },
};

// ask(request) as the pages have it.
export const started = (wasm, progress) => context.start({ program: readFileSync(wasm), files, progress });

export async function lesson(wasm, progress) {
  const ask = await started(wasm, progress);
  return request => structuredClone(ask(request));  // the context has an Object and an Array of its own
}
