/* What the page of slides (jupyterlab-rise) lacks, as an extension that JupyterLab loads without being built.

   It has no consoles and does not share @jupyterlab/console, without which the widgets' extension does not load, though
   it only asks whether there is a console. Where nobody shares the module, this shares one that says no.

   Its Shift+Enter runs a cell and goes on to the next one, which is the next slide, before anybody has seen the result.
   Here it runs the cell.

   Its slides are made for a desk: slides.css makes them for a hall, and each slide below a title repeats the title.

   A cell that a magic inserts belongs to no slide there; here it gets one, below the one of the magic. Code is chosen by its place in the notebook, which
   such cells change; here the first code of the slide is chosen.

   In the notebook, Shift+Enter goes on to the next cell, also where it is folded, which JupyterLab passes over without running it.

   On slides and in the notebook, Alt+C opens the folded code of a cell and folds it again. */
{
let shared;
const slides = location.pathname.includes("/rise/");

// Longer code that a magic inserts is folded on its slide, and code that draws.
const MOST_LINES = 12;
const source = document.currentScript.src;

async function run(app) {
  const versions = Object.values(shared["@jupyterlab/notebook"]);
  const {NotebookActions} = (await versions[0].get())();
  const {content, context} = app.shell.currentWidget;
  const {dataset} = content.activeCell.node;
  dataset.state = "running";
  try { return await NotebookActions.run(content, context.sessionContext); } finally { dataset.state = "ran"; }
}

function nextCell(app) {
  const {content} = app.shell.currentWidget;
  if (content.activeCellIndex === content.widgets.length - 1) return;
  content.deselectAll();
  content.activeCellIndex += 1;
  content.activate();
  return content.scrollToItem(content.activeCellIndex, "auto");
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

function shrink(node, slide) {
  const excess = slide.scrollHeight - slide.clientHeight;
  if (excess > 0) node.style.zoom = Math.max(0.5, (node.style.zoom || 1)*(1 - excess/node.offsetHeight));
}

function addSlide(node, content) {
  const present = document.querySelector("section section.present");
  const slide = Object.assign(document.createElement("section"), {id: `${present.id}-below`, className: "future"});
  slide.append(node);
  present.after(slide);
  repeatTitle(slide);
  const cell = content.widgets.find(widget => widget.node === node);
  const code = cell.model.sharedModel.source;
  // a worked solution is not written for slides
  new ResizeObserver(() => shrink(node, slide)).observe(node);
  cell.inputHidden = code.includes("plt.") || code.split("\n").length > MOST_LINES;
}

/* Shift+Enter runs the first code of the slide. */
function select(slide, content) {
  const node = slide.querySelector(".jp-CodeCell");
  if (node) content.activeCellIndex = content.widgets.findIndex(widget => widget.node === node);
}

/* Once the slides are there; whether they are. */
function prepareSlides(app) {
  const reveal = document.querySelector(".reveal.ready");
  if (!reveal) return false;
  const {content} = app.shell.currentWidget;
  reveal.addEventListener("slidechanged", event => select(event.currentSlide, content));
  document.querySelectorAll("section.stack > section").forEach(repeatTitle);
  const notebook = document.querySelector(".reveal .jp-Notebook");
  const loose = () => notebook.querySelectorAll(".jp-Cell:not(section .jp-Cell)").forEach(node => addSlide(node, content));
  new MutationObserver(loose).observe(notebook, {childList: true, subtree: true});
  return true;
}

function activate(app) {
  app.commands.addCommand("workbook:fold", {execute: () => fold(app), label: "Fold or open the code of the cell"});
  app.commands.addCommand("workbook:next-cell", {execute: () => nextCell(app), label: "Go on to the next cell"});
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
  // the change to another slide leaves the focus nowhere
  for (const [command, keys] of [["workbook:run", "Shift Enter"], ["workbook:fold", "Alt C"]]) {
    app.commands.addKeyBinding({command, keys: [keys], args: {}, selector: "body.rise-enabled"});
  }
  const waiting = setInterval(() => prepareSlides(app) && clearInterval(waiting), 200);
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
