#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# What the shared library exports against what its public headers declare.
"""check.py CLANG SOURCE LIBRARY [--update]: what the shared library of the engine exports.

Every function that a public header declares without its body must be exported, and nothing else of the library may be.
The list in symbols.txt changes in one commit with the headers: a name that is gone is a program that no longer starts.
"""

import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from public_headers import declarations  # noqa: E402

FUNCTIONS = {'FunctionDecl', 'CXXMethodDecl', 'CXXConstructorDecl', 'CXXDestructorDecl', 'CXXConversionDecl'}
# Tables and names of types with virtual functions, and the destructors that stand in them: which of them are made
# depends on the optimisation.
OF_TYPES = re.compile(r'(vtable|typeinfo|typeinfo name) for scree::\w+$|scree::(\w+)::~\2\(\)$')


def run(command, text=''):
    return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout


def sort_functions(node, declared, defined):
    kind = node.get('kind', '')
    if kind in FUNCTIONS:
        parts = {part.get('kind') for part in node.get('inner', [])}
        isMade = any(node.get(word) for word in ('isImplicit', 'explicitlyDefaulted', 'explicitlyDeleted', 'pure'))
        if 'mangledName' in node:
            (defined if isMade or 'CompoundStmt' in parts else declared).add(node['mangledName'])
    elif 'Template' not in kind:
        for part in node.get('inner', []):
            sort_functions(part, declared, defined)


def demangle(names):
    return set(run(['c++filt'], '\n'.join(sorted(names))).splitlines())


def main():
    clang, source, library = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
    declared, defined = set(), set()
    for node in declarations(clang, str(source / 'engine/include')):
        sort_functions(node, declared, defined)
    wanted = declared - defined
    if len(wanted) < 500:
        sys.exit(f'only {len(wanted)} functions were found in the headers: is this the checkout?')
    lines = run(['nm', '-D', '--defined-only', '--format=posix', library]).splitlines()
    exported = {line.split()[0] for line in lines}
    # Several constructors and destructors of one body are one name to a reader.
    inHeaders = demangle(wanted)
    names = {name for name in demangle(exported) if name in inHeaders or not OF_TYPES.match(name)}

    listed = HERE / 'symbols.txt'
    if '--update' in sys.argv:
        listed.write_text('\n'.join(sorted(names)) + '\n')
    before = set(listed.read_text().splitlines())
    faults = [f'declared by a header, but not exported: {name}' for name in sorted(demangle(wanted - exported))]
    faults += [f'exported, but no header declares it: {name}' for name in sorted(names - inHeaders)]
    faults += [f'no longer exported: {name}' for name in sorted(before - names)]
    faults += [f'not in {listed.name}: {name}' for name in sorted(names - before)]
    for fault in faults:
        print(fault)
    if faults:
        sys.exit(f'{len(faults)} faults; if the interface was meant to change: {" ".join(sys.argv[:4])} --update')
    print(f'{len(names)} names are exported, and are those of the headers')


main()
