# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# Drives the report pages in headless Chromium: page_browser_test.py FOLDER, where page_browser_test.cpp has left
# sample.html, index.html and counts.json. Acts like a reader with mouse and keyboard, asks for the state of the document
# after each act, and leaves screenshots in FOLDER. Exit code 0: all as it should be; 2: a program is missing.

import json
import pathlib
import struct
import sys
import zlib

sys.dont_write_bytecode = True
from webdriver import Browser, Missing  # noqa: E402

FOLDER = pathlib.Path(sys.argv[1]).resolve()
OVERLAP = 'tumbler/step-0120-overlap'


def check(actual, expected, what):
    if actual != expected:
        raise AssertionError(f'{what}: {actual!r}, not {expected!r}')


def count_colors(png):
    """Number of different pixels among the rows of a screenshot that PNG stores unfiltered or filtered alike: enough to
    tell a page from a blank window."""
    check(png[:8], b'\x89PNG\r\n\x1a\n', 'signature of a screenshot')
    at, data = 8, b''
    width, height = struct.unpack('>II', png[16:24])
    while at < len(png):
        (length,), kind = struct.unpack('>I', png[at:at + 4]), png[at + 4:at + 8]
        if kind == b'IDAT':
            data += png[at + 8:at + 8 + length]
        at += 12 + length
    raw = zlib.decompress(data)
    stride = len(raw) // height
    return width, height, len({raw[i:i + 16] for row in range(height) for i in range(row * stride, (row + 1) * stride, 16)})


def shoot(browser, name):
    png = browser.screenshot()
    (FOLDER / f'{name}.png').write_bytes(png)
    width, height, colors = count_colors(png)
    # A blank window has two or three different pieces, a page of text hundreds.
    if width < 900 or height < 500 or colors < 100:
        raise AssertionError(f'{name}.png is {width}×{height} with {colors} different pieces: an empty page?')


def check_nothing_fetched(browser):
    wrong = [entry['message'] for entry in browser.log('browser')]
    check(wrong, [], 'console of the page')
    seen = 0
    for entry in browser.log('performance'):
        message = json.loads(entry['message'])['message']
        # The browser's own first tab asks for things, too.
        if message['method'] != 'Network.requestWillBeSent' or not message['params']['documentURL'].startswith('file:'):
            continue
        seen += 1
        url = message['params']['request']['url']
        if not url.startswith(('file:', 'data:', 'blob:')):
            raise AssertionError(f'the page asks for {url}')
        if url.startswith('file:') and not url.split('#')[0].endswith('.html'):
            raise AssertionError(f'the page needs a file beside it: {url}')
    check(seen > 0, True, 'requests are seen at all')


def cells(browser, column):
    return browser.run("[...document.querySelectorAll('#totals tbody tr')].filter(r => !r.hidden).map(r => r.cells[a].textContent)", column)


def test_figure(browser):
    """A figure that came with its data."""
    check(browser.run("document.querySelectorAll('canvas.plot').length"), 1, 'interactive figures')
    chart = 'Object.values(Chart.instances)[0]'
    said = f"{chart}.tooltip.dataPoints?.map(p => {chart}.options.plugins.tooltip.callbacks.label(p)) ?? []"
    check(browser.run(said), [], 'nothing is chosen at first')
    browser.run("document.querySelector('canvas.plot').focus()")
    browser.press('right')
    check(browser.run(said), ['draft: 10, 0.5'], 'the first point')
    browser.press('right')
    check(browser.run(said), ['game </script>: 100, 0.01'], 'the second point')
    browser.press('right')
    check(browser.run(said), ['fine: 1000, ≥ 0.002'], 'a lower bound')
    seen = f'{chart}.scales.x.max / {chart}.scales.x.min'
    before = browser.run(seen)
    browser.press('+')
    check(browser.run(seen) < before / 1.5, True, 'zoomed in')
    browser.press('0')
    check(abs(browser.run(seen) / before - 1) < 1e-6, True, 'all is seen again')
    browser.click('figure .chart button')
    check(browser.run(f"[{chart}.scales.x.type, {chart}.scales.y.type]"), ['linear', 'linear'], 'linear axes')
    browser.click('figure .chart button')
    check(browser.run(f"{chart}.scales.y.type"), 'logarithmic', 'logarithmic axes again')


