// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The picture of a step. Bodies are drawn by Canvas 2D, or by WebGL2 where there are many; everything else lies over
// them on a canvas of its own.

const layerNames = {bodies: 'Bodies', contacts: 'Contacts', impulses: 'Normals and impulses', joints: 'Joints', velocities: 'Velocities',
  boxes: 'AABBs', trails: 'Trail of what is chosen', tree: 'Tree, where kept', labels: 'Names'};
/** More bodies than these are drawn by WebGL2. */
const mostByCanvas = 1000;
let colors = {};
const readColors = () => {
  const style = getComputedStyle(document.documentElement), color = (name) => style.getPropertyValue(name).trim();
  colors = {static: color('--soft'), kinematic: color('--warning'), awake: color('--good'), asleep: color('--line-strong'),
    chosen: color('--bad'), ink: color('--ink'), other: color('--bad'), line: color('--line-strong'), soft: color('--soft'), card: color('--card')};
};
const colorOf = (lane, body) => {
  const type = data.bodies[body].type;
  return type !== 'dynamic' ? colors[type] : colors[lane.isAwake(body) ? 'awake' : 'asleep'];
};

const traceShape = (pen, shape) => {
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
const paths = [];
const pathOf = (body) => {
  if (!paths[body]) {
    paths[body] = new Path2D();
    for (const shape of data.bodies[body].shapes) traceShape(paths[body], shape);
  }
  return paths[body];
};

/** Bodies by Canvas 2D. */
const drawBodies = (pen, lane, view, asOutline) => {
  const {width, height, scale, x, y, ratio} = view;
  for (let body = 0; body < bodyCount; ++body) {
    if (!lane.isThere(body)) continue;
    const px = lane.x(body), py = lane.y(body), reach = data.bodies[body].reach;
    if (Math.abs(px - x) * scale > width / 2 + reach * scale || Math.abs(py - y) * scale > height / 2 + reach * scale) continue;
    const cos = Math.cos(lane.angle(body)) * scale, sin = Math.sin(lane.angle(body)) * scale;
    pen.setTransform(cos, -sin, -sin, -cos, width / 2 + (px - x) * scale, height / 2 - (py - y) * scale);
    const ink = asOutline ? colors.other : colorOf(lane, body), path = pathOf(body);
    if (!asOutline) {
      pen.globalAlpha = 0.28;
      pen.fillStyle = ink;
      pen.fill(path);
      pen.globalAlpha = 1;
    }
    pen.lineWidth = ratio / scale;
    pen.strokeStyle = ink;
    pen.stroke(path);
  }
  pen.setTransform(1, 0, 0, 1, 0, 0);
};

/** Where a body is, from the texture of poses, and its colour. */
const poseSource = `#version 300 es
  precision highp float;
  uniform highp sampler2D poses;
  uniform vec4 view;  // centre, and factors to the canvas
  uniform vec4 inks[5];
  flat out vec4 ink;
  vec4 placed(int index, vec2 point) {
    int row = index / 1024 * 2, column = index % 1024;
    vec4 pose = texelFetch(poses, ivec2(column, row), 0);
    float kind = texelFetch(poses, ivec2(column, row + 1), 0).x;
    ink = kind < 0.0 ? vec4(0.0) : inks[int(kind)];
    vec2 place = pose.xy + vec2(pose.z * point.x - pose.w * point.y, pose.w * point.x + pose.z * point.y);
    return kind < 0.0 ? vec4(2.0, 2.0, 0.0, 1.0) : vec4((place - view.xy) * view.zw, 0.0, 1.0);
  }`;
const plainSource = `#version 300 es
  precision mediump float;
  flat in vec4 ink;
  uniform float alpha;
  out vec4 color;
  void main() { color = vec4(ink.rgb * alpha, alpha); }`;
/** Corners of polygons and ends of edges. */
const cornerSource = `${poseSource}
  layout(location = 0) in vec2 point;
  layout(location = 1) in float body;
  void main() { gl_Position = placed(int(body), point); }`;
/** A circle is the triangle around it: a corner costs more than the pixels of a small circle. Its edge is round at any zoom. */
const circleSource = `${poseSource}
  layout(location = 0) in vec3 circle;  // centre in the body, radius
  layout(location = 1) in float body;
  uniform float pixel;  // m
  out vec2 offset;      // from the centre, pixels
  flat out float radius;
  void main() {
    int number = gl_VertexID % 3;
    vec2 corner = number == 0 ? vec2(0.0, 2.0) : vec2(number == 1 ? -1.7320508 : 1.7320508, -1.0);
    vec2 away = corner * (circle.z + pixel);
    offset = away / pixel;
    radius = circle.z / pixel;
    gl_Position = placed(int(body), circle.xy + away);
  }`;
const discSource = `#version 300 es
  precision highp float;
  flat in vec4 ink;
  in vec2 offset;
  flat in float radius;
  uniform float alpha;  // of the inside
  uniform float thick;  // of lines, pixels
  out vec4 color;
  float covers(float away) { return clamp(0.5 * thick + 0.5 - away, 0.0, 1.0); }
  void main() {
    float distance = length(offset);
    float line = covers(abs(distance - radius));
    if (offset.x > 0.0 && distance < radius) line = max(line, covers(abs(offset.y)));
    float share = max(line, alpha * clamp(radius + 0.5 - distance, 0.0, 1.0));
    color = vec4(ink.rgb * share, share);
  }`;
/** Contacts: squares of one colour. */
const squareSource = `#version 300 es
  layout(location = 0) in vec2 place;
  uniform vec4 view;
  uniform float wide;
  uniform vec4 inks[5];
  flat out vec4 ink;
  void main() {
    ink = inks[0];
    gl_PointSize = wide;
    gl_Position = vec4((place - view.xy) * view.zw, 0.0, 1.0);
  }`;

/** Bodies and contacts by WebGL2: all shapes once as triangles, lines and circles, poses in a texture. */
class Painter {
  constructor(canvas) {
    const gl = this.gl = canvas.getContext('webgl2', {antialias: bodyCount <= mostByCanvas, premultipliedAlpha: true});
    if (!gl) throw new Error('no WebGL2');
    this.corners = this.link(cornerSource, plainSource);
    this.discs = this.link(circleSource, discSource);
    this.squares = this.link(squareSource, plainSource);
    const triangles = [], lines = [], circles = [];
    data.bodies.forEach((told, body) => {
      for (const shape of told.shapes) {
        if (shape.r !== undefined) {
          // No instances: software makes a draw call of each.
          for (let i = 0; i < 3; ++i) circles.push(shape.x, shape.y, shape.r, body);
          continue;
        }
        const corners = shape.v, count = corners.length / 2, isClosed = count > 2;
        const put = (list, i) => list.push(corners[2 * i], corners[2 * i + 1], body);
        for (let i = 2; i < count; ++i) put(triangles, 0), put(triangles, i - 1), put(triangles, i);
        for (let i = 0; i < count - (isClosed ? 0 : 1); ++i) put(lines, i), put(lines, (i + 1) % count);
      }
    });
    this.triangles = this.load(triangles, [2, 1]);
    this.lines = this.load(lines, [2, 1]);
    this.circles = this.load(circles, [3, 1]);
    this.points = this.load([], [2]);
    this.rows = Math.ceil(bodyCount / 1024) * 2;
    this.poses = new Float32Array(1024 * this.rows * 4);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 1024, Math.max(this.rows, 1));
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }
  link(vertex, fragment) {
    const {gl} = this, program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return {program, place: (name) => gl.getUniformLocation(program, name)};
  }
  /** Numbers one after the other for attributes of these sizes. */
  load(numbers, sizes) {
    const gl = this.gl, array = gl.createVertexArray(), buffer = gl.createBuffer(), all = sizes.reduce((a, b) => a + b);
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
    sizes.forEach((size, i) => {
      gl.vertexAttribPointer(i, size, gl.FLOAT, false, 4 * all, 4 * sizes.slice(0, i).reduce((a, b) => a + b, 0));
      gl.enableVertexAttribArray(i);
    });
    return {array, buffer, count: numbers.length / all};
  }
  clear(view) {
    this.gl.viewport(0, 0, view.width, view.height);
    this.gl.clearColor(0, 0, 0, 0);
    this.gl.clear(this.gl.COLOR_BUFFER_BIT);
  }
  /** Begins with a program; positions are relative to the middle of the view, so that a float suffices far from the origin. */
  use(linked, view, inks, alpha) {
    const {gl} = this;
    gl.useProgram(linked.program);
    gl.uniform4f(linked.place('view'), 0, 0, 2 * view.scale / view.width, 2 * view.scale / view.height);
    gl.uniform4fv(linked.place('inks'), inks.flatMap((ink) => [1, 3, 5].map((i) => parseInt(ink.slice(i, i + 2), 16) / 255).concat(1)));
    gl.uniform1f(linked.place('alpha'), alpha);
  }
  draw(lane, view, asOutline) {
    const gl = this.gl, {poses} = this, {x, y, angle, flags} = lane.now;
    const kinds = {static: 0, kinematic: 1, dynamic: 2};
    for (let body = 0; body < bodyCount; ++body) {
      const at = ((body >> 10) * 2048 + (body & 1023)) * 4;
      poses[at] = toX(x[body]) - view.x;
      poses[at + 1] = toY(y[body]) - view.y;
      poses[at + 2] = Math.cos(toAngle(angle[body]));
      poses[at + 3] = Math.sin(toAngle(angle[body]));
      const kind = kinds[data.bodies[body].type];
      poses[at + 4096] = !(flags[body] & isThere) ? -1 : asOutline ? 4 : kind === 2 && !(flags[body] & isAwake) ? 3 : kind;
    }
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 1024, this.rows, gl.RGBA, gl.FLOAT, poses);
    const inks = [colors.static, colors.kinematic, colors.awake, colors.asleep, colors.other], inside = asOutline ? 0 : 0.28;
    for (const [kind, list, alpha] of [[gl.TRIANGLES, this.triangles, inside], [gl.LINES, this.lines, 1]]) {
      if (alpha === 0 || list.count === 0) continue;
      this.use(this.corners, view, inks, alpha);
      gl.bindVertexArray(list.array);
      gl.drawArrays(kind, 0, list.count);
    }
    if (this.circles.count === 0) return;
    this.use(this.discs, view, inks, inside);
    gl.uniform1f(this.discs.place('pixel'), 1 / view.scale);
    gl.uniform1f(this.discs.place('thick'), view.ratio);
    gl.bindVertexArray(this.circles.array);
    gl.drawArrays(gl.TRIANGLES, 0, this.circles.count);
  }
  /** The points of contacts that are not chosen. */
  drawContacts(lane, view) {
    const {gl} = this, places = [];
    for (const contact of lane.contactsNow()) {
      for (const point of contact.points) places.push(point.x - view.x, point.y - view.y);
    }
    if (places.length === 0) return;
    this.use(this.squares, view, Array(5).fill(colors.kinematic), 1);
    gl.uniform1f(this.squares.place('wide'), 2 * halfOfContact(view));
    gl.bindVertexArray(this.points.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.points.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(places), gl.DYNAMIC_DRAW);
    gl.drawArrays(gl.POINTS, 0, places.length / 2);
  }
}
/** Of the edge of the square that marks a contact, pixels. */
const halfOfContact = (view) => Math.max(1.5, Math.min(3, view.scale * 0.05)) * view.ratio;

