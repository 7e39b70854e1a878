/* What the build says about a page: the attributes of the script that it adds to it (workbook/site/answer_boxes.py). */

const script = document.currentScript;

/** number, title and version of the problem, and how many answers it has; notebook and run, the addresses of its notebook and
    of the engine; part, if the page is another one that shows a box of the problem. */
export const settings = { ...script.dataset };

/** The address of a file beside this script. */
export const beside = (name) => new URL(name, script.src).href;

const requested = new Map();

/** Load a script once. Pages opened as files can load scripts and nothing else. */
export function loadScript(address) {
  if (!requested.has(address)) {
    requested.set(address, new Promise((resolve, reject) => {
      const element = document.createElement("script");
      element.src = address;
      element.onload = () => resolve();
      element.onerror = () => {
        requested.delete(address);
        reject(new Error(`${address} is missing`));
      };
      document.head.append(element);
    }));
  }
  return requested.get(address);
}
