# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# A browser to be driven: starts chromedriver on a free port and speaks the W3C WebDriver protocol to it
# (https://www.w3.org/TR/webdriver2/) with nothing but Python's library. Only what the tests of the pages need.

import base64
import json
import shutil
import subprocess
import tempfile
import urllib.error
import urllib.request

ANSWER = 300  # seconds that an answer of the browser may take
ELEMENT = 'element-6066-11e4-a52e-4f735466cecf'  # the key by which the protocol marks an element
KEYS = {'up': '\ue013', 'down': '\ue015', 'left': '\ue012', 'right': '\ue014', 'enter': '\ue007', 'space': ' ', 'tab': '\ue004'}


class Missing(Exception):
    """A program that the tests need is not installed."""


class Browser:
    """Headless Chromium with a new profile; use with `with`."""

    def __init__(self, width=1440, height=1000):
        for program, package in (('chromium', 'chromium'), ('chromedriver', 'chromium-driver')):
            if shutil.which(program) is None:
                raise Missing(f'{program} is not installed; install it with: apt-get install {package}')
        self._profiles = []
        self._session = None
        self._driver = subprocess.Popen(['chromedriver', '--port=0'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        try:
            self._port = self._read_port()
            self._session = self._start_session(width, height)
        except BaseException:
            self.close()
            raise

    def _read_port(self):
        said = []
        for line in self._driver.stdout:
            said.append(line)
            if 'started successfully on port' in line:
                return int(line.rsplit('port', 1)[1].strip().rstrip('.'))
        raise Missing('chromedriver did not start: ' + ''.join(said))

    def _start_session(self, width, height):
        """Twice, because Chromium now and then fails to come up on a busy machine; that is not what is tested."""
        try:
            return self._send('POST', '/session', self._wish(width, height))['sessionId']
        except RuntimeError:
            return self._send('POST', '/session', self._wish(width, height))['sessionId']

    def _wish(self, width, height):
        # A profile of its own: one that failed to come up may hold the lock of the last.
        self._profiles.append(tempfile.mkdtemp(prefix='profile-'))
        arguments = ['--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--hide-scrollbars',
                     '--disable-background-networking', f'--window-size={width},{height}', f'--user-data-dir={self._profiles[-1]}']
        wish = {'browserName': 'chrome', 'goog:loggingPrefs': {'browser': 'ALL', 'performance': 'ALL'}, 'timeouts': {'script': 1000 * (ANSWER - 30)},
                'goog:chromeOptions': {'args': arguments, 'binary': shutil.which('chromium')}}
        return {'capabilities': {'alwaysMatch': wish}}

    def _send(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(f'http://127.0.0.1:{self._port}{path}', data, {'Content-Type': 'application/json'}, method=method)
        # No proxy of the environment may stand between this and the driver beside it.
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        try:
            with opener.open(request, timeout=ANSWER) as answer:
                return json.load(answer)['value']
        except urllib.error.HTTPError as error:
            raise RuntimeError(f'{method} {path}: ' + json.load(error)['value']['message']) from None

    def _ask(self, method, path, body=None):
        return self._send(method, f'/session/{self._session}{path}', body)

    def close(self):
        try:
            if self._session:
                self._ask('DELETE', '')
        finally:
            self._session = None
            self._driver.terminate()
            self._driver.wait()
            self._driver.stdout.close()
            for profile in self._profiles:
                # Processes of Chromium may outlive the session and still write there.
                shutil.rmtree(profile, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def open(self, url):
        self._ask('POST', '/url', {'url': url})

    def resize(self, width, height):
        self._ask('POST', '/window/rect', {'width': width, 'height': height})

    def theme(self, name):
        """'light' or 'dark', as if the user's desktop preferred it."""
        parameters = {'features': [{'name': 'prefers-color-scheme', 'value': name}]}
        self._ask('POST', '/goog/cdp/execute', {'cmd': 'Emulation.setEmulatedMedia', 'params': parameters})

    def run(self, script, *arguments):
        """The value of a JavaScript expression in which the arguments are called a, b, c."""
        return self._ask('POST', '/execute/sync', {'script': f'const [a, b, c] = arguments; return ({script});', 'args': list(arguments)})

    def wait(self, condition, *arguments):
        """
        Returns when the JavaScript expression becomes true; the browser looks at every frame, for 20 s and 600 frames.

        Both, because a machine that sleeps or is busy lets time pass in which the page could do nothing.
        """
        script = '''const [a, b, c] = arguments, done = arguments[arguments.length - 1], start = performance.now();
            let frames = 0;
            (function look() {
                if (CONDITION) done(true);
                else if (++frames > 600 && performance.now() - start > 20000) done(false);
                else requestAnimationFrame(look);
            })();'''.replace('CONDITION', condition)
        if not self._ask('POST', '/execute/async', {'script': script, 'args': list(arguments)}):
            raise AssertionError(f'never came true: {condition}; the page is at {self.run("location.hash + document.title")!r}')

    def find(self, selector):
        return self._ask('POST', '/element', {'using': 'css selector', 'value': selector})

    def click(self, selector):
        self._ask('POST', f'/element/{self.find(selector)[ELEMENT]}/click', {})

    def type(self, selector, text):
        self._ask('POST', f'/element/{self.find(selector)[ELEMENT]}/value', {'text': text})

    def press(self, *keys):
        """Keys (names of KEYS or characters) to whatever has the focus."""
        actions = [{'type': kind, 'value': KEYS.get(key, key)} for key in keys for kind in ('keyDown', 'keyUp')]
        self._ask('POST', '/actions', {'actions': [{'type': 'key', 'id': 'keyboard', 'actions': actions}]})

    def point(self, x, y, drag_to=None):
        """Moves the mouse to a place of the window; with drag_to pulls it from there to another with the button down."""
        move = lambda place: {'type': 'pointerMove', 'duration': 0, 'x': round(place[0]), 'y': round(place[1])}
        actions = [move((x, y))]
        if drag_to:
            actions += [{'type': 'pointerDown', 'button': 0}, move(drag_to), {'type': 'pointerUp', 'button': 0}]
        self._ask('POST', '/actions', {'actions': [{'type': 'pointer', 'id': 'mouse', 'actions': actions}]})

    def screenshot(self):
        """The window as the bytes of a PNG file."""
        return base64.b64decode(self._ask('GET', '/screenshot'))

    def log(self, kind):
        """Entries since the last call: 'browser' (console and errors) or 'performance' (all requests)."""
        return self._ask('POST', '/se/log', {'type': kind})
