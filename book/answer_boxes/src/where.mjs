/* "Where am I?": what this browser keeps of the reader's work, by section and topic, and what is to be repeated today. */

import { button, make } from "./elements.mjs";
import * as store from "./store.mjs";

const { problems, sections } = JSON.parse(document.getElementById("progress-data").textContent);
const page = document.getElementById("progress-page");
const message = make("span", { role: "status" });

const link = (url, text) => make("a", { href: url }, text);
const isRight = ({ right, answers }) => right.length >= answers;
const plural = (n, word) => `${n} ${word}${n === 1 ? "" : "s"}`;

function list(title, entries, nothing) {
  const body = entries.length ? make("ul", {}, ...entries.map((parts) => make("li", {}, ...parts))) : make("p", { className: "nothing" }, nothing);
  return make("section", {}, make("h2", {}, title), body);
}

/** A row of a table: what, how much of it, as words and as a bar. */
function row(name, right, all, words) {
  const bar = make("meter", { min: 0, max: all, value: right, ariaLabel: `${right} of ${all}` });
  return make("tr", {}, make("th", { scope: "row" }, name), make("td", {}, bar), make("td", {}, words));
}

function table(title, rows) {
  if (!rows.length) return "";
  return make("section", {}, make("h2", {}, title), make("table", { className: "progress-table" }, make("tbody", {}, ...rows)));
}

function show() {
  const verified = store.readVerified();
  const begun = Object.entries(verified).filter(([number]) => problems[number]);
  const named = (number) => [link(problems[number].url, number), ` ${problems[number].title}`];
  const due = begun.filter(([, record]) => store.isDue(record)).map(([number]) => [
    link(`${problems[number].url}?again`, number),
    ` ${problems[number].title}${problems[number].varies ? ", with other numbers" : ""}`,
  ]);
  const failed = begun.filter(([, { wrong }]) => wrong?.length).map(([number, { wrong }]) => [
    ...named(number), ": ", ...wrong.flatMap((name) => [make("code", {}, name), " "]),
  ]);

  const whole = new Set(begun.filter(([, record]) => isRight(record)).map(([number]) => number));
  /** Of some problems how many answers there are, and how many are right. */
  const answersOf = (numbers) => numbers.reduce((sum, number) => sum + problems[number].answers, 0);
  const rightOf = (numbers) => numbers.reduce((sum, number) => sum + (verified[number]?.right.length ?? 0), 0);
  const bySection = sections.flatMap(({ title, url, numbers, test }) => {
    const done = numbers.filter((number) => whole.has(number)).length;
    const answered = verified[test];
    if (!numbers.some((number) => verified[number]) && !answered) return [];
    const words = [
      ...(numbers.length ? [`${done} of ${plural(numbers.length, "problem")}`] : []),
      ...(answered ? [`self-test ${answered.right.length} of ${answered.answers}`] : []),
    ].join(", ");
    const tested = [answered?.right.length ?? 0, answered?.answers ?? 0];
    return [row(link(url, title), rightOf(numbers) + tested[0], answersOf(numbers) + tested[1], words)];
  });
  const topics = {};
  for (const [number, problem] of Object.entries(problems)) for (const topic of problem.topics) (topics[topic] ??= []).push(number);
  const byTopic = Object.entries(topics).filter(([, numbers]) => numbers.some((number) => verified[number]?.right.length))
    .sort(([a], [b]) => a.localeCompare(b))
    .map(([topic, numbers]) => {
      const done = numbers.filter((number) => whole.has(number)).length;
      return row(topic, rightOf(numbers), answersOf(numbers), `${done} of ${plural(numbers.length, "problem")}`);
    });
  page.replaceChildren(
    list("To repeat today", due, "Nothing. A right answer comes back after 1, 7 and 30 days."),
    list("Tried and not right yet", failed, "Nothing."),
    table("By section", bySection),
    table("By topic", byTopic),
  );
}

function download() {
  const address = URL.createObjectURL(new Blob([store.exported()], { type: "application/json" }));
  make("a", { href: address, download: "my-progress.json" }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

async function open(file) {
  const [chosen] = file.files;
  file.value = "";
  try {
    store.importFrom(await chosen.text(), chosen.name);
    message.textContent = store.isRefused ? "This browser does not keep it." : `${chosen.name} is added to what this browser keeps.`;
    show();
  } catch (error) {
    message.textContent = error.message;
  }
}

function forget() {
  const before = store.exported();
  store.forgetAll();
  show();
  message.replaceChildren("Forgotten. ", button("Undo", "answer-tool", () => {
    store.importFrom(before, "");
    message.textContent = "";
    show();
  }));
}

const file = make("input", { type: "file", accept: ".json", hidden: true, onchange: () => open(file) });
page.before(make("p", { className: "progress-tools answer-bar" },
  button("Save as a file", "answer-tool", download), button("Add from a file", "answer-tool", () => file.click()),
  button("Forget all", "answer-tool", forget), file, message));
show();
addEventListener("pageshow", show); // answers were given meanwhile
