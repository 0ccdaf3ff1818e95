'use strict';
// The page of the exercises: one at a time, a sheet to write in, and the verdict.

(() => {
  const $ = id => document.getElementById(id);
  const sections = [...document.querySelectorAll('.exercise')], code = $('code');
  const kept = {  // a browser may refuse to keep anything
    read(key) { try { return localStorage.getItem(`byhand practise ${key}`); } catch { return null; } },
    write(key, value) { try { value === null ? localStorage.removeItem(`byhand practise ${key}`) : localStorage.setItem(`byhand practise ${key}`, value); } catch { /* as before */ } },
  };
  let exercise;
  const stub = () => $(exercise).querySelector('.stub code').textContent;
  const say = words => { $('state').textContent = words; };

  // ---- Which exercise.

  function mark() {
    for (const link of document.querySelectorAll('.exercises a')) {
      const name = link.hash.slice(1), solved = kept.read(`solved ${name}`) !== null;
      link.parentElement.classList.toggle('solved', solved);
      link.toggleAttribute('aria-current', name === exercise);
      link.title = solved ? 'solved' : '';
    }
  }

  function choose() {
    const wanted = sections.find(section => section.id === location.hash.slice(1));
    exercise = wanted?.id;
    for (const section of sections) section.hidden = section !== wanted;
    $('desk').hidden = !wanted;
    if (wanted) {
      code.value = kept.read(exercise) ?? stub();
      code.setAttribute('aria-label', `Your file, ${exercise}.cpp`);
      clear();
      number();
      $('numbers_given').value = '';
      maskedCode();
    }
    mark();
  }

  // ---- The sheet.

  // Numbers stand beside the lines and scroll with them.
  function number() {
    const lines = code.value.split('\n').length;
    code.rows = Math.max(10, Math.min(30, lines + 1));
    $('numbers').textContent = Array.from({ length: lines }, (_, i) => i + 1).join('\n');
    $('numbers').scrollTop = code.scrollTop;
  }
  function keep() {
    kept.write(exercise, code.value === stub() ? null : code.value);
    number();
  }
  function insert(text) {
    // execCommand keeps what the browser can undo.
    if (!document.execCommand?.('insertText', false, text)) code.setRangeText(text, code.selectionStart, code.selectionEnd, 'end');
  }
  function replace(text) {
    code.value = text;
    keep();
    clear();
  }
  function select(line) {
    const lines = code.value.split('\n');
    if (!line || line > lines.length) return;
    const begin = lines.slice(0, line - 1).reduce((sum, text) => sum + text.length + 1, 0);
    code.focus({ preventScroll: true });
    code.setSelectionRange(begin, begin + lines[line - 1].length);
    code.scrollIntoView({ block: 'nearest' });
  }
  code.oninput = () => { keep(); warmUp(); };
  code.onscroll = () => { $('numbers').scrollTop = code.scrollTop; };
  code.onkeydown = event => {
    if (event.key !== 'Enter' || event.isComposing) return;
    event.preventDefault();
    if (event.ctrlKey || event.metaKey) return check();
    const line = code.value.slice(0, code.selectionStart).split('\n').at(-1);
    insert('\n' + line.match(/^ */)[0] + (/\{\s*$/.test(line) ? '  ' : ''));
  };

  // ---- The compiler: asked for on phones, and started while the reader begins to type elsewhere.

  let allowed = !(matchMedia('(pointer: coarse)').matches || navigator.connection?.saveData);
  let warm;
  function warmUp() {
    if (!allowed || warm) return;
    const name = exercise, text = stub();
    warm = compiler().then(service => service.ask({ exercise: name, text })).catch(() => { warm = undefined; });
    judge().catch(() => {});
  }
  function permission() {
    if (allowed) return Promise.resolve(true);
    $('ask').hidden = false;
    $('load').focus();
    return new Promise(resolve => {
      const answer = yes => () => {
        $('ask').hidden = true;
        allowed = yes;
        $('check').focus();
        resolve(yes);
      };
      $('load').onclick = answer(true);
      $('refuse').onclick = answer(false);
    });
  }

  // ---- The verdict.

  function clear() {
    for (const part of ['details', 'film', 'solution']) $(part).hidden = true;
    $('verdict').className = $('sentence').textContent = '';
    stop();
    say('');
  }

  async function show({ kind, sentence, details, printed, line, frames, solution, derivation }) {
    $('verdict').className = kind;
    $('sentence').textContent = sentence;
    const all = details + (printed ? `Your code printed:\n${printed}` : '');
    $('details').textContent = all;
    $('details').hidden = !all;
    $('solution').hidden = !solution;
    if (solution) {
      $('solution').querySelector('code').textContent = solution;
      $('solution').querySelector('p').textContent = derivation;
      kept.write(`solved ${exercise}`, 'yes');
      mark();
    }
    select(line || +(/ in line (\d+)/.exec(sentence)?.[1] ?? 0));
    $('film').hidden = !frames;
    if (frames) {
      Object.assign($('time'), { max: frames - 1, value: frames - 1 });
      await frame(frames - 1);
    }
    dispatchEvent(new Event('resize'));  // keys scroll what is wider than the page (see site.js)
  }

  let checking = false;
  async function check() {
    if (checking) return;
    checking = true;
    const asked = exercise;
    try {
      if (!await permission()) return;
      clear();
      const verdict = await verdictOn(asked, code.value, say);
      if (asked !== exercise) return;
      await show(verdict);
      document.body.dataset.took = JSON.stringify(verdict.took);
    } catch (error) {
      $('verdict').className = 'stopped';
      $('sentence').textContent = `The exercises do not run here: ${error.message ?? error}`;
    } finally {
      say('');
      checking = false;
    }
  }

  // ---- A wrong code, to be unmasked by numbers; for this the judge alone is loaded.

  async function maskedCode() {
    $('unmasked').textContent = '';
    if (!$('unmask').open) return;
    try {
      const asked = exercise, { code, test } = await judged({ request: { ask: 'masked', exercise: asked } });
      if (asked !== exercise) return;
      $('masked').textContent = code;
      $('test').textContent = test;
    } catch (error) {
      $('unmasked').textContent = `The exercises do not run here: ${error.message ?? error}`;
    }
  }
  $('unmask').ontoggle = maskedCode;
  $('guess').onsubmit = async event => {
    event.preventDefault();
    const { report } = await judged({ request: { ask: 'unmask', exercise, numbers: $('numbers_given').value } });
    $('unmasked').textContent = report;
  };

  // ---- The film.

  let playing;
  async function frame(index) {
    const { svg } = await (await judge()).ask({ request: { ask: 'picture', index } });
    $('film').querySelector('.picture').innerHTML = svg;
    $('time').setAttribute('aria-valuetext', `${(index / 30).toFixed(2)} s`);
  }
  function stop() {
    cancelAnimationFrame(playing);
    playing = undefined;
    $('play').textContent = 'Play';
  }
  async function play() {
    if (playing !== undefined) return stop();
    $('play').textContent = 'Stop';
    const time = $('time');
    if (+time.value === +time.max) time.value = 0;
    const first = +time.value, begin = performance.now();
    const step = async () => {
      const index = Math.min(+time.max, first + Math.floor((performance.now() - begin) * 0.03));
      time.value = index;
      await frame(index);
      if (playing === undefined) return;
      if (index === +time.max) return stop();
      playing = requestAnimationFrame(step);
    };
    playing = requestAnimationFrame(step);
  }

  // ---- Buttons.

  $('check').onclick = check;
  $('play').onclick = play;
  $('time').oninput = () => { stop(); frame(+$('time').value); };
  $('reset').onclick = () => { if (code.value === stub() || confirm('Put the stub in the place of your file?')) replace(stub()); };
  $('open').onclick = () => $('file').click();
  $('file').onchange = async () => {
    const [file] = $('file').files;
    if (file && file.size <= 64 << 10) replace((await file.text()).replaceAll('\r\n', '\n'));
    else if (file) say(`${file.name} has more than 64 KB.`);
    $('file').value = '';
  };
  $('save').onclick = () => {
    const link = document.createElement('a');
    Object.assign(link, { href: URL.createObjectURL(new Blob([code.value], { type: 'text/plain' })), download: `${exercise}.cpp` });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  };
  addEventListener('hashchange', choose);
  choose();
})();
