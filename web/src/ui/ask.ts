import { el } from './dom';

/** A small dialog that asks for one line of text. */
export class Ask {
  private readonly input = el('input', { id: 'answer', type: 'text', autocomplete: 'off' });
  private readonly question = el('label', { for: 'answer' });
  private done: (text: string) => void = () => {};

  constructor(private readonly dialog: HTMLDialogElement) {
    const form = el('form', { method: 'dialog' }, this.question, this.input, el('button', { class: 'main' }, 'OK'));
    form.onsubmit = () => this.done(this.input.value.trim());
    this.input.setAttribute('data-testid', 'answer');
    dialog.append(form);
  }

  /** Calls `done` with the answer unless the dialog is dismissed. `rule`: the hint for input that violates `pattern`. */
  open(question: string, { value = '', pattern = '', rule = '', most = 1000 }: { value?: string; pattern?: string; rule?: string; most?: number }, done: (text: string) => void): void {
    this.question.textContent = question;
    this.input.value = value;
    this.input.maxLength = most;
    if (pattern) this.input.pattern = pattern;
    else this.input.removeAttribute('pattern');
    this.input.title = rule;
    this.input.required = pattern !== '';
    this.done = done;
    this.dialog.showModal();
    this.input.select();
  }
}
