// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
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
