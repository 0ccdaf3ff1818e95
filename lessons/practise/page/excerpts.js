'use strict';
// Excerpts of a lesson that its reader may change: the lesson's figure is drawn with the reader's beside its own.

const excerpts = [
  { name: 'step', file: 'lessons/02_single_constraint/plain_step.cpp', figure: 'plain_step' },
  { name: 'sweep', file: 'lessons/03_iterations/plain_sweep.cpp', figure: 'plain_sweep' },
  { name: 'bias', file: 'lessons/04_baumgarte/plain_bias.cpp', figure: 'plain_bias' },
  { name: 'clamp', file: 'lessons/05_contact/plain_clamp.cpp', figure: 'plain_clamp' },
];

const element = (name, properties = {}, ...inside) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...inside);
  return made;
};
const button = (words, onclick) => element('button', { type: 'button', textContent: words, onclick });

function makeLive({ name, file, figure }, place) {
  const ours = place.querySelector('pre'), picture = document.querySelector(`#figure-${figure} .picture`);
  const written = ours.textContent.replace(/\n$/, ''), drawn = picture.innerHTML;
  const code = element('textarea', { value: written, rows: written.split('\n').length + 2, spellcheck: false, wrap: 'off' });
  code.setAttribute('aria-label', `Your ${file.split('/').at(-1)}; Tab leaves it, Ctrl+Enter runs it`);
  const state = element('p', { className: 'state' }), details = element('pre', { hidden: true });
  state.setAttribute('role', 'status');
  const phone = matchMedia('(pointer: coarse)').matches || navigator.connection?.saveData;
  let running = false, allowed = !phone;

  const allow = () => allowed ||= confirm("Running it loads a compiler of 23 MB, once, and takes some 400 MB of this device's memory. Load it?");
  function select(line) {
    const lines = code.value.split('\n'), begin = lines.slice(0, line - 1).join('\n').length + (line > 1);
    if (!line || line > lines.length) return;
    code.focus({ preventScroll: true });
    code.setSelectionRange(begin, begin + lines[line - 1].length);
  }
  function show({ sentence, details: more, printed, line, svg }) {
    state.textContent = svg ? 'Drawn in the figure below: yours beside the dashed one, which is ours.' : sentence;
    details.textContent = more + (printed ? `Your code printed:\n${printed}` : '');
    details.hidden = !details.textContent;
    if (svg) picture.innerHTML = svg;
    else select(line || +(/ in line (\d+)/.exec(sentence)?.[1] ?? 0));
  }
  async function run() {
    if (running || !allow()) return;
    running = true;
    details.hidden = true;
    try {
      show(await verdictOn(name, code.value, words => { state.textContent = words; }, 'excerpt'));
    } catch (error) {
      state.textContent = `Excerpts do not run here: ${error.message ?? error}`;
    } finally {
      running = false;
    }
  }
  function reset() {
    code.value = written;
    picture.innerHTML = drawn;
    state.textContent = '';
    details.hidden = true;
    desk.replaceWith(ours);
    edit.hidden = false;
    edit.focus();
  }
  code.onkeydown = event => { if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) { event.preventDefault(); run(); } };
  const desk = element('div', { className: 'practise' }, element('div', { className: 'editor plain' }, code),
    element('p', { className: 'tools' }, button('Run', run), ' ', button('Reset', reset)), state, details);
  const edit = button('Change it and run it', () => {
    ours.replaceWith(desk);
    edit.hidden = true;
    code.focus();
    if (allowed) compiler().catch(() => {});
  });
  place.querySelector('figcaption').append(' ', element('span', { className: 'practise' }, edit));
}

for (const excerpt of excerpts) {
  const place = [...document.querySelectorAll('figure.excerpt')].find(one => one.querySelector('figcaption code')?.textContent === excerpt.file);
  if (!place) continue;
  document.head.append(element('link', { rel: 'stylesheet', href: 'practise/practise.css' }));
  makeLive(excerpt, place);
}
