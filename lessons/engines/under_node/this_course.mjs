// This course's solver, compiled to WebAssembly (this_course.cpp).
import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';

export async function load(modules) {
  const wasi = new WASI({ version: 'preview1' });
  const bytes = await readFile(`${modules}/this_course.wasm`);
  const { instance } = await WebAssembly.instantiate(bytes, wasi.getImportObject());
  wasi.initialize(instance);
  const { memory, request, make, step, bodies, read, velocities, take_velocities } = instance.exports;
  const doubles = (at, count) => new Float64Array(memory.buffer, at, count);

  return ({ knobs, scene }) => {
    const text = new TextEncoder().encode(JSON.stringify({ knobs, scene }));
    new Uint8Array(memory.buffer).set(text, request(text.length));
    make();
    const count = bodies();
    return {
      step,
      bodies: () => {
        const all = read();
        return Array.from({ length: count }, (_, i) => [...doubles(all + 8 * 13 * i, 13)]);
      },
      setVelocities: all => {
        doubles(velocities(), 6 * count).set(all.flat());
        take_velocities();
      },
      free: () => {},
    };
  };
}
