// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Curves over the whole session: one row for each quantity, one curve for each lane. A click or a drag goes to that step.

const laneColors = () => [colors.awake, colors.chosen, colors.kinematic, colors.soft];
const shown = (value) => value !== value ? '–' : Math.abs(value) >= 1e5 || value !== 0 && Math.abs(value) < 1e-3 ? value.toExponential(2) :
  Number(value.toPrecision(4)).toString();

class Plot {
  /** `curves`: {lane, values by step}; `goTo(share of the bar)` is called for a click. */
  constructor(parent, name, unit, curves, goTo) {
    this.curves = curves;
    this.name = name;
    this.unit = unit;
    this.row = document.createElement('div');
    this.row.className = 'plot';
    this.label = document.createElement('div');
    this.label.className = 'plot-label';
    this.canvas = document.createElement('canvas');
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', `${name} over time`);
    this.cursor = document.createElement('div');
    this.cursor.className = 'cursor';
    const box = document.createElement('div');
    box.className = 'plot-box';
    box.append(this.canvas, this.cursor);
    this.row.append(this.label, box);
    parent.append(this.row);
    const go = (event) => {
      const area = box.getBoundingClientRect();
      goTo(Math.max(0, Math.min(1, (event.clientX - area.left - barInset) / (area.width - 2 * barInset))));
    };
    box.addEventListener('pointerdown', (event) => { box.setPointerCapture(event.pointerId); go(event); });
    box.addEventListener('pointermove', (event) => { if (event.buttons & 1) go(event); });
  }
  /** Once, and when the size or the theme changed. */
  draw() {
    const {canvas, curves} = this, ratio = window.devicePixelRatio || 1, pen = canvas.getContext('2d');
    this.width = canvas.clientWidth;
    canvas.width = Math.max(1, Math.round(this.width * ratio));
    canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    let low = Infinity, high = -Infinity;
    for (const {values} of curves) for (const value of values) if (Number.isFinite(value)) low = Math.min(low, value), high = Math.max(high, value);
    this.isEmpty = low > high;
    if (this.isEmpty) return;
    if (low === high) low -= 0.5, high += 0.5;
    this.range = [low, high];
    const inset = barInset * ratio, width = canvas.width - 2 * inset, height = canvas.height - 4 * ratio;
    const toScreen = (value) => 2 * ratio + (high - value) / (high - low) * height;
    if (low < 0 && high > 0) {
      pen.strokeStyle = colors.line;
      pen.beginPath();
      pen.moveTo(inset, toScreen(0));
      pen.lineTo(inset + width, toScreen(0));
      pen.stroke();
    }
    curves.forEach(({lane, values}) => {
      pen.strokeStyle = laneColors()[lane.number % 4];
      pen.lineWidth = 1.3 * ratio;
      pen.beginPath();
      // Several steps on a pixel: their lowest and highest value.
      let column = -1, least = 0, most = 0, isDown = false;
      const flush = () => {
        if (column < 0) return;
        if (isDown) pen.lineTo(column, toScreen(least)); else pen.moveTo(column, toScreen(least));
        if (most > least) pen.lineTo(column, toScreen(most));
        isDown = true;
        column = -1;
      };
      for (let i = 0; i < values.length; ++i) {
        const value = values[i];
        if (!Number.isFinite(value)) { flush(); isDown = false; continue; }
        const x = Math.round(inset + shareOf(lane, i) * width);
        if (x === column) least = Math.min(least, value), most = Math.max(most, value);
        else { flush(); column = x; least = most = value; }
      }
      flush();
      pen.stroke();
    });
  }
  point(share) { this.cursor.style.transform = `translateX(${barInset + share * (this.width - 2 * barInset)}px)`; }
  /** What it is now. */
  tell() {
    const values = this.curves.map(({lane, values}) => shown(values[lane.now.index]));
    const text = `${this.name}${this.unit ? `, ${this.unit}` : ''}`;
    const numbers = Object.assign(document.createElement('span'), {className: 'numbers'});
    this.label.replaceChildren(Object.assign(document.createElement('span'), {textContent: text}), numbers);
    values.forEach((value, i) => {
      const said = document.createElement('b');
      said.textContent = value;
      if (lanes.length > 1) said.style.color = laneColors()[this.curves[i].lane.number % 4];
      numbers.append(said);
    });
    if (this.range) {
      const range = document.createElement('span');
      range.className = 'range';
      range.textContent = `${shown(this.range[0])} to ${shown(this.range[1])}`;
      this.label.append(range);
    }
  }
  remove() { this.row.remove(); }
}
/** Half of the thumb of the bar, px: curves begin where its middle does. */
const barInset = 8;
/** Where a step of a lane lies on the bar, 0 … 1. */
const shareOf = (lane, index) => {
  const main = lanes[0];
  if (main.last === 0) return 0;
  return (lane === main || lane.times[index] === main.times[index] ? index : main.indexAt(lane.times[index])) / main.last;
};

const worldNames = {step: ['Step', 'ms'], broadPhase: ['Broad phase', 'ms'], narrowPhase: ['Narrow phase', 'ms'], solver: ['Solver', 'ms'],
  continuous: ['Continuous', 'ms'], contacts: ['Contacts that touch', ''], awake: ['Awake bodies', ''], energy: ['Kinetic energy', 'J'],
  overlap: ['Deepest overlap', 'm']};

/** Series of a body in a lane, by step. */
const collectBodies = (lane, bodies) => {
  const count = lane.last + 1, found = new Map();
  for (const body of bodies) found.set(body, Object.fromEntries(['x', 'y', 'angle', 'speed', 'spin', 'energy'].map((name) => [name, new Float32Array(count).fill(NaN)])));
  lane.each((index, state) => {
    for (const [body, series] of found) {
      if (!(state.flags[body] & isThere) || state.flags[body] & isNoNumber) continue;
      const speed = Math.hypot(state.vx[body], state.vy[body]) * unit, spin = state.spin[body] * spinUnit;
      series.x[index] = toX(state.x[body]);
      series.y[index] = toY(state.y[body]);
      series.angle[index] = toAngle(state.angle[body]);
      series.speed[index] = speed;
      series.spin[index] = spin;
      series.energy[index] = 0.5 * (data.bodies[body].mass * speed * speed + data.bodies[body].inertia * spin * spin);
    }
  });
  return found;
};
/** Impulse and depth between two bodies by step. */
const collectContact = (lane, [a, b]) => {
  const count = lane.last + 1, series = {impulse: new Float32Array(count), depth: new Float32Array(count).fill(NaN)};
  lane.each((index, state) => {
    for (const contact of lane.readContacts(index, state)) {
      if (contact.a !== a || contact.b !== b) continue;
      for (const point of contact.points) {
        series.impulse[index] += point.impulse;
        series.depth[index] = Math.max(series.depth[index] || -Infinity, -point.separation);
      }
    }
  });
  return series;
};
const collectJoint = (lane, joint) => {
  const series = new Float32Array(lane.last + 1).fill(NaN);
  for (let index = 0; index <= lane.last; ++index) {
    const length = lane.readJoints(index).get(joint);
    if (length !== undefined) series[index] = length;
  }
  return series;
};
