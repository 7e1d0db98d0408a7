# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Drives pages of timelines like a reader. Arguments: the test (reads, places, engines, crowded, alike, plays, moments) and its page.

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'page'))
import webdriver

BUSY = 'document.getElementById("timeline").dataset.ready === "yes"'


def text(browser, name):
    return browser.run(f'document.getElementById("{name}").textContent')


def expect(what, got, wanted):
    if wanted not in str(got):
        sys.exit(f'{what}: {wanted!r} is not in {got!r}')


def key(browser, name, shift=False):
    browser.run(f'document.body.dispatchEvent(new KeyboardEvent("keydown", {{key: "{name}", shiftKey: {str(shift).lower()}, bubbles: true}}))')


def place_of(browser, x, y):
    """Where a point of a view of 9.3 by 10 m around (-0.65, 0) is in the window."""
    return browser.run('(() => { const box = document.querySelector("#views .over").getBoundingClientRect();'
                       ' const scale = 0.92 * Math.min(box.width / 9.3, box.height / 10);'
                       f' return [box.left + box.width / 2 + ({x} + 0.65) * scale, box.top + box.height / 2 - {y} * scale]; }})()')


def click(browser, x, y):
    place = place_of(browser, x, y)
    browser.point(place[0], place[1], drag_to=place)


def filled(browser, canvas):
    """Pixels that are not empty."""
    return browser.run(f'(() => {{ const c = document.createElement("canvas"), from = document.querySelector("{canvas}");'
                       ' c.width = from.width; c.height = from.height; const pen = c.getContext("2d"); pen.drawImage(from, 0, 0);'
                       ' const d = pen.getImageData(0, 0, c.width, c.height).data;'
                       ' let n = 0; for (let i = 3; i < d.length; i += 4) n += d[i] > 0; return n; })()')


def reads(browser, page):
    browser.open('file://' + page)
    browser.wait(BUSY)
    expect('the start', text(browser, 'where'), 'step 0 ')
    expect('the moment', text(browser, 'moments'), 'step 4: tunnel: shot (1), body 0')
    if filled(browser, '#marks canvas') < 100:
        sys.exit('the moment has no picture')
    key(browser, 'ArrowRight')
    expect('a step on', text(browser, 'where'), 'step 1 ')
    key(browser, 'ArrowRight', shift=True)
    expect('ten steps on', text(browser, 'where'), 'step 11 ')
    key(browser, 'End')
    expect('the end', text(browser, 'where'), 'step 60 ')
    key(browser, 'Home')
    browser.click('#moments button')
    expect('at the moment', text(browser, 'where'), 'step 4 ')
    expect('its body', text(browser, 'chosen'), 'shot (1)')
    expect('its speed', text(browser, 'values'), 'speed100 m/s')
    expect('its plots', text(browser, 'chosen-plots'), 'Energy, J')
    browser.wait('location.hash === "#step=4&body=1"')
    click(browser, 3, 2)
    expect('the crate', text(browser, 'chosen'), 'crate (2), dynamic, 4 kg')
    expect('it is awake', text(browser, 'values'), 'awakeyescontacts1')
    click(browser, 2, 1)
    expect('the contact', text(browser, 'chosen'), 'Contact of crate (2) and shelf (3)')
    expect('its plots', text(browser, 'chosen-plots'), 'Impulse, N·s')
    click(browser, -4, -4)
    expect('the joint', text(browser, 'chosen'), 'Joint of shelf (3) and body 4')
    expect('its plot', text(browser, 'chosen-plots'), 'Gap, m')
    if filled(browser, '#views .over') < 1000 or filled(browser, '#world canvas') < 50:
        sys.exit('too little is drawn')
    # A click in the middle of a curve goes to the middle.
    box = browser.run('(() => { const b = document.querySelector("#world .plot-box").getBoundingClientRect(); return [b.left + b.width / 2, b.top + 5]; })()')
    browser.point(box[0], box[1], drag_to=box)
    expect('a click on a curve', text(browser, 'where'), 'step 30 ')
    browser.run('document.getElementById("speed").value = "4", document.getElementById("speed").dispatchEvent(new Event("change"))')
    browser.click('#play')
    browser.wait('document.getElementById("where").textContent.startsWith("step 60 ")')
    expect('the end', text(browser, 'play'), 'Play')
    # A link shows what was looked at.
    browser.open('file://' + page + '?again#step=17&body=1&x=1&y=2&zoom=30&layers=bodies,labels&speed=0.25&loop=10:20&follow=1')
    browser.wait(BUSY)
    expect('a link', text(browser, 'where'), 'step 17 ')
    expect('its body', text(browser, 'chosen'), 'shot (1)')
    expect('its loop', text(browser, 'loop'), 'Loop 10 to 20')
    expect('its speed', browser.run('document.getElementById("speed").value'), '0.25')
    expect('its layers', browser.run('[...document.querySelectorAll("#layers input:checked")].map((i) => i.value).join()'), 'bodies,labels')
    key(browser, 'ArrowRight')
    browser.wait('location.hash === "#step=18&body=1&x=1&y=2&zoom=30&layers=bodies,labels&speed=0.25&loop=10:20&follow=1" || '
                 'location.hash.startsWith("#step=18&body=1&x=") && location.hash.endsWith("&layers=bodies,labels&speed=0.25&loop=10:20&follow=1")')
    browser.click('#play')
    browser.wait('Number(document.getElementById("step").value) > 18')
    browser.wait('Number(document.getElementById("step").value) < 15')
    browser.click('#play')
    # A phone.
    browser.resize(390, 844)
    browser.wait('document.documentElement.scrollWidth <= window.innerWidth')


