#!/usr/bin/env python3
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# sign_page.py FILE: ends a page that a script has written with the digest that shows changes by hand.
# The digest is that of testbed/page/markdown.cpp: FNV-1a of 64 bits over all bytes before its line.

import pathlib
import sys


def sign(text):
    text += "\nThis file was written by the command above; a test finds changes by hand.\n"
    digest = 0xCBF29CE484222325
    for byte in text.encode():
        digest = (digest ^ byte) * 0x100000001B3 % 2**64
    return text + f"<!-- digest {digest:016x} -->\n"


if len(sys.argv) != 2:
    sys.exit("usage: sign_page.py FILE")
page = pathlib.Path(sys.argv[1])
page.write_text(sign(page.read_text()))
