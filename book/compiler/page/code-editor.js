// An editor of C++: CodeMirror, in the book's colours, with the compiler's message under the line that it is about.
import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { cpp } from '@codemirror/lang-cpp';
import { HighlightStyle, bracketMatching, indentOnInput, indentUnit, syntaxHighlighting } from '@codemirror/language';
import { EditorState, StateEffect, StateField } from '@codemirror/state';
import { Decoration, EditorView, WidgetType, drawSelection, keymap, lineNumbers } from '@codemirror/view';
import { tags } from '@lezer/highlight';

const colours = HighlightStyle.define([
  { tag: [tags.keyword, tags.controlKeyword, tags.modifier, tags.definitionKeyword], class: 'hljs-keyword' },
  { tag: [tags.typeName, tags.standard(tags.typeName)], class: 'hljs-type' },
  { tag: [tags.number, tags.bool], class: 'hljs-number' },
  { tag: [tags.string, tags.character], class: 'hljs-string' },
  { tag: tags.comment, class: 'hljs-comment' },
  { tag: tags.processingInstruction, class: 'hljs-meta' },
]);

class Message extends WidgetType {
  constructor(message, more) {
    super();
    Object.assign(this, { message, more });
  }
  eq(other) {
    return other.message.text === this.message.text && other.more.length === this.more.length;
  }
  toDOM() {
    const box = document.createElement('div');
    box.className = `said ${this.message.kind}`;
    box.textContent = this.message.text;
    if (this.more.length) {
      const fold = document.createElement('details');
      fold.innerHTML = '<summary></summary><ul></ul>';
      fold.firstChild.textContent = `${this.more.length} more`;
      for (const { line, text } of this.more) {
        const item = document.createElement('li');
        item.textContent = `Line ${line}: ${text}`;
        fold.lastChild.append(item);
      }
      box.append(fold);
    }
    return box;
  }
}

const say = StateEffect.define();
const said = StateField.define({
  create: () => Decoration.none,
  update(shown, change) {
    const effect = change.effects.find(one => one.is(say));
    if (!effect) return shown.map(change.changes);
    const [first, ...more] = effect.value;
    if (!first) return Decoration.none;
    const { doc } = change.state;
    const line = doc.line(Math.min(Math.max(first.line, 1), doc.lines));
    const from = Math.min(line.from + first.column - 1, line.to);
    const word = /^\w+/.exec(doc.sliceString(from, line.to))?.[0].length ?? 1;
    const marks = [Decoration.widget({ widget: new Message(first, more), side: 1, block: true }).range(line.to)];
    if (from < line.to) marks.unshift(Decoration.mark({ class: 'wrong' }).range(from, Math.min(from + word, line.to)));
    return Decoration.set(marks, true);
  },
  provide: field => EditorView.decorations.from(field),
});

/** An editor in `parent`, { text, write, say, focus }: `changed` is called with each new text, and `refused` with the length of
 *  one that has more letters than `most`. */
export function openEditor(parent, { text, label, changed, most = Infinity, refused = () => {} }) {
  const view = new EditorView({
    parent,
    state: EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        history(),
        drawSelection(),
        indentOnInput(),
        indentUnit.of('  '),
        bracketMatching(),
        cpp(),
        syntaxHighlighting(colours),
        keymap.of([...defaultKeymap, ...historyKeymap, indentWithTab]),
        said,
        EditorState.changeFilter.of(
          change => change.newDoc.length <= most || void refused(change.newDoc.length) || false,
        ),
        EditorView.contentAttributes.of({ 'aria-label': label, 'tabindex': '0', 'spellcheck': 'false' }),
        EditorView.updateListener.of(update => update.docChanged && changed(view.state.doc.toString())),
      ],
    }),
  });
  return {
    get text() {
      return view.state.doc.toString();
    },
    write: now => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: now } }),
    /** Messages of messagesOf(): the first stands under its line, the others are folded. */
    say: messages => view.dispatch({ effects: say.of(messages) }),
    focus: () => view.focus(),
    close: () => view.destroy(),
  };
}
