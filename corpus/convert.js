// Turns what some packages hold into PLY: node convert.js FILE > MESH.ply
//   .js   a module that exports positions and cells (npm's bunny)
//   .vtp  VTK XML PolyData of triangle strips, inline binary, zlib (Debian's invesalius-examples)
'use strict';
const fs = require('fs');
const path = require('path');
const zlib = require('zlib');

// Inline binary data: base64 of [blocks, block size, last size, compressed sizes..] (u32), then
// base64 of the blocks.
function vtkArray(xml, section, name) {
  const at = xml.indexOf(`Name="${name}"`, xml.indexOf(`<${section}>`));
  const type = xml.slice(xml.lastIndexOf('<DataArray', at), at).match(/type="(\w+)"/)[1];
  const text = xml.slice(xml.indexOf('>', at) + 1, xml.indexOf('<', xml.indexOf('>', at))).trim();
  const count = Buffer.from(text.slice(0, 8), 'base64').readUInt32LE(0);
  const headerLength = Math.ceil((12 + 4 * count) / 3) * 4;
  const header = Buffer.from(text.slice(0, headerLength), 'base64');
  const data = Buffer.from(text.slice(headerLength), 'base64');
  const blocks = [];
  for (let i = 0, from = 0; i < count; ++i) {
    const size = header.readUInt32LE(12 + 4 * i);
    blocks.push(zlib.inflateSync(data.subarray(from, from + size)));
    from += size;
  }
  const bytes = new Uint8Array(Buffer.concat(blocks));
  const kinds = {Float32: Float32Array, Int32: Int32Array, Int64: BigInt64Array};
  return Array.from(new kinds[type](bytes.buffer), Number);
}

function readVtp(file) {
  const xml = fs.readFileSync(file, 'latin1');
  const strips = vtkArray(xml, 'Strips', 'connectivity');
  const corners = [];
  let begin = 0;
  for (const end of vtkArray(xml, 'Strips', 'offsets')) {
    for (let i = begin; i + 2 < end; ++i) {
      const odd = (i - begin) % 2;  // every other triangle of a strip runs backwards
      corners.push(strips[i], strips[i + 1 + odd], strips[i + 2 - odd]);
    }
    begin = end;
  }
  return {positions: vtkArray(xml, 'Points', 'Points'), corners};
}

function readModule(file) {
  const mesh = require(path.resolve(file));
  return {positions: mesh.positions.flat(), corners: mesh.cells.flat()};
}

function ply({positions, corners}) {
  const header = Buffer.from(
      `ply\nformat binary_little_endian 1.0\nelement vertex ${positions.length / 3}\n` +
      'property float x\nproperty float y\nproperty float z\n' +
      `element face ${corners.length / 3}\nproperty list uchar int vertex_indices\nend_header\n`);
  const vertices = Buffer.alloc(4 * positions.length);
  positions.forEach((value, i) => vertices.writeFloatLE(value, 4 * i));
  const faces = Buffer.alloc(13 * (corners.length / 3), 3);
  corners.forEach(
      (value, i) => faces.writeInt32LE(value, 13 * Math.floor(i / 3) + 1 + 4 * (i % 3)));
  return Buffer.concat([header, vertices, faces]);
}

const file = process.argv[2];
process.stdout.write(ply(file.endsWith('.vtp') ? readVtp(file) : readModule(file)));
