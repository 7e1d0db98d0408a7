# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Drives a timeline's page like a reader: scrubs, clicks a body, plays, goes to a moment, and opens a link.

import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'page'))
import webdriver


def text(browser, name):
    return browser.run(f'document.getElementById("{name}").textContent')


def expect(what, got, wanted):
    if wanted not in str(got):
        sys.exit(f'{what}: {wanted!r} is not in {got!r}')


def main(page):
    with tempfile.TemporaryDirectory() as profile, webdriver.Browser(profile) as browser:
        browser.open('file://' + page)
        expect('the start', text(browser, 'where'), 'step 0 ')
        expect('the moment', text(browser, 'moments'), 'step 4: tunnel: shot (1), body 0')
        browser.run('document.dispatchEvent(new KeyboardEvent("keydown", {key: "ArrowRight", bubbles: true}))')
        expect('a step on', text(browser, 'where'), 'step 1 ')
        browser.click('#moments button')
        expect('at the moment', text(browser, 'where'), 'step 4 ')
        expect('its body', text(browser, 'chosen'), 'shot (1)')
        expect('its speed', text(browser, 'values'), 'speed')
        expect('the address', browser.run('location.hash'), '#step=4&body=1')
        # A click on the crate: its middle is at 3, 2 of a view from -5.3 to 4 and from -5 to 5.
        place = browser.run('(() => { const box = document.getElementById("world").getBoundingClientRect();'
                            ' const scale = 0.92 * Math.min(box.width / 9.3, box.height / 10);'
                            ' return [box.left + box.width / 2 + (3 + 0.65) * scale, box.top + box.height / 2 - 2 * scale]; })()')
        browser.point(place[0], place[1], drag_to=place)
        expect('the crate', text(browser, 'chosen'), 'crate (2)')
        expect('it rests', text(browser, 'values'), 'awakeno')
        filled = browser.run('(() => { const c = document.getElementById("world"), d = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;'
                             ' let n = 0; for (let i = 3; i < d.length; i += 4) n += d[i] > 0; return n; })()')
        if filled < 1000:
            sys.exit(f'only {filled} pixels are drawn')
        browser.click('#play')
        browser.wait('document.getElementById("where").textContent.startsWith("step 60 ")')
        expect('the end', text(browser, 'play'), 'Play')
        browser.open('file://' + page + '#step=17&body=1')
        browser.run('window.dispatchEvent(new Event("hashchange"))')
        expect('a link', text(browser, 'where'), 'step 17 ')
        expect('its body', text(browser, 'chosen'), 'shot (1)')
        log = [entry for entry in browser.log('browser') if entry.get('level') == 'SEVERE']
        if log:
            sys.exit(f'the page complains: {log}')


if __name__ == '__main__':
    main(sys.argv[1])
