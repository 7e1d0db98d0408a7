#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Holds the pages of the project to their rules: every link leads somewhere, guides are short, every page is reached from
# the front page, every line of C++ stands in a program that is compiled, and names of the engine exist in its public
# headers. Arguments: the folder of the sources.

import pathlib
import re
import sys

GUIDE_LINES = 150  # of a README; more belongs into a topic page

root = pathlib.Path(sys.argv[1]).resolve()
errors = []


def pages():
    for path in sorted(root.rglob('*.md')):
        parts = path.relative_to(root).parts
        if parts[0] not in ('build', 'out', '.git', '.ci'):
            yield path


def without_code(text):
    """Fenced blocks and code in a line become blanks, so that lines keep their numbers."""
    text = re.sub(r'^```.*?^```', lambda m: '\n' * m.group().count('\n'), text, flags=re.S | re.M)
    return re.sub(r'`[^`\n]*`', '', text)


def anchors(path):
    found = set()
    for line in re.findall(r'^#+ (.*)$', re.sub(r'^```.*?^```', '', path.read_text(), flags=re.S | re.M), re.M):
        line = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', line).replace('`', '').strip().lower()
        found.add(re.sub(r'[^\w\- ]', '', line).replace(' ', '-'))
    return found


def lines_of(text):
    """Without indentation and spaces before a comment, which a formatter may move."""
    return [re.sub(r'\s+//', ' //', line.strip()) for line in text.split('\n') if line.strip()]


# Where C++ blocks come from; a comment `<!-- from: FILE -->` above a block names another source.
examples = {path: lines_of(path.read_text()) for path in sorted((root / 'engine/docs/examples').glob('*.cpp'))}
HEADERS_OF_USERS = ('testbed/docs/own-world.md', 'engine/compat/README.md')  # held by tests of their own


def stands_in(block, source):
    return any(source[i:i + len(block)] == block for i in range(len(source) - len(block) + 1))


def check_cpp(page, text):
    for match in re.finditer(r'(?:<!-- from: (\S+) -->\n)?```cpp\n(.*?)^```', text, flags=re.S | re.M):
        # Three dots leave lines out.
        sources = [lines_of((root / match[1]).read_text())] if match[1] else list(examples.values())
        for part in re.split(r'^\s*// …\n', match[2], flags=re.M):
            block = lines_of(part)
            if not any(stands_in(block, source) for source in sources):
                number = text[:match.start()].count('\n') + 1
                errors.append(f'{page.relative_to(root)}:{number}: these lines stand in no program of '
                              f'{match[1] or "engine/docs/examples"}: {block[0]} …')


# What `Type::Name` in code of a page may be: a type of the public headers with any name of theirs.
headers = '\n'.join(path.read_text() for path in sorted((root / 'engine/include/scree').glob('*.h')))
types = set(re.findall(r'\b(?:class|struct)\s+(?:SCREE_API\s+)?(\w+)|\benum class (\w+)', headers))
types = {name for pair in types for name in pair if name}
names = set(re.findall(r'\w+', headers))


def check_names(page, text):
    for match in re.finditer(r'`[^`\n]*`', re.sub(r'^```.*?^```', lambda m: '\n' * m.group().count('\n'), text, flags=re.S | re.M)):
        for kind, name in re.findall(r'\b([A-Z]\w+)::(\w+)', match.group()):
            if kind not in types or name not in names:
                number = text[:match.start()].count('\n') + 1
                errors.append(f'{page.relative_to(root)}:{number}: no public header has {kind}::{name}')


reached = {root / 'README.md'}
links = {}
for page in pages():
    name = page.relative_to(root)
    text = page.read_text()
    if page.name == 'README.md' and page.parent in (root, root / 'engine', root / 'testbed', root / 'scenes'):
        lines = text.count('\n')
        if lines > GUIDE_LINES:
            errors.append(f'{name}: {lines} lines; a guide has at most {GUIDE_LINES}: move topics into docs/')
    if str(name) not in HEADERS_OF_USERS:
        check_cpp(page, text)
    if page.is_relative_to(root / 'engine') and page.name != 'journal.md':
        check_names(page, text)
    if '```mermaid' in text:
        errors.append(f'{name}: a diagram that no test draws: make it by tests/docs/diagrams.py')
    links[page] = set()
    for number, line in enumerate(without_code(text).split('\n'), 1):
        for target in re.findall(r'\]\(([^)\s]+)\)', line):
            if re.match(r'[a-z]+:', target):
                continue
            file, _, anchor = target.partition('#')
            where = (page.parent / file).resolve() if file else page
            if not where.exists():
                errors.append(f'{name}:{number}: no such file: {target}')
                continue
            if where.suffix == '.md':
                links[page].add(where)
                if anchor and anchor not in anchors(where):
                    errors.append(f'{name}:{number}: no such heading: {target}')

# Results are generated; a number in bold beside a link to them must stand there.
for row in re.findall(r'^\|.*docs/results/.*$', (root / 'README.md').read_text(), re.M):
    source = (root / re.search(r'\]\((\S*docs/results/\S+)\)', row)[1]).read_text()
    for number in re.findall(r'\*\*([^*]+)\*\*', row):
        if not re.search(rf'(?<![\d.,]){re.escape(number)}(?![\d])', source):
            errors.append(f'README.md: {number} stands in none of the results that its row names')

queue = list(reached)
while queue:
    for target in links.get(queue.pop(), ()):
        if target not in reached:
            reached.add(target)
            queue.append(target)
for page in links:
    if page not in reached:
        errors.append(f'{page.relative_to(root)}: no page leads here from README.md')

for error in errors:
    print(error)
print(f'{len(links)} pages, {sum(map(len, links.values()))} links between them')
sys.exit(1 if errors or len(links) < 5 else 0)
