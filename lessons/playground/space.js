'use strict';
// Pictures of a scene in space, seen from far away: WebGL draws its solids, what lies above them is as in the plane.

const plus = (a, b, factor = 1) => a.map((x, k) => x + factor * b[k]);
const inner = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const crossed = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

const solidVertex = `#version 300 es
in vec3 corner, outwards;
uniform vec3 right, up, towards, middle, place, size;
uniform mat3 turn;
uniform vec4 floor;  // a shadow lies on dot(floor.xyz, p) = floor.w
uniform float shadow, back;  // back: how far behind its place it counts
out vec3 normal, own;
void main() {
  vec3 p = place + turn * (size * corner);
  p -= shadow * (dot(floor.xyz, p) - floor.w) * floor.xyz;
  p -= middle;
  gl_Position = vec4(dot(right, p), dot(up, p), back - dot(towards, p), 1.);
  normal = turn * (outwards / size);
  own = corner;
}`;
const solidFragment = `#version 300 es
precision highp float;
uniform vec3 colour, light;
uniform float plain, marked;
in vec3 normal, own;
out vec4 pixel;
void main() {
  float shade = plain > .5 ? 1. : .66 + .36 * max(0., dot(normalize(normal), light));
  if (marked > .5 && own.x * own.y * own.z < 0.) shade *= .84;
  pixel = vec4(colour * shade, 1.);
}`;

// Corners and normals, three numbers each, of triangles; for `edges`, of lines.
function meshes() {
  const box = [], edges = [], ball = [], rod = [], sheet = [];
  for (const axis of [0, 1, 2])
    for (const side of [-1, 1]) {
      const at = (a, b) => { const p = [0, 0, 0]; p[axis] = side / 2; p[(axis + 1) % 3] = a / 2; p[(axis + 2) % 3] = b / 2; return p; };
      const n = [0, 0, 0]; n[axis] = side;
      for (const [a, b] of [[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]]) box.push(...at(a, b), ...n);
    }
  for (const axis of [0, 1, 2])
    for (const a of [-0.5, 0.5]) for (const b of [-0.5, 0.5]) for (const end of [-0.5, 0.5]) {
      const p = [0, 0, 0]; p[axis] = end; p[(axis + 1) % 3] = a; p[(axis + 2) % 3] = b;
      edges.push(...p, 0, 0, 1);
    }
  const round = 24, onBall = (i, k) => { const a = 2 * Math.PI * i / round, b = Math.PI * k / (round / 2); return [Math.sin(b) * Math.cos(a), Math.cos(b), Math.sin(b) * Math.sin(a)]; };
  for (let i = 0; i < round; ++i)
    for (let k = 0; k < round / 2; ++k)
      for (const p of [onBall(i, k), onBall(i + 1, k), onBall(i + 1, k + 1), onBall(i, k), onBall(i + 1, k + 1), onBall(i, k + 1)]) ball.push(...p, ...p);
  for (let i = 0; i < round; ++i) {
    const at = j => [Math.cos(2 * Math.PI * j / round), Math.sin(2 * Math.PI * j / round)];
    for (const [j, y] of [[i, -0.5], [i + 1, -0.5], [i + 1, 0.5], [i, -0.5], [i + 1, 0.5], [i, 0.5]]) { const [c, s] = at(j); rod.push(c, y, s, c, 0, s); }
  }
  for (const [a, b] of [[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]]) sheet.push(a, 0, b, 0, 1, 0);
  return { box, edges, ball, rod, sheet };
}

