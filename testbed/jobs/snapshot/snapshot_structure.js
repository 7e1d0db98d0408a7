// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Structure and makers: bodies, nodes and contacts that differ, and how both pictures were made.

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
