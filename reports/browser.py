"""A headless Chromium, driven over a pipe: prints the page to PDF, and opens it in the tests.

Speaks the Chrome DevTools Protocol (JSON messages that end with a zero byte, `--remote-debugging-pipe`), so nothing but
Debian's chromium is needed.
"""
import base64
import fcntl
import json
import os
import pathlib
import select
import shutil
import subprocess
import tempfile
import time

FLAGS = (
    # The only page ever opened is the one just written; a sandbox is not to be had for root or inside most containers.
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
    # No word with the outside.
    "--no-first-run", "--disable-quic", "--disable-background-networking", "--disable-component-update",
    "--disable-sync", "--disable-extensions", "--disable-default-apps", "--no-default-browser-check",
)


class BrowserError(RuntimeError):
    """Chromium is absent, died, or answered a command with an error."""


def _moved_up(descriptor):
    moved = fcntl.fcntl(descriptor, fcntl.F_DUPFD, 10)
    os.close(descriptor)
    return moved


class Browser:
    """One page in a fresh profile. Use as a context manager.

    After `open`, `console` holds every warning and error the page wrote or threw, `requests` every address it asked for.
    """

    def __init__(self, timeout=60.0):
        program = shutil.which("chromium") or shutil.which("chromium-browser")
        if not program:
            raise BrowserError("chromium was not found; ci/setup installs it")
        self.timeout = timeout
        self.console, self.requests = [], []
        self._loaded, self._answers, self._count, self._buffer = False, {}, 0, b""
        self._profile = tempfile.mkdtemp(prefix="sunder-report-browser-")
        command_read, self._write = os.pipe()
        self._read, answer_write = os.pipe()
        # Chromium reads commands from descriptor 3 and writes answers to 4; from 10 upwards none is in the shell's way.
        command_read, answer_write = (_moved_up(descriptor) for descriptor in (command_read, answer_write))
        shell = f'exec "$@" 3<&{command_read} 4>&{answer_write} {command_read}<&- {answer_write}>&-'
        self._process = subprocess.Popen(
            ["bash", "-c", shell, "bash", program, *FLAGS, "--remote-debugging-pipe", f"--user-data-dir={self._profile}",
             "about:blank"],
            pass_fds=(command_read, answer_write), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, start_new_session=True)
        os.close(command_read)
        os.close(answer_write)
        self._session = None
        page = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self._session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self._session = None
            self.call("Browser.close")
            self._process.wait(timeout=10)
        except (BrowserError, OSError, subprocess.TimeoutExpired):
            self._process.kill()
            self._process.wait()
        os.close(self._write)
        os.close(self._read)
        shutil.rmtree(self._profile, ignore_errors=True)

    def call(self, method, **params):
        """The result of one protocol command."""
        self._count += 1
        message = {"id": self._count, "method": method, "params": params}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        answer = self._until(lambda: self._answers.pop(self._count, None), method)
        if "error" in answer:
            raise BrowserError(f"{method}: {answer['error'].get('message')}")
        return answer["result"]

    def _until(self, ready, what):
        deadline = time.monotonic() + self.timeout
        while not (value := ready()):
            if not select.select([self._read], [], [], max(0.0, deadline - time.monotonic()))[0]:
                raise BrowserError(f"{what}: no answer in {self.timeout:.0f} s")
            chunk = os.read(self._read, 1 << 20)
            if not chunk:
                raise BrowserError(f"{what}: chromium ended with status {self._process.wait()}")
            *messages, self._buffer = (self._buffer + chunk).split(b"\0")
            for message in messages:
                self._take(json.loads(message))
        return value

    def _take(self, message):
        if "id" in message:
            self._answers[message["id"]] = message
            return
        method, params = message.get("method"), message.get("params", {})
        if method == "Page.loadEventFired":
            self._loaded = True
        elif method == "Network.requestWillBeSent":
            self.requests.append(params["request"]["url"])
        elif method == "Runtime.exceptionThrown":
            self.console.append("exception: " + params["exceptionDetails"].get("text", "") + " "
                                + params["exceptionDetails"].get("exception", {}).get("description", ""))
        elif method == "Runtime.consoleAPICalled" and params["type"] in ("error", "warning", "assert"):
            self.console.append(params["type"] + ": " + " ".join(str(a.get("value", "")) for a in params["args"]))
        elif method == "Log.entryAdded" and params["entry"]["level"] in ("error", "warning"):
            self.console.append(params["entry"]["level"] + ": " + params["entry"]["text"])

    def open(self, path, width=1280, height=900, dark=False):
        """Shows the file at this size in CSS pixels; below 600 px as a phone does. Returns when it is loaded."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=2 if width < 600 else 1,
                  mobile=width < 600)
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme",
                                                           "value": "dark" if dark else "light"}])
        self.console.clear()
        self.requests.clear()
        self._loaded = False
        self.call("Page.navigate", url=pathlib.Path(path).resolve().as_uri())
        self._until(lambda: self._loaded, f"open {path}")

    def evaluate(self, expression):
        """The value of a JavaScript expression in the page; a promise is awaited."""
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise BrowserError(f"{expression}: {answer['exceptionDetails']['exception'].get('description')}")
        return answer["result"].get("value")

    def screenshot(self, path, full=False):
        """Writes a PNG of what is shown, or of the whole page."""
        options = {}
        if full:
            size = self.call("Page.getLayoutMetrics")["cssContentSize"]
            options = {"captureBeyondViewport": True,
                       "clip": {"x": 0, "y": 0, "width": size["width"], "height": min(size["height"], 16000), "scale": 1}}
        pathlib.Path(path).write_bytes(base64.b64decode(self.call("Page.captureScreenshot", **options)["data"]))

    def pdf(self, footer):
        """The page as PDF, A4, with bookmarks and this footer (text; page numbers are added)."""
        style = "font: 7.5pt sans-serif; color: #555; width: 100%; padding: 0 16mm; display: flex; justify-content: space-between"
        answer = self.call(
            "Page.printToPDF", paperWidth=8.27, paperHeight=11.69, marginTop=0.6, marginBottom=0.7, marginLeft=0.6,
            marginRight=0.6, printBackground=True, displayHeaderFooter=True, headerTemplate="<span></span>",
            footerTemplate=f'<div style="{style}"><span>{footer}</span><span><span class="pageNumber"></span> / '
                           '<span class="totalPages"></span></span></div>',
            generateTaggedPDF=True, generateDocumentOutline=True)
        return base64.b64decode(answer["data"])
