'use strict';
// Pictures of a scene in the plane: its bodies and what ties them, from the numbers of one moment.

// A body has four numbers in the plane, in space twelve (playground.hpp).
const momentOf = (numbers, each) => ({ time: numbers[0], energy: numbers[1], gap: numbers[2], each, count: (numbers.length - 3) / each, numbers });
const placeOf = ({ numbers, each }, i) => {
  const [x, y, ...rest] = numbers.subarray(3 + each * i, 3 + each * (i + 1));
  return each === 4 ? { x, y, cos: rest[0], sin: rest[1] } : { x, y, z: rest[0], turn: rest.slice(1) };
};
const positionOf = ({ x, y, z }) => z === undefined ? [x, y] : [x, y, z];
function toWorld({ x, y, z, cos, sin, turn: R }, [a, b, c]) {
  if (R) return [x + R[0] * a + R[1] * b + R[2] * c, y + R[3] * a + R[4] * b + R[5] * c, z + R[6] * a + R[7] * b + R[8] * c];
  return [x + cos * a - sin * b, y + sin * a + cos * b];
}
function toBody({ x, y, z, cos, sin, turn: R }, [px, py, pz]) {
  const a = px - x, b = py - y, c = pz - z;
  if (R) return [R[0] * a + R[3] * b + R[6] * c, R[1] * a + R[4] * b + R[7] * c, R[2] * a + R[5] * b + R[8] * c];
  return [cos * a + sin * b, cos * b - sin * a];
}
const distance = (a, b) => Math.hypot(...a.map((x, k) => b[k] - x));

