'use strict';
// A scene that a reader holds: dragged by mouse, finger or keys, let go, stepped, and seen within a step. All motion is
// the lesson's own C++ (course::Held), which draws every picture; here are only hands, clock and buttons.

// `lesson`: its program in a worker. `request(acts)` asks for the scene of the step at the present settings.
(() => {
  const slower = 100;      // times that a step is slowed
  const endOfPart = 1e-3;  // so long before the next part of a step begins, this one stands still

  globalThis.byhandHold = class {
    #acts = []; #busy; #part = 1 - endOfPart; #scene; #handles = [];

    // `plays`: it moves without being asked, where the reader has nothing against motion.
    constructor(figure, { make, lesson, request, reduced, fail, plays }) {
      Object.assign(this, { figure, lesson, request, reduced, fail });
      const button = (words, label, onclick) => make('button', { type: 'button', textContent: words, onclick, attributes: { 'aria-label': label } });
      const picture = this.picture = figure.querySelector('.picture');
      const name = figure.querySelector('figcaption').textContent.trim();
      this.hands = make('div', { className: 'hands', attributes: { role: 'group', 'aria-label': `To hold: ${name}` } });
      this.stage = make('div', { className: 'stage' });
      picture.replaceWith(this.stage);
      this.stage.append(picture, this.hands);
      this.play = button('▶', 'play', () => this.playing ? this.stop() : this.run());
      this.once = button('One step', 'one step', () => this.advance());
      this.slow = button(`Slow ×${slower}`, `Slow ×${slower}: a step part by part`, () => this.slowDown());
      this.slow.setAttribute('aria-pressed', 'false');
      this.again = button('Reset', 'reset the scene', () => this.reset());
      this.reading = make('p', { className: 'reading', attributes: { role: 'status' } });
      this.hint = make('p', { className: 'hint' }, make('strong', {}, 'Hold it yourself. '),
        'Drag a body and let it go. With keys: Tab to a body, the arrow keys pull it, Enter takes it and lets it go, Escape lets it go.');
      const controls = figure.querySelector('.controls');
      this.slow.hidden = figure.dataset.parts === 'no';
      controls.prepend(make('div', { className: 'player' }, this.play, this.once, this.slow, this.again));
      controls.append(this.reading, this.hint);
      this.make = make;
      this.stage.addEventListener('pointerdown', event => this.#take(event));
      this.stage.addEventListener('pointermove', event => { if (this.pointer === event.pointerId) this.#move(this.#point(event)); });
      for (const end of ['pointerup', 'pointercancel'])
        this.stage.addEventListener(end, event => { if (this.pointer === event.pointerId) this.release(); });
      this.hands.addEventListener('keydown', event => this.#key(event));
      // The program starts when the figure comes near.
      new IntersectionObserver(([{ isIntersecting }], watch) => {
        if (!isIntersecting) return;
        watch.disconnect();
        this.#ask().then(() => { if (plays && !reduced.matches) this.run(); });
      }, { rootMargin: '50%' }).observe(figure);
    }

    get held() { return this.#scene?.held ?? -1; }
    get scene() { return this.#scene; }

    // Does these acts at once, or with those of the next frame, and shows the scene. `part` of the next step: see Held.
    async #ask(...acts) {
      this.#acts.push(...acts);
      if (this.#busy) return this.#busy;
      this.#busy = (async () => {
        do {
          const now = this.#acts.splice(0);
          const part = this.slowed ? { part: this.#part } : {};
          const scene = await this.lesson.ask({ ...this.request(), ask: 'hold', acts: now, ...part });
          if (scene.error || scene.refused) continue;  // a setting is refused at its slider
          this.#show(scene);
        } while (this.#acts.length);
      })().catch(error => this.fail(error)).finally(() => { this.#busy = undefined; });
      return this.#busy;
    }

    #show(scene) {
      this.#scene = scene;
      this.picture.innerHTML = scene.svg;
      scene.bodies.forEach(({ name, x, y, reach }, i) => {
        const handle = this.#handles[i] ??= this.hands.appendChild(this.make('button', { type: 'button', className: 'hand', data: { body: i } }));
        handle.setAttribute('aria-label', name);
        handle.setAttribute('aria-pressed', String(scene.held === i));
        Object.assign(handle.style, { left: `${x / 9.6}%`, top: `${y / 7.2}%`, width: `${reach / 4.8}%` });
      });
      this.#handles.splice(scene.bodies.length).forEach(handle => handle.remove());
      if (scene.stopped) this.stop();
      this.#tell();
    }

    // At rest a reader of screens says the numbers; while it moves they would only interrupt.
    #tell() {
      const { words, stopped } = this.#scene;
      this.reading.setAttribute('aria-live', this.playing ? 'off' : 'polite');
      this.reading.textContent = stopped ? `${words} ${stopped}` : words;
      this.reading.classList.toggle('stopped', !!stopped);
      if (!this.playing) this.picture.setAttribute('aria-label', this.reading.textContent);
    }

    // ---- The hand.

    #point({ clientX, clientY }) {
      const { left, top, width, height } = this.picture.getBoundingClientRect();
      return [(clientX - left) / width * 960, (clientY - top) / height * 720];
    }

    async #take(event) {
      if (event.button !== 0) return;
      const pointer = event.pointerId;
      this.pointer = pointer;
      await this.#ask(['grab', ...this.#point(event)]);
      if (this.held < 0 && this.pointer === pointer) this.pointer = undefined;
      if (this.pointer !== pointer) return;
      this.stage.setPointerCapture(pointer);
      this.run();
    }

    #move(to) {
      this.at = to;
      this.playing ? this.#acts.push(['move', ...to]) : this.#ask(['move', ...to]);
    }

    release() {
      this.pointer = undefined;
      if (this.reduced.matches) this.stop();
      return this.#ask(['release']);
    }

    #key(event) {
      const body = +event.target.dataset.body, { x, y } = this.#scene.bodies[body];
      const pull = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      const take = () => { this.at = [x, y]; this.#ask(['grab', x, y]); this.run(); };
      if (pull) {
        if (this.held !== body) take();
        this.#move([this.at[0] + 30 * pull[0], this.at[1] + 30 * pull[1]]);
      } else if (event.key === 'Enter' || event.key === ' ') {
        this.held === body ? this.release() : take();
      } else if (event.key === 'Escape' && this.held >= 0) {
        this.release();
      } else {
        return;
      }
      event.preventDefault();
    }

    // ---- The clock.

    async run() {
      if (this.playing || this.#scene?.stopped) return;
      this.playing = true;
      this.#label();
      let before = performance.now(), owed = 0;
      while (this.playing) {
        await new Promise(requestAnimationFrame);
        const now = performance.now(), passed = Math.min(now - before, 100) / 1000;
        before = now;
        const { h = 1 / 60, parts = 6 } = this.#scene ?? {};
        if (!this.playing) break;
        if (this.slowed) {
          this.#part += passed / (slower * h) * parts;
          const steps = this.#part >= parts ? 1 : 0;
          if (steps) this.#part = 0;
          await this.#ask(['step', steps]);
        } else {
          owed += passed;
          const due = Math.floor(owed / h + 1e-6), steps = Math.min(4, due);
          owed = due > 4 ? 0 : owed - steps * h;
          if (steps) await this.#ask(['step', steps]);
        }
      }
    }

    stop() {
      if (!this.playing) return;
      this.playing = false;
      this.#label();
      if (this.#scene) this.#tell();
    }

    #label() {
      this.play.textContent = this.playing ? '❚❚' : '▶';
      this.play.setAttribute('aria-label', this.playing ? 'pause' : 'play');
    }

    // One step; where it is slowed, the next of its parts, as it is at its end.
    advance() {
      this.stop();
      const part = Math.round(this.#part), done = !this.slowed || part >= this.#scene.parts;
      this.#part = (done ? 1 : part + 1) - endOfPart;
      return this.#ask(['step', done ? 1 : 0]);
    }

    slowDown() {
      this.slowed = !this.slowed;
      this.#part = 1 - endOfPart;
      this.slow.setAttribute('aria-pressed', String(this.slowed));
      this.reading.classList.toggle('in-picture', this.slowed);  // which says the same
      this.once.textContent = this.slowed ? 'Next part' : 'One step';
      this.once.setAttribute('aria-label', this.slowed ? 'next part of the step' : 'one step');
      return this.#ask(['step', 0]);
    }

    reset() {
      this.stop();
      this.#part = 1 - endOfPart;
      return this.#ask(['reset']);
    }

    // The settings have changed: the scene goes on with them, and is shown with them now.
    retold() { if (this.#scene && !this.playing) this.#ask(['step', 0]); }
  };
})();
