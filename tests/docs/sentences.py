#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Lists the sentences of Markdown pages, and of comments in C++ sources, that have more than 30 words; exit code 1 if
# there are any. Tables, code, headings and generated pages do not count. Arguments: files, or a folder whose pages and
# sources are all looked at.

import pathlib
import re
import sys

MOST_WORDS = 30
SOURCE_FOLDERS = ('engine', 'testbed', 'scenes', 'tests')
SOURCE_SUFFIXES = ('.h', '.cpp', '.inc', '.c')


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


# String and character literals are matched so that what looks like a comment inside them is none.
LEXEME = re.compile(r'R"([^\s()\\]{0,16})\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])\'(?:\\.|[^\'\\\n])+\''
                    r'|//(?P<line>[^\n]*)|/\*(?P<block>.*?)\*/', re.DOTALL)


def comment_lines(text):
    """(line number, column, whether code precedes it, text) of every line of a comment."""
    for match in LEXEME.finditer(text):
        inner = match['line'] if match['line'] is not None else match['block']
        if inner is None:
            continue
        column = match.start() - (text.rfind('\n', 0, match.start()) + 1)
        follows_code = text[match.start() - column:match.start()].strip() != ''
        first = text.count('\n', 0, match.start()) + 1
        for offset, line in enumerate(inner.split('\n')):
            marker = r'[/!]?<?' if match['line'] is not None else r'\s*\*?<?'
            yield first + offset, column, follows_code and not offset, re.sub(marker, '', line, count=1)


def comments(text):
    """(line number, text) of every paragraph and list item of comments. Comment lines that follow each other are one,
    and so are a comment behind code and the lines below that begin in its column. Lines that are indented, other than
    below a list item, or that have a gap are layouts and tables. What follows `Output:` is what a program prints."""
    start, lines, previous = 0, [], (0, 0)
    is_item = is_output = False
    for number, column, follows_code, line in comment_lines(text):
        goes_on = not follows_code and (number - 1, column) == previous
        item = re.match(r'\s*(?:[-*]|\d+\.)\s+', line)
        is_item = bool(item) or (is_item and goes_on and bool(lines))
        is_output = line.strip() == 'Output:' or (is_output and goes_on)
        is_layout = re.match(r'\s{2,}\S', line) and not is_item or re.search(r'\S\s{2,}\S', line)
        is_text = line.strip() and 'SPDX' not in line and not is_output and not is_layout
        if lines and (item or not goes_on or not is_text):
            yield start, ' '.join(lines)
            lines = []
        if is_text:
            if not lines:
                start = number
            lines.append(line[item.end():] if item else line.strip())
        previous = (number, column)
    if lines:
        yield start, ' '.join(lines)


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
    found, looked_at = [], 0
    for argument in map(pathlib.Path, sys.argv[1:]):
        if argument.is_dir():
            sources = [path for folder in SOURCE_FOLDERS for path in (argument / folder).rglob('*')
                       if path.suffix in SOURCE_SUFFIXES]
            files = sorted([*argument.rglob('*.md'), *sources])
        else:
            files = [argument]
        for path in files:
            parts = path.relative_to(argument).parts if argument.is_dir() else ()
            if {'build', 'out', '.git', '.ci', 'results'} & set(parts[:-1]):
                continue
            looked_at += 1
            found += check(path)
    print('\n'.join(found))
    print(f'{len(found)} sentences of more than {MOST_WORDS} words on {looked_at} pages and sources')
    return 1 if found or not looked_at else 0


sys.exit(main())
