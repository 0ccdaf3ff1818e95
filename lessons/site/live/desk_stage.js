'use strict';
// What was derived, run by the solver and drawn: the bodies, the paths of their centres, and J's parts (6) on them.

// `run(scene)` answers with what is drawn and a sentence about it.
function deskStage(run) {
  const of = id => document.getElementById(id);
  const section = of('run'), svg = of('stage'), play = of('play'), time = of('time'), clock = of('clock'), told = of('told');
  const perSecond = 60, longestArrow = 0.6, turn = 0.2;  // moments a second, metres, the radius of a torque's arc
  const scenes = { pendulum: 'Pendulum: one body is fixed', chain: 'Chain of two', box: 'Two boxes thrown, without gravity' };
  let scene = 'pendulum', ran, scale, measured, playing = false;

  const node = (name, attributes, ...children) => {
    const element = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    element.append(...children);
    return element;
  };
  const at = ([x, y]) => `${x.toFixed(4)},${(-y).toFixed(4)}`;  // y points up
  const path = (className, points) => node('path', { class: className, d: 'M' + points.map(at).join('L') });
  const along = ([x, y], angle, length) => [x + length * Math.cos(angle), y + length * Math.sin(angle)];
  const length = ([x, y]) => Math.hypot(x, y);

  function head(className, tip, angle) {
    return path(className, [along(tip, angle + 2.6, 0.09), tip, along(tip, angle - 2.6, 0.09)]);
  }

  function arrows({ body, linear, angular }, moment) {
    const centre = moment.centres[body], className = 'part';
    const drawn = [];
    if (length(linear) * scale.linear > 0.01) {
      const angle = Math.atan2(linear[1], linear[0]), tip = along(centre, angle, length(linear) * scale.linear);
      drawn.push(path(className, [centre, tip]), head(className, tip, angle));
    }
    if (Math.abs(angular) * scale.angular > 0.05) {
      const end = angular * scale.angular, count = 24, way = Array.from({ length: count + 1 }, (_, i) => along(centre, i / count * end, turn));
      drawn.push(path(className + ' turn', way), head(className + ' turn', way.at(-1), end + Math.sign(end) * Math.PI / 2));
    }
    return drawn;
  }

  function words(moment) {
    const number = x => (Math.abs(x) < 5e-4 ? 0 : x).toFixed(2).replace('-', '−');
    return moment.parts.slice(0, 2).map(({ linear, angular }, i) =>
      `J's parts on body ${i + 1} are (${number(linear[0])}, ${number(linear[1])}) and ${number(angular)}`).join('; ') + '.';
  }

  function draw() {
    const i = Math.round(time.value * perSecond), moment = ran.moments[i];
    const bodies = moment.corners.map((corners, body) => node('g', { class: ran.moves[body] ? 'body' : 'body fixed' },
      ...ran.edges.map(([a, b]) => path('', [corners[a], corners[b]]))));
    const paths = ran.moves.flatMap((moves, body) => moves ? [path('way', ran.moments.slice(0, i + 1).map(m => m.centres[body]))] : []);
    svg.replaceChildren(...paths, ...bodies, ...moment.parts.flatMap(part => arrows(part, moment)));
    clock.textContent = `${Number(time.value).toFixed(2)} s`;
    if (!playing) told.textContent = `${measured} At ${clock.textContent} ${words(moment)}`;
  }

  function frame() {
    const all = ran.moments.flatMap(moment => moment.corners.flat()), margin = longestArrow;
    const [low, high] = [0, 1].map(axis => all.map(point => point[axis])).reduce(([low, high], values) =>
      [[...low, Math.min(...values) - margin], [...high, Math.max(...values) + margin]], [[], []]);
    svg.setAttribute('viewBox', `${low[0]} ${-high[1]} ${high[0] - low[0]} ${high[1] - low[1]}`);
    const parts = ran.moments.flatMap(moment => moment.parts);
    const largest = values => Math.max(...values, 1e-12);
    scale = { linear: longestArrow / largest(parts.map(part => length(part.linear))),
      angular: 1.5 * Math.PI / largest(parts.map(part => Math.abs(part.angular))) };
  }

  function show() {
    const answer = run(scene);
    ({ ran, measured } = answer);
    for (const button of of('scenes').children) button.setAttribute('aria-pressed', button.dataset.scene === scene);
    for (const element of [svg, play.parentElement]) element.hidden = !ran;
    svg.style.display = ran ? '' : 'none';
    playing = false;
    play.textContent = 'Play';
    time.value = 0;
    if (!ran) return void (told.textContent = measured);
    frame();
    draw();
  }

  of('scenes').replaceChildren(...Object.entries(scenes).map(([name, title]) => {
    const button = Object.assign(document.createElement('button'), { type: 'button', textContent: title });
    button.dataset.scene = name;
    button.onclick = () => {
      scene = name;
      show();
    };
    return button;
  }));

  time.oninput = () => {
    playing = false;
    play.textContent = 'Play';
    draw();
  };
  play.onclick = () => {
    playing = !playing;
    play.textContent = playing ? 'Pause' : 'Play';
    if (!playing) return draw();
    const from = Number(time.value) < Number(time.max) ? Number(time.value) : 0, begun = performance.now();
    const next = now => {
      if (!playing) return;
      const seconds = from + (now - begun) / 1000;
      time.value = Math.max(from, Math.min(seconds, time.max));
      playing = seconds < time.max;
      if (!playing) play.textContent = 'Play';
      draw();
      if (playing) requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  };

  return stands => {
    section.hidden = !stands;
    playing = false;
    if (stands) show();
  };
}