/** The box of a body now, m; null: it has no shape. */
const boxOf = (lane, body) => {
  const cos = Math.cos(lane.angle(body)), sin = Math.sin(lane.angle(body)), px = lane.x(body), py = lane.y(body);
  let box = null;
  const add = (x, y, r) => {
    const wx = px + cos * x - sin * y, wy = py + sin * x + cos * y;
    box = box ? [Math.min(box[0], wx - r), Math.min(box[1], wy - r), Math.max(box[2], wx + r), Math.max(box[3], wy + r)] : [wx - r, wy - r, wx + r, wy + r];
  };
  for (const shape of data.bodies[body].shapes) {
    if (shape.r !== undefined) add(shape.x, shape.y, shape.r);
    else for (let i = 0; i < shape.v.length; i += 2) add(shape.v[i], shape.v[i + 1], 0);
  }
  return box;
};

/** What lies over the bodies. `chosen`: {bodies, contact, joint}; `trails` by body. `isMarked`: a Painter has drawn the contacts. */
const drawLayers = (pen, lane, view, layers, chosen, trails, levels, isMarked) => {
  const {width, height, scale, x, y, ratio} = view;
  const toScreen = (wx, wy) => [width / 2 + (wx - x) * scale, height / 2 - (wy - y) * scale];
  const line = (ax, ay, bx, by) => { pen.moveTo(...toScreen(ax, ay)); pen.lineTo(...toScreen(bx, by)); };
  const isSeen = (wx, wy) => Math.abs(wx - x) * scale < width / 2 + 20 && Math.abs(wy - y) * scale < height / 2 + 20;
  pen.lineWidth = ratio;
  const nodes = layers.has('tree') ? lane.nodesNow() : null;
  if (nodes) {
    // Translucent, so that overlap adds up.
    pen.fillStyle = '#ff2a2a';
    pen.globalAlpha = 0.07;
    for (const node of nodes) {
      if (node.level > levels) continue;
      const [px, py] = toScreen(node.left, node.top);
      pen.fillRect(px, py, Math.max(1, (node.right - node.left) * scale), Math.max(1, (node.top - node.bottom) * scale));
    }
    pen.globalAlpha = 1;
  }
  if (layers.has('boxes')) {
    pen.strokeStyle = colors.soft;
    pen.beginPath();
    for (let body = 0; body < bodyCount; ++body) {
      const box = lane.isThere(body) && boxOf(lane, body);
      if (!box) continue;
      const [px, py] = toScreen(box[0], box[3]);
      pen.rect(px, py, (box[2] - box[0]) * scale, (box[3] - box[1]) * scale);
    }
    pen.stroke();
  }
  if (layers.has('trails')) {
    for (const [body, series] of trails) {
      pen.strokeStyle = colors.chosen;
      for (const [from, to, alpha] of [[0, lane.now.index, 0.9], [lane.now.index, lane.last, 0.3]]) {
        pen.globalAlpha = alpha;
        pen.beginPath();
        let isDown = false;
        for (let i = from; i <= to; ++i) {
          const px = series.x[i], py = series.y[i];
          if (px !== px || py !== py) { isDown = false; continue; }
          if (isDown) pen.lineTo(...toScreen(px, py)); else pen.moveTo(...toScreen(px, py));
          isDown = true;
        }
        pen.stroke();
      }
      pen.globalAlpha = 1;
    }
  }
  if (layers.has('joints')) {
    pen.strokeStyle = colors.kinematic;
    pen.fillStyle = colors.kinematic;
    const there = lane.readJoints(lane.now.index);
    for (const joint of there.keys()) {
      if (!lane.isThere(lane.joints[joint].a) || !lane.isThere(lane.joints[joint].b)) continue;
      const [a, b] = lane.anchors(joint);
      pen.lineWidth = (chosen.joint === joint ? 3 : 1) * ratio;
      pen.beginPath();
      line(...a, ...b);
      // A static body's origin may be anywhere.
      for (const [body, end] of [[lane.joints[joint].a, a], [lane.joints[joint].b, b]]) {
        if (data.bodies[body].type !== 'static') line(lane.x(body), lane.y(body), ...end);
      }
      pen.stroke();
      for (const end of [a, b]) {
        const [px, py] = toScreen(...end);
        pen.fillRect(px - 2 * ratio, py - 2 * ratio, 4 * ratio, 4 * ratio);
      }
    }
    pen.lineWidth = ratio;
  }
  if (layers.has('velocities')) {
    pen.strokeStyle = colors.ink;
    pen.beginPath();
    for (let body = 0; body < bodyCount; ++body) {
      if (!lane.isThere(body) || data.bodies[body].type === 'static') continue;
      const vx = lane.now.vx[body] * unit, vy = lane.now.vy[body] * unit, px = lane.x(body), py = lane.y(body);
      if (!isSeen(px, py) || Math.hypot(vx, vy) * scale < 10 * ratio) continue;
      line(px, py, px + 0.1 * vx, py + 0.1 * vy);
      const [ex, ey] = toScreen(px + 0.1 * vx, py + 0.1 * vy), angle = Math.atan2(-vy, vx);
      for (const side of [2.6, -2.6]) {
        pen.moveTo(ex, ey);
        pen.lineTo(ex + 6 * ratio * Math.cos(angle + side), ey + 6 * ratio * Math.sin(angle + side));
      }
    }
    pen.stroke();
  }
  if (layers.has('contacts') || layers.has('impulses')) drawContacts(pen, lane, view, layers, chosen, toScreen, isSeen, isMarked);
  for (const body of chosen.bodies) {
    if (!lane.isThere(body)) continue;
    const cos = Math.cos(lane.angle(body)) * scale, sin = Math.sin(lane.angle(body)) * scale, [px, py] = toScreen(lane.x(body), lane.y(body));
    pen.setTransform(cos, -sin, -sin, -cos, px, py);
    pen.lineWidth = 2.5 * ratio / scale;
    pen.strokeStyle = colors.chosen;
    pen.stroke(pathOf(body));
    pen.setTransform(1, 0, 0, 1, 0, 0);
  }
  if (layers.has('labels')) {
    pen.fillStyle = colors.ink;
    pen.font = `${11 * ratio}px system-ui, sans-serif`;
    pen.textAlign = 'center';
    let left = 400;  // more could not be read
    for (let body = 0; body < bodyCount && left > 0; ++body) {
      if (!lane.isThere(body) || data.bodies[body].type === 'static' && !data.bodies[body].name || !isSeen(lane.x(body), lane.y(body))) continue;
      pen.fillText(data.bodies[body].name || body, ...toScreen(lane.x(body), lane.y(body)));
      --left;
    }
    pen.textAlign = 'left';
  }
};
const drawContacts = (pen, lane, view, layers, chosen, toScreen, isSeen, isMarked) => {
  if (isMarked && !layers.has('impulses') && !chosen.contact) return;
  const contacts = lane.contactsNow(), {ratio} = view;
  const isChosen = (contact) => chosen.contact && contact.a === chosen.contact[0] && contact.b === chosen.contact[1];
  if (layers.has('impulses')) {
    // The largest impulse is drawn a tenth of the view long.
    let largest = 0;
    for (const contact of contacts) for (const point of contact.points) largest = Math.max(largest, point.impulse);
    pen.strokeStyle = colors.chosen;
    pen.beginPath();
    for (const contact of contacts) {
      for (const point of contact.points) {
        if (!isSeen(point.x, point.y)) continue;
        const [px, py] = toScreen(point.x, point.y);
        const length = 8 * ratio + (largest > 0 ? 0.1 * view.height * point.impulse / largest : 0);
        pen.moveTo(px, py);
        pen.lineTo(px + length * Math.cos(contact.normal), py - length * Math.sin(contact.normal));
      }
    }
    pen.stroke();
  }
  const half = halfOfContact(view), others = isMarked ? [] : [[colors.kinematic, (contact) => !isChosen(contact)]];
  for (const [ink, test] of [...others, [colors.chosen, isChosen]]) {
    pen.fillStyle = ink;
    for (const contact of contacts) {
      if (!test(contact)) continue;
      const by = isChosen(contact) ? 2 * half : half;
      for (const point of contact.points) {
        if (!isSeen(point.x, point.y)) continue;
        const [px, py] = toScreen(point.x, point.y);
        pen.fillRect(px - by, py - by, 2 * by, 2 * by);
      }
    }
  }
};

