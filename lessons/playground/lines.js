'use strict';
// A number over the last ten seconds, as a line, with its value in words beside it.

class RunningLine {
  #times = []; #values = [];
  static seconds = 10;

  // `words(value)`; `fromZero`: whether the line stands on zero.
  constructor(canvas, output, words, fromZero) { Object.assign(this, { canvas, output, words, fromZero }); }

  clear() { this.#times = []; this.#values = []; }

  add(time, value) {
    this.#times.push(time);
    this.#values.push(value);
    if (this.#times[0] < time - 2 * RunningLine.seconds) for (const list of [this.#times, this.#values]) list.splice(0, list.findIndex((_, i) => this.#times[i] >= time - RunningLine.seconds));
  }

  draw(colours) {
    const { canvas } = this, { width, height } = canvas.getBoundingClientRect(), ratio = Math.min(devicePixelRatio || 1, 2);
    if (!width) return;
    if (canvas.width !== Math.round(width * ratio)) Object.assign(canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    const context = canvas.getContext('2d'), end = this.#times.at(-1) ?? 0, begin = Math.max(0, end - RunningLine.seconds);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    const value = this.#values.at(-1);
    this.output.textContent = value === undefined ? '' : this.words(value);
    const seen = this.#values.filter((_, i) => this.#times[i] >= begin);
    let low = Math.min(...seen), high = Math.max(...seen);
    if (this.fromZero) low = 0;
    const size = Math.max(high - low, 1e-9 + 1e-3 * Math.abs(high));
    Object.assign(context, { lineWidth: 1, strokeStyle: colours.rule });
    context.beginPath();
    context.moveTo(0, height - 3.5);
    context.lineTo(width, height - 3.5);
    context.stroke();
    Object.assign(context, { lineWidth: 1.8, strokeStyle: this.fromZero ? colours.error : colours.accent, lineJoin: 'round' });
    context.beginPath();
    let begun = false;
    this.#values.forEach((one, i) => {
      if (this.#times[i] < begin) return;
      const x = (this.#times[i] - begin) / RunningLine.seconds * width, y = height - 4 - (one - low) / size * (height - 8);
      begun ? context.lineTo(x, y) : context.moveTo(x, y);
      begun = true;
    });
    context.stroke();
  }
}
