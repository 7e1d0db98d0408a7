#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Draws the two pictures of engine/docs/internals.md from the sources: the layers from their includes, and a step from the
# calls of engine/src/world/step.cpp and of a sub-step in pipeline/solve_soft.cpp. Fails if a committed picture is not the
# one that it draws, or if the table of a step in engine/README.md names other stages. --update writes the pictures anew.

import pathlib
import re
import sys
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENGINE = ROOT / 'engine'
PICTURES = ENGINE / 'docs/pictures'

# What a layer holds, in the words of the picture. Layers of one rank stand from left to right in this order.
LAYERS = {'base': 'vectors, threads, slots', 'geometry': 'functions of shapes', 'state': 'tables of all objects',
          'broad_phase': 'boxes to pairs', 'constraints': 'rows of contacts and joints', 'pipeline': 'stages of a step',
          'world': 'handles, checks, files'}

# A stage by the function that step.cpp calls: its title, its files in pipeline/, and a line about it.
STAGES = {
    'FindPairsOfEdited': ('pairs of edits', 'find_pairs.cpp', 'what the program changed since the last step'),
    'UpdateManifolds': ('narrow phase', 'narrow_phase.cpp', 'contact points; contacts begin and end'),
    'GatherLists': ('islands', 'find_islands.cpp', 'which bodies are solved together'),
    'RunSolver': ('solver', 'solve_islands.cpp, solve_soft.cpp', 'new velocities and positions; sleep'),
    'RunContinuous': ('continuous', 'continuous.cpp', 'times of impact, so that nothing tunnels'),
    'FindPairsOfMoved': ('pairs of what moved', 'find_pairs.cpp', 'new boxes, their pairs, their contacts'),
}

# A phase of a sub-step by the functions that it consists of, in their order.
PHASES = {
    'bounce': (['Bounce'], 'restitution'),
    'kick': (['ExpectContacts', 'KickAll'], 'forces, and impulses already known'),
    'solve': (['PrepareRows', 'ProjectTrees', 'SolveRows', 'SolveContacts'], 'joint rows, contacts with push'),
    'aim': (['AimTrees'], 'speeds that will close the joints'),
    'move': (['DriftAll', 'CorrectRows'], 'positions'),
    'stop': (['StopTrees', 'StopRows'], 'no speed along joints'),
    'relax': (['Relax'], 'contacts without push'),
}

STYLE = '''<style>
.paper { fill: #ffffff } .box { fill: #eef3f8; stroke: #4a6a8a } .note { fill: #f6f1e4; stroke: #9a7a2e }
.line { stroke: #55606b; fill: none; stroke-width: 1.6 } .tip { fill: #55606b } .dash { stroke-dasharray: 5 4 }
text { font: 14px "DejaVu Sans", Verdana, sans-serif; fill: #1c2126 } .name { font-weight: bold }
.small { font-size: 12px; fill: #55606b } .file { font: 12px "DejaVu Sans Mono", monospace; fill: #55606b }
@media (prefers-color-scheme: dark) {
.paper { fill: #14181c } .box { fill: #1f2b38; stroke: #7ea3c8 } .note { fill: #2e2919; stroke: #cfae5c }
.line { stroke: #a3adb8 } .tip { fill: #a3adb8 } text { fill: #e8ecf0 } .small, .file { fill: #a9b3bd } }
</style>'''


def fail(message):
    sys.exit(f'diagrams.py: {message}')


class Drawing:
    def __init__(self, width, height, title, description):
        self.parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
                      f'height="{height}" role="img">', '<!-- Drawn by tests/docs/diagrams.py. -->',
                      f'<title>{title}</title>', f'<desc>{description}</desc>', STYLE,
                      f'<rect class="paper" width="{width}" height="{height}" rx="8"/>']

    def box(self, x, y, width, height, kind='box'):
        self.parts.append(f'<rect class="{kind}" x="{x}" y="{y}" width="{width}" height="{height}" rx="6"/>')

    def text(self, x, y, words, kind='', middle=False):
        anchor = ' text-anchor="middle"' if middle else ''
        words = words.replace('&', '&amp;').replace('<', '&lt;')
        self.parts.append(f'<text class="{kind}" x="{x}" y="{y}"{anchor}>{words}</text>')

    def arrow(self, points, dashed=False, tip=True):
        """Along the points; the last leg is straight down, up, left or right, or slanted downwards."""
        (x0, y0), (x1, y1) = points[-2:]
        length = ((x1 - x0)**2 + (y1 - y0)**2)**0.5
        ux, uy = (x1 - x0) / length, (y1 - y0) / length
        if tip:
            end = (x1 - 8 * ux, y1 - 8 * uy)
            corners = [(x1, y1), (end[0] - 4 * uy, end[1] + 4 * ux), (end[0] + 4 * uy, end[1] - 4 * ux)]
            self.parts.append('<path class="tip" d="M' + ' L'.join(f'{x:.1f} {y:.1f}' for x, y in corners) + ' Z"/>')
            points = [*points[:-1], end]
        path = ' L'.join(f'{x:.1f} {y:.1f}' for x, y in points)
        self.parts.append(f'<path class="line{" dash" if dashed else ""}" d="M{path}"/>')

    def finish(self):
        return '\n'.join([*self.parts, '</svg>', ''])


