// Positions and faces of the binary PLY files that the programs write, and such files from arrays.

const types = {
  char: [1, 'getInt8'], uchar: [1, 'getUint8'], short: [2, 'getInt16'], ushort: [2, 'getUint16'],
  int: [4, 'getInt32'], uint: [4, 'getUint32'], float: [4, 'getFloat32'], double: [8, 'getFloat64'],
};
const endOfHeader = 'end_header\n';
const bytesPerFace = 13; // a count, and three indices

/** Elements with their properties, and where the data begins. */
function headerOf(bytes) {
  let text = '';
  // Longer headers than a mebibyte are no headers.
  for (let end = 4096; !text.includes(endOfHeader) && end <= 1 << 20; end *= 2)
    text = new TextDecoder('latin1').decode(bytes.subarray(0, end));
  const start = text.indexOf(endOfHeader) + endOfHeader.length;
  const elements = [];
  for (const line of text.slice(0, start).split('\n')) {
    const [word, ...rest] = line.split(' ');
    if (word === 'element') elements.push({ name: rest[0], count: Number(rest[1]), properties: [] });
    if (word === 'property') elements.at(-1).properties.push(propertyOf(rest));
  }
  return { elements, start };
}

function propertyOf(words) {
  if (words[0] !== 'list') return { name: words[1], type: types[words[0]] };
  return { name: words[3], countType: types[words[1]], type: types[words[2]] };
}

/** The offset behind a row; `take` gets each property and where its values are. */
function passRow(view, offset, properties, take) {
  for (const property of properties) {
    const [size] = property.type;
    let count = 1;
    if (property.countType) {
      count = view[property.countType[1]](offset, true);
      offset += property.countType[0];
    }
    take?.(property, offset, count);
    offset += size * count;
  }
  return offset;
}

function takeVertices(view, offset, element, positions) {
  for (let v = 0; v < element.count; ++v) {
    offset = passRow(view, offset, element.properties, ({ name, type }, at) => {
      const axis = 'xyz'.indexOf(name);
      if (name.length === 1 && axis >= 0) positions[3 * v + axis] = view[type[1]](at, true);
    });
  }
  return offset;
}

function takeFaces(view, offset, element, faces) {
  for (let f = 0; f < element.count; ++f) {
    offset = passRow(view, offset, element.properties, ({ name, countType, type }, at) => {
      if (!countType || !name.startsWith('vertex_ind')) return;
      for (let i = 0; i < 3; ++i) faces[3 * f + i] = view[type[1]](at + type[0] * i, true);
    });
  }
  return offset;
}

/** Reads binary little-endian PLY with triangles, as all programs write it. */
export function arraysOf(bytes) {
  const { elements, start } = headerOf(bytes);
  const count = (name) => elements.find((element) => element.name === name)?.count ?? 0;
  const positions = new Float64Array(3 * count('vertex'));
  const faces = new Uint32Array(3 * count('face'));
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let offset = start;
  for (const element of elements) {
    if (element.name === 'vertex') offset = takeVertices(view, offset, element, positions);
    else if (element.name === 'face') offset = takeFaces(view, offset, element, faces);
    else for (let i = 0; i < element.count; ++i) offset = passRow(view, offset, element.properties);
  }
  return { positions, faces };
}

/** Writes binary little-endian PLY with positions in double precision. */
export function plyOf(positions, faces) {
  const header = new TextEncoder().encode(
    `ply\nformat binary_little_endian 1.0\nelement vertex ${positions.length / 3}\n` +
    'property double x\nproperty double y\nproperty double z\n' +
    `element face ${faces.length / 3}\nproperty list uchar uint vertex_indices\n${endOfHeader}`);
  const bytes = new Uint8Array(header.length + 8 * positions.length + bytesPerFace * (faces.length / 3));
  bytes.set(header);
  const view = new DataView(bytes.buffer);
  let offset = header.length;
  for (const x of positions) {
    view.setFloat64(offset, x, true);
    offset += 8;
  }
  for (let i = 0; i < faces.length; i += 3) {
    view.setUint8(offset, 3);
    for (let k = 0; k < 3; ++k) view.setUint32(offset + 1 + 4 * k, faces[i + k], true);
    offset += bytesPerFace;
  }
  return bytes;
}