def places(browser, page):
    """Prints the bits of x, y and angle of all bodies, step by step."""
    browser.open('file://' + page)
    browser.wait(BUSY)
    print(browser.run('''(() => {
        const {lanes, toX, toY, toAngle} = document.getElementById("timeline").session;
        const values = new Float32Array(1), bits = new Uint32Array(values.buffer), said = [];
        lanes[0].each((index, state) => {
            for (let body = 0; body < state.flags.length; ++body) {
                for (const value of [toX(state.x[body]), toY(state.y[body]), toAngle(state.angle[body])]) {
                    values[0] = value;
                    said.push(bits[0]);
                }
            }
        });
        return said.join(" ");
    })()'''))


def crowded(browser, page):
    """Numbers of four engines stand beside each other, none of them cut or in another."""
    browser.open('file://' + page + '#step=30&body=5')
    browser.wait(BUSY)
    for width in (1400, 1000, 390):
        browser.resize(width, 900)
        browser.wait('document.documentElement.scrollWidth <= window.innerWidth')
        cut = browser.run(
            '[...document.querySelectorAll("#chosen-plots .plot-label, #chosen-plots .plot-label *, #values td, #values th")]'
            '.filter((e) => e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).display !== "inline"'
            ' || e.getBoundingClientRect().right > e.closest(".side").getBoundingClientRect().right + 1)'
            '.map((e) => e.textContent).join(" | ")')
        if cut:
            sys.exit(f'cut at a width of {width}: {cut}')
        within = browser.run(
            '[...document.querySelectorAll("#chosen-plots .plot-label")].filter((label) => {'
            ' const boxes = [...label.querySelectorAll("span:first-child, b, .range")].map((e) => e.getBoundingClientRect());'
            ' return boxes.some((a, i) => boxes.some((b, k) => k > i && a.left < b.right - 1 && b.left < a.right - 1'
            ' && a.top < b.bottom - 3 && b.top < a.bottom - 3)); }).map((label) => label.textContent).join(" | ")')
        if within:
            sys.exit(f'in each other at a width of {width}: {within}')
    browser.resize(1400, 900)
    expect('the unit once', text(browser, 'values'), 'speed, m/s')


def engines(browser, page):
    browser.open('file://' + page + '#step=30&body=5')
    browser.wait(BUSY)
    expect('both engines', browser.run('[...document.querySelectorAll("#views figcaption")].map((c) => c.textContent).join()'), 'scree,box2d')
    expect('both values', browser.run('document.querySelectorAll("#values tr:nth-child(2) td").length'), '2')
    expect('the tree', text(browser, 'kept'), 'The tree of this step is shown.')
    for view in ('figure:nth-child(1)', 'figure:nth-child(2)'):
        if filled(browser, f'#views {view} .over') < 1000:
            sys.exit(f'{view} is empty')
    key(browser, 'ArrowRight')
    expect('no tree', text(browser, 'kept'), 'No tree was kept of this step.')
    browser.click('#next-tree')
    expect('the next tree', text(browser, 'kept'), 'The tree of this step is shown.')
    browser.click('#last-tree')
    expect('the tree before', text(browser, 'where'), 'step 30 ')
    expect('one clock', browser.run('document.querySelector("#world .plot-label").querySelectorAll("b").length'), '2')
    browser.run('document.getElementById("mode").value = "over", document.getElementById("mode").dispatchEvent(new Event("change"))')
    expect('one over the other', browser.run('document.querySelectorAll("#views figure").length'), '1')
    browser.wait('location.hash.includes("engines=over")')


