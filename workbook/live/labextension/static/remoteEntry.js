/* What the page of slides (jupyterlab-rise) lacks, as an extension that JupyterLab loads without being built.

   It has no consoles and does not share @jupyterlab/console, without which the widgets' extension does not load, though
   it only asks whether there is a console. Where nobody shares the module, this shares one that says no.

   Its Shift+Enter runs a cell and goes on to the next one, which is the next slide, before anybody has seen the result.
   Here it runs the cell. */
{
let shared;
const slides = location.pathname.includes("/rise/");

async function run(app) {
  const versions = Object.values(shared["@jupyterlab/notebook"]);
  const {NotebookActions} = (await versions[0].get())();
  const {content, context} = app.shell.currentWidget;
  return NotebookActions.run(content, context.sessionContext);
}

function activate(app) {
  if (!slides) return;
  // a box to add a cell, which would lie behind the slide
  const style = Object.assign(document.createElement("style"), {textContent: ".jp-Notebook-footer {display: none}"});
  document.head.append(style);
  app.commands.addCommand("workbook:run", {execute: () => run(app), label: "Run the cell and stay"});
  for (const mode of ["edit", "command"]) {
    app.commands.addKeyBinding({command: "workbook:run", keys: ["Shift Enter"], args: {},
                                selector: `.lm-Widget.reveal .jp-Notebook.jp-mod-${mode}Mode`});
  }
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
