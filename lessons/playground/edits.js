'use strict';
// What a reader builds, as changes of a scene's file. Each takes the file's object as it is now, changes it and says in a
// few words what it did; undefined where nothing was to be done.

const density = 1;           // of what is put down [kg/m²]
const wallThickness = 0.2;   // [m]
const visible = new Set(['distance', 'normalised_distance', 'rope', 'spring', 'pin', 'contact', 'weld', 'slider']);  // as the look's ties have them
const round = x => +x.toPrecision(6);
const massOf = area => round(Math.max(0.01, density * area));
const particles = file => file.model === 'plane particles';
const inSpace = file => file.model.startsWith('space');
const massIn = body => body.mass ?? 1 / (body.inverse_mass ?? 1);

const edits = {
  box(file, from, to) {
    const drawn = Math.hypot(to[0] - from[0], to[1] - from[1]) > 0.15;
    const sides = drawn ? [Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1])].map(side => round(Math.max(side, 0.1))) : [1, 1];
    const middle = drawn ? [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2] : from;
    file.bodies.push({ mass: massOf(sides[0] * sides[1]), position: middle.map(round), shape: { box: sides } });
    return 'put down a box';
  },
  ball(file, from, to) {
    const drawn = distance(from, to);
    if (particles(file)) {
      file.bodies.push({ mass: 1, position: from.map(round) });
      return 'put down a bob';
    }
    const radius = round(drawn > 0.1 ? drawn : 0.4);
    file.bodies.push({ mass: massOf(Math.PI * radius * radius), position: from.map(round), shape: { ball: radius } });
    return 'put down a ball';
  },
  wall(file, from, to) {
    const drawn = distance(from, to) > 0.15, length = drawn ? distance(from, to) : 3;
    const middle = drawn ? [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2] : from;
    const wall = { fixed: true, position: middle.map(round), shape: { box: [round(length), wallThickness] } };
    if (drawn) wall.angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
    file.bodies.push(wall);
    return 'put up a wall';
  },
  rod(file, from, to, ends) { return tie(file, from, to, ends, { kind: 'normalised_distance' }, 'tied a rod'); },
  spring(file, from, to, ends) {
    // Its bodies swing once in .8 s and lose a tenth of a swing's height in each.
    const inverse = ends.reduce((sum, { body }) => sum + (body >= 0 && !file.bodies[body].fixed ? 1 / massIn(file.bodies[body]) : 0), 0);
    const rate = 2 * Math.PI / 0.8, mass = inverse > 0 ? 1 / inverse : 1;
    return tie(file, from, to, ends, { kind: 'spring', stiffness: round(mass * rate * rate), damping: round(0.1 * mass * rate) }, 'tied a spring');
  },
  pin(file, from, to, [{ body }, , below]) {
    if (body < 0) return undefined;
    const other = below >= 0 ? below : particles(file) ? nail(file, file.bodies[body].position) : world(file);
    file.constraints.push({ kind: 'pin', bodies: [other, body], ...(particles(file) ? {} : { point: from.map(round) }) });
    return below >= 0 ? 'pinned two bodies together' : 'pinned a body to the world';
  },
  motor(file, from, to, ends) {
    const { body } = ends[0];
    if (body < 0 || particles(file) || file.bodies[body].fixed) return undefined;
    const joint = file.constraints.find(one => one.kind === 'pin' && one.bodies.includes(body));
    const other = joint ? joint.bodies.find(one => one !== body) : ends[2] >= 0 ? ends[2] : world(file);
    if (!joint) file.constraints.push({ kind: 'pin', bodies: [other, body], point: from.map(round) });
    file.constraints.push({ kind: 'motor', on: 'turn', bodies: [other, body], speed: 3, strength: round(200 * massIn(file.bodies[body])) });
    return 'gave a body a motor';
  },
  erase(file, from, to, [{ body, constraint }]) {
    if (constraint >= 0) {
      removeConstraints(file, (_, i) => i === constraint);
      return 'removed a tie';
    }
    if (body < 0) return undefined;
    removeConstraints(file, one => one.bodies?.includes(body));
    file.bodies.splice(body, 1);
    for (const one of file.constraints) one.bodies = one.bodies.map(i => i - (i > body));
    return 'removed a body';
  },

  // Moves a body with all that hangs together with it; what is fixed and has a shape stays.
  move(file, body, by) {
    const group = groupOf(file, body);
    for (const i of group) file.bodies[i].position = add(file.bodies[i].position, by);
    for (const one of file.constraints) if (one.point && one.bodies.some(i => group.has(i))) one.point = add(one.point, by);
    return 'moved a body';
  },
  turn(file, body, angle) {
    const one = file.bodies[body];
    if (particles(file)) return undefined;
    const now = one.rotation ? Math.atan2(one.rotation[1], one.rotation[0]) : one.angle ?? 0;
    delete one.rotation;
    one.angle = now + angle;
    return 'turned a body';
  },
  // `what`: mass, friction, restitution or fixed.
  change(file, body, what, value) {
    const one = file.bodies[body];
    if (what === 'fixed') {
      for (const name of ['mass', 'inverse_mass', 'inertia', 'inverse_inertia', 'velocity', 'spin', 'fixed']) delete one[name];
      if (value) one.fixed = true;
      else one.mass = one.shape?.box ? massOf(one.shape.box[0] * one.shape.box[1]) : one.shape?.ball ? massOf(Math.PI * one.shape.ball ** 2) : 1;
      if (!value && !one.shape && !particles(file)) one.inertia = [0.1];
    } else if (what === 'mass') {
      const factor = value / massIn(one);
      if (one.inertia) one.inertia = one.inertia.map(x => x * factor);
      if (one.inverse_inertia) one.inverse_inertia = one.inverse_inertia.map(x => x / factor);
      delete one.inverse_mass;
      one.mass = value;
    } else {
      one[what] = value;
    }
    return `changed ${what} of a body`;
  },
};

