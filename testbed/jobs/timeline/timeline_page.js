// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a reader does and sees. All that is chosen stands in the address, so that a link shows the same.

const defaultLayers = ['bodies', 'contacts', 'joints', 'trails'];
const look = {x: 0, y: 0, zoom: 1, layers: new Set(defaultLayers), mode: lanes.length > 1 ? 'beside' : '0', speed: 1, loop: null, isLooping: false,
  follows: false, levels: 99, renderer: 'auto', isMoved: false};
const chosen = {bodies: [], contact: null, joint: null};
let clock = 0, isPlaying = false, isDirty = true, views = [], worldPlots = [], chosenPlots = [], trails = [];

// Views: one for each lane, or one for several.
const fit = () => {
  const area = views[0].over;
  look.x = centerX;
  look.y = centerY;
  look.zoom = 0.92 * Math.min(area.clientWidth / Math.max(right - left, 1e-6), area.clientHeight / Math.max(top_ - bottom, 1e-6));
  look.isMoved = false;
};
const shownLanes = () => look.mode === 'beside' || look.mode === 'over' ? lanes : [lanes[Number(look.mode)]];
const makeViews = () => {
  const parent = element('views');
  parent.replaceChildren();
  const groups = look.mode === 'over' ? [lanes] : shownLanes().map((lane) => [lane]);
  views = groups.map((group) => {
    const box = document.createElement('figure'), under = document.createElement('canvas'), over = document.createElement('canvas');
    under.className = 'under';
    over.className = 'over';
    over.tabIndex = 0;
    over.setAttribute('role', 'img');
    over.setAttribute('aria-label', `The world in ${group.map((lane) => lane.name).join(' and ')} at the chosen step`);
    const caption = document.createElement('figcaption');
    group.forEach((lane) => {
      const name = document.createElement('span');
      name.textContent = lane.name;
      if (lanes.length > 1) name.style.color = lane === group[0] ? colors.ink : colors.other;
      caption.append(name);
    });
    box.append(under, over, caption);
    parent.append(box);
    const view = {group, under, over, painter: null};
    const wantsGl = look.renderer === 'webgl' || look.renderer === 'auto' && bodyCount > mostByCanvas;
    if (wantsGl) {
      try {
        view.painter = new Painter(under);
      } catch (error) {
        view.painter = null;  // Canvas 2D draws them all, slower
      }
    }
    listen(view);
    return view;
  });
  sizeViews();
  element('timeline').dataset.renderer = views[0].painter ? 'webgl' : 'canvas';
};
/** Beside or above each other, whatever shows the level larger, and no higher than it needs. */
const sizeViews = () => {
  const parent = element('views'), width = parent.clientWidth, height = 0.6 * window.innerHeight, count = views.length;
  const levelWidth = Math.max(right - left, 1e-6), levelHeight = Math.max(top_ - bottom, 1e-6);
  const scaleOf = (columns, rows) => Math.min(width / columns / levelWidth, height / Math.min(rows, 2) / levelHeight);
  const isBeside = width >= 560 && scaleOf(count, 1) >= scaleOf(1, count), columns = isBeside ? count : 1;
  const wanted = width / columns / levelWidth * levelHeight + 50, most = isBeside ? height : height / Math.min(count, 2);
  parent.style.setProperty('--columns', columns);
  parent.style.setProperty('--height', `${Math.round(Math.max(isBeside ? 260 : 150, Math.min(wanted, most)))}px`);
};
const sizeOf = (view) => {
  const ratio = window.devicePixelRatio || 1, {over} = view;
  return {width: Math.max(1, Math.round(over.clientWidth * ratio)), height: Math.max(1, Math.round(over.clientHeight * ratio)), ratio,
    scale: look.zoom * ratio, x: look.x, y: look.y};
};
const drawView = (view) => {
  const size = sizeOf(view), pen = view.over.getContext('2d');
  for (const canvas of [view.over, view.under]) {
    if (canvas.width !== size.width || canvas.height !== size.height) canvas.width = size.width, canvas.height = size.height;
  }
  pen.setTransform(1, 0, 0, 1, 0, 0);
  pen.clearRect(0, 0, size.width, size.height);
  if (view.painter) view.painter.clear(size);
  if (look.layers.has('bodies')) {
    view.group.forEach((lane, i) => {
      if (view.painter) view.painter.draw(lane, size, i > 0);
      else drawBodies(pen, lane, size, i > 0);
    });
  }
  const lane = view.group[0], hasContacts = look.layers.has('contacts') || look.layers.has('impulses');
  if (view.painter && hasContacts) view.painter.drawContacts(lane, size);
  drawLayers(pen, lane, size, look.layers, chosen, trails[lane.number] || [], look.levels, view.painter !== null);
};
const draw = () => {
  isDirty = false;
  if (look.follows && chosen.bodies.length > 0 && lanes[0].isThere(chosen.bodies[0])) {
    look.x = lanes[0].x(chosen.bodies[0]);
    look.y = lanes[0].y(chosen.bodies[0]);
  }
  views.forEach(drawView);
  element('timeline').dataset.frames = Number(element('timeline').dataset.frames || 0) + 1;
};
const redraw = () => {
  if (isDirty) return;
  isDirty = true;
  requestAnimationFrame(() => { if (isDirty) draw(); });
};

