#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Does Box2D have the names that the page on porting gives it? Left columns of tables are looked up in the headers of
# Box2D 2.4 above the heading "Box2D 3", and in those of Box2D 3 below it, if they are installed. Arguments: the page, the
# folder of the headers of Box2D 2.4, and that of Box2D 3 or nothing.

import pathlib
import re
import sys

page = pathlib.Path(sys.argv[1]).read_text()
before, _, after = page.partition('\n## Box2D 3\n')
errors, count = [], 0
for text, folder in zip((before, after), sys.argv[2:]):
    words = set()
    for header in pathlib.Path(folder).rglob('*.h'):
        words |= set(re.findall(r'\w+', header.read_text()))
    for cell in re.findall(r'^\| ([^|]*) \|', text, re.M):
        for name in re.findall(r'[A-Za-z_]\w+', ' '.join(re.findall(r'`([^`]+)`', cell))):
            count += 1
            if name not in words:
                errors.append(f'{folder} has no {name}')
print('\n'.join(errors) if errors else f'{count} names are those of Box2D')
sys.exit(1 if errors or count < 50 else 0)
