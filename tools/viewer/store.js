// Cache of meshes by the names of their blocks. Meshes are unpacked on request.

import {bytesOfBase64, inflate, unpack} from './unpack.js';

const room = 160e6;  // most bytes of arrays, without copies on the graphics card

const inPage = (name) => Promise.resolve(bytesOfBase64(document.getElementById(name).textContent));

// Reads a block from the server of the page.
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
    this.kept = new Map();  // least recently used first
    this.size = 0;
  }

  // Returns a picture as the source of an image element.
  async picture(name) {
    const bytes = await this.read(name);
    let letters = '';
    for (let i = 0; i < bytes.length; i += 30000) letters += String.fromCharCode(...bytes.subarray(i, i + 30000));
    return `data:image/png;base64,${btoa(letters)}`;
  }

  // Returns a promise of the mesh. Returns the same promise while the mesh is in the cache.
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
