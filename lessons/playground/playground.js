'use strict';
// The playground's page. All motion, and what the doctor says, is the course's own C++ (lessons/playground/web.cpp).
// Here are hands and tools, the clock, the method's knobs, undo, link, file and picture.

(async () => {
  const of = id => document.getElementById(id);
  const root = of('playground'), stage = of('stage'), canvas = of('picture'), overlay = of('part'), said = of('said'), words = of('words');
  const make = (tag, properties = {}, ...children) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };
  const still = matchMedia('(prefers-reduced-motion: reduce)'), dark = matchMedia('(prefers-color-scheme: dark)');
  const slower = 100, parts = 6, endOfPart = 1e-3;
  const signed = text => text.replace('-', '−');
  const number = (value, digits = 3) => signed(Math.abs(value) >= 1e5 || (value && Math.abs(value) < 1e-3) ? String(value.toExponential(digits - 1)) : (+value.toPrecision(digits)).toLocaleString('en', { maximumSignificantDigits: digits }));

  // ---- The program, and the doctor's.

  const starts = new Map(), startTexts = new Map();  // the start scenes by name: their files, and those as they were understood
  let ask, doctor;
  try {
    const [program, letters, scenes] = await Promise.all([unpacked(byhandParts.playground), unpacked(byhandParts.letters), unpacked(byhandParts.scenes)]);
    ask = await start({ program, files: untar(letters) });
    of('starts').append(make('option', { value: '', textContent: 'Your scene', hidden: true }), ...startsOf(untar(scenes)));
    doctor = startDoctor(program, untar(letters));
  } catch (error) {
    of('missing').textContent = `The playground does not run here: ${error.message ?? error}`;
    return;
  }
  const heading = document.querySelector('#missing h1');
  heading.className = 'skip';
  of('missing').replaceWith(heading);
  root.hidden = false;

  async function startDoctor(program, files) {
    const worker = new Worker(URL.createObjectURL(new Blob([await unpackedLetters(byhandParts.doctor)], { type: 'text/javascript' })));
    worker.postMessage({ program, files });
    worker.onmessage = ({ data }) => { if (data.id === consulted) showFindings(data); };
    return worker;
  }
  async function unpackedLetters(base64) {
    const stream = new Blob([Uint8Array.from(atob(base64), letter => letter.charCodeAt(0))]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Response(stream).arrayBuffer();
  }

  // Of a file, which may have comments.
  function titleOf(text) { return JSON.parse(/"title":\s*("(?:[^"\\]|\\.)*")/.exec(text)[1]); }

  // The start scenes by name, "stack" or "01_heavy_on_light", as options of the list.
  function startsOf(files) {
    const groups = { 'Scenes': [], 'Scenes in space': [], 'Cases from engines’ users': [] };
    for (const [path, bytes] of files) {
      const text = new TextDecoder().decode(bytes), isCase = path.includes('cases/');
      const name = isCase ? path.split('/').at(-2) : path.split('/').at(-1).replace('.json', '');
      starts.set(name, text);
      const group = isCase ? 'Cases from engines’ users' : /"model":\s*"space/.test(text) ? 'Scenes in space' : 'Scenes';
      groups[group].push(make('option', { value: name, textContent: (isCase ? `${+name.slice(0, 2)}. ` : '') + titleOf(text) }));
    }
    return Object.entries(groups).map(([label, options]) => {
      const group = make('optgroup', { label });
      group.append(...options);
      return group;
    });
  }

  // ---- The scene: `text` is the file that it began with; to build is to change the file.

  const flat = new Picture(canvas), deep = new SpacePicture(canvas);
  let picture = flat;
  let text = '', file, scene, moment, names = [], h = 1 / 60, running = false, slowed = false, part = 0, shown, stoppedBy = '';
  let undone = [], done = [], selected = -1, consulted = 0, judged, findings = [], pressed, cursor, hot = -1, tool = 'hand', pendingLink, cost = 0, consulting;

  const energyLine = new RunningLine(of('energy'), of('energy-value'), value => `${number(value, 4)} J`, false);
  const gapLine = new RunningLine(of('gap'), of('gap-value'), value => lengthWords(value), true);
  const lengthWords = metres => metres < 1e-9 ? '0' : metres < 0.9995e-3 ? `${number(1e6 * metres)} µm` : metres < 0.9995 ? `${number(1e3 * metres)} mm` : `${number(metres)} m`;

  function advance(steps) {
    const at = ask.program.advance(steps), numbers = new Float64Array(ask.program.memory.buffer, at, ask.program.moment_size());
    moment = momentOf(numbers.slice(), picture === deep ? 12 : 4);
    if (steps && ask.program.has_stopped() && !stoppedBy) {
      stoppedBy = ask({ ask: 'stopped' }).stopped;
      pause();
      tell(`The scene stopped: ${stoppedBy}`);
    }
    energyLine.add(moment.time, moment.energy);
    gapLine.add(moment.time, moment.gap);
  }

  // Opens a file's text. Says why not, and returns false, where it is no scene.
  function open(given, { fit = false, words: because } = {}) {
    const answer = ask({ ask: 'open', text: given });
    if (answer.look?.in_space && !deep.works) {
      answer.failure = 'This browser has no WebGL, which draws scenes in space.';
      ask({ ask: 'open', text });
    }
    if (answer.failure) {
      tell(answer.failure);
      return false;
    }
    const before = picture;
    picture = answer.look.in_space ? deep : flat;
    picture.resize();
    text = answer.file;
    file = JSON.parse(text);
    file.constraints ??= [];
    names = answer.names;
    h = answer.step;
    scene = { look: answer.look, fixed: file.bodies.map(body => !!body.fixed),
      motors: file.constraints.filter(one => one.kind === 'motor' && one.on === 'turn').map(one => ({ body: one.bodies[1], speed: one.speed })) };
    stoppedBy = '';
    part = 0;
    pressed = undefined;
    if (selected >= file.bodies.length) selected = -1;
    energyLine.clear();
    gapLine.clear();
    advance(0);
    if (fit || picture !== before) picture.fit(scene, moment);
    of('title').textContent = file.title || 'Your scene';
    const refused = name => inSpace(file) ? name !== 'hand' : particles(file) && ['box', 'wall', 'motor'].includes(name);
    for (const button of document.querySelectorAll('#tools [data-tool]')) button.disabled = refused(button.dataset.tool);
    if (refused(tool) || picture !== before) choose('hand');
    root.toggleAttribute('data-space', inSpace(file));
    if (because) tell(because);
    showMethod();
    showSelected();
    consult();
    relink();
    redraw();
    return true;
  }

  // Changes the file of this moment by `edit`, which says what it did.
  function edit(edit) {
    const now = ask({ ask: 'now' });
    if (now.failure) return tell(now.failure);
    const changed = JSON.parse(now.file);
    changed.constraints ??= [];
    const did = edit(changed);
    if (!did) return;
    const before = text;
    if (!open(JSON.stringify(changed), { words: did[0].toUpperCase() + did.slice(1) + '.' })) return;
    turning = false;
    done.push(before);
    undone = [];
    showUndo();
  }
  function undo(from, to) {
    if (!from.length) return;
    const then = from.pop(), words = from === done ? 'Undone.' : 'Done again.';
    to.push(text);
    // A method that was turned is turned back, and the scene goes on.
    if (apartFromMethod(then) === apartFromMethod(text)) useMethod(JSON.parse(then), words);
    else open(then, { words });
    showUndo();
  }
  const apartFromMethod = given => JSON.stringify({ ...JSON.parse(given), method: 0, step: 0, duration: 0 });
  function showUndo() {
    of('undo').disabled = !done.length;
    of('redo').disabled = !undone.length;
  }
  function begin(name) {
    done = [];
    undone = [];
    selected = -1;
    const opened = open(starts.get(name), { fit: true });
    if (opened) startTexts.set(name, text);
    showUndo();
    if (opened) of('starts').value = name;
    else if (text) linkNow();
    return opened;
  }

  function tell(sentence) { said.textContent = sentence; }

  // ---- The clock.

  let before = 0, owed = 0, frames = 0, framesSince = 0, share = 1;
  function frame(now) {
    const passed = Math.min((now - before) / 1000, 0.25);
    before = now;
    if (running && slowed) {
      part += passed / (slower * h) * parts;
      if (part >= parts) { part = 0; advance(1); }
      showPart();
    } else if (running) {
      owed += passed;
      // Time is kept by more steps a frame; where the steps themselves take longer than they last, that is said.
      const due = Math.floor(owed / h + 1e-6), steps = Math.min(due, Math.max(1, Math.floor(100 / Math.max(cost, 1e-3))));
      const began = performance.now();
      if (steps) {
        advance(steps);
        cost += 0.1 * ((performance.now() - began) / steps - cost);
      }
      share += 0.05 * ((due ? steps / due : 1) - share);
      owed = due > steps ? 0 : owed - steps * h;
    }
    if (running || dirty) paint();
    ++frames;
    if (now - framesSince > 500) {
      if (running) tellSpeed(1000 * frames / (now - framesSince));
      frames = 0;
      framesSince = now;
      for (const line of [energyLine, gapLine]) line.draw(picture.colours);
    }
    requestAnimationFrame(frame);
  }
  let dirty = true;
  const redraw = () => { dirty = true; };

  function tellSpeed(perSecond) {
    of('speed').textContent = slowed ? '' : `${Math.round(perSecond)} frames a second; a step of h = ${number(1000 * h)} ms is computed in ${number(cost, 2)} ms` +
      (share < 0.95 ? `. That is too slow for this machine: time runs at ${Math.round(100 * share)} % of its speed.` : perSecond < 50 ? '. Time is kept by more steps a frame.' : '.');
    of('speed').classList.toggle('slow', !slowed && (share < 0.95 || perSecond < 50));
    root.dataset.cost = cost.toFixed(3);
    root.dataset.frames = perSecond.toFixed(1);
  }

  function paint() {
    dirty = false;
    const { marks, labels } = marksOf();
    let seen = moment;
    if (shown?.moved.length || pressed?.group) seen = { ...moment, numbers: moment.numbers.slice() };
    for (const { body, numbers } of shown?.moved ?? []) if (body < moment.count) seen.numbers.set(numbers, 3 + moment.each * body);
    for (const body of pressed?.group ?? []) pressed.to.forEach((x, axis) => { seen.numbers[3 + moment.each * body + axis] += x - pressed.from[axis]; });
    picture.draw({ scene, moment: seen, marks, labels, selected, hot, hand: pressed?.hand, draft: draftOf(), cursor });
    of('time').textContent = `${moment.time.toFixed(2)} s`;
  }

  function play() {
    if (stoppedBy) return tell(`The scene stopped: ${stoppedBy}`);
    running = true;
    owed = 0;
    tell('');
    showClock();
  }
  function pause() {
    running = false;
    showClock();
    if (moment.time !== judged?.time) consult();
  }
  function showClock() {
    const button = of('play');
    button.textContent = running ? '❚❚' : '▶';
    button.setAttribute('aria-label', running ? 'Pause' : 'Play');
    of('once').textContent = slowed ? 'Next part' : 'One step';
    of('slow').setAttribute('aria-pressed', slowed);
    overlay.hidden = words.hidden = !slowed;
    if (!slowed) shown = undefined, overlay.replaceChildren();
    if (!running) tell(stoppedBy ? `The scene stopped: ${stoppedBy}` : `At ${moment.time.toFixed(2)} s: energy ${number(moment.energy, 4)} J, largest gap ${lengthWords(moment.gap)}.`);
    redraw();
  }
  function once() {
    pause();
    if (!slowed) advance(1);
    else if (Math.round(part) >= parts) advance(1), part = 1 - endOfPart;
    else part = Math.round(part) + 1 - endOfPart;
    if (slowed) showPart();
    else showClock();
    redraw();
  }
  function slow() {
    slowed = !slowed;
    part = running ? 0 : 1 - endOfPart;
    showClock();
    if (slowed) showPart();
  }
  // J, JV, λ and the velocities within the next step, drawn as in the lessons.
  function showPart() {
    const { width, height, camera, seen, inSeen } = picture, points = 720 / height;
    const answer = ask({ ask: 'part', part: Math.min(part, parts - endOfPart), width: Math.round(width * points), camera: [...inSeen, camera.scale * points], seen,
      longest: 0.2 * Math.min(width, height) / camera.scale });
    if (answer.failure) return tell(answer.failure);
    shown = answer;
    overlay.innerHTML = answer.svg;
    words.replaceChildren(make('strong', { textContent: answer.formula }), ' ', answer.words);
    redraw();
  }

  // ---- The doctor.

  // It judges what will become of the scene as it is now.
  function consult() {
    clearTimeout(consulting);
    of('diagnosis').setAttribute('aria-busy', 'true');
    judged = { time: moment.time, text: ask({ ask: 'now' }).file ?? text };
    consulting = setTimeout(async () => (await doctor).postMessage({ id: ++consulted, text: judged.text }), 400);
  }
  function showFindings({ findings: all = [], failure }) {
    const list = of('diagnosis');
    list.setAttribute('aria-busy', 'false');
    findings = all.filter(finding => finding.grade !== 'fine');
    const fails = findings.filter(finding => finding.grade === 'fails').length;
    of('judged').textContent = judged.time > 0 ? `of the scene as it is at ${judged.time.toFixed(2)} s` : 'of the scene as it begins';
    of('verdict').textContent = failure ? `The doctor cannot say: ${failure}` : fails ? `will fail by law ${findings[0].law}` : findings.length ? 'will hold, near a limit' : 'will hold: nothing is near a limit';
    of('verdict').className = fails ? 'fails' : findings.length ? 'near' : 'fine';
    list.replaceChildren(...findings.map((finding, i) => {
      const item = make('li', { className: finding.grade }, make('strong', { textContent: `${i + 1}. Law ${finding.law}` }), ` ${signed(`${finding.quantity} = ${number(finding.number)}`)}, limit ${number(finding.limit)}. ${finding.sentence}`);
      item.append(...finding.knobs.slice(0, 3).map(knob => {
        const button = make('button', { type: 'button', textContent: `Set ${knob.words}` });
        button.onclick = () => {
          const turned = ask({ ask: 'turn', text, name: knob.name, value: knob.value });
          if (turned.failure) return tell(turned.failure);
          setMethod(JSON.parse(turned.file));
          turning = false;
        };
        return button;
      }));
      return item;
    }));
    redraw();
  }
  // Findings stand on the bodies that they name, the worst on top.
  function marksOf() {
    const marks = new Map(), labels = [];
    findings.toReversed().forEach((finding, k) => {
      const place = findings.length - k, colour = finding.grade === 'fails' ? picture.colours.error : picture.colours.force;
      for (const body of finding.bodies) if (body < moment.count && finding.grade === 'fails' && !scene.fixed[body]) marks.set(body, mixed(colour, picture.colours.body));
      const named = finding.bodies.find(body => body < moment.count && scene.look.bodies[body].as !== 'half_space');
      if (named !== undefined) labels.push([named, String(place), colour]);
    });
    return { marks, labels };
  }
  const mixed = (a, b) => `color-mix(in oklab, ${a} 55%, ${b})`;

  // ---- The method's knobs, which the scene goes on with at once.

  const knobs = { sweeps: 10, beta: 0.2, slop: 0.001, frequency: 90, substeps: 1, step: 60 };  // where the file has none
  const swept = new Set(['gauss_seidel', 'jacobi', 'conjugate_sweeps']), biased = new Set(['baumgarte', 'split_impulse']);
  function showMethod() {
    const method = file.method ?? {};
    of('solver').value = method.solver ?? 'by_graph';
    of('cure').value = method.cure ?? 'baumgarte';
    for (const name of ['sweeps', 'beta', 'slop', 'frequency', 'substeps']) setKnob(name, method[name] ?? (name === 'sweeps' && method.solver === 'conjugate_sweeps' ? 50 : knobs[name]));
    setKnob('step', Math.round(1 / file.step));
    of('warm').checked = method.warm_start ?? true;
    of('sweeps').closest('.knob').hidden = !swept.has(of('solver').value);
    of('warm').closest('.knob').hidden = !['gauss_seidel', 'jacobi'].includes(of('solver').value);
    of('beta').closest('.knob').hidden = !biased.has(of('cure').value);
    of('slop').closest('.knob').hidden = of('cure').value === 'none';
    of('frequency').closest('.knob').hidden = of('cure').value !== 'soft';
  }
  function setKnob(name, value) {
    const input = of(name);
    if (document.activeElement !== input || +input.value !== value) input.value = value;
    of(name + '-value').textContent = name === 'step' ? `1/${value} s` : name === 'slop' ? lengthWords(value) : name === 'frequency' ? `${number(value)} /s` : number(value);
  }
  // What the reader has turned; all else stays as the file has it, beyond the ends of a slider too.
  function readMethod({ target: { id, value, checked } }) {
    const method = { solver: 'by_graph', cure: 'baumgarte', ...file.method };
    const without = names => { for (const name of names) delete method[name]; };
    if (id === 'solver') without(['sweeps', 'warm_start', 'order', 'block', 'relaxation', 'tolerance', 'rounds', 'regularisation', 'unlike']);
    if (id === 'cure') without(['beta', 'slop', 'frequency', 'damping_ratio', 'relax', 'refresh', 'projection_sweeps']);
    if (id === 'warm') method.warm_start = checked;
    else if (id !== 'step') method[id] = id in knobs ? +value : value;
    setMethod({ ...file, method, step: id === 'step' ? 1 / value : file.step });
  }
  // The changes of one slider until it is let go are one to undo.
  let turning = false;
  function setMethod(given) {
    const before = text;
    if (!useMethod(given) || turning) return;
    turning = true;
    done.push(before);
    undone = [];
    showUndo();
  }
  // The scene goes on; its file begins as before, by the new method.
  function useMethod({ method, step, duration }, because = `Goes on by ${(method?.solver ?? 'by_graph').replaceAll('_', ' ')}.`) {
    const changed = { ...JSON.parse(text), method, step, duration }, as = JSON.stringify(changed);
    const answer = ask({ ask: 'use', text: as });
    if (answer.failure) {
      tell(answer.failure);
      showMethod();
      return false;
    }
    text = JSON.stringify(changed, null, 1);
    file = { ...changed, constraints: changed.constraints ?? [] };
    h = step;
    showMethod();
    consult();
    relink();
    tell(because);
    if (slowed) showPart();
    return true;
  }
  for (const name of [...Object.keys(knobs), 'solver', 'cure', 'warm']) {
    of(name).addEventListener('input', readMethod);
    of(name).addEventListener('change', () => { turning = false; });
  }

  // ---- What is selected.

  function select(body) {
    selected = body;
    showSelected();
    redraw();
  }
  function showSelected() {
    const panel = of('selected'), body = file.bodies[selected];
    panel.hidden = !body;
    if (!body) return;
    const { as } = scene.look.bodies[selected], kind = { box: 'Box', disc: 'Ball', bob: 'Bob', link: 'Link' }[as] ?? 'Body';
    of('selected-name').textContent = `${kind}: ${names[selected].replaceAll('"', '')}`;
    of('fixed').checked = !!body.fixed;
    of('mass').disabled = !!body.fixed;
    of('mass').value = body.fixed ? '' : +massIn(body).toPrecision(4);
    for (const name of ['friction', 'restitution']) {
      of(name).closest('.knob').hidden = !body.shape;
      of(name).value = body[name] ?? { friction: 0.6, restitution: 0 }[name];
    }
    of('turn').hidden = particles(file) || inSpace(file);
    of('fixed').closest('.knob').hidden = inSpace(file);
  }
  const changeSelected = (what, value) => edit(now => edits.change(now, selected, what, value));
  for (const name of ['mass', 'friction', 'restitution']) of(name).addEventListener('change', event => {
    const { value, min } = event.target;
    value !== '' && +value >= +min ? changeSelected(name, +value) : tell(`${name} must be at least ${min}`);
    showSelected();
  });
  of('fixed').addEventListener('change', event => changeSelected('fixed', event.target.checked));
  of('turn').onclick = () => edit(now => edits.turn(now, selected, Math.PI / 12));
  of('remove').onclick = () => {
    const body = selected;
    select(-1);
    edit(now => edits.erase(now, [0, 0], [0, 0], [{ body, constraint: -1 }]));
  };

  // ---- Tools and hands. A pointer and the cursor of the keys press, move and lift alike.

  function choose(name) {
    tool = name;
    cancel();
    for (const button of document.querySelectorAll('#tools [data-tool]')) button.setAttribute('aria-pressed', button.dataset.tool === name);
    of('how').textContent = picture === deep ? 'Drag a body. Drag beside it to turn the view. In space nothing new is put down here: write it into the file.' : document.querySelector(`[data-tool="${name}"]`).dataset.how;
    stage.dataset.tool = name;
  }
  for (const button of document.querySelectorAll('#tools [data-tool]')) button.onclick = () => choose(button.dataset.tool);

  function endAt(point, but = -1) {
    const body = picture.bodyAt(scene, moment, point, { any: true, but });
    return { body, arm: body >= 0 ? toBody(placeOf(moment, body), point) : undefined, constraint: constraintAt(point) };
  }
  // The tie at a point, by its place in the file.
  function constraintAt(point) {
    const near = 7 / picture.camera.scale, places = file.constraints.flatMap((one, i) => visible.has(one.kind) ? [i] : []);
    const k = scene.look.ties.findIndex(({ as, bodies, arms }) => {
      if (as === 'surface') return false;
      const ends = bodies.map((body, e) => toWorld(placeOf(moment, body), arms[e]));
      return as === 'joint' ? distance(point, ends[1]) < near : toSegment(point, ...ends) < near;
    });
    return k < 0 ? -1 : places[k];
  }

  function press(point) {
    const body = picture.bodyAt(scene, moment, point);
    pressed = { from: point, to: point, body, place: body >= 0 ? placeOf(moment, body) : undefined };
    if (tool !== 'hand') return redraw();
    select(body);
    if (body >= 0 && !running) pressed.group = groupOf(file, body);
    if (body >= 0 && !scene.fixed[body] && running) {
      const at = pressed.taken = picture.surfaceAt(scene, moment, body, point);
      ask({ ask: 'grab', body, at, seen: picture.seen });
      pressed.hand = { body, arm: scene.look.bodies[body].as === 'bob' ? [0, 0, 0] : toBody(placeOf(moment, body), at), at };
    }
    redraw();
  }
  function move(point) {
    if (!pressed) return;
    pressed.to = point;
    if (pressed.hand) {
      const at = pressed.hand.at = pressed.taken.map((x, k) => x + point[k] - pressed.from[k]);  // as deep as it was taken
      ask({ ask: 'move', at });
    }
    redraw();
  }
  function lift() {
    if (!pressed) return;
    const { from, to, body, hand } = pressed;
    pressed = undefined;
    redraw();
    if (hand) return void ask({ ask: 'release' });
    if (tool === 'hand') {
      if (body >= 0 && distance(from, to) > 3 / picture.camera.scale) edit(now => edits.move(now, body, to.map((x, k) => x - from[k])));
      return;
    }
    const first = endAt(from), ends = [first, endAt(to), first.body >= 0 ? picture.bodyAt(scene, moment, from, { any: true, but: first.body }) : -1];
    const count = file.bodies.length;
    edit(now => edits[tool](now, from, to, ends) ?? void tell(({ pin: 'A pin needs a body below it.', motor: 'A motor needs a body that moves.', erase: 'There is nothing here.' })[tool] ?? 'Begin on one body and end on another, or on the world.'));
    if (['box', 'ball', 'wall'].includes(tool) && file.bodies.length > count) select(file.bodies.length - 1);
    if (file.bodies.length < count) select(-1);
  }
  function cancel() {
    if (pressed?.hand) ask({ ask: 'release' });
    pressed = undefined;
    redraw();
  }
  function draftOf() {
    if (!pressed || pressed.hand) return undefined;
    const { from, to } = pressed, far = distance(from, to) > 3 / picture.camera.scale;
    if (['hand', 'pin', 'motor', 'erase'].includes(tool)) return undefined;
    if (tool === 'box') return { corners: [from, [to[0], from[1]], to, [from[0], to[1]]], from, to };
    if (tool === 'ball') return { from, to, radius: far ? distance(from, to) : 0.4 };
    return { tool, from, to };
  }

  const pointers = new Map();
  const pointOf = event => {
    const { left, top } = canvas.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  let panning;
  stage.addEventListener('pointerdown', event => {
    if (event.button > 1) return;
    cursor = undefined;
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, pointOf(event));
    if (pointers.size === 2) {
      cancel();
      panning = undefined;
      return;
    }
    const point = picture.point(pointOf(event));
    if (event.button === 1 || (tool === 'hand' && picture.bodyAt(scene, moment, point) < 0)) {
      panning = { at: pointOf(event), turns: picture === deep && event.button === 0 && !event.shiftKey };
      select(-1);
    } else {
      press(point);
    }
  });
  stage.addEventListener('pointermove', event => {
    const at = pointOf(event), last = pointers.get(event.pointerId);
    if (!last) {
      const now = picture.bodyAt(scene, moment, picture.point(at));
      if (now !== hot) hot = now, redraw();
      return;
    }
    if (pointers.size === 2) {
      const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
      picture.zoom(distance(at, other) / Math.max(1, distance(last, other)), other);
      redraw();
    } else if (panning) {
      const by = [at[0] - panning.at[0], at[1] - panning.at[1]];
      panning.turns ? picture.orbit(...by) : picture.pan(...by);
      panning.at = at;
      redraw();
    } else {
      move(picture.point(at));
    }
    pointers.set(event.pointerId, at);
    if (slowed && !running) showPart();
  });
  for (const end of ['pointerup', 'pointercancel'])
    stage.addEventListener(end, event => {
      if (!pointers.delete(event.pointerId)) return;
      panning = undefined;
      end === 'pointerup' ? lift() : cancel();
    });
  stage.addEventListener('pointerleave', () => { hot = -1; redraw(); });
  stage.addEventListener('wheel', event => {
    event.preventDefault();
    picture.zoom(Math.exp(-event.deltaY / 500), pointOf(event));
    redraw();
  }, { passive: false });

  stage.addEventListener('keydown', event => {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = picture === deep && { a: [-20, 0], d: [20, 0], w: [0, 20], s: [0, -20] }[event.key];
    const middle = [picture.width / 2, picture.height / 2];
    if (turn) {
      picture.orbit(...turn);
      if (slowed) showPart();
    } else if (way) {
      const [x, y] = cursor ? picture.pixel(cursor) : middle, by = event.shiftKey ? 4 : 20;
      cursor = picture.point([x + by * way[0], y - by * way[1]]);
      hot = picture.bodyAt(scene, moment, cursor);
      pressed ? move(cursor) : tell(hot >= 0 ? names[hot] : 'nothing here');
    } else if (event.key === 'Enter') {
      cursor ??= picture.point(middle);
      pressed ? lift() : press(cursor);
      if (pressed && ['pin', 'motor', 'erase'].includes(tool)) lift();
      else if (pressed) tell(pressed.hand ? 'Held. The arrow keys pull it; Enter lets it go.' : 'Begun. Move with the arrow keys; Enter ends it, Escape leaves it.');
    } else if (event.key === 'Escape') {
      cancel();
    } else if (event.key === 'Delete' || event.key === 'Backspace') {
      if (selected >= 0) of('remove').click();
    } else if (event.key === ' ') {
      running ? pause() : play();
    } else if (event.key === '.') {
      once();
    } else if (event.key === '+' || event.key === '-') {
      picture.zoom(event.key === '+' ? 1.25 : 0.8, cursor && picture.pixel(cursor));
    } else {
      return;
    }
    event.preventDefault();
    redraw();
  });
  document.addEventListener('keydown', event => {
    if (!(event.ctrlKey || event.metaKey) || /^(INPUT|TEXTAREA)$/.test(event.target.tagName) && event.target.type !== 'range') return;
    if (event.key.toLowerCase() === 'z') event.shiftKey ? undo(undone, done) : undo(done, undone);
    else if (event.key.toLowerCase() === 'y') undo(undone, done);
    else return;
    event.preventDefault();
  });

  // ---- Buttons.

  of('play').onclick = () => running ? pause() : play();
  of('once').onclick = once;
  of('slow').onclick = slow;
  of('again').onclick = () => open(text, { words: 'From the beginning.' });
  of('undo').onclick = () => undo(done, undone);
  of('redo').onclick = () => undo(undone, done);
  of('keep').onclick = () => edit(() => 'this moment is the beginning now');
  of('closer').onclick = () => { picture.zoom(1.25); redraw(); };
  of('farther').onclick = () => { picture.zoom(0.8); redraw(); };
  of('all').onclick = () => { picture.fit(scene, moment); redraw(); };
  of('empty').onclick = () => {
    done.push(text);
    open('{"title": "Your scene", "model": "plane", "bodies": [{"name": "ground", "fixed": true, "shape": {"half_space": [0, 1]}}]}', { fit: true, words: 'An empty scene with a ground.' });
    showUndo();
  };
  of('starts').onchange = event => begin(event.target.value);

  const download = (name, blob) => {
    const link = make('a', { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  };
  const fileName = () => (file.title || 'scene').toLowerCase().replace(/[^a-z0-9]+/g, '_').replace(/^_|_$/g, '').slice(0, 40) || 'scene';
  of('save').onclick = () => {
    download(`${fileName()}.json`, new Blob([text], { type: 'application/json' }));
    tell(`Saved as ${fileName()}.json: ./lessons/run scene ${fileName()}.json runs it at a terminal.`);
  };
  of('load').onclick = () => of('chosen').click();
  const openFile = async chosen => {
    const given = await chosen.text(), earlier = text;
    if (!open(given, { fit: true, words: `Opened ${chosen.name}.` })) return;
    done.push(earlier);
    showUndo();
  };
  of('chosen').onchange = async event => {
    if (event.target.files[0]) await openFile(event.target.files[0]);
    event.target.value = '';
  };
  stage.addEventListener('dragover', event => event.preventDefault());
  stage.addEventListener('drop', event => {
    event.preventDefault();
    if (event.dataTransfer.files[0]) openFile(event.dataTransfer.files[0]);
  });
  // The arrows of a part of a step lie above the canvas, as SVG.
  async function arrows() {
    const drawn = new Image(), svg = new DOMParser().parseFromString(shown.svg, 'image/svg+xml').documentElement;
    svg.setAttribute('width', canvas.width);
    svg.setAttribute('height', canvas.height);
    drawn.src = 'data:image/svg+xml,' + encodeURIComponent(new XMLSerializer().serializeToString(svg));
    await drawn.decode();
    return drawn;
  }
  of('shoot').onclick = async () => {
    const { canvas: { width, height }, ratio, colours } = picture, strip = Math.round(40 * ratio);
    paint();
    const sheet = make('canvas', { width, height: height + strip }), context = sheet.getContext('2d');
    Object.assign(context, { fillStyle: colours.paper });
    context.fillRect(0, 0, width, height + strip);
    context.drawImage(canvas, 0, 0);
    if (slowed && shown) context.drawImage(await arrows(), 0, 0, width, height);
    Object.assign(context, { fillStyle: colours.ink, font: `${Math.round(16 * ratio)}px "Course Sans", system-ui, sans-serif`, textBaseline: 'middle' });
    context.fillText(`${file.title || 'A scene'}, after ${moment.time.toFixed(2)} s. Constraints by Hand`, 14 * ratio, height + strip / 2);
    sheet.toBlob(blob => download(`${fileName()}.png`, blob), 'image/png');
    tell(`The picture is ${fileName()}.png.`);
  };

  // ---- The scene in the link.

  const through = async (bytes, stream) => new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
  const toLink = async () => {
    const short = JSON.stringify(JSON.parse(text)), bytes = await through(new TextEncoder().encode(short), new CompressionStream('deflate-raw'));
    return 'scene=' + btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join('')).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
  };
  const fromLink = async packed => new TextDecoder().decode(await through(Uint8Array.from(atob(packed.replaceAll('-', '+').replaceAll('_', '/')), letter => letter.charCodeAt(0)), new DecompressionStream('deflate-raw')));
  async function linkNow() {
    const name = [...startTexts].find(([, given]) => given === text)?.[0], hash = '#' + (name ?? await toLink());
    of('starts').value = name ?? '';
    if (location.hash !== hash) history.replaceState(null, '', hash);
    return location.href;
  }
  function relink() {
    clearTimeout(pendingLink);
    pendingLink = setTimeout(linkNow, 300);
  }
  of('link').onclick = async () => {
    const address = await linkNow(), field = of('address');
    field.hidden = false;
    field.value = address;
    field.select();
    try {
      await navigator.clipboard.writeText(address);
      tell('The link is copied. It holds the whole scene.');
    } catch {
      tell('The link is in the field: copy it. It holds the whole scene.');
    }
  };
  // Opens what the address names. Where that cannot be, opens a stack and returns what to say of it.
  async function follow() {
    const hash = decodeURIComponent(location.hash.slice(1));
    try {
      done = [];
      if (hash.startsWith('scene=') ? open(await fromLink(hash.slice(6)), { fit: true }) : begin(starts.has(hash) ? hash : 'stack')) return;
    } catch { tell('The link holds no whole scene.'); }
    const refused = said.textContent;
    begin('stack');
    return `${refused} Here is a stack instead.`;
  }
  addEventListener('hashchange', async () => {
    const refused = await follow();
    if (refused) tell(refused);
  });

  // ---- The page.

  new ResizeObserver(() => {
    const first = !moment;
    picture.resize();
    if (!first && picture.fitted) picture.fit(scene, moment);
    if (!first) redraw(), slowed && showPart();
  }).observe(canvas);
  dark.addEventListener('change', () => { flat.dress(), deep.dress(); redraw(); });
  picture.resize();
  flat.dress();
  deep.dress();
  choose('hand');
  const refused = await follow();
  if (!still.matches) play();
  else showClock();
  if (refused) tell(refused);
  root.dataset.ready = '';
  // For tests: what is on the stage.
  globalThis.byhandPlayground = { get moment() { return moment; }, get file() { return JSON.parse(text); }, get text() { return text; }, pixel: point => picture.pixel(point), get selected() { return selected; }, open, advance, pause, play };
  requestAnimationFrame(now => { before = framesSince = now; frame(now); });
})();