// What is told of the step and of what is chosen.
let toldAt = 0;
const tell = () => {
  const main = lanes[0], share = shareOf(main, main.now.index), index = main.now.index;
  for (const plot of [...worldPlots, ...chosenPlots]) plot.point(share);
  element('step').value = index;
  // Nobody reads numbers that change with every frame.
  if (isPlaying && performance.now() - toldAt < 120) return;
  toldAt = performance.now();
  element('where').textContent = `step ${main.steps[index]} · ${main.times[index].toFixed(2)} s`;
  element('step').setAttribute('aria-valuetext', `step ${main.steps[index]} of ${main.steps[main.last]}`);
  for (const plot of [...worldPlots, ...chosenPlots]) plot.tell();
  tellChosen();
  const kept = main.nodeSteps && main.nodeSteps.includes(main.steps[index]);
  element('kept').textContent = main.nodeSteps && look.layers.has('tree') ? kept ? 'The tree of this step is shown.' : 'No tree was kept of this step.' : '';
};
const rowsOf = (lane) => {
  if (chosen.contact) {
    const contact = lane.contactsNow().find((one) => one.a === chosen.contact[0] && one.b === chosen.contact[1]);
    if (!contact) return [['now', 'does not touch']];
    const rows = [['normal', `${(contact.normal * 180 / Math.PI).toFixed(1)}°`]];
    contact.points.forEach((point, i) => {
      const name = contact.points.length > 1 ? ` ${i + 1}` : '';
      rows.push([`point${name}`, `${shown(point.x)}, ${shown(point.y)} m`], [`impulse${name}`, `${shown(point.impulse)} N·s`],
        [`separation${name}`, `${shown(point.separation)} m`]);
    });
    return rows.concat(contact.isSensor ? [['kind', 'sensor']] : []);
  }
  if (chosen.joint !== null) {
    const length = lane.readJoints(lane.now.index).get(chosen.joint);
    return [['kind', lanes[0].joints[chosen.joint].type], length === undefined ? ['now', 'not there'] : [isGap(chosen.joint) ? 'gap' : 'length', `${shown(length)} m`]];
  }
  const body = chosen.bodies[0], {now} = lane;
  if (body === undefined) return [];
  if (!lane.isThere(body)) return [['now', 'not there']];
  if (now.flags[body] & isNoNumber) return [['now', 'its pose is not finite']];
  const vx = now.vx[body] * unit, vy = now.vy[body] * unit, spin = now.spin[body] * spinUnit, speed = Math.hypot(vx, vy);
  const rows = [['x', `${shown(lane.x(body))} m`], ['y', `${shown(lane.y(body))} m`], ['angle', `${shown(lane.angle(body))} rad`]];
  if (data.bodies[body].type === 'static') return rows;
  rows.push(['velocity x', `${shown(vx)} m/s`], ['velocity y', `${shown(vy)} m/s`], ['speed', `${shown(speed)} m/s`], ['spin', `${shown(spin)} rad/s`]);
  if (data.bodies[body].type === 'dynamic') {
    rows.push(['energy', `${shown(0.5 * (data.bodies[body].mass * speed * speed + data.bodies[body].inertia * spin * spin))} J`], ['awake', lane.isAwake(body) ? 'yes' : 'no']);
  }
  if (lane.contactStream) rows.push(['contacts', lane.contactsNow().filter((contact) => contact.a === body || contact.b === body).length]);
  return rows;
};
const isGap = (joint) => ['revolute', 'weld'].includes(lanes[0].joints[joint].type);
const titleOf = () => {
  if (chosen.contact) return `Contact of ${nameOf(chosen.contact[0])} and ${nameOf(chosen.contact[1])}`;
  if (chosen.joint !== null) {
    const joint = lanes[0].joints[chosen.joint];
    return `Joint of ${nameOf(joint.a)} and ${nameOf(joint.b)}`;
  }
  if (chosen.bodies.length === 0) return 'Click a body, a contact or a joint';
  const told = data.bodies[chosen.bodies[0]];
  return `${nameOf(chosen.bodies[0])}, ${told.type}${told.mass > 0 ? `, ${shown(told.mass)} kg` : ''}${chosen.bodies.length > 1 ? ` and ${chosen.bodies.length - 1} more` : ''}`;
};
const tellChosen = () => {
  element('chosen').textContent = titleOf();
  const columns = shownLanes().map(rowsOf), table = element('values');
  table.replaceChildren();
  if (columns.every((rows) => rows.length === 0)) return;
  const addRow = (name, values, tag) => {
    const row = document.createElement('tr');
    row.append(Object.assign(document.createElement('th'), {textContent: name, scope: 'row'}));
    for (const value of values) row.append(Object.assign(document.createElement(tag), {textContent: value}));
    table.append(row);
  };
  if (columns.length > 1) addRow('', shownLanes().map((lane) => lane.name), 'th');
  const longest = columns.reduce((a, b) => b.length > a.length ? b : a);
  for (const [name, value] of longest) {
    const values = columns.map((rows) => String((rows.find((row) => row[0] === name) || ['', columns.length > 1 ? '–' : ''])[1]));
    // Beside each other numbers have no room for a unit each.
    const unitName = columns.length > 1 ? (/\d( [^ \d,]+)$/.exec(value) || ['', ''])[1] : '';
    const bare = values.map((text) => unitName && text.endsWith(unitName) ? text.slice(0, -unitName.length) : text);
    addRow(unitName ? `${name},${unitName}` : name, bare, 'td');
  }
};

