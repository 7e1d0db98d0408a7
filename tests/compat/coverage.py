#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Is every public name of Box2D's headers in scree's compatibility headers, with the same type? Clang's syntax tree of
# Box2D's headers gives the list (classes, member functions, fields, enumerators with values, free functions, variables,
# type names, macros); each entry becomes one line of C++ that uses it, and clang checks those lines against the other
# headers. What does not compile is missing.
#
# usage: coverage.py CLANG BOX2D_INCLUDE SCREE_INCLUDE…   (directories that contain box2d/)

import json
import os
import re
import subprocess
import sys
import tempfile

# The rope of particles is no part of the rigid-body world.
EXEMPT_HEADERS = {'b2_rope.h'}
# The contact manager is only handed out as const, so programs cannot call what changes it.
EXEMPT_MEMBERS = {'b2ContactManager::' + name for name in ('AddPair', 'FindNewContacts', 'Destroy', 'Collide')}

PROBE = '''
struct ScreeProbe {
    bool QueryCallback(int) { return true; }
    float RayCastCallback(const b2RayCastInput&, int) { return 0.0f; }
    void AddPair(void*, void*) {}
};
'''


def run(command):
    return subprocess.run(command, capture_output=True, text=True, check=False)


class Walk:
    """Collects (name, C++ line) of everything public below the headers' folder."""

    def __init__(self, folder):
        self.folder = os.path.realpath(folder) + os.sep
        self.file = ''
        self.entries = []

    def note_file(self, node):
        """Clang writes a file name only where it changes, in the order of the dump."""
        for key in ('loc', 'range'):
            self.note_file_in(node.get(key, {}))

    def note_file_in(self, part):
        if 'file' in part:
            self.file = part['file']
        for key, value in part.items():
            if isinstance(value, dict) and key != 'includedFrom':
                self.note_file_in(value)

    def skim(self, node):
        self.note_file(node)
        for child in node.get('inner', []):
            self.skim(child)

    def top(self, node):
        for child in node.get('inner', []):
            self.note_file(child)
            here = os.path.realpath(self.file).startswith(self.folder)
            outOfLine = 'parentDeclContextId' in child
            if here and not child.get('isImplicit') and not outOfLine:
                self.declaration(child, '')
            for inner in child.get('inner', []):
                self.skim(inner)

    def add(self, name, line):
        self.entries.append((name, line))

    def declaration(self, node, scope):
        kind, name = node['kind'], node.get('name', '')
        full = scope + name
        if kind == 'CXXRecordDecl' and node.get('completeDefinition'):
            self.record(node, scope)
        elif kind == 'ClassTemplateDecl':
            self.class_template(node, scope)
        elif kind == 'EnumDecl':
            self.enumeration(node, scope)
        elif kind == 'TypedefDecl':
            self.add(full, f'using Type = ::{full};')
        elif kind == 'FunctionDecl' and '__va_list_tag' in node['type']['qualType']:
            self.add(full, f'(void)&::{full};')  # the type has no portable name
        elif kind == 'FunctionDecl':
            result, arguments = split_type(node['type']['qualType'])
            self.add(f'{full}{arguments}', f'(void)static_cast<{result} (*){arguments}>(&::{full});')
        elif kind == 'FunctionTemplateDecl':
            self.add(f'{full}<>', f'using ::{full};')
        elif kind == 'VarDecl':
            self.add(full, f'static_cast<void>(static_cast<std::add_pointer_t<{node["type"]["qualType"]}>>(&::{full}));')

    def enumeration(self, node, scope):
        value = -1
        if node.get('name'):
            self.add(scope + node['name'], f'static_assert(std::is_enum_v<{scope}{node["name"]}>);')
        for child in node.get('inner', []):
            if child['kind'] != 'EnumConstantDecl':
                continue
            given = first_value(child)
            value = int(given) if given is not None else value + 1
            self.add(scope + child['name'], f'static_assert(static_cast<int>({scope}{child["name"]}) == {value});')

    def record(self, node, scope):
        if 'name' not in node:
            return  # its fields follow as indirect fields of the owner
        name = scope + node['name']
        self.add(name, f'static_assert(sizeof({name}) > 0);')
        for base in node.get('bases', []):
            parent = base['type']['qualType']
            self.add(f'{name} : {parent}', f'static_assert(std::is_base_of_v<{parent}, {name}>);')
        access = 'private' if node.get('tagUsed') == 'class' else 'public'
        for child in node.get('inner', []):
            if child['kind'] == 'AccessSpecDecl':
                access = child['access']
            elif access == 'public' and not child.get('isImplicit'):
                self.member(child, name, node)

    def member(self, node, owner, record):
        kind, full = node['kind'], f'{owner}::{node.get("name", "")}'
        if kind == 'FieldDecl' and node.get('name'):
            self.add(full, f'(void)static_cast<{member_type(node["type"]["qualType"], owner)}>(&{full});')
        elif kind == 'IndirectFieldDecl':
            self.add(full, f'(void)&{full};')
        elif kind == 'CXXMethodDecl':
            result, arguments = split_type(node['type']['qualType'])
            pointer = '(*)' if node.get('storageClass') == 'static' else f'({owner}::*)'
            self.add(f'{full}{arguments}', f'(void)static_cast<{result} {pointer}{arguments}>(&{full});')
        elif kind == 'CXXConstructorDecl' and not record.get('definitionData', {}).get('isAbstract'):
            arguments = split_type(node['type']['qualType'])[1][1:-1]
            types = ', '.join([owner] + ([arguments] if arguments else []))
            self.add(f'{full}({arguments})', f'static_assert(std::is_constructible_v<{types}>);')
        elif kind == 'FunctionTemplateDecl':
            self.add(f'{full}<>', f'(void)&{full}<ScreeProbe>;')
        elif kind not in ('CXXDestructorDecl', 'FriendDecl'):
            self.declaration(node, owner + '::')

    def class_template(self, node, scope):
        name = f'{scope}{node["name"]}<int, 4>'  # the one there is takes a type and a size
        self.add(name, f'static_assert(sizeof({name}) > 0);')
        for pattern in node['inner']:
            access = 'private'
            for child in pattern.get('inner', []) if pattern['kind'] == 'CXXRecordDecl' else []:
                if child['kind'] == 'AccessSpecDecl':
                    access = child['access']
                elif child['kind'] == 'CXXMethodDecl' and access == 'public':
                    self.add(f'{name}::{child["name"]}', f'(void)&{name}::{child["name"]};')


