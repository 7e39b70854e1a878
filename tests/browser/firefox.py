"""Firefox for tests of the page's Python, by its own WebDriver BiDi: no geckodriver is needed."""

import json
import re
import shutil
import subprocess
import time

import pytest
from chromium import megabytes

#: A proxy that nobody serves for all hosts but the own one.
PREFERENCES = {
    "network.proxy.type": 1,
    "network.proxy.http": "127.0.0.1",
    "network.proxy.http_port": 9,
    "network.proxy.ssl": "127.0.0.1",
    "network.proxy.ssl_port": 9,
    "network.proxy.no_proxies_on": "127.0.0.1",
    "browser.shell.checkDefaultBrowser": False,
    "datareporting.policy.dataSubmissionEnabled": False,
}
READY = re.compile(r"WebDriver BiDi listening on (ws://\S+)")


class Firefox:
    """Headless Firefox with one page, which reaches no other machine."""

    def __init__(self, program, profile):
        import websocket

        lines = "".join(f'user_pref("{k}", {json.dumps(v)});\n' for k, v in PREFERENCES.items())
        (profile / "user.js").write_text(lines, encoding="utf-8")
        command = [program, "--headless", "--no-remote", "--remote-debugging-port=0"]
        log = profile / "stderr.log"
        with open(log, "w", encoding="utf-8") as stderr:
            self._process = subprocess.Popen(
                [*command, "--profile", str(profile)], stdout=subprocess.DEVNULL, stderr=stderr
            )
        end = time.monotonic() + 60
        while not (ready := READY.search(log.read_text(encoding="utf-8"))):
            assert time.monotonic() < end, "Firefox does not start"
            time.sleep(0.1)
        self._socket = websocket.create_connection(f"{ready[1]}/session", suppress_origin=True)
        self._count, self._events = 0, []
        self._ask("session.new", 60, capabilities={})
        events = ["log.entryAdded", "network.beforeRequestSent"]
        self._ask("session.subscribe", 60, events=events)
        tree = self._ask("browsingContext.getTree", 60)
        self._page = tree["contexts"][0]["context"]

    def _ask(self, method, seconds, **parameters):
        self._count += 1
        message = {"id": self._count, "method": method, "params": parameters}
        self._socket.send(json.dumps(message))
        self._socket.settimeout(seconds)
        while (answer := json.loads(self._socket.recv())).get("id") != self._count:
            self._events.append(answer)
        assert answer["type"] == "success", answer
        return answer["result"]

    def open(self, address):
        """Open a page and wait until it is loaded."""
        self._events.clear()
        parameters = {"context": self._page, "url": address, "wait": "complete"}
        self._ask("browsingContext.navigate", 60, **parameters)

    def evaluate(self, script, *arguments, seconds=300):
        """Return the value of an asynchronous script in the open page, with its `args`."""
        function = f"""async text => {{
            const run = async (...args) => {{ {script} }};
            return JSON.stringify(await run(...JSON.parse(text)) ?? null); }}"""
        outcome = self._ask(
            "script.callFunction",
            seconds,
            functionDeclaration=function,
            awaitPromise=True,
            target={"context": self._page},
            arguments=[{"type": "string", "value": json.dumps(arguments)}],
        )
        assert outcome["type"] == "success", outcome["exceptionDetails"]["text"]
        return json.loads(outcome["result"]["value"])

    def errors(self):
        """Return the errors in the console since the page was opened."""
        entries = (e["params"] for e in self._events if e.get("method") == "log.entryAdded")
        return [entry["text"] for entry in entries if entry["level"] == "error"]

    def foreign_requests(self):
        """Return the requests to other hosts since the page was opened."""
        urls = [
            event["params"]["request"]["url"]
            for event in self._events
            if event.get("method") == "network.beforeRequestSent"
        ]
        own = ("file:", "data:", "blob:", "http://127.0.0.1:")
        return [url for url in urls if not url.startswith(own)]

    def megabytes(self):
        """Return the memory of all its processes."""
        return megabytes(self._process.pid)

    def close(self):
        """End the browser and wait for it."""
        self._socket.close()
        self._process.terminate()
        self._process.wait(30)


@pytest.fixture(scope="session")
def firefox(tmp_path_factory):
    """Return a browser of another maker than `browser`, where there is one."""
    program = shutil.which("firefox-esr") or shutil.which("firefox")
    if not program:
        pytest.skip("Firefox is not installed")
    browser = Firefox(program, tmp_path_factory.mktemp("firefox"))
    yield browser
    browser.close()
