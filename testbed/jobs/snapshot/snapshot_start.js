// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Keyboard, and the first view.

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