// Solids with hidden surfaces removed, drawn into a canvas of its own.
class Solids {
  constructor() {
    this.canvas = document.createElement('canvas');
    const gl = this.gl = this.canvas.getContext('webgl2', { antialias: true, alpha: false });
    if (!gl) return;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, solidVertex], [gl.FRAGMENT_SHADER, solidFragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    this.at = Object.fromEntries(['right', 'up', 'towards', 'middle', 'place', 'size', 'turn', 'floor', 'shadow', 'back', 'colour', 'light', 'plain', 'marked'].map(name => [name, gl.getUniformLocation(program, name)]));
    this.meshes = {};
    const all = [];
    for (const [name, numbers] of Object.entries(meshes())) {
      this.meshes[name] = [all.length / 6, numbers.length / 6];
      all.push(...numbers);
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(all), gl.STATIC_DRAW);
    for (const [name, offset] of [['corner', 0], ['outwards', 12]]) {
      const place = gl.getAttribLocation(program, name);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 24, offset);
    }
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
  }

  // `seen`: right, up and towards the viewer; `scale` [pixels/m]; `reach` [m]: how far before and behind the middle.
  begin({ width, height, middle, seen: [right, up, towards], scale, reach, paper }) {
    const { gl, at, canvas } = this;
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    gl.clearColor(...paper, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniform3fv(at.right, right.map(x => 2 * scale * x / width));
    gl.uniform3fv(at.up, up.map(x => 2 * scale * x / height));
    gl.uniform3fv(at.towards, towards.map(x => x / reach));
    gl.uniform3fv(at.middle, middle);
    const light = right.map((x, k) => -0.35 * x + 0.75 * up[k] + 0.56 * towards[k]);
    gl.uniform3fv(at.light, light);
    gl.uniform1f(at.shadow, 0);
    this.grain = 1.5 / scale / reach;  // a pixel and a half
  }
  // `turn`: the rows of its rotation; `off`: how far behind its place it counts where others are as near.
  draw(mesh, { place, size, turn = [1, 0, 0, 0, 1, 0, 0, 0, 1], colour, plain = false, marked = false, off = 1, lines = false }) {
    const { gl, at } = this, [first, count] = this.meshes[mesh];
    gl.uniform3fv(at.place, place);
    gl.uniform3fv(at.size, size);
    gl.uniformMatrix3fv(at.turn, true, turn);
    gl.uniform3fv(at.colour, colour);
    gl.uniform1f(at.plain, plain);
    gl.uniform1f(at.marked, marked);
    gl.uniform1f(at.back, lines ? 0 : off * this.grain);
    gl.drawArrays(lines ? gl.LINES : gl.TRIANGLES, first, count);
  }
  // What is drawn from here on lies flat on a floor, or no longer does.
  flatten(normal, height) {
    this.gl.uniform1f(this.at.shadow, normal ? 1 : 0);
    if (normal) this.gl.uniform4fv(this.at.floor, [...normal, height]);
  }
}

class SpacePicture extends Picture {
  #solids = undefined;
  #colours = new Map();
  #ends = { turned: 0.5, raised: 0.3 };  // of the viewer, about the vertical and above the level [rad]
  #middle = [0, 0, 0];                   // what is in the middle of the picture [m]
  #radius = 1;                           // of all that moves, when the scene was fitted [m]

