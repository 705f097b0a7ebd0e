"""Headless Chromium over the DevTools protocol: messages are JSON, ended by a zero byte, over two pipes."""
import base64
import json
import os
import shutil
import subprocess
import tempfile
import threading

NAMES = ("chromium", "chromium-browser", "google-chrome")
FLAGS = """--headless --no-sandbox --disable-gpu --disable-extensions --disable-background-networking --disable-component-update
--no-first-run --hide-scrollbars --remote-debugging-pipe""".split()
PATIENCE = 60.0  # seconds for an answer


class Trouble(Exception):
    """The browser did not start, did not answer, or refused what was asked."""


def installed():
    """The browser that is there, or None."""
    return next((found for found in map(shutil.which, NAMES) if found), None)


class Browser:
    """A browser with one page. events: what it reported since they were last taken."""

    def __init__(self, program):
        self.number, self.events, self.session = 0, [], {}
        self.profile = tempfile.mkdtemp(prefix="report-check-")
        commands, self.to = os.pipe()
        of, answers = os.pipe()
        self.answers = os.fdopen(of, "rb")
        self.process = subprocess.Popen(  # it reads commands from 3 and answers on 4
            ["sh", "-c", f'exec "$0" "$@" 3<&{commands} 4>&{answers}', program, *FLAGS, f"--user-data-dir={self.profile}"],
            pass_fds=(commands, answers), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        os.close(commands)
        os.close(answers)
        page = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = {"sessionId": self.ask("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.to)
        self.process.kill()
        self.process.wait()
        self.answers.close()
        shutil.rmtree(self.profile, ignore_errors=True)

    def receive(self):
        """The next message; a browser that gives none in time is ended."""
        timer = threading.Timer(PATIENCE, self.process.kill)
        timer.start()
        message = bytearray()
        while not message.endswith(b"\0"):
            part = self.answers.read(1)
            if not part:
                raise Trouble(f"the browser ended, or gave no answer within {PATIENCE:g} s")
            message += part
        timer.cancel()
        return json.loads(message[:-1])

    def ask(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters, **self.session}
        with open(self.to, "wb", closefd=False) as pipe:
            pipe.write(json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise Trouble(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.events.append(answer)

    def wait_for(self, event):
        while not any(said.get("method") == event for said in self.events):
            self.events.append(self.receive())

    def run(self, expression):
        """What a JavaScript expression gives in the page, or the promise that it gives."""
        answer = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise Trouble(details.get("exception", {}).get("description", details["text"]))
        return answer["result"].get("value")

    def prefer(self, **features):
        """What the reader prefers: color_scheme="dark", reduced_motion="reduce"."""
        listed = [{"name": "prefers-" + name.replace("_", "-"), "value": value} for name, value in features.items()]
        self.ask("Emulation.setEmulatedMedia", media="screen", features=listed)

    def show(self, address, width, height, scheme):
        """Loads a page anew at a width, light or dark, and reports from the first byte on."""
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600)
        self.prefer(color_scheme=scheme)
        self.events.clear()
        self.ask("Page.navigate", url=address)
        self.wait_for("Page.loadEventFired")

    def picture(self, box=None, scale=1):
        """PNG of a box (x, y, width, height) of the document, or of all of it."""
        if box is None:
            size = self.ask("Page.getLayoutMetrics")["cssContentSize"]
            box = (0, 0, size["width"], size["height"])
        clip = dict(zip(("x", "y", "width", "height"), box), scale=scale)
        answer = self.ask("Page.captureScreenshot", format="png", captureBeyondViewport=True, clip=clip)
        return base64.b64decode(answer["data"])
