#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Makes the pictures of the guides again and compares them pixel by pixel with the committed ones: the overlap of trees, the
# window, timelines, a report, and what is seen of the session of a game. Where a picture shows times, its sidecar has a mask.
# Pictures of pages also depend on the browser: with another Chromium than the sidecar names, only their size is compared.
# Arguments: the program, the game, a scratch folder, and --update to write the pictures.

import json
import pathlib
import shutil
import struct
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURES = ROOT / 'testbed/pictures'
program, game, scratch = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
update = '--update' in sys.argv

# Dear ImGui places smooth edges with the processor's reciprocal square root, whose relative error is up to 1.5 / 4096 and not the
# same on all processors. Of 255 levels that is 0.1: a rounded one may be the next. Seen between an AMD EPYC and an Intel Xeon.
RSQRT = 'processors differ in reciprocal square roots, which place smooth edges'
# For each picture in pages/: the command that makes what it shows, and the boxes in which it shows times or which engines
# were built. For a page, also its address in the scratch folder and the size of the picture; for another one, the file if it
# is not called like the picture. The documentation names the same commands.
PAGES = {
    'window': {'command': 'view pyramid --offscreen --frames 240 --screenshot window.png', 'mask': [[237, 665, 968, 800], [640, 4, 1110, 26]],
               'tolerance': 1, 'reason': 'times and the list of built engines differ; ' + RSQRT},
    'timeline': {'command': 'timeline restitution-row --set continuous=off --set timeStep=1/10 --steps 40 -o balls.html',
                 'page': 'balls.html#step=14&body=7', 'size': (1440, 957), 'mask': [[40, 770, 1062, 957]]},
    'report': {'command': "snapshot check -g '^(tumbler|pyramid)/' --set iterations=2/1 --report report",
               'page': 'report/index.html', 'size': (1200, 860), 'mask': [[416, 104, 595, 173]]},
    'session-trees': {'command': 'overlap session.track --step 60 -o out', 'file': 'out/session/step-0060/compare.png', 'mask': []},
    'session-escape': {'command': 'find session.track --escape=-18,-2,18,30 --pictures out/escape',
                       'file': 'out/escape/01-escape-step-0176.png', 'mask': []},
    'session': {'command': 'timeline session.track --escape=-18,-2,18,30 -o session.html',
                'page': 'session.html#step=150&body=175', 'size': (1440, 860), 'mask': [[40, 700, 1062, 860]]},
}
OVERLAP = {'command': 'overlap tiles add-pair-400 -o testbed/pictures',
           'files': ['tiles/step-0090/compare.png', 'tiles/step-0090/difference.png', 'add-pair-400/step-0020/compare.png',
                     'add-pair-400/step-0020/difference.png']}
# Without network, and with a profile of its own, so that other browsers are left alone.
BROWSER = ['chromium', '--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--hide-scrollbars',
           '--disable-background-networking', '--disable-component-update', '--disable-sync', '--force-device-scale-factor=1',
           '--virtual-time-budget=4000', f'--user-data-dir={scratch / "profile"}']


def run(command, expected=(0,)):
    done = subprocess.run(command, cwd=scratch, capture_output=True, text=True, timeout=300, shell=isinstance(command, str))
    if done.returncode not in expected:
        sys.exit(f'{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}')
    return done.stdout


def size_of(path):
    return struct.unpack('>II', path.read_bytes()[16:24])


def differs(committed, new):
    done = subprocess.run([program, 'diff', committed, new, '-o', scratch / 'diff'], capture_output=True, text=True)
    said.append((done.stdout or done.stderr).split('\n')[0])
    return done.returncode != 0


def draw(name, page):
    width, height = page['size']
    run([*BROWSER, f'--window-size={width},{height}', f'--screenshot={scratch / (name + ".png")}', f'file://{scratch}/{page["page"]}'])


shutil.rmtree(scratch, ignore_errors=True)
(scratch / 'testbed').mkdir(parents=True)
run([game])  # session.track
references = f' --references {ROOT / "tests/snapshots"}'
chromium = run(['chromium', '--version']).split(' built')[0].strip() if shutil.which('chromium') else None
said, failed = [], False
for name, picture in PAGES.items():
    isPage = 'page' in picture
    if isPage and chromium is None:
        said.append(f'{name}: not made, since chromium is not installed')
        continue
    command = picture['command'] + (references if picture['command'].startswith('snapshot') else '')
    run(f'{program} {command}', (0, 1))  # 1: pictures differ, or something is found, as it is meant to
    if isPage:
        draw(name, picture)
    new, committed, sidecar = scratch / picture.get('file', f'{name}.png'), PICTURES / f'pages/{name}.png', PICTURES / f'pages/{name}.json'
    if update:
        shutil.copy(new, committed)
        facts = {'command': 'scree ' + picture['command']}
        if picture['mask']:
            tolerance = {'tolerance': picture['tolerance']} if 'tolerance' in picture else {}
            facts['compare'] = {**tolerance, 'mask': picture['mask'], 'reason': picture.get('reason', 'times differ from run to run')}
        if isPage:
            facts['chromium'] = chromium
        sidecar.write_text(json.dumps(facts, indent=2) + '\n')
    elif isPage and json.loads(sidecar.read_text())['chromium'] != chromium:
        said.append(f'{name}: only its size is compared, since it was made by another browser')
        failed |= size_of(new) != size_of(committed)
    elif differs(committed, new):
        # On a busy machine the browser may be ready before the pictures of a page are.
        if isPage:
            draw(name, picture)
        failed |= not isPage or differs(committed, new)

run(f'{program} {OVERLAP["command"]}')
for name in OVERLAP['files']:
    new, committed = scratch / 'testbed/pictures' / name, PICTURES / name
    if not differs(committed, new):
        continue
    if update:
        shutil.copy(new, committed)
    else:
        failed = True

pages = '\n'.join(page.read_text() for page in (ROOT / 'testbed/docs').glob('*.md'))
for command in [OVERLAP['command'], *(picture['command'] for picture in PAGES.values())]:
    if not any(text in pages for text in (f'`testbed/run {command}`', f'\ntestbed/run {command}\n', f'\nscree {command}\n')):
        said.append(f'no page of testbed/docs names the command: {command}')
        failed = True
print('\n'.join(said))
if failed:
    sys.exit('to write the pictures: tests/docs/pictures.py PROGRAM GAME FOLDER --update')
