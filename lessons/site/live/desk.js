'use strict';
// The desk's page: every line that is typed is checked by the desk's own C++, at once and in the page.

(async () => {
  const sheet = document.getElementById('sheet'), said = document.getElementById('said');
  const make = (tag, properties = {}, ...children) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };
  const fail = error => said.replaceChildren(make('p', { className: 'unreadable', textContent: `The desk does not run here: ${error.message ?? error}` }));

  let ask;
  try {
    ask = await start({ program: await unpacked(globalThis.byhandParts.desk), files: new Map() });
  } catch (error) {
    return fail(error);
  }

  const lines = () => sheet.value.split('\n');
  const stage = deskStage(scene => ask({ lines: lines(), scene }));
  const words = { right: 'right', wrong: 'wrong', unreadable: 'cannot be read', told: '' };
  const marks = { right: '✓', wrong: '✗', unreadable: '✗', told: '' };

  function hints(check) {
    const all = check.hints.filter(hint => hint);
    if (!all.length) return [];
    const list = make('ol', { className: 'hints' });
    const button = make('button', { type: 'button', textContent: 'Hint' });
    button.onclick = () => {
      list.append(make('li', { textContent: all[list.children.length] }));
      button.hidden = list.children.length === all.length;
    };
    return [button, list];
  }

  function point(check) {
    const button = make('button', { type: 'button', className: 'where', textContent: `Line ${check.line + 1}` });
    button.title = 'Go to this place';
    button.onclick = () => {
      const before = sheet.value.split('\n').slice(0, check.line).reduce((sum, line) => sum + line.length + 1, 0);
      sheet.focus();
      sheet.setSelectionRange(before + check.begin, before + check.end);
    };
    return button;
  }

  function show({ checks, report, code, failure }) {
    if (failure) return fail(failure);
    said.replaceChildren(...checks.map(check => {
      const item = make('li', { className: check.outcome }, point(check));
      if (marks[check.outcome]) item.append(make('span', { className: 'mark', ariaHidden: 'true', textContent: marks[check.outcome] }),
        make('strong', { textContent: words[check.outcome] + (check.name ? `: ${check.name}` : '') }));
      if (check.mathml) item.append(make('div', { className: 'formula', innerHTML: check.mathml }));
      item.append(make('p', { textContent: check.sentence }));
      if (check.numbers) item.append(make('p', { className: 'numbers', textContent: check.numbers }));
      if (check.outcome === 'wrong') item.append(...hints(check));
      return item;
    }));
    const foot = document.getElementById('report');
    foot.replaceChildren();
    if (report) foot.append(make('h2', { textContent: 'J stands' }), make('pre', { textContent: report }));
    if (code) foot.append(make('details', {}, make('summary', { textContent: 'As a struct that the solver takes' }), make('pre', { textContent: code })));
    stage(Boolean(report));
    const bad = checks.filter(check => check.outcome === 'wrong' || check.outcome === 'unreadable');
    const last = checks.at(-1);
    document.getElementById('verdict').textContent = !checks.length ? '' : bad.length
      ? `${bad.length} of ${checks.length} lines ${bad.length === 1 ? 'is' : 'are'} wrong; the first is line ${bad[0].line + 1}: ${bad[0].sentence}`
      : `All lines are right. ${report ? 'J stands.' : last.sentence}`;
  }

  let waiting;
  const check = () => {
    try {
      show(ask({ lines: lines() }));
    } catch (error) {
      fail(error);
    }
    history.replaceState(null, '', '#' + encodeURIComponent(sheet.value));
  };
  document.getElementById('tasks').hidden = false;
  sheet.oninput = () => {
    clearTimeout(waiting);
    waiting = setTimeout(check, 300);
  };
  for (const button of document.querySelectorAll('[data-start]'))
    button.onclick = () => {
      sheet.value = button.dataset.start;
      check();
      sheet.focus();
    };
  // A link brings its lines along.
  const task = document.getElementById(location.hash.slice(1));
  if (task?.dataset.start) sheet.value = task.dataset.start;
  else if (location.hash.length > 1) try { sheet.value = decodeURIComponent(location.hash.slice(1)); } catch { /* not lines */ }
  check();
})();
