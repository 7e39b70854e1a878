/* The box of one check cell: the code of its answers, the buttons, and below them what a run gives. */

import { isAskedAgain } from "./again.mjs";
import { button, make } from "./elements.mjs";
import { Field } from "./field.mjs";
import { cellsOfRun } from "./notebook.mjs";
import * as python from "./python.mjs";

/** What the statement says about an answer, on paper and without boxes. */
const rowOf = (name) =>
  [...document.querySelectorAll("details.answers .answer")].find((row) => row.querySelector("code").textContent === name);

export class Box {
  constructor(element, page) {
    this.element = element;
    this.page = page;
    this.check = element.dataset.check;
    this.counts = !("uncounted" in element.dataset);
    this.fields = [...element.querySelectorAll("textarea")].map(
      (textarea) =>
        new Field(textarea, {
          onChange: (field) => page.save(field),
          onRun: () => this.run(),
          onFocus: () => page.open(this),
        }),
    );
    this.build();
  }

  build() {
    this.runButton = button("Run and check", "answer-run", () => this.run());
    this.stopButton = button("Stop", "answer-stop", () => this.stop());
    this.stopButton.hidden = true;
    this.state = make("span", { className: "answer-state" });
    this.live = make("p", { className: "answer-live", role: "status" });
    this.output = make("div", { className: "answer-output" });
    for (const field of this.fields) {
      const meaning = !isAskedAgain() && rowOf(field.name)?.querySelector("p").cloneNode(true);
      if (meaning) field.explain(make("div", { className: "answer-meaning" }, meaning));
    }
    const fields = make("div", { className: "answer-fields highlight" }, ...this.element.children);
    // shortcuts of the site, such as / for the search, are not for those who write here
    fields.addEventListener("keydown", (event) => event.ctrlKey || event.metaKey || event.stopPropagation());
    const label = !this.counts ? "Your steps" : this.fields.length > 1 ? "Your answers" : "Your answer";
    this.bar = make("div", { className: "answer-bar" }, this.runButton, this.stopButton, this.state);
    this.element.append(
      make("p", { className: "answer-label", ariaHidden: "true" }, label),
      fields,
      this.bar,
      this.output,
      this.live,
    );
    this.element.hidden = false;
    for (const field of this.fields) field.fit();
  }

  /** Show hints of its answers that stand in folds elsewhere on the page. */
  addHints() {
    const several = this.fields.length > 1;
    const hints = this.fields.flatMap(({ name }) => {
      return [...(rowOf(name)?.querySelectorAll("details.hint") ?? [])].map((fold) => {
        const copy = fold.cloneNode(true);
        copy.open = false;
        if (several) copy.firstElementChild.append(" for ", make("code", {}, name));
        return copy;
      });
    });
    if (several && hints.length) {
      this.bar.append(make("details", { className: "hint answer-hints" }, make("summary", {}, "Hints"), make("div", {}, ...hints)));
    } else this.bar.append(...hints);
  }

  say(text) {
    this.state.textContent = text;
  }

  async run() {
    if (this.isRunning) return;
    if (!python.isAllowed()) {
      this.page.ask(this, () => this.run());
      return;
    }
    this.setRunning(true);
    this.clear();
    this.live.textContent = "Running.";
    const stopped = new Promise((_, reject) => {
      this.stop = () => {
        python.stop();
        reject(new Error(python.failure("stopped")));
      };
    });
    try {
      // with all loaded, nothing comes between the last look for a stop and the run
      await Promise.race([Promise.all([this.page.startPython(this), this.page.notebook()]), stopped]);
      this.say("running …");
      const began = performance.now();
      const { result, error } = await this.runCells();
      this.say(error ? "" : `${((performance.now() - began) / 1000).toPrecision(2)} s`);
      if (error) this.showFailure(python.failure(error));
      else this.show(result);
    } catch (error) {
      this.say("");
      this.showFailure(error.message);
    }
    this.setRunning(false);
  }

  async runCells() {
    const names = this.page.namesUpTo(this);
    const { cells, check } = cellsOfRun(await this.page.notebook(), this.page.names, this.page.answers(), this.check, names);
    this.cells = cells;
    return python.runCell(cells, check);
  }

  setRunning(isRunning) {
    this.isRunning = isRunning;
    this.runButton.setAttribute("aria-disabled", isRunning);
    if (!isRunning && document.activeElement === this.stopButton) this.runButton.focus();
    this.stopButton.hidden = !isRunning;
  }

  clear() {
    this.output.replaceChildren();
    this.live.textContent = "";
    for (const field of this.fields) field.markLine(null);
  }

  showFailure(message) {
    this.output.append(make("p", { className: "answer-error" }, message));
    this.live.textContent = message;
  }

  show({ printed, read, errors, verdicts, html, text }) {
    const isOwn = ({ name }) => this.fields.some((field) => field.name === name);
    const own = (texts) => texts.filter((_, k) => isOwn(this.cells[k]));
    const codes = own(read).filter(Boolean);
    if (codes.length) this.output.append(make("div", { className: "answer-read" }, "Read as:", make("pre", {}, codes.join("\n"))));
    const texts = own(printed).join("");
    if (texts) this.output.append(make("pre", { className: "answer-printed" }, texts));
    const sourced = errors.map((error) => ({ ...error, source: this.cells[error.cell] ?? { name: "check cell" } }));
    const isAnswer = ({ source }) => this.page.fields.some((field) => field.name === source.name);
    // what an error above leads to here is an error here: a name without a value
    const needsAbove = sourced.some(({ source, text: message }) => isOwn(source) && message.startsWith("NameError"));
    const messages = sourced
      .filter((error) => isOwn(error.source) || !isAnswer(error) || needsAbove)
      .map((error) => this.showError(error, isOwn(error.source)));
    const report = make("div");
    report.innerHTML = html; // by workbook.page, which escapes what a student wrote
    this.output.append(report);
    this.live.textContent = [...codes.map((code) => `Read as: ${code}`), ...messages, text].join("\n");
    if (this.counts) this.page.noteVerdicts(verdicts);
  }

  /** Show where a cell failed, and for one of this box what to write instead; return the same as text. */
  showError({ source, line, text, hint }, isOwn) {
    const place = `${source.name ?? "data cell"}${line ? `, line ${line}` : ""}`;
    const advice = isOwn ? hint : "";
    if (isOwn) this.fields.find((field) => field.name === source.name).markLine(line);
    this.output.append(
      make("div", { className: "answer-error" }, make("p", {}, make("b", {}, place), " ", text), ...(advice ? [make("pre", {}, advice)] : [])),
    );
    return `${place}: ${text}. ${advice}`;
  }
}
