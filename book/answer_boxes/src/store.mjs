/* What this browser keeps: typed answers, verified answers, and the consent to load Python. In a browser that keeps nothing
   (storage refused, a full store) the answers stay in the page, which says so. */

const PREFIX = "workbook/";
const CONSENT = "workbook: Python may be loaded";

/** Whether this browser has refused to keep something. */
export let isRefused = false;

function read(key) {
  try {
    return JSON.parse(localStorage.getItem(PREFIX + key));
  } catch {
    return null;
  }
}

function write(key, value) {
  try {
    if (value === null) localStorage.removeItem(PREFIX + key);
    else localStorage.setItem(PREFIX + key, JSON.stringify(value));
  } catch {
    isRefused = true;
  }
}

// without a store the name of the tab remembers, so that the next page does not ask again
export const hasConsent = () => read("python") === true || window.name === CONSENT;

export function rememberConsent() {
  write("python", true);
  if (isRefused) window.name = CONSENT;
}

const answersKey = (number, version) => `answers/${number}/${version}`;

/** Return the answers typed for this version of a problem, {name: code}; {} without any. */
export const readAnswers = (number, version) => read(answersKey(number, version)) ?? {};

export function writeAnswers(number, version, answers) {
  write(answersKey(number, version), Object.keys(answers).length ? answers : null);
}

/** Move answers typed for an earlier version of a problem to this one, with `renamed`, {former name: name}; return whether there
    were any. */
export function adoptEarlierAnswers(number, version, renamed) {
  const current = PREFIX + answersKey(number, version);
  let keys = [];
  try {
    keys = Object.keys(localStorage).filter((key) => key.startsWith(`${PREFIX}answers/${number}/`));
  } catch {
    // nothing is kept here
  }
  if (!keys.length || keys.includes(current)) return false;
  const earlier = Object.assign({}, ...keys.map((key) => read(key.slice(PREFIX.length))));
  writeAnswers(number, version, Object.fromEntries(Object.entries(earlier).map(([name, code]) => [renamed[name] ?? name, code])));
  for (const key of keys) write(key.slice(PREFIX.length), null);
  return true;
}

/** Days after which a right answer is asked for again. */
const INTERVALS = [1, 7, 30];
const today = () => new Date().toLocaleDateString("sv"); // 2026-11-29
const daysSince = (day) => (Date.parse(today()) - Date.parse(day)) / 86_400_000;

/** Return {number: {version, answers, right, wrong, day, again}}: how many answers a problem has; the names of those found right,
    and of those tried and not right; the day since which they are kept in mind, and how often they were right again since. */
export const readVerified = () => read("verified") ?? {};
export const writeVerified = (verified) => write("verified", verified);

/** Whether the right answers of a problem are to be given again. */
export const isDue = ({ right, day, again = 0 }) =>
  right.length > 0 && again < INTERVALS.length && (!day || daysSince(day) >= INTERVALS[again]);

/** Note the last verdicts on answers of a problem, {name: status}; `repeats` is the problem that it asks again. */
export function noteVerdicts({ number, version, answers, repeats }, verdicts) {
  const verified = readVerified();
  const known = verified[number]?.version === version ? verified[number] : {};
  const [right, wrong] = [new Set(known.right), new Set(known.wrong)];
  let { day, again } = known;
  for (const [name, status] of Object.entries(verdicts)) {
    if (status === "right" && !right.has(name)) [day, again] = [today(), 0];
    if (status === "right") right.add(name);
    else right.delete(name);
    if (status === "wrong") wrong.add(name);
    else if (status === "right") wrong.delete(name);
  }
  if (right.size + wrong.size) verified[number] = { version, answers: Number(answers), right: [...right], wrong: [...wrong], day, again };
  else delete verified[number];
  const before = verified[repeats];
  if (before && isDue(before)) {
    if (before.right.every((name) => right.has(name))) [before.day, before.again] = [today(), (before.again ?? 0) + 1];
    else if (Object.values(verdicts).includes("wrong")) [before.day, before.again] = [today(), 0];
  }
  writeVerified(verified);
}

export function forgetVerified(number) {
  const { [number]: _, ...others } = readVerified();
  writeVerified(others);
}

// Progress as a file ------------------------------------------------------------------------------------------------------

const isKept = (key) => key === `${PREFIX}verified` || key.startsWith(`${PREFIX}answers/`);

/** Return what this browser keeps of the reader's work as the text of a file. */
export const exported = () =>
  JSON.stringify({ workbook: "progress", day: today(), kept: Object.fromEntries(Object.entries(localStorage).filter(([key]) => isKept(key))) }, null, 1);

/** Add the work of a file to what is kept here; of two records of one problem the one with more right answers stays. */
export function importFrom(text, file) {
  let kept, theirs;
  try {
    const content = JSON.parse(text);
    if (content.workbook !== "progress") throw new Error();
    kept = Object.entries(content.kept).filter(([key, value]) => isKept(key) && typeof JSON.parse(value) === "object");
    theirs = JSON.parse(content.kept[`${PREFIX}verified`] ?? "{}");
    if (!Object.values(theirs).every(({ right, answers }) => Array.isArray(right) && answers > 0)) throw new Error();
  } catch {
    throw new Error(`${file} is not a file of progress that this page wrote.`);
  }
  const ours = readVerified();
  for (const [number, record] of Object.entries(theirs)) if (record.right.length >= (ours[number]?.right.length ?? 0)) ours[number] = record;
  writeVerified(ours);
  for (const [key, value] of kept) if (localStorage.getItem(key) === null) write(key.slice(PREFIX.length), JSON.parse(value));
}

/** Forget all of the reader's work. */
export function forgetAll() {
  for (const key of Object.keys(localStorage).filter(isKept)) localStorage.removeItem(key);
}
