/* The engine's interface with Python outside of the browser: the server of the tests runs what a box hands over. */
window.workbookEngine = {
  size: { http: 33.4e6, file: 44.4e6 },
  start({ onProgress }) {
    window.engineStarts = (window.engineStarts ?? 0) + 1;
    onProgress("Loading Python", 0.5);
    return Promise.resolve();
  },
  runCell(cells, check, problem, seconds, names, sealed) {
    const stopped = new Promise((resolve) => { this.stop = () => resolve({ stdout: "", result: null, error: "stopped" }); });
    const body = JSON.stringify({ cells, check, problem, names, sealed });
    const run = cells.some((cell) => cell.includes("while True"))
      ? new Promise(() => {})
      : fetch("/run", { method: "POST", body }).then(async (answer) => ({ stdout: "", result: await answer.json(), error: null }));
    return Promise.race([run, stopped]);
  },
  stop() {},
};