// Going to a step.
const goToTime = (time, isQuiet) => {
  clock = Math.max(lanes[0].times[0], Math.min(time, lanes[0].times[lanes[0].last]));
  let isChanged = false;
  for (const lane of lanes) {
    const before = lane.now.index;
    lane.seek(lane.indexAt(clock));
    isChanged = isChanged || lane.now.index !== before;
  }
  if (isChanged) redraw(), tell();
  if (!isQuiet) remember();
};
const go = (index, isQuiet) => goToTime(lanes[0].times[Math.max(0, Math.min(lanes[0].last, index))], isQuiet);
const goToShare = (share) => { setPlaying(false); go(Math.round(share * lanes[0].last)); };

const choose = (thing, isMore) => {
  chosen.contact = thing.contact || null;
  chosen.joint = thing.joint === undefined ? null : thing.joint;
  if (thing.body === undefined) chosen.bodies = [];
  else if (isMore && chosen.bodies.length > 0) chosen.bodies = chosen.bodies.includes(thing.body) ? chosen.bodies.filter((body) => body !== thing.body) : [...chosen.bodies, thing.body];
  else chosen.bodies = [thing.body];
  showChosen();
  remember();
};
const showChosen = () => {
  for (const plot of chosenPlots) plot.remove();
  chosenPlots = [];
  trails = [];
  const add = (name, unitName, curves) => chosenPlots.push(new Plot(element('chosen-plots'), name, unitName, curves, goToShare));
  if (chosen.contact) {
    const found = lanes.map((lane) => ({lane, series: collectContact(lane, chosen.contact)}));
    add('Impulse', 'N·s', found.map(({lane, series}) => ({lane, values: series.impulse})));
    add('Depth', 'm', found.map(({lane, series}) => ({lane, values: series.depth})));
  } else if (chosen.joint !== null) {
    add(isGap(chosen.joint) ? 'Gap' : 'Length', 'm', lanes.map((lane) => ({lane, values: collectJoint(lane, chosen.joint)})));
  } else if (chosen.bodies.length > 0) {
    const found = lanes.map((lane) => ({lane, bodies: collectBodies(lane, chosen.bodies)}));
    for (const {lane, bodies} of found) trails[lane.number] = [...bodies];
    for (const [key, name, unitName] of [['x', 'x', 'm'], ['y', 'y', 'm'], ['speed', 'Speed', 'm/s'], ['spin', 'Spin', 'rad/s'], ['energy', 'Energy', 'J']]) {
      if (key === 'energy' && data.bodies[chosen.bodies[0]].type !== 'dynamic') continue;
      add(name, unitName, found.map(({lane, bodies}) => ({lane, values: bodies.get(chosen.bodies[0])[key]})));
    }
  }
  for (const plot of chosenPlots) plot.draw();
  tell();
  redraw();
};

