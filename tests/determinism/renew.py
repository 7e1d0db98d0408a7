#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# tests/determinism/renew.py [PROGRAM]: writes the golden state hashes anew, into golden_hashes.h and scene_hashes.h, as
# scree_check gives them. Without PROGRAM it builds the one of build/release. For changes that are meant to change the
# bits; say in the commit why. Prints how many differ from those that stood there.

import pathlib
import re
import subprocess
import sys

folder = pathlib.Path(__file__).resolve().parent
root = folder.parent.parent
HASH = r'0x[0-9a-f]{16}'


def run_check():
    if len(sys.argv) > 1:
        program = pathlib.Path(sys.argv[1]).resolve()
    else:
        subprocess.run(['cmake', '--build', 'build/release', '--target', 'scree_check'], cwd=root, check=True,
                       stdout=subprocess.DEVNULL)
        program = root / 'build/release/tests/platforms/scree_check'
    # It fails where hashes differ, which is why it is run; its last line tells that it came to its end.
    text = subprocess.run([program, 'golden'], stdout=subprocess.PIPE, text=True).stdout
    if not re.search(r'^failures \d+$', text, re.M):
        sys.exit(f'scree: {program} golden has not come to its end')
    found = {'golden': {}, 'state': {}}
    for word, scene, kind, value in re.findall(r'^(golden|state) (\S+) (\w+) ([0-9a-f]{16})$', text, re.M):
        found[word].setdefault(scene, {})[kind] = '0x' + value
    return found


def renew(name, change):
    path = folder / name
    old = path.read_text()
    new = change(old)
    before, after = re.findall(HASH, old), re.findall(HASH, new)
    common = sum(a == b for a, b in zip(before, after))
    print(f'{name}: {len(after)} hashes, {len(after) - common} new')
    path.write_text(new)


found = run_check()
golden, states = found['golden'], found['state']


def longer_runs(text):
    text = re.sub(rf'(\{{"([a-z0-9-]+)", \d+, \d+, ){HASH}, {HASH}\}}',
                  lambda row: '{}{sequential}, {soft}}}'.format(row[1], **golden[row[2]]), text)
    return re.sub(rf'(goldenRound\[2\] = ){{{HASH}, {HASH}}}',
                  lambda row: '{}{{{sequential}, {tolerant}}}'.format(row[1], **golden['round-shapes']), text)


def calls(text):
    hashes = [golden['calls'][str(group)] for group in range(len(golden['calls']))]
    rows = ''.join(f'\n    {", ".join(hashes[i:i + 5])},' for i in range(0, len(hashes), 5))
    return re.sub(r'(goldenCalls\[\d+\] = \{)[^}]*\}', lambda table: table[1] + rows + '\n}', text)


def scenes(text):
    rows = ''.join('    {{"{}", {{{sequential}, {soft}, {tolerant}}}}},\n'.format(scene, **kinds)
                   for scene, kinds in states.items())
    return re.sub(r'(sceneHashes\[\] = \{\n).*?(\};)', lambda table: table[1] + rows + table[2], text, flags=re.S)


renew('golden_hashes.h', lambda text: calls(longer_runs(text)))
renew('scene_hashes.h', scenes)
