"""Chromium without a screen, driven by chromedriver: WebDriver is HTTP with JSON on this machine."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import time
import urllib.error
import urllib.request


def is_installed():
    return shutil.which("chromedriver") is not None and shutil.which("chromium") is not None


PATIENCE = 200  # s, for one command: a machine can be busy


class Browser:
    """Use it in `with`: both programs end with it."""

    def __init__(self, profile, *arguments):
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True)
        ready = next(line for line in self.driver.stdout if "successfully" in line)
        port = re.search(r"port (\d+)", ready)[1]
        self.address = f"http://127.0.0.1:{port}/session"
        self.address += "/" + self.call("POST", "", {"capabilities": {"alwaysMatch": {
            "timeouts": {"script": 1000 * PATIENCE, "pageLoad": 1000 * PATIENCE},
            "goog:chromeOptions": {
                "binary": shutil.which("chromium"),
                "args": ["--headless=new", "--hide-scrollbars", f"--user-data-dir={profile}", *arguments,
                         *(["--no-sandbox"] if os.geteuid() == 0 else [])]},
            "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}}})["sessionId"]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.call("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()
            self.driver.stdout.close()

    def call(self, method, path, body=None):
        data = None if method != "POST" else json.dumps(body or {}).encode()
        request = urllib.request.Request(self.address + path, data, {"Content-Type": "application/json"},
                                         method=method)
        try:
            with urllib.request.urlopen(request, timeout=PATIENCE) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from None

    def open(self, file):
        self.call("POST", "/url", {"url": pathlib.Path(file).resolve().as_uri()})

    def run(self, script, *arguments):
        """Runs JavaScript in the page; gives what it returns, or what its promise becomes."""
        return self.call("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def devtools(self, command, **parameters):
        return self.call("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def wait_until(self, condition, seconds=60):
        """Waits until the JavaScript expression is true."""
        end = time.monotonic() + seconds
        while not self.run(f"return Boolean({condition})"):
            if time.monotonic() > end:
                raise AssertionError(f"after {seconds} s still false: {condition}")
            time.sleep(0.02)

    def log(self, kind):
        """The new entries: "browser" for the console, "performance" for what DevTools report."""
        return self.call("POST", "/se/log", {"type": kind})