// The address.
const address = () => {
  const words = new URLSearchParams();
  words.set('step', lanes[0].steps[lanes[0].now.index]);
  if (chosen.bodies.length > 0) words.set('body', chosen.bodies.join(','));
  if (chosen.contact) words.set('contact', chosen.contact.join(','));
  if (chosen.joint !== null) words.set('joint', chosen.joint);
  if (look.isMoved) for (const name of ['x', 'y', 'zoom']) words.set(name, Number(look[name].toPrecision(6)));
  if ([...look.layers].sort().join() !== [...defaultLayers].sort().join()) words.set('layers', [...look.layers].join(','));
  if (look.mode !== (lanes.length > 1 ? 'beside' : '0')) words.set('engines', look.mode);
  if (look.speed !== 1) words.set('speed', look.speed);
  if (look.loop) words.set('loop', look.loop.map((index) => lanes[0].steps[index]).join(':'));
  if (look.follows) words.set('follow', 1);
  if (look.levels !== 99) words.set('levels', look.levels);
  if (look.renderer !== 'auto') words.set('renderer', look.renderer);
  return `#${words.toString().replaceAll('%2C', ',').replaceAll('%3A', ':')}`;
};
let remembering = null;
const remember = () => {
  if (remembering) return;
  // Browsers refuse an address that changes with every frame.
  remembering = setTimeout(() => { remembering = null; history.replaceState(null, '', address()); }, 150);
};
const readAddress = () => {
  const asked = new URLSearchParams(location.hash.slice(1));
  const number = (name, otherwise) => asked.has(name) && Number.isFinite(Number(asked.get(name))) ? Number(asked.get(name)) : otherwise;
  const isBody = (body) => Number.isInteger(body) && body >= 0 && body < bodyCount;
  const numbers = (name) => (asked.get(name) || '').split(/[,:]/).filter(Boolean).map(Number);
  look.layers = new Set(asked.has('layers') ? asked.get('layers').split(',').filter((name) => layerNames[name]) : defaultLayers);
  const modes = [...element('mode').options].map((option) => option.value);
  look.mode = modes.includes(asked.get('engines')) ? asked.get('engines') : lanes.length > 1 ? 'beside' : '0';
  look.speed = number('speed', 1);
  look.follows = asked.has('follow');
  look.levels = number('levels', 99);
  look.renderer = ['canvas', 'webgl'].includes(asked.get('renderer')) ? asked.get('renderer') : 'auto';
  const loop = numbers('loop').map((step) => lanes[0].indexOfStep(step));
  look.loop = loop.length === 2 ? [Math.min(...loop), Math.max(...loop)] : null;
  look.isLooping = look.loop !== null;
  chosen.bodies = numbers('body').filter(isBody);
  const contact = numbers('contact');
  chosen.contact = contact.length === 2 && contact.every(isBody) ? contact : null;
  const joint = number('joint', -1);
  chosen.joint = joint >= 0 && joint < lanes[0].joints.length ? joint : null;
  makeViews();
  fit();
  if (asked.has('zoom') && number('zoom', 0) > 0) {
    look.x = number('x', look.x);
    look.y = number('y', look.y);
    look.zoom = number('zoom', 1);
    look.isMoved = true;
  }
  tellControls();
  go(lanes[0].indexOfStep(number('step', lanes[0].steps[0])), true);
  showChosen();
};