class Picture {
  fitted = false;  // whether the camera shows all as it was when the scene was opened
  camera = { x: 0, y: 0, scale: 50 };  // the middle of the picture [m], pixels per metre

  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.resize();
    this.dress();
  }

  resize() {
    const { width, height } = this.canvas.getBoundingClientRect();
    Object.assign(this, { width, height, ratio: Math.min(devicePixelRatio || 1, 2) });
    this.canvas.width = Math.round(width * this.ratio);
    this.canvas.height = Math.round(height * this.ratio);
  }

  // The colours of the page, light or dark, each with its meaning in the course.
  dress() {
    const style = getComputedStyle(this.canvas);
    this.colours = Object.fromEntries(['paper', 'wash', 'ink', 'muted', 'rule', 'accent', 'body', 'fixed', 'constraint', 'force', 'velocity', 'error', 'wrong']
      .map(name => [name, style.getPropertyValue('--' + name).trim()]));
  }

  pixel([x, y]) { return [this.width / 2 + (x - this.camera.x) * this.camera.scale, this.height / 2 - (y - this.camera.y) * this.camera.scale]; }
  point([px, py]) { return [this.camera.x + (px - this.width / 2) / this.camera.scale, this.camera.y - (py - this.height / 2) / this.camera.scale]; }

  // What a step's parts are drawn in: the middle of the picture along what lies to the right and up in it, and these axes,
  // which in the plane are the world's.
  get inSeen() { return [this.camera.x, this.camera.y]; }
  get seen() { return undefined; }
  // The point of a body that is seen at a point.
  surfaceAt(_scene, _moment, _body, point) { return point; }

  pan(x, y) {
    this.fitted = false;
    this.camera.x -= x / this.camera.scale;
    this.camera.y += y / this.camera.scale;
  }

  // Shows all that moves with some air around it.
  fit({ look, fixed }, moment) {
    const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    look.bodies.forEach((body, i) => {
      if (body.as === 'half_space') return;
      const place = placeOf(moment, i), reach = reachOf(body);
      if (reach > 30 && fixed[i]) return;  // a long wall goes on beyond the picture
      [place.x, place.y].forEach((x, axis) => {
        low[axis] = Math.min(low[axis], x - reach);
        high[axis] = Math.max(high[axis], x + reach);
      });
    });
    if (!(low[0] <= high[0])) Object.assign(low, [-4, -1]), Object.assign(high, [4, 5]);
    const air = 0.18 * Math.max(high[0] - low[0], high[1] - low[1], 0.5);
    const scale = Math.min(this.width / (high[0] - low[0] + 2 * air), this.height / (high[1] - low[1] + 2 * air), 160);
    Object.assign(this.camera, { x: (low[0] + high[0]) / 2, y: (low[1] + high[1]) / 2, scale });
    this.fitted = true;
  }

  zoom(factor, around = [this.width / 2, this.height / 2]) {
    this.fitted = false;
    const before = this.point(around);
    this.camera.scale = Math.min(4000, Math.max(2, this.camera.scale * factor));
    const after = this.point(around);
    this.camera.x += before[0] - after[0];
    this.camera.y += before[1] - after[1];
  }

  // `marks`: colour by body; `labels`: short words at bodies; `draft`: what is being put down.
  draw({ scene, moment, marks = new Map(), labels = [], selected = -1, hand, draft, cursor, hot = -1 }) {
    const { context, ratio, width, height, colours } = this;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = colours.paper;
    context.fillRect(0, 0, width, height);
    context.lineJoin = context.lineCap = 'round';
    this.drawScene({ scene, moment, marks, selected, hot });
    for (const [i, words, colour] of labels) this.#label(this.pixel(positionOf(placeOf(moment, i))), words, colour);
    if (hand) this.#hand(hand, moment);
    if (draft) this.#draft(draft);
    if (cursor) this.#cursor(this.pixel(cursor));
    this.#scale();
  }

  drawScene({ scene, moment, marks, selected, hot }) {
    const { colours } = this;
    scene.look.bodies.forEach((body, i) => { if (body.as === 'half_space') this.#ground(placeOf(moment, i), body.sides); });
    scene.look.ties.forEach(tie => { if (tie.as === 'surface') this.#surface(scene, moment, tie); });
    scene.look.bodies.forEach((body, i) => {
      if (body.as === 'bob' || body.as === 'nothing' || body.as === 'half_space') return;
      this.#body(body, placeOf(moment, i), marks.get(i) ?? (scene.fixed[i] ? colours.fixed : colours.body), i === selected || i === hot);
    });
    for (const tie of scene.look.ties) this.#tie(scene, moment, tie);
    for (const motor of scene.motors) this.#motor(moment, motor);
    const lightest = Math.min(...scene.look.bodies.filter(body => body.as === 'bob').map(body => body.mass));
    scene.look.bodies.forEach((body, i) => {
      if (body.as !== 'bob') return;
      this.#disc(this.pixel([placeOf(moment, i).x, placeOf(moment, i).y]), bobRadius(body, lightest), marks.get(i) ?? colours.body, i === selected || i === hot);
    });
  }

  #stroke(colour, width = 1.5, dash = []) {
    Object.assign(this.context, { strokeStyle: colour, lineWidth: width });
    this.context.setLineDash(dash);
  }
  #line(points, colour, width, dash) {
    this.#stroke(colour, width, dash);
    this.context.beginPath();
    points.forEach(([x, y], i) => i ? this.context.lineTo(x, y) : this.context.moveTo(x, y));
    this.context.stroke();
  }
  #disc([x, y], radius, fill, thick) {
    const { context, colours } = this;
    this.#stroke(thick ? colours.accent : colours.ink, thick ? 3 : 1.5);
    context.fillStyle = fill;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }

  #body(body, place, fill, thick) {
    const { context, colours, ratio, camera: { scale } } = this, [x, y] = this.pixel([place.x, place.y]);
    context.fillStyle = fill;
    this.#stroke(thick ? colours.accent : colours.ink, thick ? 3 : 1.5);
    if (body.as === 'box') {
      const [w, h] = body.sides.map(side => side * scale), { cos, sin } = place;
      context.setTransform(ratio * cos, -ratio * sin, ratio * sin, ratio * cos, ratio * x, ratio * y);
      context.fillRect(-w / 2, -h / 2, w, h);
      context.strokeRect(-w / 2, -h / 2, w, h);
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
    } else if (body.as === 'disc') {
      this.#disc([x, y], body.sides[0] * scale, fill, thick);
      this.#line([[x, y], this.pixel(toWorld(place, [body.sides[0], 0]))], colours.ink, 1.2);
    } else if (body.as === 'link') {
      const ends = [body.from, body.to].map(end => this.pixel(toWorld(place, end)));
      this.#line(ends, thick ? colours.accent : colours.ink, thick ? 15 : 12);
      this.#line(ends, fill, 9);
    }
  }

  // A half-plane: everything below its line, along the picture's whole width.
  #ground(place, normal) {
    const { context, colours } = this, n = toWorld({ ...place, x: 0, y: 0 }, normal), along = [n[1], -n[0]];
    const middle = this.point([this.width / 2, this.height / 2]);
    const s = along[0] * (middle[0] - place.x) + along[1] * (middle[1] - place.y), reach = (this.width + this.height) / this.camera.scale;
    const at = (t, depth) => this.pixel([place.x + (s + t) * along[0] - depth * n[0], place.y + (s + t) * along[1] - depth * n[1]]);
    context.fillStyle = colours.wash;
    context.beginPath();
    [at(-reach, 0), at(reach, 0), at(reach, 2 * reach), at(-reach, 2 * reach)].forEach(([x, y], i) => i ? context.lineTo(x, y) : context.moveTo(x, y));
    context.fill();
    this.#hatched(at(-reach, 0), at(reach, 0));
  }
  #surface(scene, moment, { bodies: [body], arms: [arm], normal }) {
    const from = toWorld(placeOf(moment, body), arm), reach = (this.width + this.height) / this.camera.scale;
    this.#hatched(this.pixel([from[0] - reach * normal[1], from[1] + reach * normal[0]]), this.pixel([from[0] + reach * normal[1], from[1] - reach * normal[0]]));
  }
  // A line with short strokes on its right, as drawings of supports have it.
  #hatched(from, to) {
    const { context, colours } = this, length = distance(from, to), u = [(to[0] - from[0]) / length, (to[1] - from[1]) / length], step = 16;
    this.#line([from, to], colours.ink, 2);
    this.#stroke(colours.muted, 1);
    context.beginPath();
    for (let t = step; t < length; t += step) {
      const x = from[0] + t * u[0], y = from[1] + t * u[1];
      if (x < -20 || x > this.width + 20 || y < -20 || y > this.height + 20) continue;
      context.moveTo(x, y);
      context.lineTo(x - 8 * u[0] - 9 * u[1], y - 8 * u[1] + 9 * u[0]);
    }
    context.stroke();
  }

  #tie({ look, fixed }, moment, { as, bodies, arms }) {
    const { colours } = this;
    if (as === 'surface') return;
    const [from, to] = bodies.map((body, k) => this.pixel(toWorld(placeOf(moment, body), arms[k])));
    if (as === 'rod') this.#line([from, to], colours.constraint, 5);
    if (as === 'spring') this.#spring(from, to);
    bodies.forEach((body, k) => { if (fixed[body] && look.bodies[body].as === 'nothing') this.#support([from, to][k]); });
    if (as === 'joint') this.#disc(to, 4.5, colours.paper);
  }
  #spring(from, to) {
    const length = distance(from, to) || 1, u = [(to[0] - from[0]) / length, (to[1] - from[1]) / length], turns = 10, half = 7;
    const at = (t, side) => [from[0] + t * length * u[0] - side * u[1], from[1] + t * length * u[1] + side * u[0]];
    this.#line([from, at(0.1, 0), ...Array.from({ length: 2 * turns }, (_, i) => at(0.1 + 0.8 * (i + 0.5) / (2 * turns), i % 2 ? half : -half)), at(0.9, 0), to], this.colours.constraint, 2);
  }
  #support([x, y]) {
    const { context, colours } = this;
    context.fillStyle = colours.fixed;
    this.#stroke(colours.ink, 1.2);
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x - 9, y - 14);
    context.lineTo(x + 9, y - 14);
    context.closePath();
    context.fill();
    context.stroke();
    this.#line([[x - 13, y - 14], [x + 13, y - 14]], colours.ink, 2);
  }
  #motor(moment, { body, speed }) {
    const { context, colours } = this, place = placeOf(moment, body), [x, y] = this.pixel(toWorld(place, [0, 0])), turn = Math.sign(speed) || 1, radius = 15;
    this.#stroke(colours.force, 2.5);
    context.beginPath();
    const from = -0.5 * Math.PI, to = from - turn * 1.4 * Math.PI;
    context.arc(x, y, radius, from, to, turn > 0);
    context.stroke();
    const tip = [x + radius * Math.cos(to), y + radius * Math.sin(to)], ahead = to - turn * Math.PI / 2;
    this.#line([2.5, -2.5].map(off => [tip[0] + 8 * Math.cos(ahead + off), tip[1] + 8 * Math.sin(ahead + off)]).toSpliced(1, 0, tip), colours.force, 2.5);
  }
  #label([x, y], words, colour) {
    const { context, colours } = this;
    Object.assign(context, { font: '700 13px "Course Sans", system-ui, sans-serif', textAlign: 'center', textBaseline: 'middle', fillStyle: colour });
    const half = Math.max(11, context.measureText(words).width / 2 + 6);
    this.#stroke(colours.paper, 2);
    context.beginPath();
    context.roundRect(x - half, y - 11, 2 * half, 22, 11);
    context.fill();
    context.stroke();
    context.fillStyle = colours.paper;
    context.fillText(words, x, y + 1);
  }
  #hand({ body, arm, at }, moment) {
    const { colours } = this, hand = this.pixel(at);
    this.#line([this.pixel(toWorld(placeOf(moment, body), arm)), hand], colours.muted, 2.5, [6, 6]);
    this.#disc(hand, 8, colours.accent);
  }
  #draft({ tool, from, to, corners, radius }) {
    const { context, colours } = this, a = this.pixel(from), b = this.pixel(to);
    this.#stroke(colours.accent, 2, [6, 5]);
    context.beginPath();
    if (corners) corners.map(corner => this.pixel(corner)).forEach(([x, y], i) => i ? context.lineTo(x, y) : context.moveTo(x, y)), context.closePath();
    else if (radius) context.arc(...a, radius * this.camera.scale, 0, 2 * Math.PI);
    else context.moveTo(...a), context.lineTo(...b);
    context.stroke();
    if (tool === 'rod' || tool === 'spring') this.#disc(a, 4, colours.accent), this.#disc(b, 4, colours.accent);
  }
  #cursor([x, y]) {
    for (const [colour, width] of [[this.colours.paper, 5], [this.colours.accent, 2]]) {
      this.#line([[x - 12, y], [x + 12, y]], colour, width);
      this.#line([[x, y - 12], [x, y + 12]], colour, width);
    }
  }
  // How long a metre is, or ten of them or a tenth.
  #scale() {
    const { context, colours, camera: { scale } } = this, length = 10 ** Math.round(Math.log10(90 / scale)), x = this.width - 18, y = this.height - 16;
    this.#line([[x - length * scale, y - 4], [x - length * scale, y], [x, y], [x, y - 4]], colours.muted, 1.5);
    Object.assign(context, { font: '13px "Course Sans", system-ui, sans-serif', textAlign: 'right', textBaseline: 'bottom', fillStyle: colours.muted });
    context.fillText(`${length} m`, x, y - 5);
  }

  // The body at a point of the world, the topmost first; -1 if there is none. Grounds are bodies only where `any` is.
  bodyAt(scene, moment, point, { any = false, but = -1, slack = 8 } = {}) {
    const near = slack / this.camera.scale, lightest = Math.min(...scene.look.bodies.filter(body => body.as === 'bob').map(body => body.mass));
    for (let i = scene.look.bodies.length - 1; i >= 0; --i) {
      const body = scene.look.bodies[i], place = placeOf(moment, i), [a, b] = toBody(place, point);
      if (i === but) continue;
      if (body.as === 'box' && Math.abs(a) <= body.sides[0] / 2 + near && Math.abs(b) <= body.sides[1] / 2 + near) return i;
      if (body.as === 'disc' && Math.hypot(a, b) <= body.sides[0] + near) return i;
      if (body.as === 'bob' && Math.hypot(a, b) <= bobRadius(body, lightest) / this.camera.scale + near) return i;
      if (body.as === 'link' && toSegment([a, b], body.from, body.to) <= 7 / this.camera.scale + near) return i;
    }
    if (!any) return -1;
    return scene.look.bodies.findIndex((body, i) => body.as === 'half_space' && toBody(placeOf(moment, i), point).reduce((sum, x, k) => sum + x * body.sides[k], 0) <= near);
  }
}

function reachOf(body) {
  if (body.as === 'disc') return body.sides[0];
  if (body.as === 'box') return Math.hypot(...body.sides) / 2;
  return body.as === 'link' ? Math.hypot(...body.from) : 0;
}
const bobRadius = (body, lightest) => 11 * Math.min(Math.cbrt(body.mass / lightest), 4);
function toSegment(p, a, b) {
  const d = [b[0] - a[0], b[1] - a[1]], t = Math.min(1, Math.max(0, ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1] || 1)));
  return distance(p, [a[0] + t * d[0], a[1] + t * d[1]]);
}
