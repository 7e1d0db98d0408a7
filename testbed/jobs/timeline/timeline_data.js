// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What stands in the page, decoded: the motion of each lane (an engine, or the recording), its contacts, joints and kept
// trees, step by step. motion_data.h and contact_data.h say how the bytes are laid out.

const element = (id) => document.getElementById(id);
const data = JSON.parse(element('timeline-data').textContent);
const bodyCount = data.bodies.length;
const [left, bottom, right, top_] = data.view;
const unit = data.unit, centerX = (left + right) / 2, centerY = (bottom + top_) / 2;
const turn = 2 * Math.PI / 65536, spinUnit = 1 / 4096;
const fromGridX = (x) => centerX + x * unit, fromGridY = (y) => centerY + y * unit;
const floatBits = new Int32Array(1), floatValue = new Float32Array(floatBits.buffer);
/** The float whose bits, in the order of floats, a number is. */
const fromOrdered = (ordered) => {
  floatBits[0] = ordered < 0 ? ordered ^ 0x7fffffff : ordered;
  return floatValue[0];
};
/** Places and angles of bodies, m and rad: of the grid, or with --positions exact all bits of them. */
const toX = data.exact ? fromOrdered : fromGridX, toY = data.exact ? fromOrdered : fromGridY;
const toAngle = data.exact ? fromOrdered : (angle) => angle * turn;

/** The bytes of a stream: base64 around zlib. */
const inflate = async (id) => {
  const node = element(id), inflater = new DecompressionStream('deflate');
  const parts = [], text = node.textContent, writer = inflater.writable.getWriter(), reader = inflater.readable.getReader();
  const write = async () => {
    for (let at = 0; at < text.length; at += 1 << 20) {
      const piece = atob(text.slice(at, at + (1 << 20)));
      const bytes = new Uint8Array(piece.length);
      for (let i = 0; i < piece.length; ++i) bytes[i] = piece.charCodeAt(i);
      await writer.write(bytes);
    }
    await writer.close();
  };
  const writing = write();
  let size = 0;
  for (;;) {
    const {done, value} = await reader.read();
    if (done) break;
    parts.push(value);
    size += value.length;
  }
  await writing;
  node.textContent = '';  // it is not read again
  const bytes = new Uint8Array(size);
  for (let at = 0, i = 0; i < parts.length; at += parts[i++].length) bytes.set(parts[i], at);
  return bytes;
};

/** Steps that each begin with their length. */
class Stream {
  constructor(bytes, count) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer);
    this.offsets = new Uint32Array(count);
    for (let at = 0, i = 0; i < count; ++i) {
      this.offsets[i] = at + 4;
      at += 4 + this.view.getUint32(at, true);
    }
  }
  open(index) { this.at = this.offsets[index]; }
  byte() { return this.bytes[this.at++]; }
  word() { this.at += 2; return this.view.getUint16(this.at - 2, true); }
  /** A number of seven bits a byte, the lowest first. */
  number() {
    let value = 0, shift = 0, byte;
    do {
      byte = this.bytes[this.at++];
      value |= (byte & 0x7f) << shift;
      shift += 7;
    } while (byte & 0x80);
    return value >>> 0;
  }
  /** One with a sign, which is its lowest bit. */
  signed() {
    const value = this.number();
    return value >>> 1 ^ -(value & 1);
  }
  /** The upper half of a float. */
  real() {
    scratch.setUint16(0, this.word(), false);
    return scratch.getFloat32(0, false);
  }
}
const scratch = new DataView(new ArrayBuffer(4));

const isThere = 1, isAwake = 2, isNoNumber = 4;
const coordinates = ['x', 'y', 'angle', 'vx', 'vy', 'spin'];
/** Where every body is, and by how much each number changed last, which is what the next step is predicted by. */
class State {
  constructor() {
    this.index = -1;
    for (const name of coordinates) {
      this[name] = new Int32Array(bodyCount);
      this['d' + name] = new Int32Array(bodyCount);
    }
    this.stamp = new Int32Array(bodyCount).fill(-2);
    this.flags = new Uint8Array(bodyCount);
  }
  arrays() { return [...coordinates.flatMap((name) => [this[name], this['d' + name]]), this.stamp, this.flags]; }
  copy(other) {
    const from = other.arrays();
    this.arrays().forEach((array, i) => array.set(from[i]));
    this.index = other.index;
  }
}
/** Goes on by one step. */
const advance = (state, stream) => {
  const index = state.index + 1;
  stream.open(index);
  const {x, y, angle, vx, vy, spin, dx, dy, dangle, dvx, dvy, dspin, stamp, flags} = state;
  let body = -1;
  for (let left = stream.number(); left > 0; --left) {
    body += 1 + stream.number();
    const flag = flags[body] = stream.byte();
    if (!(flag & isThere) || flag & isNoNumber) continue;
    const goesOn = stamp[body] === index - 1 ? 1 : 0;
    let change = goesOn * dx[body] + stream.signed();
    x[body] += change; dx[body] = change;
    change = goesOn * dy[body] + stream.signed();
    y[body] += change; dy[body] = change;
    change = goesOn * dangle[body] + stream.signed();
    angle[body] += change; dangle[body] = change;
    change = goesOn * dvx[body] + stream.signed();
    vx[body] += change; dvx[body] = change;
    change = goesOn * dvy[body] + stream.signed();
    vy[body] += change; dvy[body] = change;
    change = goesOn * dspin[body] + stream.signed();
    spin[body] += change; dspin[body] = change;
    stamp[body] = index;
  }
  state.index = index;
};

