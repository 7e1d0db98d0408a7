#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Runs one example of engine/docs/examples and compares what it prints with the lines under `// Output:` at its end.
# Arguments: the source, the program, a scratch folder.

import pathlib
import subprocess
import sys

source, program, scratch = sys.argv[1:4]
_, mark, tail = pathlib.Path(source).read_text().partition('\n// Output:\n')
expected = [line.removeprefix('// ') for line in tail.strip().split('\n')]
if not mark or expected == ['']:
    sys.exit(f'{source}: there is no "// Output:" at the end')
pathlib.Path(scratch).mkdir(parents=True, exist_ok=True)
run = subprocess.run([program], cwd=scratch, capture_output=True, text=True, timeout=60)
printed = run.stdout.strip().split('\n')
if run.returncode != 0 or printed != expected or run.stderr:
    sys.exit(f'{source}: exit code {run.returncode}\nexpected {expected}\nprinted  {printed}\n{run.stderr}')