  // Whether this browser draws it.
  get works() { return !!(this.#solids ??= new Solids()).gl; }

  // What lies to the right, up and towards the viewer.
  get axes() {
    const { turned, raised } = this.#ends, [ct, st, cr, sr] = [Math.cos(turned), Math.sin(turned), Math.cos(raised), Math.sin(raised)];
    return [[ct, 0, -st], [-sr * st, cr, -sr * ct], [cr * st, sr, cr * ct]];
  }
  get seen() { return this.axes.slice(0, 2); }
  get inSeen() { return this.seen.map(axis => inner(axis, this.#middle)); }

  pixel(point) {
    const from = plus(point, this.#middle, -1), [u, v] = this.seen.map(axis => inner(axis, from));
    return [this.width / 2 + u * this.camera.scale, this.height / 2 - v * this.camera.scale];
  }
  // The point that is seen there, as far away as the middle.
  point([px, py]) {
    const [right, up] = this.axes, { scale } = this.camera;
    return plus(plus(this.#middle, right, (px - this.width / 2) / scale), up, (this.height / 2 - py) / scale);
  }

  fit({ look, fixed }, moment) {
    const low = [Infinity, Infinity, Infinity], high = low.map(x => -x);
    look.bodies.forEach((body, i) => {
      const reach = reachOf(body);
      if (body.as === 'half_space' || (reach > 30 && fixed[i])) return;
      positionOf(placeOf(moment, i)).forEach((x, axis) => {
        low[axis] = Math.min(low[axis], x - reach);
        high[axis] = Math.max(high[axis], x + reach);
      });
    });
    if (!(low[0] <= high[0])) low.fill(-1), high.fill(1);
    this.#middle = plus(low, high).map(x => x / 2);
    this.#radius = Math.max(0.5 * Math.hypot(...plus(high, low, -1)), 1e-3);
    this.camera.scale = 0.44 * Math.min(this.width, this.height) / this.#radius;
    this.fitted = true;
  }
  pan(x, y) {
    const [right, up] = this.axes, { scale } = this.camera;
    this.fitted = false;
    this.#middle = plus(plus(this.#middle, right, -x / scale), up, y / scale);
  }
  zoom(factor, around = [this.width / 2, this.height / 2]) {
    this.fitted = false;
    const before = this.point(around);
    this.camera.scale = Math.min(1e6, Math.max(0.1, this.camera.scale * factor));
    this.#middle = plus(plus(this.#middle, before), this.point(around), -1);
  }
  // Turns the view by so many pixels of a drag.
  orbit(x, y) {
    const ends = this.#ends;
    ends.turned -= x / 150;
    ends.raised = Math.min(1.5, Math.max(-1.5, ends.raised + y / 150));
  }

  drawScene({ scene, moment, marks, selected, hot }) {
    const { context, ratio, width, height, colours, camera: { scale } } = this, { look, fixed } = scene, solids = this.#solids;
    const of = colour => this.#rgb(colour), metres = pixels => pixels / scale;
    const reach = 40 * this.#radius + metres(width + height);
    solids.begin({ width: this.canvas.width, height: this.canvas.height, middle: this.#middle, seen: this.axes, scale: scale * ratio, reach, paper: of(colours.paper) });
    const all = this.#parts(scene, moment, marks, selected, hot);
    look.bodies.forEach((body, i) => {
      if (body.as !== 'half_space') return;
      const place = placeOf(moment, i), normal = toWorld({ ...place, x: 0, y: 0, z: 0 }, body.sides);
      if (normal[1] < 0.5) return;  // walls would hide what is behind them
      this.#floor(normal, inner(normal, positionOf(place)));
      solids.flatten(normal, inner(normal, positionOf(place)));
      for (const [mesh, part] of all) if (mesh !== 'edges' && inner(normal, part.place) > inner(normal, positionOf(place))) solids.draw(mesh, { ...part, colour: of(`color-mix(in srgb, ${colours.ink} 16%, ${colours.wash})`), plain: true, off: 3 });
      solids.flatten();
    });
    for (const [mesh, part] of all) solids.draw(mesh, part);
    context.drawImage(solids.canvas, 0, 0, width, height);
  }

  #floor(normal, height) {
    const { colours } = this, solids = this.#solids, radius = 3 * this.#radius;
    const z = crossed(Math.abs(normal[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], normal), across = z.map(c => c / Math.hypot(...z)), along = crossed(normal, across);
    const turn = [0, 1, 2].flatMap(k => [along[k], normal[k], across[k]]);
    const middle = plus(this.#middle, normal, height - inner(normal, this.#middle));
    solids.draw('sheet', { place: middle, size: [radius, 1, radius], turn, colour: this.#rgb(colours.wash), plain: true, off: 4 });
    // Lines at round places, however the view is moved.
    const step = 10 ** Math.floor(Math.log10(this.#radius)), thick = 0.6 / this.camera.scale;
    for (const [way, other, size] of [[along, across, [thick, 1, radius]], [across, along, [radius, 1, thick]]]) {
      const from = inner(way, middle);
      for (let t = Math.ceil((from - radius) / step) * step; t <= from + radius; t += step)
        solids.draw('sheet', { place: plus(middle, way, t - from), size, turn, colour: this.#rgb(colours.rule), plain: true, off: 2 });
    }
  }

  // All solids, each with its mesh.
  #parts({ look, fixed }, moment, marks, selected, hot) {
    const { colours, camera: { scale } } = this, parts = [], metres = pixels => pixels / scale;
    const lightest = Math.min(...look.bodies.filter(body => body.as === 'bob').map(body => body.mass));
    const ball = (place, radius, colour, more) => parts.push(['ball', { place, size: [radius, radius, radius], colour: this.#rgb(colour), ...more }]);
    const rod = (from, to, radius, colour) => {
      const d = plus(to, from, -1), length = Math.hypot(...d);
      if (!(length > 1e-9)) return;
      const y = d.map(x => x / length), z = crossed(Math.abs(y[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], y), across = z.map(x => x / Math.hypot(...z)), x = crossed(y, across);
      parts.push(['rod', { place: plus(from, d, 0.5), size: [radius, length, radius], turn: [0, 1, 2].flatMap(k => [x[k], y[k], across[k]]), colour: this.#rgb(colour) }]);
    };
    look.bodies.forEach((body, i) => {
      const place = placeOf(moment, i), at = positionOf(place), chosen = i === selected || i === hot;
      const own = marks.get(i) ?? (fixed[i] ? colours.fixed : colours.body), colour = chosen ? `color-mix(in oklab, ${colours.accent} 35%, ${own})` : own;
      if (body.as === 'box') {
        parts.push(['box', { place: at, size: body.sides, turn: place.turn, colour: this.#rgb(colour) }]);
        parts.push(['edges', { place: at, size: body.sides, turn: place.turn, colour: this.#rgb(chosen ? colours.accent : colours.ink), plain: true, lines: true }]);
      } else if (body.as === 'disc') {
        ball(at, body.sides[0], colour, { turn: place.turn, marked: true });
      } else if (body.as === 'bob') {
        ball(at, metres(bobRadius(body, lightest)), colour);
      }
    });
    for (const { as, bodies, arms } of look.ties) {
      const [from, to] = bodies.map((body, k) => toWorld(placeOf(moment, body), arms[k]));
      if (as === 'rod') rod(from, to, metres(2.2), colours.constraint);
      if (as === 'spring') rod(from, to, metres(1.2), colours.constraint);
      if (as === 'joint') ball(to, metres(5), colours.constraint);
      bodies.forEach((body, k) => {
        if (as === 'surface') return;
        if (fixed[body] && look.bodies[body].as === 'nothing') ball([from, to][k], metres(6), colours.fixed);
        if (as === 'joint' && !fixed[body]) rod(positionOf(placeOf(moment, body)), to, metres(2), colours.muted);
      });
    }
    return parts;
  }

  // Three numbers from 0 to 1 of any colour of the page.
  #rgb(colour) {
    if (!this.#colours.has(colour)) {
      const context = Object.assign(document.createElement('canvas'), { width: 1, height: 1 }).getContext('2d', { willReadFrequently: true });
      context.fillStyle = colour;
      context.fillRect(0, 0, 1, 1);
      this.#colours.set(colour, [...context.getImageData(0, 0, 1, 1).data].slice(0, 3).map(x => x / 255));
    }
    return this.#colours.get(colour);
  }

  // How far towards the viewer from a point of `point` a body's surface is [m]; undefined where the line of sight passes it.
  #surface(body, place, from, slack, lightest) {
    const towards = this.axes[2], near = slack / this.camera.scale, o = toBody(place, from), d = toBody({ ...place, x: 0, y: 0, z: 0 }, towards);
    if (body.as === 'disc' || body.as === 'bob') {
      const radius = near + (body.as === 'disc' ? body.sides[0] : bobRadius(body, lightest) / this.camera.scale), along = inner(o, d);
      const rest = radius * radius - inner(o, o) + along * along;
      return rest >= 0 ? Math.sqrt(rest) - along : undefined;
    }
    if (body.as !== 'box') return undefined;
    let enters = -Infinity, leaves = Infinity;
    for (let k = 0; k < 3; ++k) {
      const half = body.sides[k] / 2 + near;
      if (Math.abs(d[k]) < 1e-12) {
        if (Math.abs(o[k]) > half) return undefined;
        continue;
      }
      const [a, b] = [(-half - o[k]) / d[k], (half - o[k]) / d[k]];
      enters = Math.max(enters, Math.min(a, b));
      leaves = Math.min(leaves, Math.max(a, b));
    }
    return enters <= leaves ? leaves : undefined;
  }
  // The nearest body on the line of sight; without slack first, or thin neighbours would be in each other's way.
  bodyAt(scene, moment, point) {
    const lightest = Math.min(...scene.look.bodies.filter(body => body.as === 'bob').map(body => body.mass));
    for (const slack of [0, 8]) {
      let nearest = -1, most = -Infinity;
      scene.look.bodies.forEach((body, i) => {
        const way = this.#surface(body, placeOf(moment, i), point, slack, lightest);
        if (way > most) nearest = i, most = way;
      });
      if (nearest >= 0) return nearest;
    }
    return -1;
  }
  surfaceAt(scene, moment, body, point) {
    const lightest = Math.min(...scene.look.bodies.filter(one => one.as === 'bob').map(one => one.mass)), way = this.#surface(scene.look.bodies[body], placeOf(moment, body), point, 8, lightest);
    return plus(point, this.axes[2], way ?? 0);
  }
}
