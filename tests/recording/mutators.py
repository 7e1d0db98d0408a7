#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Does a recording hold every call that changes a world? Clang's syntax tree of the engine's public headers gives the
# member functions that may change an object (public, not const, not static) of World, Body, Fixture, Contact and all
# joints; each must be a call that recordings know, or stand below with the reason why not.
#
# usage: mutators.py CLANG INCLUDE_FOLDER PROGRAM_THAT_LISTS_RECORDED_CALLS

import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from public_headers import declarations  # noqa: E402

CLASSES = {'World', 'Body', 'Fixture', 'Contact', 'Joint'}

# Not recorded on purpose: name → reason. A name that the headers do not have is an error, so that this list stays true.
READS = 'changes nothing: gives a pointer through which the caller may'
PROGRAM = 'belongs to the program, not to the world'
EXEMPT = {
    'World::SetContactListener': PROGRAM,
    'World::SetContactFilter': PROGRAM,
    'World::SetDestructionListener': PROGRAM,
    'World::SetMaterialMixer': PROGRAM,
    'World::SetErrorHandler': PROGRAM,
    'World::SetDebugDraw': PROGRAM,
    'World::DebugDraw': 'draws',
    'World::SetWorkers': 'changes no result',
    'World::PrepareQueries': 'changes no result',
    'World::TrimMemory': 'changes no result',
    'World::SetMeasureErrors': 'changes no result, only what a report tells',
    'World::SetReportMoves': 'changes no result, only what events tell',
    'World::SetHitSpeed': 'changes no result, only what events tell',
    'World::SetFeatures': 'changes no result, only which calls are refused',
    'World::GetState': READS,
    'World::Find': READS,
    'World::GetBodyList': READS,
    'World::GetJointList': READS,
    'World::GetContactList': READS,
    'Body::GetFixtureList': READS,
    'Body::GetNext': READS,
    'Body::GetWorld': READS,
    'Body::SetUserData': PROGRAM,
    'Fixture::GetShape': READS + ' (writes are not recorded, Fixture::SetShape is: engine/docs/recording.md)',
    'Fixture::GetBody': READS,
    'Fixture::GetNext': READS,
    'Fixture::SetUserData': PROGRAM,
    'Contact::GetFixtureA': READS,
    'Contact::GetFixtureB': READS,
    'Contact::GetNext': READS,
    'Joint::SetUserData': PROGRAM,
}


def mutators(record):
    access = 'private' if record.get('tagUsed') == 'class' else 'public'
    for child in record.get('inner', []):
        if child['kind'] == 'AccessSpecDecl':
            access = child['access']
        elif child['kind'] == 'CXXMethodDecl' and access == 'public':
            changes = not child['type']['qualType'].endswith(' const') and child.get('storageClass') != 'static'
            if changes and not child.get('isImplicit') and not child['name'].startswith('operator'):
                yield child['name']


def main():
    clang, include, lister = sys.argv[1:]
    recorded = set(subprocess.run([lister], capture_output=True, text=True, check=True).stdout.split('\n')) - {''}
    found = {}
    for node in declarations(clang, include):
        if node['kind'] != 'CXXRecordDecl' or not node.get('completeDefinition'):
            continue
        isJoint = any(base['type']['qualType'].endswith('Joint') for base in node.get('bases', []))
        if node.get('name') in CLASSES or isJoint:
            for name in mutators(node):
                found[f'{node["name"]}::{name}'] = node['name']
    faults = []
    if len(found) < 80:
        faults.append(f'only {len(found)} member functions found: is this the right folder?')
    # A call that takes sub-steps or the like is recorded under its name and a word in brackets.
    plain = {name.split(' (')[0] for name in recorded}
    faults += [f'not recorded: {name}' for name in sorted(found) if name not in plain and name not in EXEMPT]
    faults += [f'exempt, but recorded: {name}' for name in sorted(EXEMPT) if name in plain]
    faults += [f'exempt, but not in the headers: {name}' for name in sorted(EXEMPT) if name not in found]
    faults += [f'recorded, but not in the headers: {name}' for name in sorted(plain) if name not in found]
    for fault in faults:
        print(fault)
    print(f'{len(found)} member functions may change a world, {len(plain)} are recorded, {len(EXEMPT)} exempt')
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
