'use strict';
// Settings as an address carries them, and the values of a slider: what needs no page.

(() => {
  // A stray "%", as mail programs make it, stays as it is.
  const unescaped = text => { try { return decodeURIComponent(text); } catch { return text; } };

  // What "#step-4&beta=1.9&versus=h:1/120" says: a place in the page, [name, value] pairs, and the pairs to compare with,
  // none of them for "versus=defaults". Without any pair it is only a place.
  function readAddress(hash) {
    const said = { place: '', settings: [], versus: undefined };
    for (const part of hash.replace(/^#/, '').split('&').map(unescaped).filter(Boolean)) {
      const [name, value] = part.split('=');
      if (value === undefined) said.place ||= name;
      else if (name === 'versus') said.versus = value === 'defaults' ? [] : value.split(',').map(pair => pair.split(':'));
      else said.settings.push([name, value]);
    }
    said.onlyPlace = !said.settings.length && !said.versus;
    return said;
  }

  function address({ place, settings, versus }) {
    const pairs = (map, sign) => [...map].map(pair => pair.join(sign));
    const parts = [...place ? [place] : [], ...pairs(settings, '=')];
    if (versus) parts.push('versus=' + (pairs(versus, ':').join(',') || 'defaults'));
    return parts.length ? '#' + parts.join('&') : '';
  }

  const number = typed => {
    const [above, below = 1] = typed.replace('−', '-').split('/').map(Number);
    return above / below;
  };

  // A value with the fewest letters that are exactly it: 0.2, 1/480.
  function written(value) {
    const short = String(+value.toPrecision(6)), below = Math.round(1 / value);
    if (+short === value || !(Math.abs(value * below - 1) < 1e-12)) return String(value);
    return `1/${below}`;
  }

  // Multiples of 1, 2 or 5 times a power of ten, some 300 in a range.
  function evenly(low, high) {
    const rough = (high - low) / 400, power = 10 ** Math.floor(Math.log10(rough));
    const step = power * [1, 2, 5, 10].find(factor => factor * power >= rough * (1 - 1e-9));
    const all = [];
    for (let i = Math.ceil(low / step); i * step <= high; ++i) all.push(+(i * step).toPrecision(12));
    return all;
  }

  // 1, 1.05, 1.1 … 2, 2.1 … 5, 5.2 … in every power of ten: neighbours differ by two to five hundredths.
  function byRatio(low, high) {
    const all = [];
    for (let power = Math.floor(Math.log10(low)); 10 ** power <= high; ++power)
      for (let i = 100; i < 1000; i += i < 200 ? 5 : i < 500 ? 10 : 20) all.push(+`${i}e${power - 2}`);
    return all;
  }

  // The distinct values of a slider in their order, as typed: one key leads from one to the next. The default, the ends
  // and, where time steps are fractions of a second, those in use are among them and have no close neighbours, so that a
  // hand finds them again.
  function sliderValues({ low, high, whole, typed }) {
    const all = whole && high - low <= 1000 ? Array.from({ length: high - low + 1 }, (_, i) => low + i)
      : low > 0 && high / low >= 100 ? byRatio(low, high) : evenly(low, high);
    const fractions = /^1\/\d+$/.test(typed) ? [10, 15, 20, 30, 60, 120, 240, 480, 960].map(n => `1/${n}`) : [];
    const firm = new Map([...fractions, written(low), written(high), typed].map(one => [number(one), one]));
    const within = value => value >= low && value <= high;
    const grid = [...new Set(all.map(value => whole ? Math.round(value) : value))].filter(within);
    const gap = Math.max(1, Math.round(grid.length / 150)), spread = value => grid.findLastIndex(one => one <= value);
    const crowded = new Set();
    if (!whole) for (const value of [...firm.keys()].filter(within))
      for (let i = spread(value) - gap + 1; i <= spread(value) + gap; ++i) crowded.add(grid[i]);
    const values = new Map(grid.filter(value => !crowded.has(value)).map(value => [value, written(value)]));
    for (const [value, one] of firm) if (within(value)) values.set(value, one);
    return [...values].sort(([a], [b]) => a - b).map(([, one]) => one);
  }

  // The place in such a list that is nearest to what was typed.
  function placeOf(values, typed) {
    const distances = values.map(one => Math.abs(number(one) - number(typed)));
    return distances.indexOf(Math.min(...distances));
  }

  const greek = { alpha: 'α', beta: 'β', gamma: 'γ', delta: 'δ', lambda: 'λ', mu: 'μ', omega: 'ω', phi: 'φ', theta: 'θ', zeta: 'ζ' };
  // How the text calls a parameter: β for beta.
  const symbol = name => greek[name] ?? name;

  globalThis.byhandSettings = { readAddress, address, sliderValues, placeOf, symbol };
})();
