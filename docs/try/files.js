// The list of files: which one is shown and worked on.

import {byId, button, make} from './elements.js';

export const mostBytes = 100e6;

const sizeText = (bytes) => (bytes < 1e5 ? `${Math.ceil(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(1)} MB`);

export const detailOf = ({bytes, mesh, problem}) => {
  if (problem) return 'cannot be read';
  const faces = mesh ? `${new Intl.NumberFormat('en').format(mesh.faces.length / 3)} faces` : 'reading';
  return bytes ? `${faces} · ${sizeText(bytes.length)}` : faces;
};

// Rows of `entries`; `on` has the functions select and remove.
export function showFiles(entries, selected, on) {
  const rows = entries.map((entry) => {
    const radio = make('input', {type: 'radio', name: 'shown', value: entry.id});
    radio.checked = entry === selected;
    radio.addEventListener('change', () => on.select(entry));
    const label = make('label', {}, radio, make('span', {class: 'name', title: entry.name}, entry.name),
      make('span', {class: 'detail'}, detailOf(entry)));
    const remove = button('×', {class: 'remove', 'aria-label': `Remove ${entry.name}`}, () => on.remove(entry));
    return make('div', {class: 'file'}, label, remove);
  });
  const hadFocus = document.activeElement?.name === 'shown';
  byId('files').replaceChildren(...rows);
  if (hadFocus) byId('files').querySelector('input:checked')?.focus();
}

// Calls `onFiles` with files that are chosen or dropped anywhere on the page.
export function listenForFiles(onFiles) {
  const input = byId('file');
  for (const element of document.querySelectorAll('.choose')) element.addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    onFiles([...input.files]);
    input.value = '';
  });
  const setDragging = (isDragging) => document.body.classList.toggle('dragging', isDragging);
  addEventListener('dragover', (event) => {
    event.preventDefault();
    setDragging(true);
  });
  addEventListener('dragleave', (event) => event.relatedTarget ?? setDragging(false));
  addEventListener('drop', (event) => {
    event.preventDefault();
    setDragging(false);
    onFiles([...event.dataTransfer.files]);
  });
}