// Playing.
let playedFrom = 0, playedAt = 0;
const setPlaying = (flag) => {
  if (flag === isPlaying && !flag) return;
  isPlaying = flag;
  element('play').textContent = flag ? 'Pause' : 'Play';
  element('play').setAttribute('aria-pressed', flag);
  const times = lanes[0].times;
  if (flag && look.isLooping && (clock < times[look.loop[0]] || clock >= times[look.loop[1]])) goToTime(times[look.loop[0]], true);
  else if (flag && clock >= times[lanes[0].last]) goToTime(times[0], true);
  playedFrom = clock;
  playedAt = performance.now();
  if (flag) requestAnimationFrame(tick); else remember();
  tell();
};
const tick = (at) => {
  if (!isPlaying) return;
  const times = lanes[0].times, end = look.isLooping ? times[look.loop[1]] : times[lanes[0].last];
  const time = playedFrom + Math.max(0, at - playedAt) / 1000 * look.speed;
  goToTime(Math.min(time, end), true);
  if (isDirty) draw();
  if (time < end) { requestAnimationFrame(tick); return; }
  if (look.isLooping && look.loop[1] > look.loop[0]) {
    goToTime(times[look.loop[0]], true);
    playedFrom = clock;
    playedAt = at;
    requestAnimationFrame(tick);
    return;
  }
  setPlaying(false);
};
const setLoop = (from, to) => {
  look.loop = from === null ? null : [Math.max(0, Math.min(from, to)), Math.min(lanes[0].last, Math.max(from, to))];
  look.isLooping = look.loop !== null;
  tellControls();
  remember();
};
const tellControls = () => {
  element('speed').value = String(look.speed);
  element('follow').checked = look.follows;
  element('mode').value = look.mode;
  element('levels').value = String(look.levels);
  for (const input of element('layers').querySelectorAll('input')) input.checked = look.layers.has(input.value);
  const band = element('band'), last = Math.max(lanes[0].last, 1);
  element('loop').setAttribute('aria-pressed', look.isLooping);
  band.hidden = !look.loop;
  if (look.loop) {
    band.style.left = `calc(${barInset}px + ${look.loop[0] / last} * (100% - ${2 * barInset}px))`;
    band.style.width = `calc(${(look.loop[1] - look.loop[0]) / last} * (100% - ${2 * barInset}px))`;
    element('loop').textContent = `Loop ${lanes[0].steps[look.loop[0]]} to ${lanes[0].steps[look.loop[1]]}`;
  } else {
    element('loop').textContent = 'Loop';
  }
};