def includes():
    """For each layer the lower layers that it includes directly."""
    found = {layer: set() for layer in LAYERS}
    for file in (ENGINE / 'src').rglob('*'):
        if file.suffix not in ('.h', '.cpp', '.inc'):
            continue
        own = file.relative_to(ENGINE / 'src').parts[0]
        if own not in LAYERS:
            fail(f'{file.relative_to(ROOT)} is in a folder that LAYERS does not describe')
        for name in re.findall(r'^#include "(\w+)/', file.read_text(), re.M):
            if name in LAYERS and name != own:
                found[own].add(name)
    return found


def reduce(below):
    """Without the arrows that a chain of others already implies."""
    def reach(layer):
        found = set(below[layer])
        for other in below[layer]:
            found |= reach(other)
        return found
    return {layer: sorted(other for other in below[layer] if not any(other in reach(b) for b in below[layer] - {other}))
            for layer in below}


def draw_layers():
    below = includes()
    rank = {}
    def rank_of(layer, path=()):
        if layer in path:
            fail('includes go in a circle: ' + ' → '.join([*path, layer]))
        if layer not in rank:
            rank[layer] = 1 + max((rank_of(other, (*path, layer)) for other in below[layer]), default=-1)
        return rank[layer]
    for layer in below:
        rank_of(layer)
    levels = max(rank.values()) + 1
    # An arrow past a row takes a place in it, so that it crosses no box.
    arrows = [(layer, other) for layer, others in reduce(below).items() for other in others]
    rows = [[layer for layer in LAYERS if rank[layer] == level] for level in range(levels)]
    for layer, other in arrows:
        for level in range(rank[other] + 1, rank[layer]):
            rows[level].append((layer, other))

    width, row, box_width, box_height = 900, 92, 200, 52
    left, right = 220, width - 20
    height = 20 + levels * row
    described = '; '.join(f'{layer} includes {", ".join(sorted(below[layer])) or "no other"}' for layer in LAYERS)
    d = Drawing(width, height, 'The layers of the engine', described)
    place = {}
    for level, names in enumerate(rows):
        step = (right - left) / len(names)
        for i, name in enumerate(names):
            place[name] = (left + step * (i + 0.5) - box_width / 2, 30 + (levels - 1 - level) * row)

    def port(end, layer, ends):
        """x on the edge of a box: its arrows are spread in the order of where they go."""
        ends = sorted(ends, key=lambda other: place[other][0])
        return place[layer][0] + box_width * (ends.index(end) + 1) / (len(ends) + 1)

    def next_on(layer, other):
        return (layer, other) if (layer, other) in place else other
    for layer, other in arrows:
        first = next_on(layer, other)
        start = port(first, layer, [next_on(*arrow) for arrow in arrows if arrow[0] == layer])
        came = (layer, other) if first != other else layer
        end = port(came, other, [arrow if arrow in place else arrow[0] for arrow in arrows if arrow[1] == other])
        points = [(start, place[layer][1] + box_height)]
        if first != other:
            x = place[first][0] + box_width / 2
            top, bottom = place[first][1], 30 + (levels - 2 - rank[other]) * row
            points += [(x, top), (x, bottom + box_height)]
        d.arrow([*points, (end, place[other][1])])
    for layer, words in LAYERS.items():
        x, y = place[layer]
        d.box(x, y, box_width, box_height)
        d.text(x + box_width / 2, y + 22, layer + '/', 'name', True)
        d.text(x + box_width / 2, y + 40, words, 'small', True)

    # The public headers stand beside all layers: their values are used by each, their classes are implemented by world/.
    top, bottom = place['world'][1], 30 + (levels - 1) * row + box_height
    headers = top + row
    d.box(20, top, 180, box_height, 'note')
    d.text(110, top + 22, 'compat/', 'name', True)
    d.text(110, top + 40, "Box2D 2.4's names", 'small', True)
    d.box(20, headers, 180, bottom - headers, 'note')
    d.text(110, headers + 28, 'include/scree/', 'name', True)
    for i, words in enumerate(['public headers:', 'every layer uses', 'their values,', 'world/ implements', 'their classes']):
        d.text(110, headers + 54 + 18 * i, words, 'small', True)
    d.arrow([(110, top + box_height), (110, headers)])
    wx = place['world'][0]
    d.arrow([(wx, top + box_height / 2), (215, top + box_height / 2), (215, headers + 20), (200, headers + 20)], dashed=True)
    return d.finish()


def body_of(source, signature):
    """What stands between the braces of the function that the signature begins."""
    start = source.index('{', source.index(signature))
    depth = 0
    for i in range(start, len(source)):
        depth += {'{': 1, '}': -1}.get(source[i], 0)
        if depth == 0:
            return source[start + 1:i]
    fail(f'no end of {signature}')


