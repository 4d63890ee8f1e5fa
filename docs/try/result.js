// Shows a result: how it was made, the command line that makes the same file, and the download.

import {copyButton} from '../../tools/viewer/tables.js';
import {byId, make} from './elements.js';
import {formatOf} from './tasks.js';

// The chain ends at the first command that fails.
export const textOfCommands = (commands) => commands.join(' &&\n');

function showCommands(commands) {
  const text = textOfCommands(commands);
  const code = make('pre', {tabindex: '0', role: 'region', 'aria-label': 'Command line'}, make('code', {}, text));
  byId('commands').replaceChildren(code, copyButton(text));
}

function showNotes(messages) {
  byId('notes').hidden = messages.length === 0;
  byId('notes').firstElementChild.textContent =
    messages.length === 1 ? 'What the program says: one line' : `What the program says: ${messages.length} lines`;
  byId('notes').lastElementChild.replaceChildren(...messages.map((line) => make('li', {}, line)));
}

export class Result {
  show(entry) {
    byId('result').hidden = !entry.made;
    // An open list stays open if the same result is shown again.
    if (!entry.made || entry.bytes === this.bytes) return;
    this.bytes = entry.bytes;
    URL.revokeObjectURL(this.address);
    this.address = URL.createObjectURL(new Blob([entry.bytes], {type: 'application/octet-stream'}));
    const {seconds, commands, messages} = entry.made;
    byId('summary').textContent = `${entry.name}, made in ${seconds.toFixed(seconds < 10 ? 1 : 0)}\u00a0s.`;
    byId('download').href = this.address;
    byId('download').download = entry.name;
    byId('format').value = formatOf(entry.name);
    showCommands(commands);
    // Lines of progress are many, and are useless after the run.
    showNotes(messages.filter((line) => !/^(iteration \d+:|\s*\d+ ?%)/.test(line)));
  }
}
