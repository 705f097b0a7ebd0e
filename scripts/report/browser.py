"""Headless Chromium over the DevTools protocol: messages are JSON, ended by a zero byte, over two pipes."""
import base64
import collections
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

NAMES = ("chromium", "chromium-browser", "google-chrome")
FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-extensions",
    "--disable-background-networking",
    "--disable-component-update",
    "--no-first-run",
    "--hide-scrollbars",
    "--remote-debugging-pipe",
)


class Trouble(Exception):
    """The browser did not start, did not answer, or refused what was asked."""


def installed():
    """The browser that is there, or None."""
    return next((found for found in map(shutil.which, NAMES) if found), None)


class Browser:
    """A browser with one page. events: what it reported since they were last taken."""

    def __init__(self, program, patience=60.0):
        self.patience, self.number, self.rest, self.events = patience, 0, b"", []
        self.said = collections.deque()
        self.profile = tempfile.mkdtemp(prefix="report-check-")
        commands, self.to = os.pipe()
        self.of, answers = os.pipe()

        def connect():  # between fork and exec: the browser reads commands from 3 and answers on 4
            first, second = os.dup(commands), os.dup(answers)
            while first in (3, 4) or second in (3, 4):
                first, second = os.dup(first), os.dup(second)
            os.dup2(first, 3)
            os.dup2(second, 4)

        os.set_inheritable(commands, True)
        self.process = subprocess.Popen(
            [program, *FLAGS, f"--user-data-dir={self.profile}", "about:blank"],
            preexec_fn=connect,
            close_fds=False,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(commands)
        os.close(answers)
        self.session = None
        targets = self.ask("Target.getTargets")["targetInfos"]
        page = next(target["targetId"] for target in targets if target["type"] == "page")
        self.session = self.ask("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.to)
        os.close(self.of)
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        shutil.rmtree(self.profile, ignore_errors=True)

    def receive(self, deadline):
        """The next message."""
        while not self.said:
            ready, _, _ = select.select([self.of], [], [], max(0.0, deadline - time.monotonic()))
            if not ready:
                raise Trouble(f"the browser gave no answer within {self.patience:g} s")
            part = os.read(self.of, 1 << 20)
            if not part:
                raise Trouble("the browser ended")
            *whole, self.rest = (self.rest + part).split(b"\0")
            self.said.extend(json.loads(message) for message in whole)
        return self.said.popleft()

    def ask(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.to, data) :]
        deadline = time.monotonic() + self.patience
        while True:
            answer = self.receive(deadline)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise Trouble(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.events.append(answer)

    def wait_for(self, event):
        deadline = time.monotonic() + self.patience
        while not any(said.get("method") == event for said in self.events):
            self.events.append(self.receive(deadline))

    def run(self, expression):
        """What a JavaScript expression gives in the page, or the promise that it gives."""
        answer = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise Trouble(details.get("exception", {}).get("description", details["text"]))
        return answer["result"].get("value")

    def show(self, address, width, height, scheme):
        """Loads a page anew at a width, light or dark, and reports from the first byte on."""
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")
        self.ask(
            "Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600
        )
        self.ask(
            "Emulation.setEmulatedMedia", media="screen", features=[{"name": "prefers-color-scheme", "value": scheme}]
        )
        self.events.clear()
        self.ask("Page.navigate", url=address)
        self.wait_for("Page.loadEventFired")

    def picture(self, box=None):
        """PNG of a box (x, y, width, height) of the document, or of all of it."""
        if box is None:
            size = self.ask("Page.getLayoutMetrics")["cssContentSize"]
            box = (0, 0, size["width"], size["height"])
        clip = dict(zip(("x", "y", "width", "height"), box), scale=1)
        return base64.b64decode(
            self.ask("Page.captureScreenshot", format="png", captureBeyondViewport=True, clip=clip)["data"]
        )

    def type_key(self, key, code, number, text=""):
        for kind in ("keyDown", "keyUp"):
            self.ask(
                "Input.dispatchKeyEvent",
                type=kind,
                key=key,
                code=code,
                windowsVirtualKeyCode=number,
                **({"text": text} if kind == "keyDown" and text else {}),
            )
