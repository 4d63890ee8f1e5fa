// The form of tasks: the inputs of each one, and a sentence if one of them is missing.

import {byId, make} from './elements.js';
import {isLength, takesTwo} from './tasks.js';

const texts = {
  repair: ['Repair', 'Closes holes, turns flipped parts and removes self-intersections, by the least change.'],
  combine: ['Combine', 'Unites two solids, or cuts one by the other. Decisions are exact.'],
  offset: ['Offset', 'Moves the surface outwards, or inwards if the distance is negative.'],
  decimate: ['Decimate', 'Merges faces while the surface stays this close to the original.'],
  morph: ['Morph', 'Moves the surface in steps until it lies on the second file, and keeps the steps as a film.'],
};

export class Form {
  constructor(onSubmit) {
    this.form = byId('task');
    this.form.addEventListener('change', () => this.#arrange());
    this.form.addEventListener('submit', (event) => {
      event.preventDefault();
      const problem = this.problem();
      onSubmit(problem ? {problem} : this.#values());
    });
    this.#arrange();
  }

  get kind() {
    return this.form.elements.kind.value;
  }

  #values() {
    const {operation, other, distance, error, every, keepOpen} = this.form.elements;
    return {
      kind: this.kind, other: takesTwo(this.kind) ? other.value : undefined,
      options: {
        operation: operation.value, distance: distance.value, error: error.value, every: every.value,
        keepOpen: keepOpen.checked,
      },
    };
  }

  // Returns a sentence, or undefined if all inputs are valid.
  problem() {
    const {distance, error} = this.form.elements;
    const field = {offset: distance, decimate: error}[this.kind];
    if (field && !isLength(field.value)) {
      field.focus();
      return `'${field.value}' is not a length: write a number, such as 0.5, or a share of the diagonal, such as 1%.`;
    }
    return undefined;
  }

  #arrange() {
    const [verb, about] = texts[this.kind];
    byId('go').textContent = verb;
    byId('about').textContent = this.isOneMissing() ? `${about} Add a second file first.` : about;
    for (const element of this.form.querySelectorAll('[data-for]'))
      element.hidden = !element.dataset.for.split(' ').includes(this.kind);
    byId('other-label').textContent = this.kind === 'morph' ? 'Into' : 'Second file';
    byId('go').disabled = this.isBusy || this.isOneMissing();
  }

  isOneMissing() {
    return takesTwo(this.kind) && byId('other').options.length === 0;
  }

  setBusy(isBusy) {
    this.isBusy = isBusy;
    byId('cancel').hidden = !isBusy;
    this.#arrange();
  }

  // Sets the files with which the selected one can be combined.
  setOthers(entries) {
    const select = byId('other');
    const chosen = select.value;
    select.replaceChildren(...entries.map(({id, name}) => make('option', {value: id}, name)));
    if (entries.some(({id}) => String(id) === chosen)) select.value = chosen;
    this.#arrange();
  }
}
