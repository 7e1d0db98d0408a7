// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pixels and counts: what the pictures are made of, and what is under the cursor.

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
