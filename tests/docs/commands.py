#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Runs every command line of the pages, in a scratch folder, on smaller worlds where the page's would take long: what is
# held is that each line is understood and ends well. Arguments: the folder of the sources, the program, a program that
# writes session.recording, a scratch folder, and words that a line must have to be run (none: all lines).

import os
import pathlib
import re
import shutil
import subprocess
import sys

root, program, recorder, scratch = map(pathlib.Path, sys.argv[1:5])
words = sys.argv[5:]

# Held elsewhere: pages and reports with a test of their own, what installs or builds, and another machine's queue.
OTHER_TESTS = ('testbed/docs/own-world.md',)
NOT_RUN = re.compile(r'^(tests/run|tests/fuzz/run|tests/platforms/run|tests/determinism/renew|tests/capture/|cmake |g\+\+ |sbatch |sudo |apt|dpkg|ctest|build/|git |cd |\.ci/|SCREE_RECORD=|testbed/run requires (--quick -o|--ablation))')
SMALL = {'tiles': 20, 'mixed': 100, 'slow-explosion': 100, 'tumbler': 50, 'falling-squares': 20, 'pyramid': 6}


def lighter(line):
    """The line on a smaller world; what it asks for stays."""
    line = line.replace('my-tower', 'box-stack')
    command = re.search(r'\bscree ([a-z-]+)', line)
    command = command[1] if command else ''
    extra = []
    if command in ('overlap', 'render'):
        extra.append('--image 640x400')
    if command == 'metrics':
        extra.append('--image 160x100')  # every step is counted over as many pixels
    line = line.replace('tiles add-pair-400', 'pyramid add-pair-400')  # which has one size: tiles would be whole
    if command in ('overlap', 'render', 'metrics', 'view'):
        for scene, size in SMALL.items():
            if re.search(rf'\b{scene}\b(?!-|\.)', line) and '--size' not in line and 'add-pair' not in line:
                extra.append(f'--size {size}')
    if command == 'view' and '--offscreen' not in line:
        extra.append('--offscreen --frames 2 --no-times')
    line = re.sub(r'--against \S+', f'--against {program}', line)
    if command == 'bench' and '--from' not in line:
        line = re.sub(r'--(repeat|steps) \d+', '', line)
        line = re.sub(r'--sizes [\w,@]+', '--sizes 100,200', line)
        if not re.search(r'bench (?!-)\S', line):
            line = line.replace('scree bench', 'scree bench pyramid')
        extra.append('--repeat 1 --steps 3')
        if '--sizes' not in line and 'scene.json' not in line:
            extra.append('--sizes 12')  # legal in every scene
    if command == 'tradeoff' and re.search(r'tradeoff (?!-)\S', line):
        extra.append('--seconds 0.2')
    elif command == 'tradeoff' and ' -g' not in line and '--from' not in line:
        extra.append('-g incline')
    if command == 'tradeoff' and '--quick' not in line and '--from' not in line:
        extra.append('--quick')
    if command == 'extremes' and ' -g' not in line and '--from' not in line:
        extra.append('-g friction')
    if command == 'requires':
        extra.append('--quick' if '--quick' not in line else '')
        extra.append('--steps 5' if '--steps' not in line and re.search(r'requires (?!-)\S', line) else '')
    if command == 'snapshot' and '--scenes' not in line and not re.search(r'snapshot (list|merge)', line):
        line = line.replace("'^tiles/'", "'^box-stack/'" if 'snapshot accept' in line else "'^pyramid/'")
        extra.append('--references references' if '--references' not in line else '')
        extra.append("-g '^box-stack/'" if ' -g' not in line and 'snapshot accept' not in line else '')
    extra = ' '.join(word for word in extra if word)
    head, mark, tail = line.partition(' ::: ')  # arguments of parallel come last
    return f'{head} {extra}{mark}{tail}'


def prepare():
    shutil.rmtree(scratch, ignore_errors=True)
    for folder in ('bin', 'levels', 'out', 'references/box-stack', 'references/pyramid'):
        (scratch / folder).mkdir(parents=True)
    (scratch / 'bin/scree').symlink_to(program)
    for scene in ('box-stack', 'pyramid'):
        for file in (root / 'tests/snapshots' / scene).iterdir():
            shutil.copy(file, scratch / 'references' / scene)
    for line in ('scree convert pyramid level-3.scene.json --size 4', 'scree convert box-stack levels/1.scene.json --size 4',
                 'scree convert box-stack session.track --size 4', str(recorder),
                 'scree bench pyramid --sizes 20 --steps 3 --repeat 1 --json all.json',
                 'scree render pyramid --size 4 --step 1 --image 160x100 -o a && cp a/pyramid/step-0001/render-scree.png a.png',
                 'cp a.png b.png'):
        run = execute(line)
        if run.returncode != 0:
            sys.exit(f'{line}: exit code {run.returncode}\n{run.stdout}')


def execute(line):
    path = f'{scratch / "bin"}{os.pathsep}{os.environ["PATH"]}'
    return subprocess.run(['bash', '-c', line], cwd=scratch, env={**os.environ, 'PATH': path}, timeout=300,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def lines():
    for page in sorted(root.rglob('*.md')):
        name = page.relative_to(root)
        if name.parts[0] in ('build', 'out', '.git', '.ci') or str(name) in OTHER_TESTS:
            continue
        text = page.read_text()
        for block in re.finditer(r'^```sh\n(.*?)^```', text, flags=re.S | re.M):
            number = text[:block.start()].count('\n') + 1
            for line in block[1].replace('\\\n', '  ').split('\n'):
                number += 1
                if line.strip() and not line.startswith('#'):
                    yield f'{name}:{number}', re.sub(r'\s+# .*$', '', line)


prepare()
has_box2d3 = not re.search(r'^box2d3\s+not found', execute('scree env').stdout, re.M)
failures, count, left = [], 0, 0
for place, line in lines():
    if not all(word in line for word in words):
        continue
    if NOT_RUN.match(line) or ('box2d3' in line and not has_box2d3):
        left += 1
        continue
    light = lighter(line.replace('testbed/run ', 'scree '))
    run = execute(light)
    count += 1
    # 1 is an answer where a command asks for something: it was found, differs, or was missed.
    asks = re.search(r'scree (find|diff|snapshot (check|verify))|--targets|--at-least', light)
    if run.returncode != 0 and not (run.returncode == 1 and asks):
        failures.append(f'{place}: {line}\n  as {light}\n  exit code {run.returncode}: {run.stdout[-600:]}')
print('\n'.join(failures))
print(f'{count} command lines run, {left} held elsewhere, {len(failures)} failed')
sys.exit(1 if failures or (not words and count < 20) else 0)
