// Meshes by the names of their blocks: unpacked when they are wanted, and kept while there is room.

import {bytesOfBase64, inflate, unpack} from './unpack.js';

const room = 160e6;  // bytes of arrays, those on the graphics card not counted

const inPage = (name) => Promise.resolve(bytesOfBase64(document.getElementById(name).textContent));

// Of a page that is served, beside it.
async function fromServer(name) {
  const answer = await fetch(`block/${name}`);
  if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
  return new Uint8Array(await answer.arrayBuffer());
}

const sizeOf = (mesh) => 60 * mesh.vertices + 24 * mesh.faces;

export class Store {
  constructor(isLive, onDrop) {
    this.read = isLive ? fromServer : inPage;
    this.onDrop = onDrop;
    this.kept = new Map();  // the least recently used first
    this.size = 0;
  }

  // A picture as the source of an image.
  async picture(name) {
    const bytes = await this.read(name);
    let letters = '';
    for (let i = 0; i < bytes.length; i += 30000) letters += String.fromCharCode(...bytes.subarray(i, i + 30000));
    return `data:image/png;base64,${btoa(letters)}`;
  }

  // A promise of the mesh; the same one while it is kept.
  get(name, extent) {
    const known = this.kept.get(name);
    if (known) {
      this.kept.delete(name);
      this.kept.set(name, known);
      return known;
    }
    const promise = this.read(name).then(inflate).then((bytes) => unpack(bytes, extent));
    this.kept.set(name, promise);
    promise.then((mesh) => this.#add(mesh), () => this.kept.delete(name));
    return promise;
  }

  #add(mesh) {
    this.size += sizeOf(mesh);
    for (const [name, promise] of this.kept) {
      if (this.size <= room || this.kept.size <= 8) break;
      this.kept.delete(name);
      promise.then((old) => {
        this.size -= sizeOf(old);
        this.onDrop(old);
      }, () => {});
    }
  }
}
