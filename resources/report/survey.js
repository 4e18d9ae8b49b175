// One selection for the plan, the tables, the slices and the 3-D view; filters of the stem table.
(() => {
  'use strict';
  const data = JSON.parse(document.getElementById('survey-data').textContent);
  const stems = new Map(data.stems.map(stem => [stem.id, stem]));
  const card = document.getElementById('tree'), tip = document.getElementById('tip');
  const of = id => document.querySelectorAll(`[data-tree="${CSS.escape(id)}"]`);
  const drawing = document.getElementById('view') && window.boleView3d
    ? window.boleView3d(data, id => select(id, 'view')) : null;
  let selected = null;

  const fixed = (value, digits) => value === null ? '\u2013' : value.toFixed(digits).replace('-', '\u2212');
  const diameter = s => fixed(s.dbh, 1) + (s.lo !== null && s.hi !== null ? ` \u00b1 ${fixed((s.hi - s.lo) / 2, 1)}` : '') + ' cm';
  const height = s => s.height === null ? '\u2013' : (s.seen ? '' : '\u2265 ') + fixed(s.height, 1) + ' m';

  function element(tag, text, parent) {
    const e = document.createElement(tag);
    e.textContent = text;
    if (parent) parent.append(e);
    return e;
  }

  // The slice that stands among all slices, once more.
  function sliceOf(id) {
    const source = document.querySelector(`.slices [data-tree="${CSS.escape(id)}"] svg`);
    if (!source) return null;
    const copy = source.cloneNode(true);
    for (const e of copy.querySelectorAll('[id]')) e.removeAttribute('id');
    copy.classList.add('slice');
    return copy;
  }

  function fillCard(id) {
    card.replaceChildren();
    card.hidden = id === null;
    if (id === null) return;
    const stem = stems.get(id);
    const close = element('button', '\u00d7', card);
    close.type = 'button';
    close.title = 'Close (Esc)';
    close.addEventListener('click', () => select(null));
    element('h3', `Tree ${id}`, card);
    const slice = sliceOf(id);
    if (slice) card.append(slice);
    element('div', `DBH ${diameter(stem)}`, card);
    element('div', `Height ${height(stem)}`, card);
    if (stem.quality) element('div', `Quality ${stem.quality}, state ${stem.state || 'auto'}`, card);
    if (stem.why) element('div', stem.why, card);
    if (!stem.inside) element('div', 'Outside the plot', card);
  }

  // Brings a row or slice into its own box without moving the page.
  function reveal(id) {
    for (const e of of(id)) {
      const box = e.closest('.scroll');
      if (!box) continue;
      const top = e.offsetTop - box.clientHeight / 2;
      box.scrollTop = Math.max(0, top);
    }
  }

  function select(id, from) {
    if (selected !== null) for (const e of of(selected)) e.classList.remove('selected');
    selected = id !== null && stems.has(id) ? id : null;
    if (selected !== null) {
      for (const e of of(selected)) e.classList.add('selected');
      if (from !== 'table') reveal(selected);
    }
    fillCard(selected);
    if (drawing) drawing.select(selected);
  }

  const treeAt = event => event.target.closest ? event.target.closest('[data-tree]') : null;
  let hovered = null;
  document.addEventListener('mouseover', event => {
    const id = treeAt(event)?.dataset.tree ?? null;
    if (id === hovered) return;
    if (hovered !== null) for (const e of of(hovered)) e.classList.remove('hover');
    hovered = id;
    if (id !== null) for (const e of of(id)) e.classList.add('hover');
    const stem = id === null ? null : stems.get(id);
    tip.hidden = !stem || !event.target.closest('svg.plan');
    if (stem) tip.textContent = `Tree ${id}: ${diameter(stem)}, ${height(stem)}`;
  });
  document.addEventListener('mousemove', event => {
    if (tip.hidden) return;
    tip.style.left = Math.min(event.clientX + 14, innerWidth - tip.offsetWidth - 8) + 'px';
    tip.style.top = (event.clientY + 18) + 'px';
  });
  document.addEventListener('click', event => {
    const e = treeAt(event);
    if (!e) return;
    const id = e.dataset.tree;
    select(id === selected ? null : id, e.tagName === 'TR' ? 'table' : 'other');
  });
  document.addEventListener('keydown', event => { if (event.key === 'Escape') select(null); });

  const find = document.getElementById('find'), quality = document.getElementById('quality'),
    onlyLook = document.getElementById('only-look'), shown = document.getElementById('shown');
  const rows = [...document.querySelectorAll('#stems tbody tr')];
  function filter() {
    const text = find.value.trim().toLowerCase();
    let count = 0;
    const hidden = new Set();
    for (const row of rows) {
      const stem = stems.get(row.dataset.tree);
      const fits = (!quality.value || stem.quality === quality.value) && (!onlyLook.checked || stem.look) &&
        (!text || stem.id === text || (isNaN(text) && stem.why.toLowerCase().includes(text)));
      row.hidden = !fits;
      row.classList.toggle('filtered', !fits);
      if (fits) ++count; else hidden.add(stem.id);
    }
    for (const e of document.querySelectorAll('.plan [data-tree]')) e.classList.toggle('dim', hidden.has(e.dataset.tree));
    for (const e of document.querySelectorAll('.slices [data-tree]')) {
      e.hidden = hidden.has(e.dataset.tree);
      e.classList.toggle('filtered', e.hidden);
    }
    shown.textContent = `${count} of ${rows.length} shown`;
  }
  if (find) {
    for (const e of [find, quality, onlyLook]) e.addEventListener('input', filter);
    filter();
  }
  const asked = /^#tree-(.+)$/.exec(decodeURIComponent(location.hash));
  if (asked) select(asked[1]);
})();
