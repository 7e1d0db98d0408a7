#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# page.py PROGRAM FILE: runs the micro-benchmarks that documents speak of and writes their medians as a page.
# PROGRAM is build/release/tests/bench/scree_micro.

import datetime
import json
import pathlib
import re
import subprocess
import sys

SCENES = 'slow-explosion|falling-squares|tiles|mostly-static-single'
REPETITIONS = 5
PARTS = (
    ('Broad phases', f'^detect/.*/({SCENES})$',
     'Time to update all boxes and find all pairs, ns per moving box, by algorithm and scene. The boxes are those of the '
     'scene at its default size after 60 steps; they move back and forth between two steps.'),
    ('Pairs of shapes', '^collide/', 'Time of one manifold, ns. With `eight`, eight pairs are computed together.'),
    ('Rollback', '^rollback/', 'Time to save or restore a world, µs.'),
)


def measure(program, pattern):
    """Name, median of the processor time in ns (of an item, where there are several) and bytes of each benchmark."""
    run = subprocess.run([program, f'--benchmark_filter={pattern}', f'--benchmark_repetitions={REPETITIONS}',
                          '--benchmark_report_aggregates_only=true', '--benchmark_format=json'],
                         check=True, capture_output=True, text=True)
    units = {'ns': 1.0, 'us': 1e3, 'ms': 1e6, 's': 1e9}
    rows = []
    for one in json.loads(run.stdout)['benchmarks']:
        if one['aggregate_name'] != 'median':
            continue
        ofItem = [value * 1e9 for key, value in one.items() if key.startswith('s/')]
        time = ofItem[0] if ofItem else one['cpu_time'] * units[one['time_unit']]
        rows.append((one['run_name'], time, one.get('bytes/body')))
    return rows


def table(head, rows):
    lines = ['| ' + ' | '.join(head) + ' |', '|---|' + '---:|' * (len(head) - 1)]
    return '\n'.join(lines + ['| ' + ' | '.join(row) + ' |' for row in rows]) + '\n'


def number(value):
    return f'{value:,.0f}' if value >= 20 else f'{value:.1f}'


def broad_phases(rows):
    """A row per algorithm, a column per scene."""
    cells = {tuple(name.split('/')[1:3]): time for name, time, _ in rows}
    scenes = sorted({scene for _, scene in cells})
    algorithms = sorted({algorithm for algorithm, _ in cells}, key=lambda a: cells[a, 'tiles'])
    return table(['algorithm', *scenes], [[f'`{a}`', *(number(cells[a, s]) for s in scenes)] for a in algorithms])


def others(rows, scale):
    hasBytes = any(size is not None for *_, size in rows)
    head = ['benchmark', 'time', 'bytes a body'] if hasBytes else ['benchmark', 'time']
    return table(head, [[f'`{name}`', number(time / scale), *([number(size)] if hasBytes else [])]
                        for name, time, size in rows])


if len(sys.argv) != 3:
    sys.exit('usage: page.py PROGRAM FILE')
program, page = sys.argv[1], pathlib.Path(sys.argv[2])
root = pathlib.Path(__file__).resolve().parents[2]
commit = subprocess.run(['git', '-C', root, 'describe', '--always', '--dirty', '--abbrev=12'], capture_output=True,
                        text=True).stdout.strip() or 'unknown'
processor = re.search(r'^model name\s*:\s*(.*)$', pathlib.Path('/proc/cpuinfo').read_text(), re.M)
text = f'''# Kernels

One run of `tests/bench/page.py build/release/tests/bench/scree_micro FILE`: processor time of one thread, medians of
{REPETITIONS}.

- processor: {processor[1] if processor else 'unknown'}
- commit: {commit}
- date: {datetime.date.today()}
'''
for title, pattern, what in PARTS:
    rows = measure(program, pattern)
    if not rows:
        sys.exit(f'{program}: no benchmark is called {pattern}')
    body = broad_phases(rows) if title == 'Broad phases' else others(rows, 1e3 if title == 'Rollback' else 1.0)
    text += f'\n## {title}\n\n{what}\n\n{body}'
page.write_text(text)
subprocess.run([sys.executable, root / 'tests/docs/sign_page.py', page], check=True)
