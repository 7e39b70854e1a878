/* A problem asked again, at its address with ?again: its boxes are empty, and where it varies it has other numbers. */

import { make } from "./elements.mjs";
import { loadScript, settings } from "./settings.mjs";
import { readVerified } from "./store.mjs";

const CLASS = "asked-again";

export const isAskedAgain = () => document.body.classList.contains(CLASS);

/** Make the page ask its problem again. */
export async function askAgain() {
  const { number } = settings;
  const { right = [], again = 0 } = readVerified()[number] ?? {};
  const rows = settings.rows?.split(" ") ?? [];
  const row = rows[again % rows.length];
  const names = right.map((name) => make("code", {}, name)).flatMap((code) => [code, " "]);
  const banner = make(
    "div",
    { className: "again-banner" },
    make("p", {}, `Problem ${number} once more${row ? ", with other numbers" : ""}. `, ...(names.length ? ["Answer again: ", ...names] : [])),
    make("p", {}, make("a", { href: location.pathname }, "The page of the problem"), " has its first numbers and what you answered there."),
  );
  const statement = document.querySelector("div.exercise, .origin");
  statement.before(banner);
  Object.assign(settings, { number: `${number}~${row ?? 0}`, repeats: number });
  if (!row) return;
  await loadScript(settings.notebook.replace(/ipynb\.js$/, "again.js"));
  const { statement: text, notebook } = window.workbookRows[row];
  window.workbookNotebook = notebook;
  document.body.classList.add(CLASS);
  const shown = make("div", { className: "again-statement" });
  shown.innerHTML = text; // made by the build
  statement.before(shown);
  window.MathJax?.startup?.promise?.then(() => MathJax.typesetPromise([shown]));
  const sources = Object.fromEntries(notebook.cells.map(({ id, source }) => [id, source]));
  for (const field of document.querySelectorAll(".answer-box textarea")) field.value = field.defaultValue = sources[field.dataset.cell];
}
