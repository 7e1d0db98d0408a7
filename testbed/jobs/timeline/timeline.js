// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A session to be played: decodes the motion that stands in the page, draws a step on a canvas, and tells of one body.
// All that is chosen stands in the address: #step=512&body=37.

(() => {
const element = (id) => document.getElementById(id);
const data = JSON.parse(element('timeline-data').textContent);
const text = atob(data.motion);
const bytes = new Uint8Array(text.length);
for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
const motion = new DataView(bytes.buffer);
const bodyCount = data.bodies.length, lastIndex = data.steps.length - 1, keyEvery = 64, gone = 0xffff;

// State: where every body is. Steps hold what changed; a copy is kept every so often to go back to.
const now = {index: -1, x: new Float32Array(bodyCount), y: new Float32Array(bodyCount), angle: new Float32Array(bodyCount),
  isThere: new Uint8Array(bodyCount), isAwake: new Uint8Array(bodyCount)};
const offsets = [], keys = [];
for (let at = 0; offsets.length <= lastIndex;) {
  offsets.push(at);
  at += 4 + 8 * motion.getUint32(at, true);
}
const apply = (index) => {
  let at = offsets[index];
  const count = motion.getUint32(at, true);
  for (at += 4; at < offsets[index] + 4 + 8 * count; at += 8) {
    const word = motion.getUint16(at, true), body = word & 0x7fff;
    const x = motion.getUint16(at + 2, true), y = motion.getUint16(at + 4, true), angle = motion.getUint16(at + 6, true);
    now.isThere[body] = x === gone && y === gone && angle === gone ? 0 : 1;
    now.isAwake[body] = word >> 15;
    now.x[body] = data.left + x / 65534 * data.width;
    now.y[body] = data.bottom + y / 65534 * data.height;
    now.angle[body] = angle / 65536 * 2 * Math.PI;
  }
  now.index = index;
};
const fields = ['x', 'y', 'angle', 'isThere', 'isAwake'];
const seek = (index) => {
  const key = Math.floor(index / keyEvery);
  if (now.index > index || key > Math.floor(now.index / keyEvery) && keys[key]) {
    const from = keys[Math.min(key, keys.length - 1)];
    for (const field of fields) now[field].set(from[field]);
    now.index = from.index;
  }
  while (now.index < index) {
    apply(now.index + 1);
    if (now.index % keyEvery === 0 && !keys[now.index / keyEvery]) {
      const key = {index: now.index};
      for (const field of fields) key[field] = now[field].slice();
      keys[now.index / keyEvery] = key;
    }
  }
};

// The picture.
const canvas = element('world'), pen = canvas.getContext('2d');
const camera = {x: 0, y: 0, scale: 1};
let chosen = -1, path = null;
const color = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const fit = () => {
  let [left, bottom, right, top] = data.view;
  camera.x = (left + right) / 2;
  camera.y = (bottom + top) / 2;
  camera.scale = 0.92 * Math.min(canvas.clientWidth / (right - left), canvas.clientHeight / (top - bottom));
};
const trace = (shape) => {
  if (shape.r !== undefined) {
    pen.moveTo(shape.x + shape.r, shape.y);
    pen.arc(shape.x, shape.y, shape.r, 0, 2 * Math.PI);
    pen.moveTo(shape.x, shape.y);
    pen.lineTo(shape.x + shape.r, shape.y);
    return;
  }
  for (let i = 0; i < shape.v.length; i += 2) {
    if (i === 0) pen.moveTo(shape.v[0], shape.v[1]); else pen.lineTo(shape.v[i], shape.v[i + 1]);
  }
  if (shape.v.length > 4) pen.closePath();
};
const draw = () => {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== width || canvas.height !== height) canvas.width = width, canvas.height = height;
  pen.setTransform(1, 0, 0, 1, 0, 0);
  pen.clearRect(0, 0, width, height);
  if (element('follow').checked && chosen >= 0) camera.x = now.x[chosen], camera.y = now.y[chosen];
  const colors = {static: color('--soft'), kinematic: color('--warning'), awake: color('--good'), asleep: color('--line-strong')};
  const scale = camera.scale * ratio;
  for (let body = 0; body < bodyCount; ++body) {
    if (!now.isThere[body]) continue;
    const cos = Math.cos(now.angle[body]) * scale, sin = Math.sin(now.angle[body]) * scale;
    pen.setTransform(cos, -sin, -sin, -cos, width / 2 + (now.x[body] - camera.x) * scale, height / 2 - (now.y[body] - camera.y) * scale);
    const type = data.bodies[body].type;
    const ink = body === chosen ? color('--bad') : colors[type] || colors[now.isAwake[body] ? 'awake' : 'asleep'];
    pen.beginPath();
    for (const shape of data.bodies[body].shapes) trace(shape);
    pen.globalAlpha = 0.25;
    pen.fillStyle = ink;
    pen.fill();
    pen.globalAlpha = 1;
    pen.lineWidth = (body === chosen ? 2 : 1) * ratio / scale;
    pen.strokeStyle = ink;
    pen.stroke();
  }
  drawPlot(ratio);
};

// One body over time.
const collect = (body) => {
  const back = now.index, collected = {x: new Float32Array(lastIndex + 1), y: new Float32Array(lastIndex + 1)};
  for (let i = 0; i <= lastIndex; ++i) {
    seek(i);
    collected.x[i] = now.isThere[body] ? now.x[body] : NaN;
    collected.y[i] = now.isThere[body] ? now.y[body] : NaN;
  }
  seek(back);
  collected.speed = collected.x.map((x, i) => i === 0 ? NaN :
    Math.hypot(x - collected.x[i - 1], collected.y[i] - collected.y[i - 1]) / (data.times[i] - data.times[i - 1] || NaN));
  return collected;
};
const plot = element('plot'), plotPen = plot.getContext('2d');
const drawPlot = (ratio) => {
  plot.width = plot.clientWidth * ratio;
  plot.height = plot.clientHeight * ratio;
  if (!path) return;
  const half = plot.height / 2;
  for (const [row, values, name] of [[0, path.y, 'height, m'], [1, path.speed, 'speed, m/s']]) {
    let low = Infinity, high = -Infinity;
    for (const value of values) if (value === value) low = Math.min(low, value), high = Math.max(high, value);
    plotPen.beginPath();
    let isDown = false;
    values.forEach((value, i) => {
      if (value !== value) { isDown = false; return; }
      const x = i / Math.max(lastIndex, 1) * plot.width;
      const y = (row + 1) * half - 4 - (value - low) / (high - low || 1) * (half - 18 * ratio);
      if (isDown) plotPen.lineTo(x, y); else plotPen.moveTo(x, y);
      isDown = true;
    });
    plotPen.strokeStyle = color(row === 0 ? '--good' : '--bad');
    plotPen.stroke();
    plotPen.fillStyle = color('--soft');
    plotPen.font = `${11 * ratio}px sans-serif`;
    plotPen.fillText(`${name}: ${low.toPrecision(3)} to ${high.toPrecision(3)}`, 4 * ratio, row * half + 12 * ratio);
  }
  const x = now.index / Math.max(lastIndex, 1) * plot.width;
  plotPen.beginPath();
  plotPen.moveTo(x, 0);
  plotPen.lineTo(x, plot.height);
  plotPen.strokeStyle = color('--ink');
  plotPen.stroke();
};
const nameOf = (body) => data.bodies[body].name ? `${data.bodies[body].name} (${data.bodies[body].index})` : `body ${data.bodies[body].index}`;
const tell = () => {
  element('where').textContent = `step ${data.steps[now.index]} · ${data.times[now.index].toFixed(2)} s`;
  element('step').value = now.index;
  const list = element('values');
  list.replaceChildren();
  if (chosen < 0) return;
  element('chosen').textContent = nameOf(chosen);
  const rows = now.isThere[chosen] ? [['type', data.bodies[chosen].type], ['x', now.x[chosen].toFixed(3) + ' m'], ['y', now.y[chosen].toFixed(3) + ' m'],
    ['angle', now.angle[chosen].toFixed(3) + ' rad'], ['speed', path.speed[now.index].toFixed(3) + ' m/s'],
    ['awake', now.isAwake[chosen] ? 'yes' : 'no']] : [['now', 'not there']];
  for (const [name, value] of rows) {
    const term = document.createElement('dt'), said = document.createElement('dd');
    term.textContent = name;
    said.textContent = value;
    list.append(term, said);
  }
};
const remember = () => history.replaceState(null, '', `#step=${data.steps[now.index]}${chosen >= 0 ? `&body=${data.bodies[chosen].index}` : ''}`);
const show = () => { draw(); tell(); };
const go = (index, isQuiet) => {
  seek(Math.max(0, Math.min(lastIndex, index)));
  show();
  if (!isQuiet) remember();
};
const choose = (body) => {
  chosen = body;
  path = body < 0 ? null : collect(body);
  if (body < 0) element('chosen').textContent = 'Click a body';
  show();
  remember();
};

// What a reader does.
const toWorld = (event) => {
  const box = canvas.getBoundingClientRect();
  return [camera.x + (event.clientX - box.left - box.width / 2) / camera.scale, camera.y - (event.clientY - box.top - box.height / 2) / camera.scale];
};
const bodyAt = (x, y) => {
  let best = -1, nearest = Infinity;
  for (let body = 0; body < bodyCount; ++body) {
    if (!now.isThere[body]) continue;
    const away = Math.hypot(now.x[body] - x, now.y[body] - y);
    const reach = data.bodies[body].reach + 4 / camera.scale;
    // What is small and near the click is meant, not the level around it.
    if (away <= reach && away * (1 + data.bodies[body].reach) < nearest) nearest = away * (1 + data.bodies[body].reach), best = body;
  }
  return best;
};
let press = null;
canvas.addEventListener('pointerdown', (event) => { press = {x: event.clientX, y: event.clientY, camera: {...camera}, isDrag: false}; canvas.setPointerCapture(event.pointerId); });
canvas.addEventListener('pointermove', (event) => {
  if (!press) return;
  press.isDrag = press.isDrag || Math.hypot(event.clientX - press.x, event.clientY - press.y) > 3;
  if (!press.isDrag) return;
  camera.x = press.camera.x - (event.clientX - press.x) / camera.scale;
  camera.y = press.camera.y + (event.clientY - press.y) / camera.scale;
  draw();
});
canvas.addEventListener('pointerup', (event) => {
  if (press && !press.isDrag) choose(bodyAt(...toWorld(event)));
  press = null;
});
canvas.addEventListener('wheel', (event) => {
  event.preventDefault();
  const [x, y] = toWorld(event), factor = Math.exp(-event.deltaY / 500);
  camera.scale *= factor;
  camera.x = x + (camera.x - x) / factor;
  camera.y = y + (camera.y - y) / factor;
  draw();
}, {passive: false});
plot.addEventListener('click', (event) => { if (path) go(Math.round(event.offsetX / plot.clientWidth * lastIndex)); });
let isPlaying = false, playedFrom = 0, playedAt = 0;
const setPlaying = (flag) => {
  isPlaying = flag;
  element('play').textContent = flag ? 'Pause' : 'Play';
  element('play').setAttribute('aria-pressed', flag);
  if (flag && now.index === lastIndex) go(0, true);
  playedFrom = data.times[now.index];
  playedAt = performance.now();
  if (flag) requestAnimationFrame(tick); else remember();
};
const tick = (at) => {
  if (!isPlaying) return;
  const time = playedFrom + Math.max(0, at - playedAt) / 1000 * Number(element('speed').value);
  let index = now.index;
  while (index < lastIndex && data.times[index + 1] <= time) ++index;
  if (index !== now.index) go(index, true);
  if (index === lastIndex) setPlaying(false); else requestAnimationFrame(tick);
};
element('play').addEventListener('click', () => setPlaying(!isPlaying));
element('speed').addEventListener('change', () => { if (isPlaying) setPlaying(true); });
element('fit').addEventListener('click', () => { fit(); draw(); });
element('follow').addEventListener('change', draw);
element('step').max = lastIndex;
element('step').addEventListener('input', () => { if (isPlaying) setPlaying(false); go(Number(element('step').value)); });
document.addEventListener('keydown', (event) => {
  if (event.target.tagName === 'SELECT' || event.target.id === 'step') return;
  const way = {ArrowLeft: -1, ArrowRight: 1}[event.key];
  if (event.key === ' ' && event.target.tagName !== 'BUTTON') event.preventDefault(), setPlaying(!isPlaying);
  if (way) event.preventDefault(), setPlaying(false), go(now.index + way * (event.shiftKey ? 10 : 1));
});
const indexOfStep = (step) => { const found = data.steps.findIndex((one) => one >= step); return found < 0 ? lastIndex : found; };
const placeOf = (index) => data.bodies.findIndex((body) => body.index === index);
const goToMoment = (moment) => { setPlaying(false); go(indexOfStep(moment.step)); if (moment.bodies.length > 0) choose(placeOf(moment.bodies[0])); };
for (const moment of data.moments) {
  const row = document.createElement('li'), button = document.createElement('button'), mark = document.createElement('button');
  button.textContent = moment.text;
  mark.title = moment.text;
  mark.style.left = `${100 * indexOfStep(moment.step) / Math.max(lastIndex, 1)}%`;
  for (const one of [button, mark]) one.type = 'button', one.addEventListener('click', () => goToMoment(moment));
  row.append(button);
  element('moments').append(row);
  element('marks').append(mark);
}
if (data.moments.length === 0) element('moments').textContent = 'None was found.';
const readAddress = () => {
  const asked = new URLSearchParams(location.hash.slice(1));
  go(asked.has('step') ? indexOfStep(Number(asked.get('step'))) : 0, true);
  if (asked.has('body')) choose(placeOf(Number(asked.get('body'))));
};
window.addEventListener('hashchange', readAddress);
window.addEventListener('resize', draw);
fit();
readAddress();
})();
