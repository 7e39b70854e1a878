/* Python for the page: nothing is loaded before the reader agrees, once in this browser. */

import { loadScript, settings } from "./settings.mjs";
import { hasConsent, rememberConsent } from "./store.mjs";

/** Seconds after which a run is ended. */
const LIMIT = 60;

let agreed = hasConsent();

export const isAllowed = () => agreed;

export function allow() {
  agreed = true;
  rememberConsent();
}

async function engine() {
  await loadScript(`${settings.run}engine.js`);
  return window.workbookEngine;
}

/** Whole megabytes that the engine loads once. */
export async function megabytes() {
  const { size } = await engine();
  return Math.round((location.protocol === "file:" ? size.file : size.http) / 1e6);
}

export async function start(onProgress) {
  await (await engine()).start({ base: new URL(settings.run, location.href).href, onProgress });
}

/** Run the cells of a box, [{name, source}], and its check: {result, error} as `workbook.page.run_cell` and the engine return
    them. */
export async function runCell(cells, check) {
  const names = cells.map(({ name }) => name ?? "");
  const run = await (await engine()).runCell(cells.map(({ source }) => source), check, "", LIMIT, names, window.workbookMistakes);
  if (run.result?.patches) stop(); // the next run has the modules as they were
  return run;
}

export const stop = () => window.workbookEngine?.stop();

/** What ended a run, for the reader. */
export function failure(error) {
  if (error === "stopped") return "Stopped.";
  if (error === "time") return `Stopped after ${LIMIT} seconds.`;
  return `The run broke off (${error}), as one does whose recursion is too deep. Python is ready again.`;
}
