/* The code of one answer: a textarea, and the editor that takes its place when a box is first used. */

import { beside, loadScript } from "./settings.mjs";

export const KEYS = "answer-keys";

export class Field {
  constructor(textarea, { onChange, onRun, onFocus }) {
    this.textarea = textarea;
    this.name = textarea.dataset.name;
    this.former = textarea.dataset.former;
    this.cell = textarea.dataset.cell;
    this.stub = this.shown = textarea.defaultValue;
    this.events = { onChange: () => onChange(this), onRun };
    textarea.addEventListener("focus", onFocus);
    textarea.addEventListener("input", () => this.changed());
    textarea.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" || !(event.shiftKey || event.ctrlKey || event.metaKey)) return;
      event.preventDefault();
      onRun();
    });
  }

  get text() {
    return this.editor ? this.editor.get() : this.textarea.value;
  }

  set text(text) {
    if (this.text === text) return;
    if (this.editor) this.editor.set(text);
    else {
      this.textarea.value = text;
      this.changed();
    }
  }

  get isTyped() {
    return ![this.stub, this.shown].includes(this.text.trim());
  }

  /** What the answer cell of the notebook holds: its stub until something is typed. */
  get source() {
    return this.isTyped ? this.text : this.stub;
  }

  /** Show what is asked for, formulas and all, above the field and not as a comment in it. */
  explain(meaning) {
    this.shown = this.stub.replace(/#.*/g, "").trim();
    this.textarea.value = this.textarea.defaultValue = this.shown;
    this.textarea.before(meaning);
  }

  changed() {
    this.fit();
    this.events.onChange();
  }

  /** Make the textarea as high as its text, in a browser that does not do so by itself. */
  fit() {
    if (CSS.supports("field-sizing", "content")) return;
    this.textarea.style.height = "auto";
    this.textarea.style.height = `${this.textarea.scrollHeight}px`;
  }

  /** Replace the textarea by the editor; without it the textarea stays. */
  async mount() {
    await loadScript(beside("editor.js"));
    this.editor ??= window.workbookEditor(this.textarea, { label: this.name, describedBy: KEYS, ...this.events });
  }

  markLine(line) {
    this.editor?.mark(line);
  }
}