// All that hangs together with a body by constraints, and what holds nothing else.
function groupOf(file, body) {
  const group = new Set([body]);
  if (!file.bodies[body].fixed)
    for (let before = 0; before < group.size;) {
      before = group.size;
      for (const { bodies } of file.constraints)
        if (bodies.some(one => group.has(one) && !file.bodies[one].fixed)) for (const one of bodies) if (!file.bodies[one].fixed) group.add(one);
    }
  file.bodies.forEach((one, i) => {
    const held = file.constraints.filter(({ bodies }) => bodies.includes(i));
    if (one.fixed && !one.shape && held.length && held.every(({ bodies }) => bodies.some(other => other !== i && group.has(other)))) group.add(i);
  });
  return group;
}

const add = (a, b) => a.map((x, k) => x + b[k]);

// A body of the world that constraints are nailed to.
function world(file) {
  const there = file.bodies.findIndex(body => body.fixed && !body.velocity && !body.spin);
  return there >= 0 ? there : file.bodies.push({ fixed: true, position: [0, 0] }) - 1;
}
const nail = (file, at) => file.bodies.push({ fixed: true, position: [...at] }) - 1;

function tie(file, from, to, [one, two], constraint, words) {
  if (distance(from, to) < 0.05 || (one.body < 0 && two.body < 0) || one.body === two.body) return undefined;
  const ends = [[one, from], [two, to]].map(([{ body, arm }, at]) => {
    if (particles(file)) return { body: body >= 0 ? body : nail(file, at) };
    if (body >= 0) return { body, arm };
    const i = world(file), { position: [x, y], rotation, angle = 0 } = file.bodies[i];
    return { body: i, arm: toBody({ x, y, cos: rotation?.[0] ?? Math.cos(angle), sin: rotation?.[1] ?? Math.sin(angle) }, at) };
  });
  file.constraints.push({ ...constraint, bodies: ends.map(end => end.body), ...(particles(file) ? {} : { arms: ends.map(end => end.arm) }) });
  return words;
}

// Friction names its contact by the contact's place, so places that move are followed.
function removeConstraints(file, gone) {
  const kept = [], place = new Map();
  file.constraints.forEach((one, i) => {
    if (gone(one, i) || (one.contact !== undefined && !place.has(one.contact))) return;
    place.set(i, kept.length);
    kept.push(one.contact === undefined ? one : { ...one, contact: place.get(one.contact) });
  });
  file.constraints = kept;
}