def first_value(node):
    """The value of the outermost expression below a node that has one."""
    for child in node.get('inner', []):
        value = child.get('value', first_value(child))
        if value is not None:
            return value
    return None


def split_type(function_type):
    """'void (int) const' → ('void', '(int) const')"""
    depth, end = 0, function_type.rindex(')')
    for i in range(end, -1, -1):
        depth += {')': 1, '(': -1}.get(function_type[i], 0)
        if depth == 0:
            return function_type[:i].strip(), function_type[i:]
    raise ValueError(function_type)


def member_type(field_type, owner):
    """The pointer-to-member type of a field; enumerations nested in the class are written without it."""
    array = re.match(r'(.*?)(\[.*\])$', field_type)
    base, tail = (array[1].strip(), array[2]) if array else (field_type, '')
    if base in ('Type', 'State'):
        base = f'{owner}::{base}'
    return f'{base} ({owner}::*){tail}' if tail else f'{base} {owner}::*'


def macros(clang, source, include):
    names = set()
    for line in run([clang, '-std=c++20', '-dM', '-E', '-x', 'c++', source] + include).stdout.splitlines():
        match = re.match(r'#define (\w+)', line)
        if match and re.match(r'(?i)b2', match[1]) and not match[1].endswith('_H'):
            names.add(match[1])
    return names


def main():
    clang, box2d, ours = sys.argv[1], sys.argv[2], sys.argv[3:]
    headers = sorted(name for name in os.listdir(os.path.join(box2d, 'box2d')) if name not in EXEMPT_HEADERS)
    includes = ''.join(f'#include <box2d/{name}>\n' for name in headers)
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, 'list.cpp')
        with open(source, 'w', encoding='utf-8') as out:
            out.write(includes)
        theirs = ['-I' + box2d]
        mine = ['-I' + path for path in ours]
        tree = run([clang, '-std=c++20', '-fsyntax-only', '-Xclang', '-ast-dump=json', source] + theirs)
        if tree.returncode != 0:
            sys.exit(tree.stderr)
        walk = Walk(os.path.join(box2d, 'box2d'))
        walk.top(json.loads(tree.stdout))
        entries = [(name, line) for name, line in walk.entries if re.sub(r'\(.*', '', name) not in EXEMPT_MEMBERS]
        for name in sorted(macros(clang, source, theirs)):
            entries.append((f'macro {name}', None))

        def missing(include):
            known = macros(clang, source, include)
            lines = (includes + '#include <type_traits>\n' + PROBE).split('\n')
            line_of = {}
            for number, (name, line) in enumerate(entries):
                if line is not None:
                    line_of[len(lines) + 1] = name
                    lines.append(f'inline void Check{number}() {{ {line} }}')
            check = os.path.join(folder, 'check.cpp')
            with open(check, 'w', encoding='utf-8') as out:
                out.write('\n'.join(lines) + '\n')
            result = run([clang, '-std=c++20', '-fsyntax-only', '-ferror-limit=0', '-Wno-unused', check] + include)
            wrong = {}
            for match in re.finditer(r'check\.cpp:(\d+):\d+: (?:fatal )?error: (.*)', result.stderr):
                wrong.setdefault(line_of.get(int(match[1]), 'headers'), match[2])
            if result.returncode != 0 and not wrong:
                wrong['headers'] = result.stderr[:2000]
            wrong.update({name: 'no such macro' for name, line in entries if line is None and name[6:] not in known})
            return wrong

        # The same lines against Box2D itself: a line that fails there says nothing and is a fault of this script.
        faults = missing(theirs)
        wrong = missing(mine)
    for name in sorted(faults):
        print(f'not checkable: {name}: {faults[name]}')
    for name in sorted(wrong):
        if name not in faults:
            print(f'missing: {name}: {wrong[name]}')
    lacking = len(set(wrong) - set(faults))
    print(f'{len(entries)} public names, {lacking} missing, {len(faults)} not checkable, '
          f'exempt: {len(EXEMPT_MEMBERS)} members, {", ".join(sorted(EXEMPT_HEADERS))}')
    return 1 if lacking or faults else 0


if __name__ == '__main__':
    sys.exit(main())
