/* What the page of slides (jupyterlab-rise) lacks, as an extension that JupyterLab loads without being built.

   It has no consoles and does not share @jupyterlab/console, without which the widgets' extension does not load, though
   it only asks whether there is a console. Where nobody shares the module, this shares one that says no.

   Its Shift+Enter runs a cell and goes on to the next one, which is the next slide, before anybody has seen the result.
   Here it runs the cell, after those above it that have not run: the unseen ones (imports, functions, data), and those
   of slides that were passed over.

   A slide is never empty: what has nothing to show before it has run (a picture whose code is folded, an explorer, the
   next step of an answer) runs when its slide comes.

   Its slides are made for a desk: ../slides.css makes them for a hall, and each slide has the title of its section.
   Short lines of code stand beside what they show, a picture that is not wide beside its caption; what does not fit is
   made smaller.

   A cell that a magic inserts belongs to no slide there; here it gets one, below the one of the magic. Code is chosen by its place in the notebook, which
   such cells change; here the first code of the slide is chosen.

   In the notebook, Shift+Enter goes on to the next cell, also where it is folded, which JupyterLab passes over without running it.

   On slides and in the notebook, Alt+C opens the folded code of a cell and folds it again. */
{
let shared;
const slides = location.pathname.includes("/rise/");

// Longer code that a magic inserts is folded on its slide, and code that draws.
const MOST_LINES = 12;
// Code with longer lines leaves no room beside it; a picture that is wider leaves none either.
const MOST_LETTERS = 60, WIDEST = 1.7;

// The colours of a <jp-toolbar> depend on themselves, without end, where the theme comes after it. Slides hide toolbars,
// and make them of plain elements.
if (slides) {
  const create = document.createElement;
  document.createElement = function (name, ...more) { return create.call(this, name === "jp-toolbar" ? "div" : name, ...more); };
}

async function run(app) {
  const versions = Object.values(shared["@jupyterlab/notebook"]);
  const {NotebookActions} = (await versions[0].get())();
  const {content, context} = app.shell.currentWidget;
  const {dataset} = content.activeCell.node;
  const above = content.widgets.slice(0, content.activeCellIndex);
  const waiting = above.filter(({model}) => model.type === "code" && model.executionCount === null && !model.sharedModel.source.startsWith("%"));
  dataset.state = "running";
  try {
    await NotebookActions.runCells(content, waiting, context.sessionContext);
    return await NotebookActions.run(content, context.sessionContext);
  } finally { dataset.state = "ran"; }
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
  if (!heading || heading.matches("h1") && slide.contains(heading)) return;
  const copy = Object.assign(document.createElement("div"), {className: "workbook-title", innerHTML: heading.innerHTML});
  copy.querySelector(".jp-InternalAnchorLink")?.remove();
  slide.prepend(copy);
}

/* Where a slide is too high, the code of a cell or what it shows is made smaller, whichever is higher. */
function shrink(node, slide) {
  const excess = slide.scrollHeight - slide.clientHeight;
  if (excess <= 0) return;
  const [input, output] = [".jp-Cell-inputWrapper", ".jp-Cell-outputWrapper"].map(name => node.querySelector(name));
  const {style, offsetHeight} = output.offsetHeight > input.offsetHeight ? output : input;
  style.zoom = Math.max(0.5, (style.zoom || 1)*(1 - excess/offsetHeight));
}

/* Code on a slide gets its place and its size. */
function place(node, slide, content) {
  const {source} = content.widgets.find(widget => widget.node === node).model.sharedModel;
  const longest = Math.max(...source.split("\n").map(line => line.length));
  if (source.includes("\n") && longest <= MOST_LETTERS) node.classList.add("workbook-beside");
  new ResizeObserver(() => shrink(node, slide)).observe(node);
}

/* A cell that is inserted gets a slide; where the magic that inserted it shows no text, it takes the place of the magic. */
function addSlide(node, app) {
  const {content} = app.shell.currentWidget;
  const present = document.querySelector("section section.present");
  const magic = present.querySelector(".jp-CodeCell:not(.reveal-skip)");
  const above = content.widgets.find(widget => widget.node === magic);
  const silent = above?.model.sharedModel.source.startsWith("%answer") && !magic.querySelector(".jp-RenderedMarkdown");
  if (silent) magic.classList.add("reveal-skip");
  const slide = silent ? present : Object.assign(document.createElement("section"), {id: `${present.id}-below`, className: "future"});
  slide.append(node);
  if (!silent) {
    present.after(slide);
    repeatTitle(slide);
  }
  const cell = content.widgets.find(widget => widget.node === node);
  const code = cell.model.sharedModel.source;
  // a worked solution is not written for slides
  cell.inputHidden = code.includes("plt.") || code.split("\n").length > MOST_LINES;
  node.dataset.inserted = true;
  place(node, slide, content);
  if (silent) select(slide, app);
}

/* Shift+Enter runs the first code of the slide; what would leave the slide empty runs at once. */
function select(slide, app) {
  const {content} = app.shell.currentWidget;
  const node = slide.querySelector(".jp-CodeCell:not(.reveal-skip)");
  if (!node) return;
  content.activeCellIndex = content.widgets.findIndex(widget => widget.node === node);
  const {inputHidden, model} = content.activeCell, {source} = model.sharedModel;
  const shows = inputHidden || source.startsWith("%explore") || (node.dataset.inserted && source.startsWith("%answer"));
  if (!shows || node.dataset.state) return;
  if (source.startsWith("%")) node.classList.add("workbook-quiet");
  run(app);
}

/* A formula that is wider than its slide is made smaller. */
function narrow(slide) {
  for (const formula of slide.querySelectorAll(".jp-MarkdownCell mjx-container[display]")) {
    formula.style.fontSize = "";
    const excess = formula.scrollWidth/formula.clientWidth;
    if (excess > 1) formula.style.fontSize = `${Math.floor(100/excess)}%`;
  }
}

/* Once the slides are there; whether they are. */
function prepareSlides(app) {
  const reveal = document.querySelector(".reveal.ready");
  if (!reveal) return false;
  const {content} = app.shell.currentWidget;
  reveal.addEventListener("slidechanged", ({currentSlide}) => { select(currentSlide, app); narrow(currentSlide); });
  for (const slide of document.querySelectorAll("section.stack > section")) {
    repeatTitle(slide);
    for (const node of slide.querySelectorAll(".jp-CodeCell:not(.reveal-skip)")) place(node, slide, content);
  }
  reveal.addEventListener("load", ({target: picture}) => {
    if (!picture.matches(".jp-OutputArea-output > img")) return;
    picture.closest("section").classList.toggle("workbook-tall", picture.naturalWidth < WIDEST*picture.naturalHeight);
  }, true);
  addEventListener("resize", () => {
    document.querySelectorAll(".reveal .jp-CodeCell > *").forEach(({style}) => { style.zoom = ""; });
    narrow(reveal.querySelector("section section.present"));
  });
  const notebook = document.querySelector(".reveal .jp-Notebook");
  const loose = () => notebook.querySelectorAll(".jp-Cell:not(section .jp-Cell)").forEach(node => addSlide(node, app));
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
