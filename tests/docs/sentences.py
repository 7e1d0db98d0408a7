#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Lists the sentences of Markdown pages, and of comments in public headers, that have more than 30 words; exit code 1 if
# there are any. Tables, code, headings and generated pages do not count. Arguments: files, or a folder whose pages and
# public headers are all looked at.

import pathlib
import re
import sys

MOST_WORDS = 30


def paragraphs(text):
    """(line number, text) of every paragraph and list item."""
    start, lines = 0, []
    in_code = in_comment = False
    for number, line in enumerate(text.split('\n') + [''], 1):
        if line.startswith('```'):
            in_code = not in_code
            line = ''
        if in_code:
            line = ''
        if '<!--' in line:
            in_comment = True
        if in_comment:
            in_comment = '-->' not in line
            line = ''
        item = re.match(r'\s*(?:[-*]|\d+\.)\s+', line)
        is_text = line.strip() and not line.lstrip().startswith(('|', '#', '!['))
        if lines and (not is_text or item):
            yield start, ' '.join(lines)
            lines = []
        if is_text:
            if not lines:
                start = number
            lines.append(line[item.end():] if item else line.strip())


def comments(text):
    """(line number, text) of every comment; lines that follow each other are one."""
    start, lines = 0, []
    for number, line in enumerate(text.split('\n') + [''], 1):
        comment = re.match(r'\s*///?<?\s?(.*)', line)
        if comment and 'SPDX' not in line:
            if not lines:
                start = number
            lines.append(comment[1])
        elif lines:
            yield start, ' '.join(lines)
            lines = []


def sentences(text):
    text = re.sub(r'`[^`]*`', 'Code', text)
    text = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', text)
    return re.split(r'(?<=[.!?])["”)]*\s+(?=[A-ZÀ-Þ`*"“(0-9])', text)


def check(path):
    found = []
    for line, text in (paragraphs if path.suffix == '.md' else comments)(path.read_text()):
        for sentence in sentences(text):
            count = len([word for word in sentence.split() if re.search(r'\w', word)])
            if count > MOST_WORDS:
                found.append(f'{path}:{line}: {count} words: {sentence[:90]}…')
    return found


def main():
    found, pages = [], 0
    for argument in map(pathlib.Path, sys.argv[1:]):
        headers = argument.glob('engine/include/scree/*.h')
        for page in sorted([*argument.rglob('*.md'), *headers]) if argument.is_dir() else [argument]:
            parts = page.relative_to(argument).parts if argument.is_dir() else ()
            if {'build', 'out', '.git', '.ci', 'results'} & set(parts[:-1]):
                continue
            pages += 1
            found += check(page)
    print('\n'.join(found))
    print(f'{len(found)} sentences of more than {MOST_WORDS} words on {pages} pages and headers')
    return 1 if found or not pages else 0


sys.exit(main())