def inked(browser, canvas):
    """How many pixels are not empty in the frame after a step on, and how many full ones their ink would make."""
    browser.run('(() => { document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "ArrowRight", bubbles: true}));'
                ' requestAnimationFrame(() => {'  # after the page's own, while the frame is still there
                f' const c = document.createElement("canvas"), from = document.querySelector("{canvas}");'
                ' c.width = from.width; c.height = from.height; const pen = c.getContext("2d"); pen.drawImage(from, 0, 0);'
                ' const d = pen.getImageData(0, 0, c.width, c.height).data; let n = 0, sum = 0;'
                ' for (let i = 3; i < d.length; i += 4) n += d[i] > 0, sum += d[i] / 255;'
                ' window.inked = [n, sum]; }); return 0; })()')
    browser.wait('window.inked !== undefined')
    return browser.run('window.inked')


def alike(browser, page):
    """Circles, polygons and contacts cover the same pixels by WebGL2 as by Canvas 2D, within what edges differ by."""
    # Squares lie between pixels: by Canvas 2D their edges touch more of these, with as much ink.
    for layers, share in (('bodies', 0.05), ('contacts', 0.2)):
        found = []
        for renderer, canvas in (('canvas', '.over'), ('webgl', '.under')):
            browser.open('file://' + page + f'?{renderer}{layers}#renderer={renderer}&step=30&layers={layers}')
            browser.wait(BUSY)
            expect('the renderer', browser.run('document.getElementById("timeline").dataset.renderer'), renderer)
            found.append(inked(browser, f'#views {canvas}'))
        print(layers, *found)
        (pixels, ink), (others, other) = found
        if pixels < 50 or abs(pixels - others) > share * pixels or abs(ink - other) > 0.03 * ink:
            sys.exit(f'{layers}: canvas and webgl differ: pixels, ink {found}')


def plays(browser, page):
    """Plays by Canvas 2D and by WebGL2, as the address asks; of each, the draw calls and corners of a frame."""
    # Not a rate of frames: that judges the machine and what else it does.
    for renderer in ('canvas', 'webgl'):
        browser.open('file://' + page + f'?{renderer}#renderer={renderer}&speed=1')
        browser.wait(BUSY)
        expect('the renderer', browser.run('document.getElementById("timeline").dataset.renderer'), renderer)
        browser.run('(() => { const of = WebGL2RenderingContext.prototype, draw = of.drawArrays;'
                    ' window.calls = 0; window.corners = 0; of.drawArrays = function(kind, first, count) {'
                    ' ++window.calls; window.corners += count; draw.call(this, kind, first, count); }; return 0; })()')
        frames = 'Number(document.getElementById("timeline").dataset.frames)'
        first = browser.run(frames)
        browser.click('#play')
        browser.wait(f'{frames} >= {first + 3}')
        calls, corners, drawn = browser.run(f'[window.calls, window.corners, {frames}]')
        print(renderer, calls / (drawn - first), corners / (drawn - first))
        if filled(browser, '#views .over' if renderer == 'canvas' else '#views .under') < 1000 and renderer == 'canvas':
            sys.exit('too little is drawn')


def moments(browser, page):
    """Prints the moments of the list; a click on the first goes there."""
    browser.open('file://' + page)
    browser.wait(BUSY)
    print(browser.run('[...document.querySelectorAll("#moments button")].map((one) => one.textContent).join("\\n")'))
    browser.click('#moments button')
    expect('at the moment', text(browser, 'where'), 'step 4 ')


def main(test, page):
    with webdriver.Browser() as browser:
        {'reads': reads, 'places': places, 'engines': engines, 'crowded': crowded, 'alike': alike, 'plays': plays, 'moments': moments}[test](browser, page)
        log = [entry for entry in browser.log('browser') if entry.get('level') == 'SEVERE']
        if log:
            sys.exit(f'the page complains: {log}')


if __name__ == '__main__':
    main(*sys.argv[1:])
