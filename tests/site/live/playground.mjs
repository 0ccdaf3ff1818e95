// The playground's WebAssembly under node, and the same scenes at a terminal.
import { execFileSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { started } from './lesson.mjs';

export const root = fileURLToPath(new URL('../../..', import.meta.url));
const { BYHAND_PROGRAMS: programs, BYHAND_WASM: modules } = process.env;

// The files that the playground begins with, as lessons/site/live/build packs them.
export const startScenes = [
  ...['stack', 'cover_chain', 'ragdoll', 'slider_crank', 'bridge', 'dominoes', 'card_house', 'pyramid', 'pile', 'cradle', 'heavy_on_light', 'heavy_chain',
    'heavy_on_light_in_space', 'pile_in_space', 'chain_in_space'].map(name => `lessons/scenes/${name}.json`),
  'tests/lessons/doctor/samples/jenga.json',
  ...readdirSync(join(root, 'lessons/cases')).filter(name => /^\d\d_/.test(name)).sort().map(name => `lessons/cases/${name}/scene.json`),
];

// { ask(request), advance(steps) }; the latter returns time, energy, gap and the numbers of all bodies.
export async function playground() {
  const ask = await started(join(modules, 'playground.wasm'));
  const { advance, memory, moment_size } = ask.program;
  return {
    ask: request => structuredClone(ask(request)),
    advance(steps) {
      const at = advance(steps);  // which may have made the memory another one
      return Array.from(new Float64Array(memory.buffer, at, moment_size()));
    },
  };
}

// What `./lessons/run scene FILE` computes: { numbers, stopped } after so many steps.
export const watched = (file, steps) => JSON.parse(execFileSync(join(programs, 'watched_scene'), [file, String(steps)], { encoding: 'utf8', maxBuffer: 1e8 }));

// The first number that differs to the bit, or -1.
export const firstDifference = (a, b) => a.length !== b.length ? Math.min(a.length, b.length) : a.findIndex((x, i) => !Object.is(x, b[i]));