def test_sample(browser):
    browser.open((FOLDER / 'sample.html').as_uri())
    check(browser.run('document.querySelector("h1").textContent'), 'Sample & <report>', 'title')
    first = cells(browser, 0)

    time = '#totals thead tr:last-child th:nth-child(2) button'
    browser.click(time)
    check(cells(browser, 1), ['1,312.4', '✓9.5', '✗−20.5', '–'], 'times from the largest')
    check(browser.run("document.querySelector('#totals [aria-sort=descending]').cellIndex"), 1, 'marked column')
    browser.press('enter')  # the head still has the focus
    check(cells(browser, 1), ['✗−20.5', '✓9.5', '1,312.4', '–'], 'times from the smallest, no number last')
    browser.press('enter')
    check(cells(browser, 0), first, 'the first order again')
    browser.click('#totals thead tr:last-child th:nth-child(1) button')
    check([name for name in cells(browser, 0) if 'scene' in name], ['scene-9', 'scene-10'], 'numbers in names')

    browser.type('.filter input', 'missed scene')
    check(cells(browser, 0), ['scene-9'], 'filtered rows')
    check(browser.run("document.querySelector('.filter output').value"), '1 of 4', 'what the filter says')

    check(browser.run("[...document.images].map(i => i.complete && i.naturalWidth > 0)"), [True, True], 'pictures decoded')
    test_figure(browser)
    browser.run("document.querySelector('nav a:last-child').click()")
    check(browser.run('!!document.querySelector(location.hash)'), True, 'contents lead to a section')
    shoot(browser, 'sample-light')
    colors = "getComputedStyle(document.body).backgroundColor"
    light = browser.run(colors)
    browser.theme('dark')
    check(browser.run(colors) != light, True, 'the dark theme differs')
    shoot(browser, 'sample-dark')
    browser.theme('light')
    check_nothing_fetched(browser)


def listed(browser):
    return browser.run("[...document.querySelectorAll('.case')].map(c => c.dataset.id)")


def test_list(browser):
    check(len(listed(browser)), 4, 'cases that are not equal')
    check(browser.run("document.querySelectorAll('.case img.thumb').length"), 4, 'thumbnails')
    browser.click('.chip[data-status=equal]')
    check(len(listed(browser)), 25, 'all cases')
    browser.type('#search', 'TILES 0007')
    check(listed(browser), ['tiles/step-0007-bodies'], 'filter by words')
    browser.run("(document.getElementById('search').value = '', document.getElementById('search').dispatchEvent(new Event('input')))")
    browser.click('.chip[data-status=equal]')
    browser.click('.chip[data-status=changed]')
    check(listed(browser), ['pyramid/step-0120-joints', 'pyramid/step-0040-contacts'], 'filter by status')
    browser.click('.chip[data-status=changed]')
    browser.click('#order option[value=pixels]')
    check(listed(browser)[:2], [OVERLAP, 'tumbler/step-0120-contacts'], 'most changed first')
    browser.click('#order option[value=list]')


def open_case(browser, name):
    browser.click(f'.case[data-id="{name}"]')
    browser.wait('document.getElementById("detail").dataset.ready === a', name)
    check(browser.run("document.querySelector('#detail h2').textContent.startsWith(a)", name), True, 'title of the case')


def center_of(browser, x, y, side='expected'):
    """Place in the window of a pixel of the picture."""
    return browser.run('''(() => {
        const box = document.querySelector(`#stage [data-side=${c}]`).closest('.frame').getBoundingClientRect();
        return [box.left + box.width * (a + 0.5) / 480, box.top + box.height * (b + 0.5) / 300];
    })()''', x, y, side)


