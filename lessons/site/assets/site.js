// What every page can do without the lesson's program: recall equations, search, mark the step in view. The pages are
// complete without it, and it loads nothing from elsewhere.
'use strict';
(() => {
  document.documentElement.classList.add('scripted');
  const element = (name, attributes = {}, ...inside) => {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    made.append(...inside);
    return made;
  };

  // "(14)" shows the equation below it: while the mouse is over either, while it has the focus, or from one tap to the
  // next. Escape closes it. A second tap, or Enter, follows the link.
  let shown = null, closing = 0;
  const close = () => {
    shown?.box.remove();
    shown?.link.removeAttribute('aria-describedby');
    shown = null;
  };
  const recall = link => {
    clearTimeout(closing);
    if (shown?.link === link) return;
    close();
    const mathml = window.equations?.[link.textContent.slice(1, -1)];
    if (!mathml) return;
    const box = element('div', { class: 'recalled', id: 'recalled', role: 'tooltip' });
    box.innerHTML = mathml;
    document.body.append(box);
    const at = link.getBoundingClientRect(), size = box.getBoundingClientRect();
    const left = Math.max(8, Math.min(at.left, document.documentElement.clientWidth - size.width - 8));
    const below = at.bottom + size.height + 8 < innerHeight;
    box.style.left = `${left + scrollX}px`;
    box.style.top = `${(below ? at.bottom + 4 : at.top - size.height - 4) + scrollY}px`;
    link.setAttribute('aria-describedby', 'recalled');
    shown = { link, box };
  };
  const closest = (event, selector) => event.target instanceof Element ? event.target.closest(selector) : null;
  document.addEventListener('pointerover', event => {
    if (event.pointerType === 'touch') return;
    const link = closest(event, '.recall');
    if (link) recall(link);
    else if (closest(event, '.recalled')) clearTimeout(closing);
    else if (shown && document.activeElement !== shown.link) {
      clearTimeout(closing);
      closing = setTimeout(close, 250);
    }
  });
  document.addEventListener('focusin', event => {
    const link = closest(event, '.recall');
    if (link && link.matches(':focus-visible')) recall(link);
    else if (!closest(event, '.recalled')) close();
  });
  document.addEventListener('keydown', event => { if (event.key === 'Escape') close(); });
  let touched = false;
  document.addEventListener('pointerdown', event => { touched = event.pointerType === 'touch'; });
  document.addEventListener('click', event => {
    const link = closest(event, '.recall');
    if (link && touched && shown?.link !== link) {
      event.preventDefault();
      recall(link);
    } else if (touched && !link && !closest(event, '.recalled')) close();
  });

  // Pictures for a narrow page come in a file of their own, packed (see pack_narrow_pictures), and take the place of the
  // wide ones; a page that is turned gets those back. The media query is that of style.css.
  const layout = globalThis.byhandLayout = {
    narrow: matchMedia('(max-width: 40rem), (max-width: 58rem) and (orientation: portrait)'),
    of(part) {
      for (const figure of part.querySelectorAll('figure:is([data-figure], [data-film])')) {
        const picture = figure.querySelector('.picture'), laidOut = narrowOnes[figure.id];
        if (!laidOut) continue;
        wideOnes[figure.id] ??= picture.innerHTML;
        picture.innerHTML = layout.narrow.matches ? laidOut : wideOnes[figure.id];
      }
    },
  };
  const wideOnes = {};
  let narrowOnes = {};
  const unpacked = async packed => {
    const bytes = Uint8Array.from(atob(packed), letter => letter.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).json();
  };
  const layOut = async () => {
    const file = document.documentElement.dataset.narrow;
    if (layout.narrow.matches && file && !Object.keys(narrowOnes).length)
      narrowOnes = await new Promise(resolve => {
        globalThis.byhandNarrow = packed => resolve(unpacked(packed));
        const script = element('script', { src: file });
        script.onerror = () => resolve({});
        document.head.append(script);
      });
    layout.of(document);
  };
  layout.done = layout.narrow.matches ? layOut().catch(() => {}) : Promise.resolve();
  layout.narrow.addEventListener('change', () => layOut().then(() => document.dispatchEvent(new Event('laidout')), () => {}));

  // A formula that is a little too wide is set smaller. What is wider still can be scrolled with the keyboard. All is
  // measured at once, before anything is set: each change between two measurements would lay the page out anew.
  const smallest = 0.75;
  const fit = (parts = [document]) => {
    const boxes = parts.flatMap(part => [...part.querySelectorAll('.formula, .scroll, .picture, pre')]);
    for (const box of boxes) if (box.matches('.formula')) box.style.fontSize = '';
    const measured = boxes.map(box => ({ box, room: box.clientWidth, width: box.scrollWidth }));
    for (const { box, room, width } of measured) {
      const share = box.matches('.formula') && width > room ? Math.max(smallest, 0.99 * room / width) : 1;
      if (share < 1) box.style.fontSize = `${share}em`;
      if (share * width > room + 1) box.tabIndex = 0;
      else box.removeAttribute('tabindex');
    }
  };
  const unfitted = new Set();
  layout.fitSoon = part => {
    if (!unfitted.size) requestAnimationFrame(() => { fit([...unfitted]); unfitted.clear(); });
    unfitted.add(part);
  };
  addEventListener('resize', () => fit());
  addEventListener('load', () => fit());
  document.addEventListener('toggle', () => fit(), true);

  // At which edges of a picture more of it is out of sight.
  const tellMore = picture => {
    const left = picture.scrollLeft > 8, right = picture.scrollLeft + picture.clientWidth < picture.scrollWidth - 8;
    picture.dataset.more = `${left ? 'left' : ''} ${right ? 'right' : ''}`.trim();
  };
  document.addEventListener('scroll', ({ target }) => { if (target instanceof Element && target.matches('.picture')) tellMore(target); }, { capture: true, passive: true });

  // What a narrow page shows of a wider figure at first: what is drawn farthest left, or all of it in the middle.
  const look = new IntersectionObserver(entries => {
    for (const { isIntersecting, target: picture } of entries) {
      if (!isIntersecting) continue;
      look.unobserve(picture);
      picture.dataset.placed = '';
      tellMore(picture);
      if (picture.scrollWidth <= picture.clientWidth + 1) continue;
      const boxes = [...picture.querySelectorAll('svg :is(circle, text, path:not(svg > path:first-child))')].map(drawn => drawn.getBoundingClientRect());
      const begin = picture.getBoundingClientRect().left - picture.scrollLeft;
      const left = Math.min(...boxes.map(box => box.left)) - begin, right = Math.max(...boxes.map(box => box.right)) - begin;
      picture.scrollLeft = left - Math.max(8, (picture.clientWidth - (right - left)) / 2);
      tellMore(picture);
    }
  }, { rootMargin: '50%' });
  document.querySelectorAll('.picture').forEach(picture => look.observe(picture));

  // "04_baumgarte.html?only=drift" is that figure, film or scene alone, for a frame in another page, which is told its
  // height: { byhand: 'drift', height: 612 }.
  const only = new URLSearchParams(location.search).get('only');
  const alone = only && ['figure', 'film', 'hold'].map(kind => document.getElementById(`${kind}-${only}`)).find(Boolean);
  if (alone) {
    alone.classList.add('alone');
    document.documentElement.classList.add('only');
    new ResizeObserver(() => {
      const { height } = document.querySelector('.page').getBoundingClientRect();
      parent.postMessage({ byhand: only, height: Math.ceil(height) }, '*');
    }).observe(alone);
  }

  // What paper shows of the page's address.
  document.querySelector('.printed')?.append(`, ${location.href.split('#')[0]}`);

  // A figure as it is shown, saved as SVG, or as PNG of two pixels a point.
  const save = (name, blob) => {
    const link = element('a', { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  };
  const asUrl = blob => new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(reader.result);
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(blob);
  });
  // One file: a bitmap beside the page comes into it. A page that was opened from the disk may not read that.
  const asSvg = async svg => {
    const whole = svg.cloneNode(true);
    whole.removeAttribute('width');  // of another, for which it keeps room
    whole.removeAttribute('height');
    for (const frame of whole.querySelectorAll('foreignObject')) {
      const image = document.createElementNS(svg.namespaceURI, 'image');
      for (const { name, value } of frame.attributes) image.setAttribute(name, value);
      image.setAttribute('href', await asUrl(await (await fetch(frame.querySelector('img').src)).blob()));
      frame.replaceWith(image);
    }
    return new Blob([new XMLSerializer().serializeToString(whole)], { type: 'image/svg+xml' });
  };
  const asPng = (blob, { width, height }) => new Promise((resolve, reject) => {
    const image = new Image(2 * width, 2 * height), address = URL.createObjectURL(blob);
    image.onerror = reject;
    image.onload = () => {
      const canvas = element('canvas', { width: image.width, height: image.height });
      canvas.getContext('2d').drawImage(image, 0, 0, image.width, image.height);
      URL.revokeObjectURL(address);
      canvas.toBlob(resolve, 'image/png');
    };
    image.src = address;
  });
  document.addEventListener('click', async event => {
    const button = closest(event, '.files button');
    const figure = button?.closest('figure'), svg = figure?.querySelector('.picture svg');
    if (!svg) return;
    const name = figure.dataset.figure ?? figure.dataset.film;
    try {
      const blob = await asSvg(svg);
      if (button.textContent === 'SVG') save(`${name}.svg`, blob);
      else save(`${name}.png`, await asPng(blob, svg.viewBox.baseVal));
    } catch {
      button.replaceWith('(not from the disk)');
    }
  });

  // The step in view is marked in the list of steps.
  const entries = new Map([...document.querySelectorAll('.beside a')].map(a => [a.hash.slice(1), a]));
  if (entries.size > 0) {
    const steps = [...document.querySelectorAll('.step')];
    const mark = () => {
      const here = steps.filter(step => step.getBoundingClientRect().top < innerHeight / 3).pop();
      for (const [id, link] of entries) {
        if (here?.id === id) link.setAttribute('aria-current', 'location');
        else link.removeAttribute('aria-current');
      }
    };
    let waiting = false;
    addEventListener('scroll', () => {
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(() => { waiting = false; mark(); });
    }, { passive: true });
    mark();
  }

  // The search: every word typed is in the step, titles count most. Its index is loaded when somebody searches.
  const place = document.querySelector('.search');
  const input = element('input', { type: 'search', 'aria-label': 'Search the course', placeholder: matchMedia('(max-width: 30rem)').matches ? 'Search' : 'Search ( / )', autocomplete: 'off', spellcheck: 'false' });
  const results = element('ol', { 'aria-label': 'Results' });
  const said = element('p', { class: 'none', role: 'status', hidden: '' });
  place.append(input, said, results);
  let index;
  const load = () => index ??= new Promise((resolve, reject) => {
    const script = element('script', { src: place.dataset.index });
    globalThis.byhandSearch = packed => resolve(unpacked(packed).then(pages => pages.flatMap(([page, lesson, steps]) =>
      steps.map(([anchor, title, words]) => ({ href: `${page}#${anchor}`, lesson, title, words, low: plain(words), heading: plain(`${lesson} ${title}`) })))));
    script.onerror = () => reject(new Error('assets/search.js cannot be loaded'));
    document.head.append(script);
  });
  // As it is typed: without accents, any dash for a hyphen, a Greek letter or its name, a method by its other names.
  const plain = text => text.normalize('NFD').replace(/\p{M}/gu, '').normalize('NFC').toLowerCase();
  const greek = { alpha: 'α', beta: 'β', gamma: 'γ', delta: 'δ', zeta: 'ζ', theta: 'θ', lambda: 'λ', mu: 'μ', rho: 'ρ', phi: 'φ', omega: 'ω' };
  const alsoCalled = { pgs: 'gauss.seidel', si: 'sequential impulses?', erp: 'baumgarte' };
  const pattern = word => {
    const letter = Object.entries(greek).find(pair => pair.includes(word)) ?? [];
    const typed = word.replace(/[.*+?^${}()|[\]\\]/g, '\\$&').replace(/-/g, '[-\u2010-\u2015\u2212 ]');
    return [typed, ...letter, ...alsoCalled[word] ? [alsoCalled[word]] : []].join('|');
  };
  const occurrences = (text, word) => text.match(new RegExp(pattern(word), 'g'))?.length ?? 0;
  const score = (entry, words) => {
    let sum = 0;
    for (const word of words) {
      const found = 20 * occurrences(entry.heading, word) + Math.min(10, occurrences(entry.low, word));
      if (found === 0) return 0;
      sum += found;
    }
    return sum;
  };
  const excerpt = (entry, words) => {
    const at = Math.max(0, entry.low.search(new RegExp(pattern(words[0]))));
    const begin = at < 60 ? 0 : entry.words.lastIndexOf(' ', at - 50) + 1;
    const text = entry.words.slice(begin, begin + 160);
    const parts = text.split(new RegExp(`(${words.map(pattern).join('|')})`, 'i'));
    const line = element('span');
    parts.forEach((part, i) => line.append(i % 2 ? element('mark', {}, part) : part));
    line.prepend(begin ? '… ' : '');
    line.append(begin + 160 < entry.words.length ? ' …' : '');
    return line;
  };
  const search = async () => {
    const words = plain(input.value).split(/\s+/).filter(Boolean);
    const typed = input.value;
    if (words.length === 0) {
      results.replaceChildren();
      said.hidden = true;
      return;
    }
    let entries;
    try { entries = await load(); } catch (error) { said.textContent = error.message; said.hidden = false; return; }
    if (input.value !== typed) return;
    const found = entries.map(entry => [score(entry, words), entry]).filter(([points]) => points > 0)
      .sort((a, b) => b[0] - a[0]).slice(0, 12);
    results.replaceChildren(...found.map(([, entry]) => element('li', {},
      element('a', { href: entry.href }, element('strong', {}, `${entry.lesson}, step ${entry.title}`), excerpt(entry, words)))));
    said.textContent = found.length ? found.length === 12 ? 'The first 12 steps found' : found.length === 1 ? '1 step found' : `${found.length} steps found` : `No step has ${words.join(' and ')}.`;
    said.hidden = found.length > 0;
  };
  document.addEventListener('keydown', event => {
    if (event.key !== '/' || event.ctrlKey || event.metaKey || event.altKey || event.target.matches('input, textarea, select')) return;
    event.preventDefault();
    input.focus();
  });
  input.addEventListener('focus', () => load().catch(() => {}));
  input.addEventListener('input', search);
  place.addEventListener('keydown', event => {
    const links = [...results.querySelectorAll('a')], here = links.indexOf(document.activeElement);
    if (event.key === 'Escape') { input.value = ''; search(); input.focus(); }
    else if (event.key === 'ArrowDown' && links.length) { event.preventDefault(); links[Math.min(here + 1, links.length - 1)].focus(); }
    else if (event.key === 'ArrowUp' && here >= 0) { event.preventDefault(); (here ? links[here - 1] : input).focus(); }
    else if (event.key === 'Enter' && document.activeElement === input && links.length) links[0].click();
  });
  document.addEventListener('pointerdown', event => { if (!closest(event, '.search')) results.replaceChildren(); });
  results.addEventListener('click', () => results.replaceChildren());
})();
