// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The page of compared pictures: a list of cases, one of them open. What is shown is a function of `view`; every action
// changes it and shows again. Pixels are read from the embedded pictures, counts from the colours by which they were
// drawn. The parts, in this order, are joined into one function: snapshot.js, the list and the open case;
// snapshot_stage.js, the pictures; snapshot_pixels.js, colours and counts; snapshot_structure.js, what changed in the
// world; snapshot_start.js, keyboard and start.

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
    one.changed_pixels > 0 && !one.message.includes('pixel') &&
      `${number(one.changed_pixels)} pixels changed, a channel by up to ${one.max_difference}`];
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
