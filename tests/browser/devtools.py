"""Drives a headless Chromium over its DevTools pipe: nothing but the standard library is needed."""

import base64
import fcntl
import json
import os
import shutil
import subprocess
import tempfile
import threading

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")


def find_browser():
    """The path of a Chromium, or None."""
    named = os.environ.get("BOLE_CHROMIUM")
    return named or next((path for path in map(shutil.which, NAMES) if path), None)


class Browser:
    """A page in a headless browser. `requests` lists every address that the page asked for."""

    def __init__(self, path, width=1280, height=900, arguments=()):
        self.requests, self.messages = [], []
        self._replies, self._events, self._next = {}, {}, 0
        self._news = threading.Condition()
        self._home = tempfile.mkdtemp(prefix="bole-browser-")
        to_browser, self._out = os.pipe()
        self._in, from_browser = os.pipe()

        def pipes():  # the browser reads from descriptor 3 and writes to 4
            # First out of the way: either may be 3 or 4 itself.
            reads, writes = (fcntl.fcntl(d, fcntl.F_DUPFD, 100) for d in (to_browser, from_browser))
            os.dup2(reads, 3)
            os.dup2(writes, 4)
            for descriptor in (3, 4):
                os.set_inheritable(descriptor, True)

        self._process = subprocess.Popen(
            [path, "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--remote-debugging-pipe", "--hide-scrollbars",
             f"--user-data-dir={self._home}", f"--window-size={width},{height}", "--no-first-run", "--disable-extensions",
             "--disable-background-networking", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
             *arguments, "about:blank"],
            preexec_fn=pipes, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        threading.Thread(target=self._read, daemon=True).start()
        targets = self._call("Target.getTargets")["targetInfos"]
        target = next(t["targetId"] for t in targets if t["type"] == "page")
        self._session = self._call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(domain + ".enable")
        self.resize(width, height)

    def _read(self):
        rest = b""
        while True:
            try:
                chunk = os.read(self._in, 1 << 16)
            except OSError:
                chunk = b""
            if not chunk:
                with self._news:
                    self._replies[None] = {}
                    self._news.notify_all()
                return
            rest += chunk
            *whole, rest = rest.split(b"\0")
            for text in whole:
                self._take(json.loads(text))

    def _take(self, message):
        with self._news:
            if "id" in message:
                self._replies[message["id"]] = message
            else:
                self._events[message["method"]] = self._events.get(message["method"], 0) + 1
                parameters = message.get("params", {})
                if message["method"] == "Network.requestWillBeSent":
                    self.requests.append(parameters["request"]["url"])
                elif message["method"] == "Runtime.exceptionThrown":
                    details = parameters["exceptionDetails"]
                    self.messages.append(details.get("exception", {}).get("description", details["text"]))
                elif message["method"] == "Log.entryAdded" and parameters["entry"]["level"] == "error":
                    self.messages.append(parameters["entry"]["text"])
            self._news.notify_all()

    def _call(self, method, session=None, **parameters):
        self._next += 1
        number = self._next
        message = {"id": number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self._out, data):]
        with self._news:
            if not self._news.wait_for(lambda: number in self._replies or None in self._replies, timeout=120):
                raise TimeoutError(f"no reply to {method} within 120 s")
            if number not in self._replies:
                raise RuntimeError("the browser ended")
            reply = self._replies.pop(number)
        if "error" in reply:
            raise RuntimeError(f"{method}: {reply['error']['message']}")
        return reply.get("result", {})

    def call(self, method, **parameters):
        return self._call(method, self._session, **parameters)

    def resize(self, width, height):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def forget(self):
        """Requests and messages are counted anew."""
        self.requests.clear()
        self.messages.clear()

    def open(self, path):
        loaded = self._events.get("Page.loadEventFired", 0)
        self.call("Page.navigate", url=path.resolve().as_uri())
        with self._news:
            if not self._news.wait_for(lambda: self._events.get("Page.loadEventFired", 0) > loaded, timeout=120):
                raise TimeoutError(f"{path} was not loaded within 120 s")

    def run(self, script):
        """The value of an expression in the page; a promise is waited for."""
        result = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"].get("exception", {}).get("description", script))
        return result["result"].get("value")

    def click(self, x, y):
        for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="none" if kind == "mouseMoved" else "left", clickCount=1)

    def move(self, x, y):
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def click_on(self, selector):
        """Clicks the middle of an element, as a person does: whatever lies above it takes the click."""
        x, y = self.run(
            f"(() => {{ const e = document.querySelector({json.dumps(selector)}); e.scrollIntoView({{block: 'center'}});"
            " const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; })()")
        self.click(x, y)

    def picture(self, path, full=False):
        parameters = {"format": "png", "captureBeyondViewport": full}
        if full:
            size = self.call("Page.getLayoutMetrics")["cssContentSize"]
            parameters["clip"] = {"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1}
        path.write_bytes(base64.b64decode(self.call("Page.captureScreenshot", **parameters)["data"]))

    def pdf(self):
        return base64.b64decode(self.call("Page.printToPDF", preferCSSPageSize=True, printBackground=True)["data"])

    def close(self):
        try:
            self._call("Browser.close")
        except (RuntimeError, OSError, TimeoutError):
            pass
        try:
            self._process.wait(20)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        os.close(self._out)
        shutil.rmtree(self._home, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