// The pointer: a click chooses, a drag pans, two fingers or the wheel zoom.
const zoomAt = (view, clientX, clientY, factor) => {
  const box = view.over.getBoundingClientRect();
  const dx = (clientX - box.left - box.width / 2) / look.zoom, dy = (clientY - box.top - box.height / 2) / look.zoom;
  look.x += dx * (1 - 1 / factor);
  look.y -= dy * (1 - 1 / factor);
  look.zoom *= factor;
  look.isMoved = true;
  redraw();
  remember();
};
const listen = (view) => {
  const {over} = view, pointers = new Map();
  let press = null;
  over.addEventListener('pointerdown', (event) => {
    pointers.set(event.pointerId, event);
    over.setPointerCapture(event.pointerId);
    press = {x: event.clientX, y: event.clientY, lookX: look.x, lookY: look.y, isDrag: pointers.size > 1};
  });
  over.addEventListener('pointermove', (event) => {
    if (!press || !pointers.has(event.pointerId)) return;
    const before = [...pointers.values()];
    pointers.set(event.pointerId, event);
    const after = [...pointers.values()];
    if (after.length === 2) {
      const apart = ([a, b]) => Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
      zoomAt(view, (after[0].clientX + after[1].clientX) / 2, (after[0].clientY + after[1].clientY) / 2, apart(after) / (apart(before) || 1));
      press.isDrag = true;
      return;
    }
    press.isDrag = press.isDrag || Math.hypot(event.clientX - press.x, event.clientY - press.y) > 3;
    if (!press.isDrag || after.length > 1) return;
    look.x = press.lookX - (event.clientX - press.x) / look.zoom;
    look.y = press.lookY + (event.clientY - press.y) / look.zoom;
    look.isMoved = true;
    redraw();
  });
  const release = (event) => {
    pointers.delete(event.pointerId);
    if (!press) return;
    if (!press.isDrag && event.type === 'pointerup') {
      const box = over.getBoundingClientRect();
      const x = look.x + (event.clientX - box.left - box.width / 2) / look.zoom, y = look.y - (event.clientY - box.top - box.height / 2) / look.zoom;
      const near = (event.pointerType === 'touch' ? 14 : 6) / look.zoom;
      const thing = view.group.map((lane) => thingAt(lane, look.layers, x, y, near)).find((one) => Object.keys(one).length > 0);
      choose(thing || {}, event.shiftKey);
    } else {
      remember();
    }
    if (pointers.size === 0) press = null;
  };
  over.addEventListener('pointerup', release);
  over.addEventListener('pointercancel', release);
  over.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoomAt(view, event.clientX, event.clientY, Math.exp(-event.deltaY / 500));
  }, {passive: false});
};

