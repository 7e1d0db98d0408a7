# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Functions of public headers, for the tests of what is exported and of what recordings hold.
"""What the engine's public headers declare, by clang's syntax tree."""

import json
import os
import subprocess
import sys
import tempfile

SCOPES = {'NamespaceDecl', 'LinkageSpecDecl'}


def declarations(clang, include):
    """The declarations of all public headers, in the order of the dump; those of scree itself, not of its scopes."""
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, 'all.cpp')
        with open(source, 'w', encoding='utf-8') as out:
            for header in sorted(os.listdir(os.path.join(include, 'scree'))):
                out.write(f'#include "scree/{header}"\n')
        command = [clang, '-std=c++20', '-fsyntax-only', '-I' + include, '-Xclang', '-ast-dump=json', '-Xclang',
                   '-ast-dump-filter=scree', source]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(result.stderr)
    decoder, at, text = json.JSONDecoder(), 0, result.stdout
    while (at := text.find('{', at)) >= 0:
        node, at = decoder.raw_decode(text, at)
        yield from _flat(node)


def _flat(node):
    if node.get('kind') not in SCOPES:
        yield node
        return
    for child in node.get('inner', []):
        yield from _flat(child)
