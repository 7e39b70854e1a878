/* What the page of slides (jupyterlab-rise) lacks, as an extension that JupyterLab loads without being built.

   It has no consoles and does not share @jupyterlab/console, without which the widgets' extension does not load, though
   it only asks whether there is a console. Where nobody shares the module, this shares one that says no.

   Its Shift+Enter runs a cell and goes on to the next one, which is the next slide, before anybody has seen the result.
   Here it runs the cell.

   Its slides are made for a desk: slides.css makes them for a hall, and each slide below a title repeats the title.

   A cell that a magic inserts belongs to no slide there; here it gets one, below the one of the magic.

   On slides and in the notebook, Alt+C opens the folded code of a cell and folds it again. */
{
let shared;
const slides = location.pathname.includes("/rise/");

const source = document.currentScript.src;

async function run(app) {
  const versions = Object.values(shared["@jupyterlab/notebook"]);
  const {NotebookActions} = (await versions[0].get())();
  const {content, context} = app.shell.currentWidget;
  return NotebookActions.run(content, context.sessionContext);
}

function fold(app) {
  const cell = app.shell.currentWidget.content.activeCell;
  cell.inputHidden = !cell.inputHidden;
}

function repeatTitle(slide) {
  const heading = slide.parentElement.querySelector(":is(h1, h2, h3)");
  if (!heading || slide.contains(heading)) return;
  const copy = Object.assign(document.createElement("div"), {className: "workbook-title", innerHTML: heading.innerHTML});
  copy.querySelector(".jp-InternalAnchorLink")?.remove();
  slide.prepend(copy);
}

function addSlide(cell) {
  const present = document.querySelector("section section.present");
  const slide = Object.assign(document.createElement("section"), {id: `${present.id}-${cell.id || Date.now()}`, className: "future"});
  slide.append(cell);
  present.after(slide);
  repeatTitle(slide);
}

/* Once the slides are there; whether they are. */
function prepareSlides() {
  if (!document.querySelector(".reveal.ready")) return false;
  document.querySelectorAll("section.stack > section").forEach(repeatTitle);
  const notebook = document.querySelector(".reveal .jp-Notebook");
  const loose = () => notebook.querySelectorAll(".jp-Cell:not(section .jp-Cell)").forEach(addSlide);
  new MutationObserver(loose).observe(notebook, {childList: true, subtree: true});
  return true;
}

function activate(app) {
  app.commands.addCommand("workbook:fold", {execute: () => fold(app), label: "Fold or open the code of the cell"});
  for (const mode of ["edit", "command"]) {
    const selector = `.jp-Notebook.jp-mod-${mode}Mode`;
    app.commands.addKeyBinding({command: "workbook:fold", keys: ["Alt C"], args: {}, selector});
  }
  if (!slides) return;
  const style = Object.assign(document.createElement("link"), {rel: "stylesheet", href: new URL("slides.css", source)});
  document.head.append(style);
  app.commands.addCommand("workbook:run", {execute: () => run(app), label: "Run the cell and stay"});
  for (const mode of ["edit", "command"]) {
    app.commands.addKeyBinding({command: "workbook:run", keys: ["Shift Enter"], args: {},
                                selector: `body .lm-Widget.reveal .jp-Notebook.jp-mod-${mode}Mode`});
  }
  const waiting = setInterval(() => prepareSlides() && clearInterval(waiting), 200);
}

(window._JUPYTERLAB ??= {})["workbook-live"] = {
  init(scope) {
    const nothing = {IConsoleTracker: {name: "@jupyterlab/console:IConsoleTracker"}};
    shared = scope;
    scope["@jupyterlab/console"] ??= {
      "4.99.0": {get: () => Promise.resolve(() => nothing), from: "workbook-live", eager: false, loaded: 0},
    };
  },
  get() {
    return Promise.resolve(() => ({__esModule: true, default: {id: "workbook-live:slides", autoStart: true, activate}}));
  },
};
}
