// Unpacks a block (lib/page/pack.h) to arrays that can be drawn.

export function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

export async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Reads streams of numbers. A stream has the lowest bytes of all numbers, then the second lowest
// bytes, and so on.
class Streams {
  constructor(bytes, at) {
    this.bytes = bytes;
    this.at = at;
  }

  numbers(count, width) {
    const numbers = new Uint32Array(count);
    for (let byte = 0; byte < width; ++byte, this.at += count) {
      const plane = this.bytes.subarray(this.at, this.at + count);
      for (let i = 0; i < count; ++i) numbers[i] |= plane[i] << (8 * byte);
    }
    return numbers;
  }

  sums(count, width) {
    const numbers = this.numbers(count, width);
    const mask = width === 1 ? 0xff : 0xffff;
    for (let i = 1; i < count; ++i) numbers[i] = (numbers[i] + numbers[i - 1]) & mask;
    return numbers;
  }
}

function indicesOf(streams, header) {
  const codes = streams.numbers(3 * header.faces, header.vertices <= 65535 ? 2 : 4);
  let next = 0;
  for (let i = 0; i < codes.length; ++i) {
    const code = codes[i];
    codes[i] = next - code;
    if (code === 0) ++next;
  }
  return codes;
}

// Returns positions scaled to a unit ball around 0, so that floats are precise for any position and
// size of a mesh.
function positionsOf(streams, header, {middle, radius}) {
  const count = header.vertices;
  const positions = new Float32Array(3 * count);
  for (let axis = 0; axis < 3; ++axis) {
    const codes = streams.sums(count, 2);
    const low = (header.low[axis] - middle[axis]) / radius;
    const step = ((header.high[axis] - middle[axis]) / radius - low) / 65535;
    for (let i = 0; i < count; ++i) positions[3 * i + axis] = low + step * codes[i];
  }
  return positions;
}

function columnOf(streams, column, header) {
  const rows = column.of === 'face' ? header.faces : header.vertices;
  if (column.of === 'color')
    return {...column, channels: [0, 1, 2].map(() => streams.sums(rows, 1))};
  const codes = streams.sums(rows, 2);
  const step = (column.high - column.low) / 65534;
  const values = new Float32Array(rows);
  for (let i = 0; i < rows; ++i)
    values[i] = codes[i] === 65535 ? NaN : column.low + step * codes[i];
  return {...column, values};
}

export function unpack(bytes, extent) {
  const size = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + size)));
  const streams = new Streams(bytes, 4 + size);
  const indices = indicesOf(streams, header);
  const positions = positionsOf(streams, header, extent);
  const columns = header.columns.map((column) => columnOf(streams, column, header));
  return {vertices: header.vertices, faces: header.faces, indices, positions, columns};
}