/** One engine's session, or the recorded one. */
class Lane {
  constructor(told, number) {
    Object.assign(this, told);
    this.number = number;
    this.last = this.steps.length - 1;
    this.now = new State();
    this.keys = [];
    // At most 256 of them, and 200 MB.
    this.keyEvery = Math.max(64, Math.ceil(this.steps.length / 256), Math.ceil(this.steps.length * bodyCount * 53 / 2e8));
    this.cache = {contacts: null, at: -1};
  }
  async load() {
    const name = (what) => `timeline-${what}-${this.number}`;
    this.motion = new Stream(await inflate(name('motion')), this.steps.length);
    this.contactStream = element(name('contacts')) && new Stream(await inflate(name('contacts')), this.steps.length);
    this.jointStream = element(name('joints')) && new Stream(await inflate(name('joints')), this.steps.length);
    this.nodeStream = element(name('nodes')) && new Stream(await inflate(name('nodes')), this.nodeSteps.length);
    const numbers = await inflate(name('series')), floats = new Float32Array(numbers.buffer, 0, numbers.length >> 2);
    this.series = Object.fromEntries(this.seriesNames.map((series, i) => [series, floats.subarray(i * this.steps.length, (i + 1) * this.steps.length)]));
  }
  seek(index) {
    const {now, keys, keyEvery} = this;
    if (now.index === index) return;
    const key = Math.floor(index / keyEvery);
    if (keys.length > 0 && (now.index > index || key > Math.floor(now.index / keyEvery))) {
      const from = keys[Math.min(key, keys.length - 1)];
      if (now.index > index || from.index > now.index) now.copy(from);
    }
    while (now.index < index) {
      advance(now, this.motion);
      if (now.index % keyEvery === 0 && keys.length === now.index / keyEvery) {
        const kept = new State();
        kept.copy(now);
        keys.push(kept);
      }
    }
  }
  /** Calls look(index, state) for every step. */
  each(look) {
    const state = new State();
    while (state.index < this.last) {
      advance(state, this.motion);
      look(state.index, state);
    }
  }
  /** The last step at or before a time. */
  indexAt(time) {
    let low = 0, high = this.last;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.times[middle] <= time + 1e-9) low = middle; else high = middle - 1;
    }
    return low;
  }
  indexOfStep(step) {
    const found = this.steps.findIndex((one) => one >= step);
    return found < 0 ? this.last : found;
  }
  readContacts(index, state) {
    const stream = this.contactStream, contacts = [];
    if (!stream) return contacts;
    stream.open(index);
    for (let left = stream.number(); left > 0; --left) {
      const a = stream.number(), b = stream.number(), kind = stream.byte(), normal = stream.word() * turn;
      const contact = {a, b, isSensor: (kind & 4) !== 0, normal, points: []};
      for (let i = 0; i < (kind & 3); ++i) {
        const x = stream.signed(), y = stream.signed();
        contact.points.push({x: toX(state.x[a]) + x * unit, y: toY(state.y[a]) + y * unit, impulse: stream.real(), separation: stream.real()});
      }
      contacts.push(contact);
    }
    return contacts;
  }
  contactsNow() {
    if (this.cache.at !== this.now.index) this.cache = {at: this.now.index, contacts: this.readContacts(this.now.index, this.now)};
    return this.cache.contacts;
  }
  /** Lengths between the anchors of the joints that are there, by number. */
  readJoints(index) {
    const stream = this.jointStream, lengths = new Map();
    if (!stream) return lengths;
    stream.open(index);
    let joint = -1;
    for (let left = stream.number(); left > 0; --left) {
      joint += 1 + stream.number();
      lengths.set(joint, stream.real());
    }
    return lengths;
  }
  /** Boxes of the tree that was kept of this step: level, left, bottom, right, top; null: none was. */
  nodesNow() {
    const kept = this.nodeStream ? this.nodeSteps.indexOf(this.steps[this.now.index]) : -1;
    if (kept < 0) return null;
    if (this.nodesAt === kept) return this.nodes;
    const stream = this.nodeStream, nodes = [];
    stream.open(kept);
    for (let left = stream.number(); left > 0; --left) {
      nodes.push({level: stream.byte(), left: fromGridX(stream.signed()), bottom: fromGridY(stream.signed()), right: fromGridX(stream.signed()), top: fromGridY(stream.signed())});
    }
    this.nodesAt = kept;
    this.nodes = nodes;
    return nodes;
  }
  x(body) { return toX(this.now.x[body]); }
  y(body) { return toY(this.now.y[body]); }
  angle(body) { return toAngle(this.now.angle[body]); }
  isThere(body) { return (this.now.flags[body] & isThere) !== 0; }
  isAwake(body) { return (this.now.flags[body] & isAwake) !== 0; }
  /** Ends of a joint, m. */
  anchors(joint) {
    const place = (body, [x, y]) => {
      const cos = Math.cos(this.angle(body)), sin = Math.sin(this.angle(body));
      return [this.x(body) + cos * x - sin * y, this.y(body) + sin * x + cos * y];
    };
    const told = this.joints[joint];
    return [place(told.a, told.anchorA), place(told.b, told.anchorB)];
  }
}
const lanes = data.lanes.map((told, number) => new Lane(told, number));
const nameOf = (body) => data.bodies[body].name ? `${data.bodies[body].name} (${body})` : `body ${body}`;
