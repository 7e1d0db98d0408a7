// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The page of compared pictures: a list of cases, one of them open. What is shown is a function of `view`; every action
// changes it and shows again. Pixels are read from the embedded pictures, counts from the colours by which they were
// drawn.

(() => {
const data = JSON.parse(document.getElementById('snapshot-data').textContent);
const sides = ['expected', 'actual'];
const modes = [['side', 'Side by side'], ['slider', 'Slider'], ['blink', 'Blink'], ['difference', 'Difference'],
  ['counts', 'Counts']];
const blinkMs = 600;
const cases = data.cases;
const statuses = [...new Set(cases.map((one) => one.status))];
const isClean = statuses.every((status) => status === 'equal');
const view = {
  search: '', statuses: new Set(statuses.filter((status) => isClean || status !== 'equal')), order: 'list',
  open: null, mode: 'side', zoom: 'fit', marks: true, slide: 50, blinking: true, shown: 'expected',
  cursor: null, timer: 0, pixels: {}, colors: {}, most: 0,
};
const byId = (id) => document.getElementById(id);

/** make('div', {class: 'a', onclick: f}, child, 'text', …); null children and attributes are left out. */
function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === null || value === false) continue;
    if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else element.setAttribute(key, value === true ? '' : value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}
/** Text with code in back quotes. */
const inline = (text) => text.split('`').map((part, i) => (i % 2 ? make('code', {}, part) : part));
/** Equal pixels over another state are worth a warning: the next change may show. */
function badge(one) {
  if (one.status !== 'equal') return make('span', {class: 'badge bad'}, `✗ ${one.status}`);
  if (one.structure && !one.structure.equal) return make('span', {class: 'badge warning'}, '! equal, state changed');
  return make('span', {class: 'badge good'}, '✓ equal');
}
const number = (value) => value.toLocaleString('en');
const picture = (one, side) => one.embedded[side]?.picture ?? null;
const time = (one) => one.ms.simulate + one.ms.render + one.ms.compare;

// The list.

function listed() {
  const found = cases.filter((one) => view.statuses.has(one.status) &&
    page.matches(`${one.id} ${one.status} ${one.kind ?? ''} ${one.layers ?? ''} ${one.message}`, view.search.trim()));
  if (view.order === 'pixels') found.sort((a, b) => b.changed_pixels - a.changed_pixels);
  if (view.order === 'time') found.sort((a, b) => time(b) - time(a));
  return found;
}

function makeRow(one) {
  const source = one.embedded.difference ?? picture(one, 'actual') ?? picture(one, 'expected');
  const note = one.changed_pixels > 0 ? `${number(one.changed_pixels)} px` : `${time(one).toFixed(0)} ms`;
  return make('div', {class: 'case', role: 'option', id: `case-${cases.indexOf(one)}`, 'data-id': one.id,
    'data-status': one.status, 'aria-selected': one === view.open ? 'true' : 'false', onclick: () => open(one)},
    source ? make('img', {class: 'thumb', src: source, alt: '', loading: 'lazy'}) : make('span', {class: 'thumb none'}),
    make('div', {class: 'words'}, make('div', {class: 'name'}, ...one.id.split(/(?<=[/-])/).flatMap((w) => [w, make('wbr')])),
      make('div', {class: 'note'}, badge(one), note)));
}

function showList() {
  const found = listed();
  byId('cases').replaceChildren(...found.map(makeRow));
  if (found.length === 0) byId('cases').append(make('p', {class: 'none'}, 'No case matches.'));
  byId('shown').value = `${found.length} of ${cases.length}`;
  if (view.open) byId('cases').setAttribute('aria-activedescendant', `case-${cases.indexOf(view.open)}`);
}

function showChips() {
  byId('chips').replaceChildren(...statuses.map((status) => make('button', {
    type: 'button', class: 'chip', 'data-status': status, 'aria-pressed': String(view.statuses.has(status)),
    onclick: () => {
      if (!view.statuses.delete(status)) view.statuses.add(status);
      showChips();
      showList();
    },
  }, `${status} ${cases.filter((one) => one.status === status).length}`)));
}

function step(by) {
  const found = listed();
  if (found.length === 0) return;
  const at = found.indexOf(view.open);
  open(found[Math.min(Math.max(at + by, 0), found.length - 1)]);
  document.querySelector('.case[aria-selected="true"]').scrollIntoView({block: 'nearest'});
}

// The open case.

/** The modes that make sense: a comparison needs both pictures, a difference also equal sizes. */
function isPossible(mode) {
  if (mode === 'side') return true;
  if (mode === 'difference') return view.open.embedded.difference !== null;
  if (mode === 'counts') {
    const {expected, actual} = view.open;
    return sides.every((side) => view.colors[side]) && expected.width === actual.width && expected.height === actual.height;
  }
  return picture(view.open, 'expected') !== null && picture(view.open, 'actual') !== null;
}

function open(one) {
  view.open = one;
  view.cursor = null;
  view.pixels = {};
  view.colors = {};
  for (const side of sides) {
    view.colors[side] = readColors(one.embedded[side]?.colors);
    readPixels(one, side);
  }
  if (!isPossible(view.mode)) view.mode = 'side';
  delete byId('detail').dataset.ready;
  history.replaceState(null, '', `#${encodeURIComponent(one.id)}`);
  showList();
  showDetail();
}

function makeAccept(one) {
  if (!one.update) return null;
  return make('div', {class: 'accept'}, make('h3', {}, 'Accept this picture'),
    make('div', {class: 'code'}, make('pre', {id: 'update'}, one.update), make('button', {type: 'button'}, 'Copy')));
}

function showDetail() {
  const one = view.open;
  if (!one) {
    byId('detail').replaceChildren(make('p', {class: 'none'}, 'Choose a case in the list.'));
    return;
  }
  const facts = [one.scene && `${one.scene}, size ${one.size}`, one.scene && `step ${one.step}`,
    one.layers && (one.kind === 'overlap' ? `overlap of ${one.layers} nodes` : one.layers.replaceAll(',', ', ')),
    one.changed_pixels > 0 && `${number(one.changed_pixels)} pixels changed, a channel by up to ${one.max_difference}`];
  byId('detail').replaceChildren(
    make('header', {}, make('h2', {}, one.id, ' ', badge(one)),
      make('p', {class: 'message'}, ...inline(one.message)),
      make('p', {class: 'facts'}, facts.filter(Boolean).join(' · '))),
    ...makeViewer(one), makeAccept(one) ?? '', make('div', {class: 'below'}, makeStructure(one), makeMakers(one)));
  showStage();
  moveCursor(null);
}

function makeViewer(one) {
  if (!sides.some((side) => picture(one, side))) {
    return [make('p', {class: 'none'}, one.status === 'equal' ? 'The pictures are equal and were not kept in the report.'
      : 'There is no picture to show.')];
  }
  return [makeToolbar(), make('div', {id: 'readout', role: 'status'}), make('div', {id: 'stage', tabindex: '0', role: 'group',
    'aria-label': 'Pictures; arrow keys move the cursor'})];
}

function makeToolbar() {
  const zoom = make('select', {class: 'field', id: 'zoom', onchange: (event) => {
    view.zoom = event.target.value;
    showStage();
  }}, ...['fit', '1', '2', '4', '8'].map((size) =>
    make('option', {value: size, selected: size === view.zoom}, size === 'fit' ? 'Fit' : `${size}×`)));
  return make('div', {class: 'toolbar'},
    make('div', {class: 'modes', role: 'radiogroup', 'aria-label': 'View'}, ...modes.map(([mode, title], i) =>
      make('button', {type: 'button', role: 'radio', 'data-mode': mode, 'aria-checked': String(mode === view.mode),
        title: `${title} (${i + 1})`, disabled: !isPossible(mode), onclick: () => setMode(mode)}, title))),
    make('label', {}, 'Zoom ', zoom),
    make('label', {}, make('input', {type: 'checkbox', id: 'marks', checked: view.marks, onchange: (event) => {
      view.marks = event.target.checked;
      showStage();
    }}), ' Outline changes and masks'));
}

function setMode(mode) {
  if (!view.open || !isPossible(mode)) return;
  view.mode = mode;
  for (const button of document.querySelectorAll('.modes [data-mode]')) {
    button.setAttribute('aria-checked', String(button.dataset.mode === mode));
  }
  showStage();
}

// The stage: one or two frames; a frame holds pictures of one size on each other.

function frameSize(side) {
  const one = view.open;
  const of = side === 'both' ? sides.map((s) => one[s]).filter(Boolean) : [one[side] ?? one.expected ?? one.actual];
  return [Math.max(...of.map((s) => s.width)), Math.max(...of.map((s) => s.height))];
}

function makeMark(area, className, title, width, height) {
  const [x0, y0, x1, y1] = area;
  return make('span', {class: `mark ${className}`, title, style: `left:${(100 * x0) / width}%;top:${(100 * y0) / height}%;` +
    `width:${(100 * (x1 - x0)) / width}%;height:${(100 * (y1 - y0)) / height}%`});
}

function makeFrame(side, title, images) {
  const [width, height] = frameSize(side);
  const one = view.open;
  const marks = !view.marks || side === 'none' ? [] : [
    ...(one.box ? [makeMark(one.box, 'changed', 'around the changed pixels', width, height)] : []),
    ...one.rule.mask.map((area) => makeMark(area, 'masked', 'mask: does not count', width, height))];
  const own = (name) => frameSize(sides.includes(name) ? name : 'both');
  const pictures = images.map((name) => {
    const source = {difference: () => one.embedded.difference, counts: drawCounts}[name]?.() ?? picture(one, name);
    const [w, h] = own(name);
    return make('img', {'data-side': name, src: source, alt: `${name} picture of ${one.id}`, draggable: 'false',
      style: `width:${(100 * w) / width}%;height:${(100 * h) / height}%`});
  });
  const style = view.zoom === 'fit' ? `--natural:${width}px;--ratio:${width / height};aspect-ratio:${width}/${height}`
    : `width:${width * Number(view.zoom)}px;aspect-ratio:${width}/${height}`;
  return make('div', {class: 'frame-box'}, make('div', {class: 'frame-title'}, title),
    make('div', {class: `frame ${view.zoom === 'fit' ? 'fit' : ''}`, 'data-width': width, 'data-height': height, style,
      onpointermove: pointAt, onpointerleave: () => moveCursor(null), onpointerdown: dragSlider},
    ...pictures, ...marks, make('span', {class: 'cross', hidden: true})));
}

const makeEmpty = (side) => make('div', {class: 'frame-box'}, make('div', {class: 'frame-title'}, side),
  make('div', {class: 'frame empty'}, side === 'expected' ? 'no reference picture' : 'no picture was made'));

const stages = {
  side: () => sides.map((side) => (picture(view.open, side) ? makeFrame(side, side, [side]) : makeEmpty(side))),
  slider: () => [makeFrame('both', 'left of the line expected, right of it actual', ['expected', 'actual']),
    make('input', {type: 'range', id: 'slider', min: 0, max: 100, step: 0.5, value: view.slide,
      'aria-label': 'Where the actual picture begins', oninput: (event) => slideTo(Number(event.target.value))})],
  blink: () => [makeFrame('both', '', ['expected', 'actual']),
    make('div', {class: 'blink-tools'}, make('button', {type: 'button', class: 'chip', id: 'pause', onclick: pause}),
      make('button', {type: 'button', class: 'chip', id: 'swap', onclick: () => { stopBlinking(); swap(); }}, 'Swap'))],
  difference: () => [makeFrame('both', 'yellow to red: changed, little to much · blue: within the tolerance · green: under the mask',
    ['difference'])],
  counts: () => (sides.every((side) => view.pixels[side]) ? [makeFrame('both', '', ['counts'])] : []),
};

function showStage() {
  clearInterval(view.timer);
  const stage = byId('stage');
  if (!stage) return;
  stage.dataset.mode = view.mode;
  stage.replaceChildren(...stages[view.mode]());
  if (view.mode === 'slider') slideTo(view.slide);
  if (view.mode === 'counts' && stage.firstChild) {
    stage.querySelector('.frame-title').textContent = `tree nodes over each pixel, actual − expected: blue fewer, red more, by up to ${view.most}`;
  }
  if (view.mode === 'blink') {
    view.blinking = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    show('expected');
    if (view.blinking) view.timer = setInterval(swap, blinkMs);
  }
  showCross();
}

function slideTo(percent) {
  view.slide = percent;
  const frame = document.querySelector('#stage .frame');
  frame.style.setProperty('--slide', `${percent}%`);
  byId('slider').value = percent;
}

function dragSlider(event) {
  if (view.mode !== 'slider') return;
  const frame = event.currentTarget;
  const follow = (move) => {
    const box = frame.getBoundingClientRect();
    slideTo(Math.min(Math.max((100 * (move.clientX - box.left)) / box.width, 0), 100));
  };
  follow(event);
  frame.setPointerCapture(event.pointerId);
  frame.addEventListener('pointermove', follow);
  frame.addEventListener('pointerup', () => frame.removeEventListener('pointermove', follow), {once: true});
}

function show(side) {
  view.shown = side;
  const stage = byId('stage');
  stage.dataset.shown = side;
  stage.querySelector('.frame-title').textContent = side;
  byId('pause').textContent = view.blinking ? 'Pause' : 'Blink';
}
const swap = () => show(view.shown === 'expected' ? 'actual' : 'expected');
function stopBlinking() {
  clearInterval(view.timer);
  view.blinking = false;
}
function pause() {
  const resume = !view.blinking;
  stopBlinking();
  view.blinking = resume;
  if (resume) view.timer = setInterval(swap, blinkMs);
  show(view.shown);
}

// Pixels and counts.

/** Hex digits of the colours of counts 0, 1, 2, … → colour to [least, largest count of that colour]. */
function readColors(digits) {
  if (!digits) return null;
  const counts = new Map();
  for (let count = 0; count * 6 < digits.length; ++count) {
    const color = digits.slice(count * 6, count * 6 + 6);
    counts.set(color, [counts.get(color)?.[0] ?? count, count]);
  }
  return counts;
}

async function readPixels(one, side) {
  const source = picture(one, side);
  if (!source) return;
  const image = new Image();
  image.src = source;
  await image.decode();
  const canvas = make('canvas', {width: image.naturalWidth, height: image.naturalHeight});
  const context = canvas.getContext('2d', {willReadFrequently: true});
  context.drawImage(image, 0, 0);
  const pixels = context.getImageData(0, 0, canvas.width, canvas.height);
  if (view.open !== one) return;
  view.pixels[side] = pixels;
  byId('detail').dataset.ready = one.id;
  if (view.mode === 'counts') showStage();
  showReadout();
}

/** The difference of counts as a picture: dark where none, blue to light for fewer, red to light for more nodes now, grey
 *  where a colour stands for no single count. Unlike the colours it does not depend on the scale of either picture. */
function drawCounts() {
  const {expected, actual} = view.pixels, {width, height} = expected;
  const colorAt = (pixels, at) => (1 << 24 | pixels.data[at] << 16 | pixels.data[at + 1] << 8 | pixels.data[at + 2]).toString(16).slice(1);
  const countAt = (side, at) => {
    const range = view.colors[side].get(colorAt(view.pixels[side], at));
    return range && range[0] === range[1] ? range[0] : null;
  };
  const changes = new Array(width * height);
  for (let i = 0; i < changes.length; ++i) {
    const before = countAt('expected', 4 * i), after = countAt('actual', 4 * i);
    changes[i] = before === null || after === null ? null : after - before;
  }
  view.most = changes.reduce((most, change) => Math.max(most, Math.abs(change)), 0);
  const image = new ImageData(width, height);
  const fewer = [[49, 106, 196], [170, 214, 255]], more = [[200, 52, 42], [255, 206, 170]];
  changes.forEach((change, i) => {
    const ends = change < 0 ? fewer : more, share = view.most > 1 ? (Math.abs(change) - 1) / (view.most - 1) : 0;
    const color = change === null ? [90, 90, 90] : change === 0 ? [40, 40, 40]
      : [0, 1, 2].map((k) => ends[0][k] + (ends[1][k] - ends[0][k]) * share);
    image.data.set([...color, 255], 4 * i);
  });
  const canvas = make('canvas', {width, height});
  canvas.getContext('2d').putImageData(image, 0, 0);
  return canvas.toDataURL();
}

/** {color: 'rrggbb', count: text or null} of one place; null outside. */
function sample(side) {
  const pixels = view.pixels[side], {x, y} = view.cursor;
  if (!pixels || x >= pixels.width || y >= pixels.height) return null;
  const at = 4 * (y * pixels.width + x);
  const color = [0, 1, 2].map((i) => pixels.data[at + i].toString(16).padStart(2, '0')).join('');
  const range = view.colors[side]?.get(color);
  return {color, range, channels: [...pixels.data.slice(at, at + 3)],
    count: range ? (range[0] === range[1] ? `${range[0]}` : `${range[0]}–${range[1]}`) : null};
}

function showReadout() {
  const readout = byId('readout');
  if (!readout) return;
  if (!view.cursor) {
    readout.replaceChildren(make('span', {class: 'none'}, 'Point at a picture to read its pixels' +
      (view.colors.actual || view.colors.expected ? ' and the number of tree nodes over them.' : '.')));
    return;
  }
  const found = {expected: sample('expected'), actual: sample('actual')};
  const describe = (side) => {
    const one = found[side];
    return make('span', {class: 'sample', 'data-side': side}, make('b', {}, side),
      make('i', {class: 'swatch', style: one ? `background:#${one.color}` : ''}),
      make('span', {class: 'color'}, one ? `#${one.color}` : 'outside'),
      one && view.colors[side] ? make('span', {class: 'count'}, one.count === null ? 'no count here (label)' : `count ${one.count}`) : null);
  };
  const {expected, actual} = found;
  let change = null;
  if (expected && actual) {
    const most = Math.max(...[0, 1, 2].map((i) => Math.abs(expected.channels[i] - actual.channels[i])));
    const counts = expected.range && actual.range && expected.range[0] === expected.range[1] && actual.range[0] === actual.range[1]
      ? actual.range[0] - expected.range[0] : null;
    const signed = counts === null ? '' : `count ${counts > 0 ? '+' : counts < 0 ? '−' : '±'}${Math.abs(counts)}, `;
    change = make('span', {class: `change ${most === 0 ? '' : 'bad'}`}, most === 0 && !counts ? 'same' : `${signed}channel ${most}`);
  }
  const isMasked = view.open.rule.mask.some(([x0, y0, x1, y1]) =>
    view.cursor.x >= x0 && view.cursor.x < x1 && view.cursor.y >= y0 && view.cursor.y < y1);
  readout.replaceChildren(make('span', {class: 'place'}, `x ${view.cursor.x}  y ${view.cursor.y}`),
    describe('expected'), describe('actual'), change ?? '', isMasked ? make('span', {class: 'none'}, 'under the mask') : '');
}

function showCross() {
  for (const frame of document.querySelectorAll('#stage .frame:not(.empty)')) {
    const cross = frame.querySelector('.cross');
    cross.hidden = view.cursor === null;
    if (!view.cursor) continue;
    cross.style.left = `${(100 * (view.cursor.x + 0.5)) / frame.dataset.width}%`;
    cross.style.top = `${(100 * (view.cursor.y + 0.5)) / frame.dataset.height}%`;
  }
}

function moveCursor(cursor) {
  view.cursor = cursor;
  showCross();
  showReadout();
}

function pointAt(event) {
  const frame = event.currentTarget, box = frame.getBoundingClientRect();
  const place = (offset, length, pixels) => Math.min(Math.max(Math.floor((offset / length) * pixels), 0), pixels - 1);
  moveCursor({x: place(event.clientX - box.left, box.width, Number(frame.dataset.width)),
    y: place(event.clientY - box.top, box.height, Number(frame.dataset.height))});
}

// Structure, makers.

/** heads: [name, is a number]; rows: {cells, differs(column)}. */
function makeTable(id, heads, rows) {
  const makeCell = (row, text, i) => make('td', {'data-v': heads[i][1] ? text : null,
    class: [heads[i][1] && 'number', row.differs?.(i) && 'differs'].filter(Boolean).join(' ') || null},
  typeof text === 'number' ? number(text) : text);
  const head = make('tr', {}, ...heads.map(([name, isNumber]) => make('th', {scope: 'col', 'aria-sort': 'none',
    class: isNumber ? 'number' : null}, make('button', {type: 'button'}, name))));
  return make('div', {class: 'table-box', tabindex: '0', role: 'region', 'aria-label': id}, make('table', {id},
    make('thead', {}, head),
    make('tbody', {}, ...rows.map((row) => make('tr', {}, ...row.cells.map((text, i) => makeCell(row, text, i)))))));
}

const formatBody = (b) => `(${b.x}, ${b.y}) m, ${b.angle} rad, ${b.awake ? 'awake' : 'asleep'}`;
const formatNode = (n) => `level ${n.level}, [${n.box.join(', ')}] m`;
const formatContact = (c) => `${c.touching ? 'touching' : 'apart'}, ${c.points} point${c.points === 1 ? '' : 's'}`;
const kinds = [['bodies', (e) => `body ${e.index}`, formatBody], ['nodes', (e) => `node ${e.index}`, formatNode],
  ['contacts', (e) => `bodies ${e.bodies.join(' – ')}, fixtures ${e.fixtures.join(' – ')}`, formatContact]];

function makeStructure(one) {
  const box = make('div', {id: 'structure'}, make('h3', {}, 'Structure'));
  const isCompared = sides.every((side) => one.embedded[side]?.structured);
  if (!one.structure && !isCompared) {
    box.append(make('p', {class: 'none'}, one.status === 'equal' ? 'Equal.' : 'Not compared: a side has no description of its structure.'));
    return box;
  }
  if (!one.structure || one.structure.equal) {
    box.append(make('p', {}, 'Bodies, tree nodes and contacts are the same bit for bit: what differs is how they were drawn.'));
    return box;
  }
  box.append(makeTable('structure-counts',
    [['', false], ['expected', true], ['actual', true], ['changed', true], ['added', true], ['removed', true]],
    kinds.map(([kind]) => {
      const c = one.structure[kind];
      return {cells: [kind, c.expected, c.actual, c.changed, c.added, c.removed], differs: (i) => i > 2 && [c.changed, c.added, c.removed][i - 3] > 0};
    })));
  for (const [kind, name, format] of kinds) {
    const part = one.structure[kind], total = part.changed + part.added + part.removed;
    if (part.list.length === 0) continue;
    const of = (e, side) => (e[side] ? format(e[side]) : e.change === 'changed' ? 'not kept' : '–');
    const more = total > part.list.length ? `, first ${part.list.length} of ${number(total)}` : ` (${number(total)})`;
    box.append(make('details', {class: 'changes', 'data-kind': kind}, make('summary', {}, `${kind} that differ${more}`),
      makeTable(`structure-${kind}`, [[kind, false], ['change', false], ['expected', false], ['actual', false]],
        part.list.map((e) => ({cells: [name(e), e.change, of(e, 'expected'), of(e, 'actual')]})))));
  }
  return box;
}

function makeMakers(one) {
  const makers = sides.map((side) => one.embedded[side]?.maker ?? null);
  const keys = [...new Set(makers.flatMap((maker) => Object.keys(maker ?? {})))];
  const rule = one.rule, ms = one.ms;
  const format = (value) => (typeof value === 'number' ? String(Math.round(value * 1e4) / 1e4) : String(value ?? '–'));
  const rows = keys.map((key) => {
    const values = makers.map((maker) => format(maker?.[key]));
    return {cells: [key.replaceAll('_', ' '), ...values], differs: (i) => i > 0 && makers[0] && makers[1] && values[0] !== values[1]};
  });
  const ruleText = [rule.tolerance === 0 ? 'exact' : `channels may differ by ${rule.tolerance}`,
    rule.mask.length ? `${rule.mask.length} masked area${rule.mask.length > 1 ? 's' : ''}` : 'no mask',
    rule.tolerated_pixels ? `${number(rule.tolerated_pixels)} pixels tolerated` : null,
    rule.masked_pixels ? `${number(rule.masked_pixels)} differing pixels masked` : null].filter(Boolean).join(', ');
  return make('div', {id: 'makers'}, make('h3', {}, 'How they were made and compared'),
    make('dl', {class: 'lines'}, make('dt', {}, 'rule'), make('dd', {id: 'rule'}, ruleText, ` (${rule.source})`,
      rule.reason ? make('div', {class: 'none'}, rule.reason) : null),
    make('dt', {}, 'time'), make('dd', {id: 'times'}, `simulate ${ms.simulate.toFixed(1)} ms, render ${ms.render.toFixed(1)} ms, ` +
      `compare ${ms.compare.toFixed(1)} ms`)),
    rows.length ? makeTable('made', [['', false], ['expected', false], ['actual', false]], rows) : null);
}

// Keyboard.

function moveByKey(key, fast) {
  const frame = document.querySelector('#stage .frame:not(.empty)');
  if (!frame) return;
  const [dx, dy] = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[key];
  const width = Number(frame.dataset.width), height = Number(frame.dataset.height), by = fast ? 10 : 1;
  const from = view.cursor ?? {x: Math.floor(width / 2), y: Math.floor(height / 2)};
  moveCursor({x: Math.min(Math.max(from.x + dx * by, 0), width - 1), y: Math.min(Math.max(from.y + dy * by, 0), height - 1)});
}

document.addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  if (event.target.matches('input, select')) {
    if (event.key === 'Escape') event.target.blur();
    return;
  }
  const onStage = event.target.id === 'stage' && event.key.startsWith('Arrow');
  if (onStage) moveByKey(event.key, event.shiftKey);
  else if (event.key === 'ArrowDown') step(1);
  else if (event.key === 'ArrowUp') step(-1);
  else if (event.key === '/') byId('search').focus();
  else if (event.key === ' ' && view.mode === 'blink' && !event.target.matches('button, summary')) pause();
  else if (modes[Number(event.key) - 1]) setMode(modes[Number(event.key) - 1][0]);
  else return;
  event.preventDefault();
});

byId('search').addEventListener('input', (event) => {
  view.search = event.target.value;
  showList();
});
byId('order').addEventListener('change', (event) => {
  view.order = event.target.value;
  showList();
});
showChips();
showList();
const wanted = cases.find((one) => one.id === decodeURIComponent(location.hash.slice(1))) ?? listed()[0];
if (wanted) open(wanted);
else showDetail();
})();
