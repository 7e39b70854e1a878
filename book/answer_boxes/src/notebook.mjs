/* The student's notebook: answers put into it, and read from one. The grader reads what is written here. */

const lines = (source) => (Array.isArray(source) ? source.join("") : source);
const role = (cell) =>
  (cell.metadata?.tags ?? []).find((tag) => ["setup", "data", "answer", "check", "steps"].includes(tag)) ?? "";
const assigned = (source) => new Set([...source.matchAll(/^([A-Za-z_]\w*)[ \t]*=(?!=)/gm)].map((match) => match[1]));

/** A copy of the notebook whose answer cells hold `answers`, {name: code}; all else is as it was. */
export function withAnswers(notebook, names, answers) {
  const copy = structuredClone(notebook);
  for (const cell of copy.cells) if (names[cell.id] in answers) cell.source = answers[names[cell.id]];
  return copy;
}

/** The code cells to run before a check cell and that cell: {cells: [{name, source}], check}; data cells have no name.
    A stub that nobody touched is left out, since it would overwrite an answer of a cell above; so does the grader. */
export function cellsOfRun(notebook, names, answers, checkId, boxNames) {
  const cells = [];
  for (const cell of notebook.cells) {
    if (cell.id === checkId) return { cells, check: lines(cell.source) };
    const name = names[cell.id];
    if (role(cell) === "data") cells.push({ source: lines(cell.source) });
    else if (boxNames.has(name) && !isStub(answers[name])) cells.push({ name, source: answers[name] });
  }
  throw new Error(`the notebook has no cell ${checkId}`);
}

/** Whether a cell still is `name = ...` with its comment. */
export const isStub = (source) => /^[A-Za-z_]\w*\s*=\s*\.\.\.$/.test(source.replace(/#.*/g, "").trim());

/** The answers of a notebook file, {name: code}, without untouched stubs; an Error says why a file is refused. */
export function answersOf(text, file, { number, title, names, renamed }) {
  let notebook;
  try {
    notebook = JSON.parse(text.replace(/^\uFEFF/, ""));
  } catch {
    throw new Error(`${file} is not a notebook.`);
  }
  const about = notebook?.metadata?.workbook;
  if (!about?.number || !Array.isArray(notebook.cells)) throw new Error(`${file} is not a notebook of this workbook.`);
  if (about.number !== number) {
    throw new Error(`${file} is the notebook of problem ${about.number}, ${about.title}. This page is problem ${number}, ${title}.`);
  }
  return collect(notebook.cells.filter((cell) => cell.cell_type === "code"), names, renamed);
}

/* A student may move and split cells and add some: a cell belongs to the answer that it assigns or whose cell it was, else
   to the answer above it, or to the first one below where there is none above. */
function collect(cells, names, renamed) {
  const answers = {};
  let last = null;
  let waiting = [];
  for (const cell of cells) {
    const source = lines(cell.source).trim();
    const targets = new Set([...assigned(source)].map((target) => renamed[target] ?? target));
    const isCheckOfSteps = role(cell) === "steps" && !targets.size;
    if (!source || ["setup", "data", "check"].includes(role(cell)) || isCheckOfSteps || isStub(source)) continue;
    const name = Object.values(names).find((candidate) => targets.has(candidate)) ?? names[cell.id] ?? last;
    if (name === null) waiting.push(source);
    else {
      answers[name] = [...(name in answers ? [answers[name]] : []), ...waiting, source].join("\n\n");
      waiting = [];
      last = name;
    }
  }
  return answers;
}
