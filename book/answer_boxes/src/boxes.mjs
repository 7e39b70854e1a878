/* The answer boxes of a problem's page. The page holds them hidden; without this script, or without WebAssembly, it stays as
   it is. */

import { askAgain } from "./again.mjs";
import { Box } from "./box.mjs";
import { make } from "./elements.mjs";
import { KEYS } from "./field.mjs";
import { answersOf, withAnswers } from "./notebook.mjs";
import { AnswersPanel } from "./panel.mjs";
import * as python from "./python.mjs";
import { Question } from "./question.mjs";
import { loadScript, settings } from "./settings.mjs";
import * as store from "./store.mjs";

class Page {
  constructor(elements) {
    this.boxes = elements.map((element) => new Box(element, this));
    this.fields = this.boxes.flatMap((box) => box.fields);
    this.names = Object.fromEntries(this.fields.map((field) => [field.cell, field.name]));
    this.renamed = Object.fromEntries(this.fields.filter(({ former }) => former).map(({ former, name }) => [former, name]));
    this.panel = settings.part ? null : new AnswersPanel(this, elements.at(-1));
    this.question = new Question();
    const adopted = store.adoptEarlierAnswers(settings.number, settings.version, this.renamed);
    this.setAnswers(store.readAnswers(settings.number, settings.version));
    if (adopted) this.panel?.say("They were typed for an earlier version of this problem: check them again.");
    this.panel?.count();
  }

  // Answers ---------------------------------------------------------------------------------------------------------------

  /** The code of every answer, {name: code}. */
  answers() {
    return Object.fromEntries(this.fields.map((field) => [field.name, field.source]));
  }

  /** Show these answers, and the stubs of all others. */
  setAnswers(answers) {
    for (const field of this.fields) field.text = answers[field.name] ?? field.shown;
  }

  /** Keep what was typed into a field; other boxes may have been used in another tab since this page was opened. */
  save(field) {
    const { [field.name]: _, ...answers } = store.readAnswers(settings.number, settings.version);
    if (field.isTyped) answers[field.name] = field.text;
    store.writeAnswers(settings.number, settings.version, answers);
    this.panel?.count();
  }

  noteVerdicts(verdicts) {
    store.noteVerdicts(settings, verdicts);
    this.panel?.count();
  }

  /** The answers of a box and of all boxes above it. */
  namesUpTo(last) {
    const above = this.boxes.slice(0, this.boxes.indexOf(last) + 1);
    return new Set(above.flatMap((box) => box.fields.map((field) => field.name)));
  }

  // The notebook ----------------------------------------------------------------------------------------------------------

  /** The notebook; with it come its sealed mistakes, `window.workbookMistakes`. */
  async notebook() {
    if (!window.workbookNotebook) await loadScript(settings.notebook);
    return window.workbookNotebook;
  }

  async download() {
    const text = JSON.stringify(withAnswers(await this.notebook(), this.names, this.answers()), null, 1) + "\n";
    const address = URL.createObjectURL(new Blob([text], { type: "application/x-ipynb+json" }));
    make("a", { href: address, download: settings.notebook.split("/").at(-1).replace(/\.js$/, "") }).click();
    setTimeout(() => URL.revokeObjectURL(address), 60_000);
  }

  async openNotebook(file) {
    this.setAnswers(answersOf(await file.text(), file.name, { ...settings, names: this.names, renamed: this.renamed }));
  }

  // Editor and Python -----------------------------------------------------------------------------------------------------

  /** A box is used: the editors come, and Python if the reader has agreed; else the question, once a visit. */
  async open(box) {
    this.mounting ??= this.mount();
    if (python.isAllowed()) this.startPython(box).catch((error) => box.say(error.message));
    else if (!this.question.wasAsked) this.ask(box);
  }

  async mount() {
    document.body.append(make("p", { id: KEYS, hidden: true }, "Tab indents. Escape, then Tab leaves the editor. Shift and Enter run the check."));
    await Promise.all(this.fields.map((field) => field.mount()));
    await window.MathJax?.startup?.promise;
    for (const box of this.boxes) box.addHints();
  }

  /** Ask whether Python may be loaded; then start it, and do what was asked for. */
  ask(box, then = () => {}) {
    this.question.ask(box, () => {
      python.allow();
      this.startPython(box).then(then, (error) => box.say(error.message));
    });
  }

  async startPython(box) {
    this.waiting = box;
    if (this.isStarted) return;
    box.say("starting Python …");
    await python.start((text, fraction) => {
      this.waiting.say(`${text} ${fraction < 1 ? `${Math.round(100 * fraction)} %` : "…"}`);
    });
    if (!this.isStarted) this.waiting.say("ready");
    this.isStarted = true;
  }
}

const elements = [...document.querySelectorAll(".answer-box")];
if (typeof WebAssembly === "object" && elements.length) {
  // the stubs of the student edition: the boxes hold them
  document.querySelectorAll(".cell.tag_answer").forEach((cell) => cell.closest("details") ?? cell.classList.add("answer-stub"));
  const isAgain = new URLSearchParams(location.search).has("again") && !settings.part;
  Promise.resolve(isAgain && askAgain()).then(() => new Page(elements));
}