// Moments: marks on the bar with small pictures, and a list.
const moments = data.moments;
const laneOf = (moment) => lanes[moment.lanes[0]];
const placeOf = (moment) => laneOf(moment).times[laneOf(moment).indexOfStep(moment.step)];
const goToMoment = (moment) => {
  setPlaying(false);
  goToTime(placeOf(moment));
  if (moment.bodies.length > 0) choose({body: moment.bodies[0]});
};
const drawThumbnail = (canvas, moment) => {
  const lane = laneOf(moment), back = lane.now.index, ratio = 2;
  canvas.width = 72 * ratio;
  canvas.height = 44 * ratio;
  lane.seek(lane.indexOfStep(moment.step));
  const body = moment.bodies.find((one) => data.bodies[one].type !== 'static'), size = {width: canvas.width, height: canvas.height, ratio};
  const isPlaced = body !== undefined && lane.isThere(body);
  size.x = isPlaced ? lane.x(body) : centerX;
  size.y = isPlaced ? lane.y(body) : centerY;
  size.scale = isPlaced ? canvas.height / (10 * Math.max(data.bodies[body].reach, 1e-6)) : 0.9 * Math.min(canvas.width / (right - left), canvas.height / (top_ - bottom));
  const pen = canvas.getContext('2d');
  drawBodies(pen, lane, size, false);
  drawLayers(pen, lane, size, new Set(['contacts']), {bodies: isPlaced ? [body] : [], contact: null, joint: null}, [], 0);
  lane.seek(back);
};
const mostThumbnails = 24;
const showMoments = () => {
  const list = element('moments'), marks = element('marks');
  list.replaceChildren();
  marks.replaceChildren();
  if (moments.length === 0) list.textContent = 'None was found.';
  marks.classList.toggle('pictured', moments.length > 0 && bodyCount <= 5000);
  const width = marks.clientWidth || 1;
  let free = -Infinity, drawn = 0;
  moments.forEach((moment) => {
    const share = shareOf(laneOf(moment), laneOf(moment).indexOfStep(moment.step));
    const row = document.createElement('li'), button = document.createElement('button'), mark = document.createElement('button');
    const names = moment.lanes.map((one) => lanes[one].name).join(', ');
    const text = moment.lanes.length < lanes.length ? `${names}: ${moment.text}` : moment.text;
    button.append(Object.assign(document.createElement('span'), {textContent: text}));
    mark.title = text;
    mark.setAttribute('aria-label', text);
    const place = Math.max(38, Math.min(width - 38, barInset + share * (width - 2 * barInset)));
    if (place >= free && drawn < mostThumbnails && bodyCount <= 5000) {
      const picture = document.createElement('canvas');
      drawThumbnail(picture, moment);
      mark.append(picture);
      mark.className = 'picture';
      free = place + 78;
      ++drawn;
    }
    mark.style.left = mark.className ? `${place}px` : `calc(${barInset}px + ${share} * (100% - ${2 * barInset}px))`;
    for (const one of [button, mark]) one.type = 'button', one.addEventListener('click', () => goToMoment(moment));
    row.append(button);
    list.append(row);
    marks.append(mark);
    const tick = document.createElement('i');
    tick.className = 'tick';
    tick.style.left = `calc(${barInset}px + ${share} * (100% - ${2 * barInset}px))`;
    marks.append(tick);
  });
};
const nextMoment = (way) => {
  const found = way > 0 ? moments.find((moment) => placeOf(moment) > clock + 1e-9) : moments.findLast((moment) => placeOf(moment) < clock - 1e-9);
  if (found) goToMoment(found);
};