def stages_of_step():
    """[(function, field of Profile)] in the order in which step.cpp runs them."""
    source = (ENGINE / 'src/world/step.cpp').read_text()
    bodies = {'Advance': body_of(source, 'void Advance('), 'RunStages': body_of(source, 'void RunStages(')}
    found, waiting = [], []

    def walk(text):
        for match in re.finditer(r'profile\.(\w+) \+?= watch\.Lap\(\)|\b(\w+)\(', text):
            if match[1]:
                found.extend((function, match[1]) for function in waiting)
                waiting.clear()
            elif match[2] in bodies:
                walk(bodies[match[2]])
            elif match[2] in STAGES:
                waiting.append(match[2])
    walk(body_of(source, 'StepReport RunStep('))
    if [function for function, _ in found] != list(STAGES):
        fail(f'step.cpp runs {found}, and STAGES lists {list(STAGES)}')
    return found


def check_table(stages):
    """The table of engine/README.md names these files and fields in this order."""
    text = (ENGINE / 'README.md').read_text()
    section = text.partition('\n## One step\n')[2].partition('\n## ')[0]
    rows = [line.split('|')[2:5:2] for line in section.split('\n') if line.startswith('| ') and '`pipeline/' in line]
    for (function, field), (file, column) in zip(stages, rows):
        if not all(name in file for name in STAGES[function][1].split(', ')) or field not in column:
            fail(f'engine/README.md: the row of {STAGES[function][0]} should name {STAGES[function][1]} and {field}')
    if len(rows) < len(stages):
        fail('engine/README.md: the table of a step has too few rows')


def check_phases():
    source = (ENGINE / 'src/pipeline/solve_soft.cpp').read_text()
    calls = re.findall(r'^\s*(\w+)\(', body_of(source, 'void Substep(int index)'), re.M)
    expected = [function for functions, _ in PHASES.values() for function in functions]
    if calls != expected:
        fail(f'solve_soft.cpp: a sub-step calls {calls}, and PHASES lists {expected}')


def draw_step():
    stages = stages_of_step()
    check_table(stages)
    check_phases()
    for function, _ in stages:
        for name in STAGES[function][1].split(', '):
            if not (ENGINE / 'src/pipeline' / name).exists():
                fail(f'pipeline/{name} does not exist')

    width, row, box_height, x, box_width = 900, 84, 60, 150, 330
    height = 40 + row * len(stages)
    described = '; then '.join(f'{STAGES[function][0]} ({STAGES[function][1]})' for function, _ in stages)
    d = Drawing(width, height, 'One step of a world', described)
    middle = x + box_width / 2
    solver = 0
    for i, (function, field) in enumerate(stages):
        title, file, words = STAGES[function]
        y = 30 + row * i
        if function == 'RunSolver':
            solver = y
        d.box(x, y, box_width, box_height)
        d.text(x + 12, y + 21, title, 'name')
        d.text(x + box_width - 12 - 7.3 * len(file), y + 21, file, 'file')
        d.text(x + 12, y + 44, words, 'small')
        d.text(24, y + 35, field, 'file')
        d.arrow([(126, y + 30), (x, y + 30)], dashed=True, tip=False)
        if i + 1 < len(stages):
            d.arrow([(middle, y + box_height), (middle, y + row)])
    last = 30 + row * (len(stages) - 1) + box_height
    d.text(24, 18, 'field of Profile', 'small')
    d.arrow([(middle, last), (middle, last + 14), (12, last + 14), (12, 24), (middle, 24), (middle, 30)], dashed=True)
    d.text(middle + 10, last + 18, 'next step', 'small')

    # What the soft step does in each sub-step.
    px, pw, ph = 536, 344, 34
    py = 30
    panel = 60 + ph * len(PHASES)
    d.box(px, py, pw, panel, 'note')
    d.text(px + 14, py + 24, 'soft step: each sub-step', 'name')
    for i, (phase, (_, words)) in enumerate(PHASES.items()):
        y = py + 58 + ph * i
        d.text(px + 40, y, f'{i + 1}  {phase}', 'name')
        d.text(px + 122, y, words, 'small')
        if i + 1 < len(PHASES):
            d.arrow([(px + 46, y + 6), (px + 46, y + ph - 14)])
    bottom = py + 58 + ph * (len(PHASES) - 1)
    d.arrow([(px + 34, bottom - 4), (px + 18, bottom - 4), (px + 18, py + 54), (px + 34, py + 54)])
    d.arrow([(x + box_width, solver + 30), (px - 40, solver + 30), (px - 40, py + 100), (px, py + 100)], dashed=True)
    return d.finish()


drawings = {'layers.svg': draw_layers(), 'step.svg': draw_step()}
old = []
for name, drawing in drawings.items():
    xml.etree.ElementTree.fromstring(drawing)  # throws if it is not well-formed
    path = PICTURES / name
    if '--update' in sys.argv:
        PICTURES.mkdir(exist_ok=True)
        path.write_text(drawing)
    elif not path.exists() or path.read_text() != drawing:
        old.append(name)
if old:
    fail(f'{", ".join(old)} in engine/docs/pictures is not what the sources say: tests/docs/diagrams.py --update')
print(f'{len(drawings)} pictures are what the sources say')
