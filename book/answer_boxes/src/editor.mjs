/* The editor of a box: CodeMirror in Python mode. Bundled alone, since it is loaded when a box is first used. */

import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { pythonLanguage } from "@codemirror/lang-python";
import { bracketMatching, indentOnInput, indentUnit, syntaxHighlighting } from "@codemirror/language";
import { EditorState, StateEffect, StateField } from "@codemirror/state";
import { Decoration, EditorView, keymap } from "@codemirror/view";
import { tagHighlighter, tags } from "@lezer/highlight";

/* The classes of the page's own code, so that both have the same colours. */
const colours = tagHighlighter([
  { tag: tags.keyword, class: "k" },
  { tag: tags.operatorKeyword, class: "ow" },
  { tag: tags.moduleKeyword, class: "kn" },
  { tag: [tags.bool, tags.null], class: "kc" },
  { tag: [tags.variableName, tags.propertyName], class: "n" },
  { tag: tags.definition(tags.function(tags.variableName)), class: "nf" },
  { tag: tags.operator, class: "o" },
  { tag: tags.number, class: "mi" },
  { tag: tags.string, class: "s2" },
  { tag: tags.comment, class: "c1" },
  { tag: tags.punctuation, class: "p" },
]);

const markLine = StateEffect.define();

/* The line of an error stays marked until the text changes. */
const markedLine = StateField.define({
  create: () => Decoration.none,
  update(marked, transaction) {
    for (const effect of transaction.effects) if (effect.is(markLine)) marked = lineMark(transaction.state.doc, effect.value);
    return transaction.docChanged ? Decoration.none : marked;
  },
  provide: (field) => EditorView.decorations.from(field),
});

function lineMark(doc, number) {
  if (!number || number > doc.lines) return Decoration.none;
  return Decoration.set(Decoration.line({ class: "answer-error-line" }).range(doc.line(number).from));
}

/**
 * Put an editor in place of a textarea, with its text, focus and cursor.
 *
 * Tab indents; after Escape it leaves the editor. Returns {get(), set(text), focus(), mark(line or null)}.
 */
window.workbookEditor = (textarea, { label, describedBy, onChange, onRun }) => {
  const run = () => {
    onRun();
    return true;
  };
  const view = new EditorView({
    doc: textarea.value,
    selection: { anchor: textarea.selectionStart, head: textarea.selectionEnd },
    extensions: [
      history(),
      pythonLanguage,
      syntaxHighlighting(colours),
      indentUnit.of("    "),
      EditorState.tabSize.of(4),
      indentOnInput(),
      bracketMatching(),
      markedLine,
      EditorView.lineWrapping,
      EditorView.contentAttributes.of({ "aria-label": label, "aria-describedby": describedBy, autocapitalize: "off", autocorrect: "off", spellcheck: "false" }),
      EditorView.updateListener.of((update) => update.docChanged && onChange(update.state.doc.toString())),
      keymap.of([{ key: "Shift-Enter", run }, { key: "Mod-Enter", run }, indentWithTab, ...defaultKeymap, ...historyKeymap]),
    ],
  });
  const focused = document.activeElement === textarea;
  textarea.replaceWith(view.dom);
  if (focused) view.focus();
  return {
    get: () => view.state.doc.toString(),
    set: (text) => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } }),
    focus: () => view.focus(),
    mark: (line) => view.dispatch({ effects: markLine.of(line) }),
  };
};