def test_cursor(browser):
    wanted = json.loads((FOLDER / 'counts.json').read_text())
    check(len(wanted) >= 3, True, 'pixels to look at')
    browser.click('.modes [data-mode=side]')
    for pixel in wanted:
        for side in ('expected', 'actual'):  # either picture shows both
            browser.point(*center_of(browser, pixel['x'], pixel['y'], side))
            check(browser.run("document.querySelector('#readout .place').textContent"), f"x {pixel['x']}  y {pixel['y']}", 'pixel')
            for shown in ('expected', 'actual'):
                check(browser.run("document.querySelector(`.sample[data-side=${a}] .count`).textContent", shown),
                      f"count {pixel[shown]}", f'{shown} count at {pixel}')
    browser.run("document.getElementById('stage').focus()")
    browser.press('right', 'down', 'down')
    last = wanted[-1]
    check(browser.run("document.querySelector('#readout .place').textContent"), f"x {last['x'] + 1}  y {last['y'] + 2}", 'cursor by keys')
    check(browser.run("document.querySelectorAll('#stage .cross:not([hidden])').length"), 2, 'a cross in each picture')


def test_views(browser):
    browser.click('.modes [data-mode=slider]')
    slide = "document.querySelector('#stage .frame').style.getPropertyValue('--slide')"
    clip = "getComputedStyle(document.querySelector('#stage [data-side=actual]')).clipPath"
    check(browser.run(slide), '50%', 'the slider begins in the middle')
    # From the middle to the right edge of pixel 119 of 480; half a window pixel of rounding is 0.1 %.
    start, end = center_of(browser, 240, 150), center_of(browser, 119.5, 150)
    browser.point(*start, drag_to=end)
    check(abs(float(browser.run(slide).rstrip('%')) - 25) < 0.2, True, 'the slider follows the mouse')
    browser.run("document.getElementById('slider').focus()")
    browser.press(*['right'] * 10)
    check(abs(float(browser.run(slide).rstrip('%')) - 30) < 0.6, True, 'the slider follows the keys')
    check(browser.run(clip).startswith('inset('), True, 'the actual picture is cut')
    shoot(browser, 'snapshot-slider')

    browser.run("document.getElementById('stage').focus()")
    browser.press('3')
    check(browser.run("document.getElementById('stage').dataset.mode"), 'blink', 'view by key')
    for side in ('actual', 'expected'):  # by itself
        browser.wait('document.getElementById("stage").dataset.shown === a', side)
    browser.click('#swap')
    shown = browser.run("document.getElementById('stage').dataset.shown")
    hidden = {'actual': 'expected', 'expected': 'actual'}[shown]
    check(browser.run("getComputedStyle(document.querySelector(`#stage [data-side=${a}]`)).visibility", hidden), 'hidden', 'one is hidden')
    check(browser.run("document.getElementById('pause').textContent"), 'Blink', 'a swap by hand ends the blinking')
    browser.click('#swap')
    check(browser.run("document.getElementById('stage').dataset.shown"), hidden, 'swapped')

    browser.click('.modes [data-mode=difference]')
    check(browser.run("document.querySelector('#stage img').dataset.side"), 'difference', 'difference picture')
    shoot(browser, 'snapshot-difference')

    browser.press('5')
    browser.wait("document.querySelector('#stage img[data-side=counts]')?.complete")
    check('by up to' in browser.run("document.querySelector('#stage .frame-title').textContent"), True, 'legend of the counts')
    # Red where the run itself says that more nodes lie over the pixel now, blue where fewer, dark where as many.
    for pixel in json.loads((FOLDER / 'counts.json').read_text()):
        red, _, blue = browser.run('''(() => {
            const context = Object.assign(document.createElement('canvas'), {width: 480, height: 300}).getContext('2d');
            context.drawImage(document.querySelector('#stage img[data-side=counts]'), 0, 0);
            return [...context.getImageData(a, b, 1, 1).data].slice(0, 3);
        })()''', pixel['x'], pixel['y'])
        change = pixel['actual'] - pixel['expected']
        check((red > blue) - (red < blue), (change > 0) - (change < 0), f'colour of the change of counts at {pixel}')


