/* The question before Python is loaded: how much, from where, and what happens to what is typed. */

import { button, make } from "./elements.mjs";
import { megabytes } from "./python.mjs";

export class Question {
  wasAsked = false;

  /** Show the question in a box; `agreed` is called if the reader agrees. */
  async ask(box, agreed) {
    this.wasAsked = true;
    this.element?.remove();
    let size;
    try {
      size = await megabytes();
    } catch {
      box.say("Python is missing beside these pages.");
      return;
    }
    this.element?.remove();
    const yes = button(`Load Python (${size} MB)`, "answer-run", () => {
      this.element.remove();
      box.runButton.focus();
      agreed();
    });
    const no = button("Not now", "answer-stop", () => {
      this.element.remove();
      box.runButton.focus();
    });
    const words =
      `Checking answers here needs Python with NumPy, SciPy and SymPy: ${size} MB from this site. ` +
      "This browser is asked once. What you type stays on this computer.";
    this.element = make("div", { className: "answer-question", role: "group", ariaLabel: "Load Python" }, make("p", {}, words), make("div", { className: "answer-bar" }, yes, no));
    box.output.before(this.element);
    box.live.textContent = words;
  }
}
