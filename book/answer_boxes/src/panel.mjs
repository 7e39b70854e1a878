/* Below the last box: the answers are kept in this browser, can be taken along as a notebook, and cleared. */

import { button, make } from "./elements.mjs";
import { settings } from "./settings.mjs";
import * as store from "./store.mjs";

export class AnswersPanel {
  constructor(page, lastBox) {
    this.page = page;
    this.message = make("span", { role: "status" });
    this.kept = make("span");
    this.verified = make("span");
    const file = make("input", { type: "file", accept: ".ipynb", hidden: true, onchange: () => this.open(file) });
    (lastBox.closest("details.steps") ?? lastBox).after(
      make(
        "section",
        { className: "answers-panel", ariaLabel: "Your answers" },
        make("p", {}, this.kept, this.verified, this.message),
        make(
          "p",
          { className: "answer-bar" },
          button("Download as notebook", "answer-tool", () => page.download().catch((error) => this.say(error.message))),
          button("Open from notebook", "answer-tool", () => file.click()),
          button("Clear", "answer-tool", () => this.clear()),
          file,
        ),
      ),
    );
  }

  say(text, ...more) {
    this.message.replaceChildren(text, ...more);
  }

  /** Say whether answers are kept, and how many were found right. */
  count() {
    this.kept.textContent = store.isRefused
      ? "This browser does not keep your answers: download them as a notebook. "
      : "Your answers are kept in this browser. ";
    const { number, version } = settings;
    const verified = store.readVerified()[number];
    const right = verified?.version === version ? verified.right.length : 0;
    this.verified.textContent = right ? `${right} of ${settings.answers} verified here. ` : "";
    // topics may tell how to solve it
    if (right === Number(settings.answers)) document.querySelector("details.topics")?.setAttribute("open", "");
  }

  async open(file) {
    const [notebook] = file.files;
    file.value = ""; // the same file can be opened again
    const before = this.page.answers();
    try {
      await this.page.openNotebook(notebook);
      this.say(`The answers of ${notebook.name} are in the boxes. `, this.undo(before));
    } catch (error) {
      this.say(error.message);
    }
  }

  clear() {
    const before = this.page.answers();
    const verified = store.readVerified();
    this.page.setAnswers({});
    for (const box of this.page.boxes) box.clear();
    store.forgetVerified(settings.number);
    this.count();
    this.say("Cleared. ", this.undo(before, verified));
  }

  undo(answers, verified = null) {
    return button("Undo", "answer-tool", () => {
      this.page.setAnswers(answers);
      if (verified) store.writeVerified(verified);
      this.count();
      this.say("");
    });
  }
}
