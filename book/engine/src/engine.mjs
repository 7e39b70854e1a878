// The page's Python: `start`, `run`, `snapshot` and `stop`. Another engine can stand behind these four.
import bootScript from "./boot.py";
import { Assets } from "./assets.mjs";
import * as images from "./images.mjs";
import { Session } from "./session.mjs";

const { key, size } = window.workbookEngineFiles;
const HERE = new URL(".", document.currentScript.src).href;
const SECONDS = 20; // of a run, unless the page says otherwise
const STOPPED = "stopped", TIME = "time";

let starting = null, parts = null, session = null, queue = Promise.resolve();

// Load Python and start it; a second call returns the same promise.
function start({ base = HERE, onProgress = () => {} } = {}) {
  starting ??= load(base, onProgress).catch(error => { starting = null; throw error; });
  return starting;
}

async function load(base, onProgress) {
  const assets = new Assets(base, share => onProgress("Loading Python", share));
  const [module, stdlib, library, image] = await Promise.all([
    assets.response("python.wasm", "application/wasm").then(WebAssembly.compileStreaming),
    assets.blob("stdlib.zip"),
    assets.blob("library.tar"),
    images.read(key),
  ]);
  parts = { module, stdlib, library, image, script: bootScript };
  onProgress("Starting Python", 1);
  session = new Session(parts);
  await session.ready;
  if (!image) {
    parts.image = new Blob([await snapshot()]);
    images.keep(key, parts.image);
  }
}

// Execute Python text in a fresh namespace, one run after the other. Resolves to what it printed, the
// value of its name `result`, and an error or null: "stopped", "time", or a text.
function run(code, seconds = SECONDS) {
  const outcome = queue.then(() => execute(code, seconds));
  queue = outcome;
  return outcome;
}

async function execute(code, seconds) {
  let timer;
  try {
    await start();
    await session.ready;
    const running = session;
    timer = setTimeout(() => restart(running, TIME), 1000 * seconds);
    return await running.ask("execute", { code });
  } catch (error) {
    // after a trap the memory is worth nothing
    if (![STOPPED, TIME].includes(error.message) && parts?.image) restart(session, error.message);
    return { stdout: "", result: null, error: error.message };
  } finally {
    clearTimeout(timer);
  }
}

// Run the cells above a check and the check itself: `workbook.page.run_cell`.
function runCell(cells, check, problem = "", seconds = SECONDS, names = [], sealed = {}) {
  const text = JSON.stringify(JSON.stringify([cells, check, problem, names, sealed]));
  return run(`import json\nfrom workbook.page import run_cell\nresult = run_cell(*json.loads(${text}))`, seconds);
}

const snapshot = () => session.ask("snapshot");

// End what runs, at once; a fresh worker starts from the image.
function stop() {
  if (parts?.image) restart(session, STOPPED);
}

function restart(ended, reason) {
  ended.end(reason);
  session = new Session(parts);
}

// A browser keeps pages that were left, to show them again at once. It is not to keep their Python: that ends, and a
// page that comes back starts it anew.
addEventListener("pagehide", () => {
  if (!session) return; // what is being loaded goes on with the page
  session.end(STOPPED);
  starting = parts = session = null;
});

window.workbookEngine = { size, start, run, runCell, snapshot, stop };
