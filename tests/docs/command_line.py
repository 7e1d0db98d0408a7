#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Is testbed/docs/command-line.md what the program writes? Also holds --help of every command to what the page says: each
# command has a section and names its exit codes. Arguments: the program, and --update to write the page anew.

import difflib
import pathlib
import re
import subprocess
import sys
import tempfile

page = pathlib.Path(__file__).resolve().parents[2] / 'testbed/docs/command-line.md'
program = pathlib.Path(sys.argv[1]).resolve()


def run(*words):
    return subprocess.run([program, *words], check=True, capture_output=True, text=True).stdout


with tempfile.TemporaryDirectory() as folder:
    written = pathlib.Path(folder) / 'page.md'
    run('man', '--reference', str(written))
    text = written.read_text()

if '--update' in sys.argv:
    page.write_text(text)

errors = []
commands = re.findall(r'^  (\w+) ', run('--help').split('Subcommands:')[1], re.M)
for command in commands:
    said = run(command, '--help')
    if f'\n## scree {command}\n' not in text:
        errors.append(f'{command}: no section on the page')
    if 'Exit codes: 0 done' not in said:
        errors.append(f'{command} --help does not say its exit codes')
    if re.search(r'\bboth engines\b', said):
        errors.append(f'{command} --help says "both engines", and there are more')
    for option in re.findall(r'^  (?:-\w,)?(--[\w-]+)', said, re.M):
        if option not in text:
            errors.append(f'{command} {option}: not on the page')

old = page.read_text() if page.exists() else ''
if old != text:
    errors += list(difflib.unified_diff(old.split('\n'), text.split('\n'), str(page.name), 'the program', lineterm='', n=0))
    errors.append('the page is old: tests/docs/command_line.py PROGRAM --update')
print('\n'.join(errors) if errors else f'{len(commands)} commands, the page is what the program writes')
sys.exit(1 if errors or not commands else 0)