/** What lies at a place, m: a contact or a joint within `near`, else the smallest body that holds it. */
const isInside = (shape, x, y) => {
  if (shape.r !== undefined) return Math.hypot(x - shape.x, y - shape.y) <= shape.r;
  let inside = false;
  const v = shape.v;
  for (let i = 0, j = v.length - 2; v.length > 4 && i < v.length; j = i, i += 2) {
    if ((v[i + 1] > y) !== (v[j + 1] > y) && x < (v[j] - v[i]) * (y - v[i + 1]) / (v[j + 1] - v[i + 1]) + v[i]) inside = !inside;
  }
  return inside;
};
const awayFromLine = (ax, ay, bx, by, x, y) => {
  const dx = bx - ax, dy = by - ay, along = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(ax + along * dx - x, ay + along * dy - y);
};
const bodyAt = (lane, x, y, near) => {
  let best = -1, least = Infinity;
  for (let body = 0; body < bodyCount; ++body) {
    if (!lane.isThere(body)) continue;
    const dx = x - lane.x(body), dy = y - lane.y(body), reach = data.bodies[body].reach;
    if (Math.hypot(dx, dy) > reach + near) continue;
    const cos = Math.cos(lane.angle(body)), sin = Math.sin(lane.angle(body));
    const lx = cos * dx + sin * dy, ly = cos * dy - sin * dx;
    for (const shape of data.bodies[body].shapes) {
      // What is small is meant, not what lies around it; an edge only where nothing else is.
      if (isInside(shape, lx, ly)) {
        if (reach < least) least = reach, best = body;
      } else if (shape.v) {
        for (let i = 0; i + 3 < shape.v.length; i += 2) {
          const away = awayFromLine(shape.v[i], shape.v[i + 1], shape.v[i + 2], shape.v[i + 3], lx, ly);
          if (away <= near && 1e9 + away < least) least = 1e9 + away, best = body;
        }
      }
    }
  }
  return best;
};
const thingAt = (lane, layers, x, y, near) => {
  let best = null, least = near;
  if (layers.has('contacts')) {
    for (const contact of lane.contactsNow()) {
      for (const point of contact.points) {
        const away = Math.hypot(point.x - x, point.y - y);
        if (away < least) least = away, best = {contact: [contact.a, contact.b]};
      }
    }
  }
  if (layers.has('joints')) {
    for (const joint of lane.readJoints(lane.now.index).keys()) {
      const [a, b] = lane.anchors(joint), away = awayFromLine(...a, ...b, x, y);
      if (away < least) least = away, best = {joint};
    }
  }
  const body = best ? -1 : bodyAt(lane, x, y, near);
  return best || (body >= 0 ? {body} : {});
};
