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

/** Return {number: {version, answers, right}}: how many answers a problem has, and the names of those found right. */
export const readVerified = () => read("verified") ?? {};
export const writeVerified = (verified) => write("verified", verified);

/** Note the last verdicts on answers of a problem, {name: status}. */
export function noteVerdicts({ number, version, answers }, verdicts) {
  const verified = readVerified();
  const right = new Set(verified[number]?.version === version ? verified[number].right : []);
  for (const [name, status] of Object.entries(verdicts)) {
    if (status === "right") right.add(name);
    else right.delete(name);
  }
  if (right.size) verified[number] = { version, answers: Number(answers), right: [...right] };
  else delete verified[number];
  writeVerified(verified);
}

export function forgetVerified(number) {
  const { [number]: _, ...others } = readVerified();
  writeVerified(others);
}