def test_words(browser):
    check(browser.run("document.getElementById('update').textContent"), f"scree snapshot update -g '^{OVERLAP}$'", 'update command')
    row = "[...document.querySelectorAll('#structure-counts tbody tr')].map(r => [...r.cells].map(c => c.textContent))"
    rows = browser.run(row)
    check([r[0] for r in rows], ['bodies', 'nodes', 'contacts'], 'kinds')
    check(rows[2][3:], ['0', '1', '1'], 'contacts changed, added, removed')
    check(int(rows[0][3]) > 50, True, 'bodies changed')
    browser.click('.changes[data-kind=bodies] summary')
    check(browser.run("document.querySelectorAll('#structure-bodies tbody tr').length"), 50, 'bodies listed')
    check('first 50 of' in browser.run("document.querySelector('.changes[data-kind=bodies] summary').textContent"), True, 'says that it is cut')
    made = browser.run("Object.fromEntries([...document.querySelectorAll('#made tbody tr')].map(r => [r.cells[0].textContent, r.cells[1].textContent]))")
    check(made['gl renderer'], 'built in', 'renderer')
    check('simulate 12.5 ms' in browser.run("document.getElementById('times').textContent"), True, 'times')
    browser.run("document.getElementById('structure').scrollIntoView()")
    shoot(browser, 'snapshot-structure')


def test_others(browser):
    browser.run("document.getElementById('stage').focus()")
    browser.run("document.getElementById('cases').focus()")
    browser.press('down')
    check(browser.run("document.querySelector('.case[aria-selected=true]').dataset.id"), 'tumbler/step-0120-contacts', 'next by key')
    rule = browser.run("document.getElementById('rule').textContent")
    check(all(word in rule for word in ('differ by 2', '1 masked area', '31 differing', 'names the machine')), True, f'rule: {rule}')
    check(browser.run("document.querySelectorAll('#stage .mark.masked').length"), 2, 'mask outlined in both pictures')
    check(browser.run("document.querySelector('.modes [data-mode=counts]').disabled"), True, 'counts only of overlap pictures')
    check('bit for bit' in browser.run("document.getElementById('structure').textContent"), True, 'equal structure')
    open_case(browser, 'pyramid/step-0120-joints')
    check(browser.run("[...document.querySelectorAll('.modes button')].map(b => b.disabled)"), [False, True, True, True, True], 'views without a reference')
    check(browser.run("document.querySelector('#stage .empty').textContent"), 'no reference picture', 'missing side')
    open_case(browser, 'pyramid/step-0040-contacts')
    browser.click('.modes [data-mode=slider]')
    width = "document.querySelector('#stage [data-side=expected]').style.width"
    check(browser.run(width), '50%', 'the smaller picture keeps its size')
    browser.click('.chip[data-status=equal]')
    browser.click('.case[data-id="diagonal/step-0030-overlap"]')
    check('not kept' in browser.run("document.getElementById('detail').textContent"), True, 'an equal case without pictures')
    open_case(browser, 'tumbler/step-0120-contacts')


def test_snapshots(browser):
    browser.open((FOLDER / 'index.html').as_uri())
    test_list(browser)
    open_case(browser, OVERLAP)
    shoot(browser, 'snapshot-light')
    test_cursor(browser)
    test_views(browser)
    test_words(browser)
    browser.theme('dark')
    test_others(browser)
    shoot(browser, 'snapshot-dark')
    # A link to a case opens it.
    browser.open('about:blank')
    browser.open((FOLDER / 'index.html').as_uri() + '#tumbler%2Fstep-0120-contacts')
    check(browser.run("document.querySelector('#detail h2').textContent.split(' ')[0]"), 'tumbler/step-0120-contacts', 'case of a link')
    check_nothing_fetched(browser)


def main():
    try:
        with Browser() as browser:
            test_sample(browser)
            test_snapshots(browser)
    except Missing as missing:
        print(missing)
        return 2
    return 0


if __name__ == '__main__':
    sys.exit(main())
