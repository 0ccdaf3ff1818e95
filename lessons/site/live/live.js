'use strict';
// A lesson's page comes to life: its parameters become sliders, and what depends on one that changed is told again by
// the lesson's own C++ in two workers, one for steps that answer at once and one for the others.

(() => {
  const { readAddress, address, sliderValues, placeOf, symbol } = globalThis.byhandSettings ?? {};
  const parts = globalThis.byhandParts ?? {};  // the lesson, its files and the worker, packed (see pack in build)
  const quick = 100, patience = 2500, rest = 350;  // ms: of a step; of a reader before a step needs a button; between changes
  const reduced = matchMedia('(prefers-reduced-motion: reduce)');

  const make = (tag, properties = {}, ...children) => {
    const { data = {}, attributes = {}, ...own } = properties;
    const element = Object.assign(document.createElement(tag), own);
    Object.assign(element.dataset, data);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  };
  const pause = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds));
  const nextFrame = () => new Promise(requestAnimationFrame);

  // ---- The lesson's program in a worker.

  class Stopped extends Error {}

  class Lesson {
    #worker; #waiting = new Map(); #next = 0; #source;

    start() {
      this.#source ??= unpacked(parts.worker).then(bytes => URL.createObjectURL(new Blob([bytes], { type: 'text/javascript' })));
      this.started = this.#source.then(source => {
        const worker = this.#worker = new Worker(source);
        worker.onmessage = ({ data }) => this.#hear(data);
        worker.onerror = event => this.#hear({ id: 0, failure: event.message });
        return this.#post({ start: { lesson: parts.lesson, files: parts.files } });
      });
      return this.started;
    }

    #post(message, progress) {
      return new Promise((resolve, reject) => {
        const id = this.#next++;
        this.#waiting.set(id, { resolve, reject, progress });
        this.#worker.postMessage({ id, ...message });
      });
    }

    memory = 0;  // bytes that the program uses

    #hear({ id, answer, failure, done, total, memory }) {
      this.memory = memory ?? this.memory;
      const waiting = this.#waiting.get(id);
      if (!waiting) return;
      if (total !== undefined) return waiting.progress?.(done, total);
      this.#waiting.delete(id);
      failure === undefined ? waiting.resolve(answer) : waiting.reject(new Error(failure));
    }

    // `milliseconds`: how long it may take; without it, as long as it takes.
    async ask(request, { milliseconds, progress } = {}) {
      await (this.started ?? this.start());
      const answer = this.#post({ request }, progress);
      const timer = milliseconds && setTimeout(() => this.stop(), milliseconds);
      return answer.finally(() => clearTimeout(timer));
    }

    stop() {
      this.#worker?.terminate();
      this.started = undefined;
      for (const { reject } of this.#waiting.values()) reject(new Stopped('stopped'));
      this.#waiting.clear();
    }
  }

  const atOnce = new Lesson(), takingTime = new Lesson(), inHand = new Lesson();  // the last starts where a scene is held

  async function unpacked(packed) {
    const bytes = Uint8Array.from(atob(packed), letter => letter.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
  }

  // ---- Settings: what the reader changed, as it was typed, and those with which to compare. The address carries them:
  // #beta=1.9&h=1/120&versus=beta:0.2 or versus=defaults

  const settings = new Map();
  let versus;  // as `settings`, or undefined
  let parameters = new Map();

  const dropped = [];  // sentences about settings of the address that the lesson does not take

  // Takes the settings of the address that the lesson accepts; one that it refuses does not hold up the others. An
  // address that names no setting, as a link within the page, is a place alone: the settings stay as they are.
  async function takeAddress() {
    const said = readAddress(location.hash);
    if (said.onlyPlace) return writeAddress();
    const accepted = async pairs => {
      const all = new Map();
      for (const [name, value] of pairs) {
        const answer = parameters.has(name) ? await atOnce.ask({ ask: 'check', settings: { [name]: value ?? '' } })
          : { refused: `This lesson has no parameter ${name}.` };
        if (answer.refused) dropped.push(answer.refused);
        else all.set(name, answer.typed[name]);
      }
      return all;
    };
    dropped.length = 0;
    const taken = await accepted(said.settings), beside = said.versus && await accepted(said.versus);
    settings.clear();
    for (const [name, value] of taken) if (value !== parameters.get(name).typed) settings.set(name, value);
    versus = beside?.size || said.versus?.length === 0 ? beside : undefined;
    writeAddress();
  }

  // Browsers limit how often the address may be written; where one refuses, it is only older than the page.
  function writeAddress() {
    clearTimeout(writing);
    writing = undefined;
    const { place } = readAddress(location.hash), hash = address({ place, settings, versus });
    try {
      if (hash !== location.hash) history.replaceState(null, '', hash || location.pathname + location.search);
    } catch {}
  }
  let writing;
  function writeAddressLater() {
    clearTimeout(writing);
    writing = setTimeout(writeAddress, 300);
  }

  const asObject = map => Object.fromEntries(map);

  // Names of the parameters in which the two settings differ, and how one of them is called beside the other.
  const valueIn = (map, name) => map.get(name) ?? parameters.get(name).typed;
  const differing = () => versus ? [...parameters.keys()].filter(name => valueIn(settings, name) !== valueIn(versus, name)) : [];
  const called = (map, names) => names.map(name => `${name} = ${valueIn(map, name)}`).join(', ');

  // ---- One step of the page.

  // A task of the derivation desk opens its page, a case its own; both stand beside every live lesson.
  const pages = [
    { kind: 'desk', command: /^\.\/lessons\/run desk --task (\d+)$/, page: number => `desk.html#task-${number}` },
    { kind: 'case', command: /^\.\/lessons\/run case (\d+)$/, page: number => `case_${number.padStart(2, '0')}.html` },
  ];
  function linkPages(node) {
    for (const code of node.querySelectorAll('code'))
      for (const { kind, command, page } of pages) {
        const called = command.exec(code.textContent);
        if (!called || code.closest('a')) continue;
        const link = make('a', { className: kind, href: page(called[1]) });
        code.replaceWith(link);
        link.append(code);
      }
  }

  // What must differ for a child to count as changed: not its picture, nor what this script added.
  function bare(node) {
    const copy = node.cloneNode(true);
    copy.querySelectorAll('.picture, .files, .reply').forEach(part => part.replaceChildren());
    copy.querySelectorAll('.controls, .versus').forEach(part => part.remove());
    copy.querySelectorAll('a.desk, a.case').forEach(link => link.replaceWith(...link.childNodes));
    copy.querySelectorAll('details').forEach(part => part.removeAttribute('open'));
    copy.querySelectorAll('[tabindex]').forEach(part => part.removeAttribute('tabindex'));
    copy.querySelectorAll('.picture').forEach(({ dataset }) => { delete dataset.placed; delete dataset.more; delete dataset.sideways; });
    if (copy.matches('details')) copy.removeAttribute('open');
    copy.classList.remove('fresh', 'compared');
    if (!copy.classList.length) copy.removeAttribute('class');
    return copy;
  }

  class Step {
    constructor(section, reads) {
      this.section = section;
      this.label = section.dataset.step;
      this.read = new Set(reads[this.label]);
      this.stale = false;
      this.written = section.cloneNode(true);  // at the defaults
      this.controls = [];
      this.state = make('p', { className: 'state', attributes: { role: 'status' } });
      this.inSpace = !!section.querySelector('.picture :is(foreignObject, image)');
      this.sceneAlone = section.dataset.only !== undefined;  // as on the cover: nothing of it is told again
      const heading = section.querySelector('h2');
      heading ? heading.after(this.state) : section.prepend(this.state);
      section.querySelectorAll('.controls').forEach((place, i) => {
        const knobs = this.controlsOf(place.dataset.knobs.split(' ').filter(Boolean), `-${i + 1}`);
        place.append(make('div', { className: 'knobs' }, ...knobs.map(({ element }) => element)));
      });
      this.others = make('div', { className: 'settings' });
      this.folded = make('details', {}, make('summary'), this.others);
      this.shown = new Map();  // by data-item: the child as it was last shown, bare, and its picture
      this.films = new Map();
      const held = section.querySelector('figure[data-hold]');
      if (held) this.hold = new byhandHold(held, { make, lesson: inHand, request: () => this.request(), reduced, fail: error => bar.fail(error), plays: this.sceneAlone });
      this.section.querySelectorAll('figure[data-film]').forEach(figure => this.films.set(figure.dataset.film, new Film(this, figure)));
    }

    get lesson() { return this.milliseconds < quick ? atOnce : takingTime; }
    get distance() { return this.measured ?? this.measure(); }
    // Where the page is written and measured in turn, it is laid out anew each time: `measured` holds until the next frame.
    static measureAll() {
      for (const step of steps) step.measured = step.measure();
      requestAnimationFrame(() => steps.forEach(step => { step.measured = undefined; }));
    }
    measure() {
      if (!this.section.getClientRects().length) return Infinity;  // one figure is shown alone
      const { top, bottom } = this.section.getBoundingClientRect();
      return top > innerHeight ? top - innerHeight : bottom < 0 ? -bottom : 0;
    }

    request(more) { return { ...more, step: this.label, settings: asObject(settings), narrow: byhandLayout.narrow.matches }; }

    // Tells the step at the present settings. Without `willing`, only if it does not take long. While the reader changes
    // them, what is in space is drawn small; once they rest, it is drawn again.
    async tell(willing = false) {
      const again = this.small && !this.stale;
      this.stale = false;
      this.small = this.inSpace && performance.now() - changed <= rest;
      this.telling = true;
      const begin = performance.now();
      const bar = setTimeout(() => this.say('computing …'), 300);
      try {
        const told = await this.lesson.ask(this.request({ ask: 'tell', small: this.small }), {
          milliseconds: willing ? undefined : patience,
          progress: (done, total) => this.sayProgress(done, total),
        });
        if (!again) this.milliseconds = performance.now() - begin;
        if (told.refused) return refuse(told);
        if (told.error) return this.say(told.error);
        this.needsButton = false;
        this.read = new Set(told.reads);
        this.offerOthers();
        this.show(told.html);
        this.say('');
      } catch (error) {
        if (!(error instanceof Stopped)) throw error;
        this.milliseconds = Infinity;
        this.small = false;
        this.needsButton = true;
        this.offerRun();
      } finally {
        clearTimeout(bar);
        this.telling = false;
        this.section.classList.toggle('stale', this.stale || !!this.needsButton);
      }
    }

    say(words) { this.state.replaceChildren(words); }
    sayProgress(done, total) {
      const bar = make('progress', { max: total, value: done, attributes: { 'aria-label': 'share of this step that is computed' } });
      const stop = make('button', { type: 'button', textContent: 'Stop', onclick: () => takingTime.stop() });
      this.state.replaceChildren('computing ', bar, ' ', stop);
    }
    offerRun() {
      const run = make('button', { type: 'button', className: 'run', textContent: 'Run it with these settings' });
      run.onclick = () => queue.run(this);
      this.state.replaceChildren('This step takes longer than a moment. ', run);
    }

    show(html) {
      const fresh = new DOMParser().parseFromString(html, 'text/html').querySelector('section');
      const keep = new Set();
      let before = this.state;
      for (const next of fresh.querySelectorAll(':scope > [data-item]')) {
        before = this.place(next, before);
        keep.add(before);
      }
      for (const old of this.section.querySelectorAll(':scope > [data-item]')) if (!keep.has(old)) old.remove();
      this.compare();
    }

    // Beside each picture and each measured number what it is at the other settings, where the reader compares, and
    // below each text its sentences that differ.
    async compare() {
      if (this.sceneAlone) return;
      this.uncompared = !!versus && this.distance > innerHeight;
      if (this.uncompared) return;
      const names = differing().filter(name => this.read.has(name)), turn = this.comparing = {};
      const other = names.length ? await this.toldVersus().catch(error => bar.fail(error)) : undefined;
      if (this.comparing !== turn) return;
      this.section.querySelectorAll('.versus').forEach(part => part.remove());
      this.section.querySelectorAll('.compared').forEach(part => part.classList.remove('compared'));
      if (!other) return;
      const [here, there] = [called(settings, names), called(versus, names)];
      for (const figure of this.section.querySelectorAll(':scope > figure:is([data-figure], [data-film])')) {
        const picture = other.querySelector(`:scope > #${figure.id} .picture`);
        if (!picture) continue;
        figure.classList.add('compared');
        const shown = figure.querySelector('.picture');
        const twin = make('div', { className: 'versus twin', innerHTML: apart(picture.innerHTML), attributes: { role: 'img', 'aria-label': `${there}: ${picture.getAttribute('aria-label')}` } });
        const wipe = make('input', { className: 'versus wipe', type: 'range', min: 0, max: 100, value: 50, attributes: { 'aria-label': `how much is shown of ${there}`, 'aria-valuetext': '50 %' } });
        wipe.oninput = () => {
          figure.style.setProperty('--wipe', `${wipe.value}%`);
          wipe.setAttribute('aria-valuetext', `${wipe.value} %`);
        };
        wipe.oninput();
        figure.prepend(make('p', { className: 'versus legend' }, make('span', { className: 'there', textContent: there }), make('span', { className: 'here', textContent: here })));
        shown.before(twin);
        shown.after(wipe);
        shown.onscroll = () => { twin.scrollLeft = shown.scrollLeft; };
        shown.onscroll();
      }
      const numbers = new Map([...other.querySelectorAll(':scope > .measures > div')].map(row =>
        [row.querySelector('dt').textContent, row.querySelector('dd').textContent]));
      for (const row of this.section.querySelectorAll(':scope > .measures > div')) {
        const number = numbers.get(row.querySelector('dt').textContent);
        if (number !== undefined) row.append(make('dd', { className: 'versus', textContent: `${number} with ${there}` }));
      }
      const told = new Set(sentences(this.section));
      for (const twin of other.querySelectorAll(':scope > :is(.text, .claims)')) {
        const words = sentences(twin).filter(sentence => !told.has(sentence)).join(' ');
        const child = this.section.querySelector(`:scope > [data-item="${twin.dataset.item}"]:is(.text, .claims)`);
        if (words && child) (child.querySelector('summary') ?? child).append(make('span', { className: 'versus' }, make('strong', {}, `With ${there}: `), words));
      }
    }

    // This step at the settings with which the reader compares.
    async toldVersus() {
      if (!versus.size) return this.written;
      const key = JSON.stringify([...versus]);
      if (this.other?.key === key) return this.other.section;
      if (this.needsButton) return;
      const told = await this.lesson.ask({ ...this.request({ ask: 'tell' }), settings: asObject(versus) }, { milliseconds: patience })
        .catch(error => { if (!(error instanceof Stopped)) throw error; return {}; });
      if (told.refused || told.error) this.say(told.refused ?? told.error);
      if (!told.html) return;
      this.other = { key, section: new DOMParser().parseFromString(told.html, 'text/html').querySelector('section') };
      return this.other.section;
    }

    // Puts the child `next` after `before`, or leaves what stands there if it is the same; returns what stands there.
    place(next, before) {
      const key = next.dataset.item;
      const old = this.section.querySelector(`:scope > [data-item="${key}"]`);
      if (next.dataset.hold) return old;  // goes on by itself
      const picture = next.querySelector('.picture')?.innerHTML;
      const words = bare(next);
      const same = old && old.tagName === next.tagName && (this.shown.get(key)?.words ?? bare(old)).isEqualNode(words);
      if (same) {
        if (picture !== undefined && picture !== this.shown.get(key)?.picture) this.draw(old, picture);
        this.shown.set(key, { words, picture });
        if (before.nextElementSibling !== old) before.after(old);
        return old;
      }
      this.shown.set(key, { words, picture });
      this.carryOver(old, next);
      if (old && old.id && old.id === next.id) return this.renew(old, next, before);
      const controls = old?.querySelector('.controls');
      if (controls) next.querySelector('.picture')?.after(controls);
      if (old) old.replaceWith(next);
      before.after(next);
      if (next.dataset.film) this.adopt(next);
      linkPages(next);
      byhandLayout.fitSoon(next);
      this.mark(next);
      return next;
    }

    // A figure stays where it is with its controls, one of which may be in the reader's hand: its picture and words change.
    renew(old, next, before) {
      const [here, there] = [old, next].map(figure => figure.querySelector('.picture'));
      old.dataset.item = next.dataset.item;
      here.setAttribute('aria-label', there.getAttribute('aria-label'));
      this.draw(old, there.innerHTML);
      old.querySelector('figcaption').replaceWith(next.querySelector('figcaption'));
      if (before.nextElementSibling !== old) before.after(old);
      linkPages(old);
      this.mark(old);
      return old;
    }

    draw(figure, picture) {
      const film = this.films.get(figure.dataset.film);
      figure.querySelector('.picture').innerHTML = picture;
      if (film) film.retold();
    }
    adopt(figure) {
      const film = this.films.get(figure.dataset.film);
      film ? film.moveTo(figure) : this.films.set(figure.dataset.film, new Film(this, figure));
    }

    // What was unfolded or typed stays so.
    carryOver(old, next) {
      if (!old) return;
      const details = [...next.querySelectorAll('details')];
      if (next.matches('details')) details.unshift(next);
      const before = [...old.querySelectorAll('details')];
      if (old.matches('details')) before.unshift(old);
      details.forEach((one, i) => { if (before[i]?.open) one.open = true; });
      const typed = old.querySelector('input[type=text]'), field = next.querySelector('input[type=text]');
      if (typed && field) field.value = typed.value;
    }

    mark(child) {
      child.classList.add('fresh');
      setTimeout(() => child.classList.remove('fresh'), 1600);
    }

    controlsOf(names, place) {
      const added = names.map(name => new Control(`${this.label}${place}-${name}`, parameters.get(name)));
      // The Tab key comes to a parameter's number once in a step, and to each of its sliders.
      for (const { parameter, slider, field } of added)
        if (slider && this.controls.some(control => control.parameter === parameter)) field.tabIndex = -1;
      this.controls.push(...added);
      return added;
    }

    // At the foot of the step the parameters that it reads and no picture offers.
    offerOthers() {
      const offered = new Set(this.controls.map(control => control.parameter.name));
      const more = this.controlsOf([...parameters.keys()].filter(name => this.read.has(name) && !offered.has(name)), '');
      this.others.append(...more.map(({ element }) => element));
      const count = this.others.children.length, place = this.section.querySelector('.others');
      this.folded.firstChild.textContent = count === 1 ? 'One more parameter of this step' : `${count} more parameters of this step`;
      if (count && place && !this.folded.isConnected) place.append(this.folded);
    }
  }

  // ---- A parameter beside a step.

  // A parameter's meaning without the steps in which it counts, which a reader of the step knows.
  const withoutPlaces = meaning => meaning.replace(/ \((?:[^()]*\bsteps? \d[^()]*|deeper)\)/, '');

  class Control {
    constructor(place, parameter) {
      this.parameter = parameter;
      const { name, unit, meaning, choices, allowed } = parameter;
      const id = `set-${place}`;
      const measured = unit && unit !== '1' && !choices.length ? [make('span', { className: 'unit', textContent: unit })] : [];
      const sign = symbol(name) !== name ? [make('i', { textContent: symbol(name) }), ' ', name] : [make(name.length === 1 ? 'i' : 'span', { textContent: name })];
      const title = make('span', { className: 'name', id: id + '-name' }, ...sign, ...measured.length ? [' in ', ...measured] : []);
      const about = make('span', { className: 'meaning', id: id + '-meaning', title: meaning, textContent: withoutPlaces(meaning) });
      this.undo = undo(name);
      this.error = make('p', { className: 'refused', id: id + '-refused', attributes: { role: 'alert' } });
      const naming = { 'aria-labelledby': title.id, 'aria-describedby': `${about.id} ${this.error.id}` };
      this.element = make('div', { className: 'setting', data: { name } }, title, this.undo);
      if (choices.length) {
        this.field = make('select', { attributes: naming }, ...choices.map(choice => make('option', { textContent: choice })));
      } else {
        this.field = make('input', { type: 'text', autocomplete: 'off', spellcheck: false, attributes: naming });
        this.element.title = `${allowed} ${unit === '1' ? '' : unit}`;
      }
      this.field.onchange = () => change(name, this.field.value);
      this.element.append(this.field);
      if (!choices.length) {
        this.values = sliderValues(parameter);
        this.slider = make('input', {
          type: 'range', min: 0, max: this.values.length - 1, step: 1,
          attributes: { 'aria-labelledby': title.id, 'aria-describedby': about.id },
        });
        this.slider.oninput = () => change(name, this.values[this.slider.value], this.slider);
        this.element.append(this.slider);
      }
      this.element.append(about, this.error);
      this.show();
    }

    show(moving) {
      const typed = settings.get(this.parameter.name) ?? this.parameter.typed;
      this.error.textContent = '';
      this.field.value = typed;
      this.field.removeAttribute('aria-invalid');
      this.element.classList.toggle('changed', settings.has(this.parameter.name));
      this.undo.hidden = !settings.has(this.parameter.name);
      if (!this.slider) return;
      if (this.slider !== moving) this.slider.value = placeOf(this.values, typed);
      this.slider.setAttribute('aria-valuetext', `${typed} ${this.parameter.unit === '1' ? '' : this.parameter.unit}`);
    }

    refuse(sentence) {
      this.error.textContent = sentence;
      this.field.setAttribute('aria-invalid', 'true');
    }
  }

  // What a step says in its texts, and of its claims whether they hold.
  const sentences = part => [...part.querySelectorAll(':is(.text :is(p, li), .claims > summary):not(.versus)')]
    .flatMap(({ textContent }) => textContent.split(/(?<=[.:;?!]) /));

  // A picture's markup with other ids, to stand beside the picture.
  const apart = svg => svg.replaceAll(/(id="|url\(#|href="#)/g, '$1versus-');

  let steps = [];
  const controls = name => steps.flatMap(step => step.controls).filter(control => control.parameter.name === name);

  function refuse({ refused, parameter }) { controls(parameter).forEach(control => control.refuse(refused)); }

  // ---- A change: what depends on it is told again, the step in view first.

  let changed = 0, changing = 0;

  async function change(name, value, moving) {
    ++changing;
    await take(name, value, moving).catch(error => bar.fail(error));
    --changing;
  }

  async function take(name, value, moving) {
    changed = performance.now();
    Step.measureAll();
    const { typed } = parameters.get(name);
    if (!moving) {  // a slider stays within its range
      const answer = await atOnce.ask({ ask: 'check', settings: { [name]: value } });
      if (answer.refused) return refuse(answer);
      value = answer.typed[name];
    }
    value === typed ? settings.delete(name) : settings.set(name, value);
    controls(name).forEach(control => control.show(moving));
    moving ? writeAddressLater() : writeAddress();
    bar.show();
    queue.add(steps.filter(step => step.read.has(name)));
  }

  const queue = {
    running: new Set(),

    add(stale) {
      for (const step of stale) {
        step.hold?.retold();
        if (step.sceneAlone) continue;
        step.stale = true;
        step.section.classList.add('stale');
        if (step.needsButton) step.offerRun();
      }
      this.advance();
    },

    next(lesson) {
      const rested = performance.now() - changed > rest;
      return steps
        .filter(step => (step.stale || step.small && rested) && !step.telling && !step.needsButton && step.lesson === lesson)
        .map(step => ({ step, distance: step.distance }))
        .filter(({ distance, step }) => distance <= (rested ? innerHeight : 0) && (rested || step.milliseconds === undefined || step.milliseconds < 4 * quick))
        .sort((a, b) => a.distance - b.distance)[0]?.step;
    },

    async advance() {
      for (const lesson of [atOnce, takingTime]) this.serve(lesson);
      steps.filter(step => step.uncompared && !step.stale && step.distance <= innerHeight).forEach(step => step.compare());
      clearTimeout(this.later);
      if (steps.some(step => step.stale || step.small)) this.later = setTimeout(() => this.advance(), rest + 20);
    },

    async serve(lesson) {
      if (this.running.has(lesson)) return;
      this.running.add(lesson);
      try {
        for (let step; (step = this.next(lesson));) {
          await step.tell();
          await nextFrame();
        }
      } catch (error) {
        bar.fail(error);
      } finally {
        this.running.delete(lesson);
      }
    },

    async run(step) {
      step.stale = true;
      await step.tell(true).catch(error => bar.fail(error));
    },
  };

  // ---- A film: every frame is drawn when it is looked at.

  class Film {
    constructor(step, figure) {
      this.step = step;
      this.name = figure.dataset.film;
      const button = (words, label, onclick) => make('button', { type: 'button', textContent: words, onclick, attributes: { 'aria-label': label } });
      this.play = button('▶', 'play', () => this.playing ? this.stop() : this.run());
      this.back = button('‹', 'one frame back', () => this.jump(-1));
      this.ahead = button('›', 'one frame on', () => this.jump(1));
      this.back.tabIndex = this.ahead.tabIndex = -1;  // what the arrow keys do at the slider
      this.slider = make('input', { type: 'range', min: 0, max: 1, value: 0, attributes: { 'aria-label': 'time in the film' } });
      this.slider.oninput = () => { this.stop(); this.show(+this.slider.value); };
      this.time = make('output');
      this.loop = make('button', { type: 'button', textContent: 'Loop', attributes: { 'aria-pressed': 'false' } });
      this.loop.onclick = () => this.loop.setAttribute('aria-pressed', String(!this.looping));
      this.speed = make('select', { attributes: { 'aria-label': 'speed' } },
        ...[['1', '×1'], ['0.5', '×½'], ['0.25', '×¼'], ['0.1', '×1⁄10']].map(([value, textContent]) => make('option', { value, textContent })));
      this.wide = button('', 'full screen', () => document.fullscreenElement ? document.exitFullscreen() : this.figure.requestFullscreen());
      this.wide.innerHTML = '<svg viewBox="0 0 16 16" aria-hidden="true"><path d="M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4" /></svg>';
      this.wide.hidden = !document.fullscreenEnabled;
      this.player = make('div', { className: 'player' }, this.play, this.back, this.ahead, this.slider, this.time, this.loop, this.speed, this.wide);
      this.moveTo(figure);
    }

    moveTo(figure) {
      this.figure = figure;
      (figure.querySelector('.controls') ?? figure.querySelector('.picture')).prepend(this.player);
      this.retold();
    }

    // The step was told again, and its first frame stands in the picture; the one that was shown follows.
    retold() {
      const screen = this.figure.querySelector('.picture .screen');
      if (!screen) return;
      const wanted = this.index;
      this.frames = +screen.dataset.frames;
      this.rate = +screen.dataset.rate;
      this.slider.max = this.frames - 1;
      this.index = 0;
      this.slider.value = this.index;
      this.tellTime();
      if (wanted && !this.playing) this.show(Math.min(wanted, this.frames - 1));
    }

    tellTime() {
      const seconds = index => (index / this.rate).toFixed(2), last = this.frames - 1;
      this.time.textContent = this.rate ? `${seconds(this.index)} of ${seconds(last)} s` : `picture ${this.index} of ${last}`;
      this.slider.setAttribute('aria-valuetext', this.time.textContent);
    }

    // What is shown was drawn small, and need not be any longer.
    get smaller() { return this.small && !this.playing && !this.step.small; }

    get looping() { return this.loop.getAttribute('aria-pressed') === 'true'; }

    async ready() {
      if (this.step.milliseconds === undefined) await this.step.tell(true);
    }

    // Draws frame `index`; if others are asked for meanwhile, the last of them after it. While the film plays, what is in
    // space is drawn small.
    async show(index) {
      this.wanted = index;
      if (this.drawing) return this.drawing;
      this.drawing = (async () => {
        await this.ready();
        do {
          index = this.wanted;
          this.small = this.step.inSpace && (!!this.playing || this.step.small);
          const { svg, error } = await this.step.lesson.ask(this.step.request({ ask: 'frame', film: this.name, index, small: this.small }));
          if (error) return this.step.say(error);
          this.figure.querySelector('.picture .screen').innerHTML = svg;
          await this.showVersus(index);
          this.index = index;
          this.slider.value = index;
          this.tellTime();
        } while (this.wanted !== index || this.smaller);
      })().catch(error => bar.fail(error)).finally(() => { this.drawing = undefined; });
      return this.drawing;
    }

    async showVersus(index) {
      const twin = this.figure.querySelector('.twin');
      if (!twin) return;
      const request = this.step.request({ ask: 'frame', film: this.name, index, small: this.small });
      const { svg } = await this.step.lesson.ask({ ...request, settings: asObject(versus) });
      if (svg) twin.innerHTML = apart(svg);
    }

    async jump(by) {
      this.stop();
      await this.ready();
      await this.show(Math.min(this.frames - 1, Math.max(0, this.index + by)));
    }

    async run() {
      this.playing = true;
      this.play.textContent = '❚❚';
      this.play.setAttribute('aria-label', 'pause');
      await this.ready();
      this.index ??= 0;
      do await this.runOnce(); while (this.playing && this.looping);
      this.stop();
    }

    async runOnce() {
      const first = this.index >= this.frames - 1 ? 0 : this.index, begin = performance.now();
      const rate = (this.rate || 3) * this.speed.value;  // frames that stand for steps: three a second
      this.drawn = 0;
      for (let index = first; this.playing; ++this.drawn) {
        await this.show(index);
        if (index >= this.frames - 1) break;
        await nextFrame();
        index = Math.min(this.frames - 1, Math.max(index, first + Math.floor((performance.now() - begin) / 1000 * rate)));
      }
      this.perSecond = this.drawn / ((performance.now() - begin) / 1000);
    }

    stop() {
      this.playing = false;
      this.play.textContent = '▶';
      this.play.setAttribute('aria-label', 'play');
      if (this.smaller) this.show(this.index);
    }
  }

  // ---- Questions, graded by the lesson.

  async function grade(form, typed) {
    const [label, question] = form.dataset.question.split('.');
    const step = steps.find(step => step.label === label);
    const reply = form.querySelector('.reply');
    const given = await step.lesson.ask(step.request({ ask: 'grade', question: +question, typed }));
    const verdict = !given.understood ? '' : given.right ? 'Yes. ' : 'No. ';
    // A first wrong choice gets the hint and another try; the reply to it, which tells more, comes with the second.
    const thought = form.dataset.kind === 'choice' && given.understood && !given.right && !form.dataset.tried;
    if (thought) form.dataset.tried = 'once';
    const hint = thought && (form.querySelector('.hint > p')?.textContent ?? 'Think it over and choose again.');
    reply.className = 'reply ' + (!given.understood ? '' : given.right ? 'right' : 'wrong');
    reply.textContent = verdict + (hint || (given.reply ?? given.error).replace(/,? or `\?` for what else can be typed/, ''));
  }

  document.addEventListener('submit', event => {
    const form = event.target.closest('form[data-question]');
    if (!form) return;
    event.preventDefault();
    if (form.dataset.kind === 'number') grade(form, form.elements.typed.value).catch(error => bar.fail(error));
  });
  document.addEventListener('change', event => {
    const form = event.target.closest('form[data-kind="choice"]');
    if (form && event.target.name === 'typed') grade(form, event.target.value).catch(error => bar.fail(error));
  });

  // ---- What the reader changed, at the foot of the window.

  // Sets one parameter back.
  function undo(name) {
    const { typed } = parameters.get(name), words = `set ${name} back to ${typed}`;
    return make('button', { type: 'button', className: 'undo', textContent: '×', title: words, onclick: () => change(name, typed), attributes: { 'aria-label': words } });
  }

  const bar = {
    element: make('aside', { className: 'changes', hidden: true, attributes: { 'aria-label': 'Changed settings' } }),

    show() {
      const reset = make('button', { type: 'button', className: 'reset', textContent: 'Reset', onclick: resetAll });
      const copy = make('button', { type: 'button', textContent: 'Copy link', onclick: () => this.copy(copy) });
      const changes = [...settings].map(([name, value]) =>
        make('span', { className: 'change' }, `${name} = ${value}`, make('span', { className: 'was' }, ` (${parameters.get(name).typed})`), undo(name)));
      const button = (className, words, onclick) => make('button', { type: 'button', className, textContent: words, onclick });
      const pin = button('compare-with-this', 'Compare with this', () => compareWith(new Map(settings)));
      const atDefaults = !!versus && !versus.size;
      const beside = button('beside-defaults', 'Beside the defaults', () => compareWith(atDefaults ? undefined : new Map()));
      beside.setAttribute('aria-pressed', String(atDefaults));
      const there = versus?.size ? [make('span', { className: 'change' }, `beside ${called(versus, [...versus.keys()])}`),
        button('stop-comparing', 'Stop comparing', () => compareWith(undefined))] : [];
      const refused = dropped.length ? [make('span', { className: 'refused', attributes: { role: 'alert' } }, `Left out of the link: ${dropped.join(' ')}`)] : [];
      this.element.replaceChildren(...refused, ...changes, ...there, reset, pin, beside, copy);
      this.element.hidden = !settings.size && !versus && !dropped.length;
    },

    copy(button) {
      writeAddress();
      const here = () => { button.textContent = 'The link is in the address bar'; };
      if (!navigator.clipboard) return here();  // as on a page without https
      navigator.clipboard.writeText(location.href).then(() => { button.textContent = 'Copied'; }, here);
    },

    fail(error) {
      if (error instanceof Stopped) return;
      this.element.hidden = false;
      this.element.setAttribute('role', 'alert');
      this.element.replaceChildren(`The lesson's program stopped (${error.message}). The page stays readable; load it again to change settings.`);
    },

    // Files of the site that could not be loaded.
    lack() {
      this.element.hidden = false;
      this.element.setAttribute('role', 'alert');
      this.element.replaceChildren('This page could not load its program: you can read it, but not change it.');
    },
  };

  const compareAll = () => steps.filter(step => !step.stale).forEach(step => step.compare());

  function compareWith(other) {
    versus = other;
    writeAddress();
    bar.show();
    compareAll();
  }

  function resetAll() {
    const names = [...settings.keys()];
    settings.clear();
    dropped.length = 0;
    names.forEach(name => controls(name).forEach(control => control.show()));
    changed = performance.now();
    writeAddress();
    bar.show();
    queue.add(steps.filter(step => names.some(name => step.read.has(name))));
  }

  // ---- Beginning.

  async function begin() {
    const article = document.querySelector('article.lesson');
    if (!article) return;
    document.body.append(bar.element);
    if (!parts.lesson || !parts.files || !parts.worker || !globalThis.byhandHold || !globalThis.byhandSettings) return bar.lack();
    try {
      const about = await atOnce.start();
      parameters = new Map(about.parameters.map(parameter => [parameter.name, parameter]));
    } catch (error) {
      return bar.fail(error);
    }
    await takeAddress();
    await byhandLayout.done;
    const { steps: reads } = JSON.parse(document.getElementById('parameters').textContent);
    steps = [...article.querySelectorAll('section[data-step]')].map(section => new Step(section, reads));
    linkPages(article);
    steps.forEach(step => step.offerOthers());
    if (settings.size || versus) document.getElementById(readAddress(location.hash).place)?.scrollIntoView();
    document.documentElement.classList.add('live');
    bar.show();
    if (settings.size) queue.add(steps.filter(step => [...settings.keys()].some(name => step.read.has(name))));
    compareAll();
    addEventListener('scroll', () => queue.advance(), { passive: true });
    const follow = async () => {
      const before = asObject(settings);
      await takeAddress();
      document.getElementById(readAddress(location.hash).place)?.scrollIntoView();
      const names = [...parameters.keys()].filter(name => before[name] !== settings.get(name));
      names.forEach(name => controls(name).forEach(control => control.show()));
      bar.show();
      queue.add(steps.filter(step => names.some(name => step.read.has(name))));
      compareAll();
    };
    // The page was turned: its pictures are those of the defaults, laid out anew.
    document.addEventListener('laidout', () => {
      for (const step of steps) {
        byhandLayout.of(step.written);
        step.shown.clear();
        step.films.forEach(film => film.retold());
      }
      queue.add(steps.filter(step => [...settings.keys()].some(name => step.read.has(name))));
    });
    addEventListener('hashchange', () => follow().catch(error => bar.fail(error)));
    takingTime.start().catch(error => bar.fail(error));
    document.documentElement.dataset.ready = '';
  }

  // For tests: the steps, whether all in reach are told at the present settings, and the bytes of the programs.
  globalThis.byhandPage = {
    get steps() { return steps; },
    settled: () => !changing && !writing && performance.now() - changed > rest + 50 && !steps.some(step => step.telling)
      && !queue.next(atOnce) && !queue.next(takingTime),
    memory: () => atOnce.memory + takingTime.memory + inHand.memory,
  };
  begin();
})();