const start = async () => {
  for (const lane of lanes) await lane.load();
  readColors();
  const mode = element('mode');
  if (lanes.length > 1) {
    mode.append(new Option('side by side', 'beside'), new Option('one over the other', 'over'));
    lanes.forEach((lane, i) => mode.append(new Option(`${lane.name} alone`, i)));
  } else {
    mode.append(new Option(lanes[0].name, '0'));
    mode.parentElement.hidden = true;
  }
  const hasTrees = lanes.some((lane) => lane.nodeStream);
  if (hasTrees) defaultLayers.push('tree');
  for (const [name, title] of Object.entries(layerNames)) {
    if (name === 'tree' && !hasTrees || ['contacts', 'impulses'].includes(name) && !lanes.some((lane) => lane.contactStream)) continue;
    if (name === 'joints' && lanes.every((lane) => lane.joints.length === 0)) continue;
    const label = document.createElement('label'), input = document.createElement('input');
    input.type = 'checkbox';
    input.value = name;
    input.addEventListener('change', () => {
      if (input.checked) look.layers.add(name); else look.layers.delete(name);
      redraw();
      tell();
      remember();
    });
    label.append(input, title);
    element('layers').append(label);
  }
  element('tree-tools').hidden = !hasTrees;
  if (hasTrees) {
    for (const lane of lanes) {
      for (const step of lane.nodeSteps || []) {
        const tick = document.createElement('i');
        tick.className = 'kept';
        tick.title = `the tree of step ${step} was kept`;
        tick.style.left = `calc(${barInset}px + ${shareOf(lane, lane.indexOfStep(step))} * (100% - ${2 * barInset}px))`;
        element('trees').append(tick);
      }
    }
  }
  const goToTree = (way) => {
    const times = lanes.flatMap((lane) => (lane.nodeSteps || []).map((step) => lane.times[lane.indexOfStep(step)])).sort((a, b) => a - b);
    const found = way > 0 ? times.find((time) => time > clock + 1e-9) : times.findLast((time) => time < clock - 1e-9);
    setPlaying(false);
    if (found !== undefined) goToTime(found);
  };
  element('last-tree').addEventListener('click', () => goToTree(-1));
  element('next-tree').addEventListener('click', () => goToTree(1));
  element('step').max = lanes[0].last;
  element('timeline').dataset.lanes = lanes.length;
  for (const lane of lanes) lane.seek(0);
  readAddress();
  for (const [name, [title, unitName]] of Object.entries(worldNames)) {
    const curves = lanes.filter((lane) => lane.series[name]).map((lane) => ({lane, values: lane.series[name]}));
    // A stage that never ran has no curve.
    if (curves.some(({values}) => values.some((value) => value !== 0))) worldPlots.push(new Plot(element('world'), title, unitName, curves, goToShare));
  }
  const drawPlots = () => { for (const plot of [...worldPlots, ...chosenPlots]) plot.draw(); };
  drawPlots();
  showMoments();
  tell();

  element('play').addEventListener('click', () => setPlaying(!isPlaying));
  const by = (count) => { setPlaying(false); go(lanes[0].now.index + count); };
  element('back').addEventListener('click', () => by(-1));
  element('on').addEventListener('click', () => by(1));
  element('speed').addEventListener('change', () => { look.speed = Number(element('speed').value); if (isPlaying) setPlaying(true); remember(); });
  element('mode').addEventListener('change', () => { look.mode = element('mode').value; makeViews(); if (!look.isMoved) fit(); redraw(); tell(); remember(); });
  element('levels').addEventListener('change', () => { look.levels = Number(element('levels').value); redraw(); remember(); });
  element('fit').addEventListener('click', () => { fit(); look.follows = false; tellControls(); redraw(); remember(); });
  element('follow').addEventListener('change', () => { look.follows = element('follow').checked; redraw(); remember(); });
  element('loop').addEventListener('click', () => {
    if (look.loop) setLoop(null);
    else setLoop(Math.max(0, lanes[0].now.index - Math.round(lanes[0].last / 20)), lanes[0].now.index + Math.round(lanes[0].last / 20));
  });
  element('step').addEventListener('input', () => { setPlaying(false); go(Number(element('step').value)); });
  document.addEventListener('keydown', (event) => {
    const isTyping = ['SELECT', 'INPUT'].includes(event.target.tagName) && event.target.type !== 'checkbox';
    if (isTyping && event.target.id !== 'step' || event.ctrlKey || event.altKey || event.metaKey) return;
    const keys = {
      ' ': () => event.target.tagName !== 'BUTTON' && (event.target.type !== 'checkbox') ? setPlaying(!isPlaying) : null,
      ArrowLeft: () => by(event.shiftKey ? -10 : -1), ArrowRight: () => by(event.shiftKey ? 10 : 1),
      Home: () => by(-Infinity), End: () => by(Infinity),
      '[': () => setLoop(lanes[0].now.index, look.loop ? look.loop[1] : lanes[0].last),
      ']': () => setLoop(look.loop ? look.loop[0] : 0, lanes[0].now.index),
      n: () => nextMoment(1), p: () => nextMoment(-1), f: () => element('fit').click(), Escape: () => choose({}),
    };
    const action = keys[event.key];
    if (!action || event.key === ' ' && (event.target.tagName === 'BUTTON' || event.target.type === 'checkbox')) return;
    event.preventDefault();
    action();
  });
  window.addEventListener('hashchange', readAddress);
  const renew = () => {
    readColors();
    drawPlots();
    showMoments();
    redraw();
    tell();
  };
  let renewing = null;
  window.addEventListener('resize', () => {
    clearTimeout(renewing);
    renewing = setTimeout(() => { sizeViews(); if (!look.isMoved) fit(); renew(); }, 100);
    redraw();
  });
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', renew);
  isDirty = false;
  redraw();
  element('timeline').session = {lanes, toX, toY, toAngle};  // for scripts that read the page
  element('timeline').dataset.ready = 'yes';
};
start().catch((error) => {
  element('where').textContent = `This browser cannot play the session: ${error.message}`;
  throw error;
});
