// Runs scenes in engines that are compiled to WebAssembly: node host.mjs MODULES, the folder where npm has put them. A
// request is a line of JSON, and so is its answer:
//   {"engine": "physx", "mode": "TGS", "knobs": {"iterations": 16}, "scene": …}  makes a world of a scene, as
//     lessons/engines/under_node.cpp writes it
//   {"velocities": [[v, spin], …]}  of its bodies
//   {"steps": 4, "h": 0.004}  → {"seconds": of the processor, in all steps of this world,
//                                "bodies": [[position, quaternion from w on, v, spin], …]}
// Any other is answered by {}.
import { createInterface } from 'node:readline';

for (const print of ['log', 'warn', 'error']) console[print] = () => {}; // engines would print among the answers
const processorSeconds = () => (({ user, system }) => 1e-6 * (user + system))(process.cpuUsage());

const loaded = {};
let world, seconds;
for await (const line of createInterface({ input: process.stdin })) {
  const { engine, mode, knobs, scene, velocities, steps, h } = JSON.parse(line);
  let answer = {};
  if (engine) {
    world?.free();
    loaded[engine] ??= await (await import(`./${engine}.mjs`)).load(process.argv[2]);
    world = loaded[engine]({ scene, mode, knobs, knob: (name, shipped) => knobs[name] ?? shipped });
    seconds = 0;
  } else if (velocities) {
    world.setVelocities(velocities);
  } else if (steps !== undefined) {
    const begin = processorSeconds();
    for (let i = 0; i < steps; ++i) world.step(h);
    seconds += processorSeconds() - begin;
    answer = { seconds, bodies: world.bodies() };
  }
  process.stdout.write(JSON.stringify(answer) + '\n');
}
