/* On lists of problems: which of them were verified in this browser. */

import { make } from "./elements.mjs";
import { readVerified } from "./store.mjs";

const NOTE =
  "✓, or a number such as 1/3, marks answers that were verified in this browser. " +
  "The marks are your own record: they prove nothing to a grader.";
const verified = readVerified();

function mark(link) {
  const problem = verified[link.textContent.trim()];
  if (!problem?.right.length) return;
  const { answers, right } = problem;
  const isWhole = right.length === answers;
  const words = isWhole ? "verified" : `${right.length} of ${answers} verified`;
  const sign = isWhole ? "✓" : `${right.length}/${answers}`;
  link.after(" ", make("span", { className: "problem-verified", title: words, role: "img", ariaLabel: words }, sign));
}

document
  .querySelectorAll("table.problem-list td:first-child a, table.route td a, dl.topics li a, .section-problems li a:first-child")
  .forEach(mark);
const list = document.querySelector(".problem-verified")?.closest(".pst-scrollable-table-container, table, dl, .chapter-map");
list?.before(make("p", { className: "verified-note" }, NOTE));
