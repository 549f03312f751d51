// Encodes a mesh with the meshoptimizer of the npm registry and decodes it again.
// usage: node meshopt_npm.mjs PACKAGE IN OUT
// IN:  corners, vertices, bytes a vertex; indices; vertices.
// OUT: used vertices, bytes of indices and of vertices; the vertices' new numbers (2^32 - 1: not
// used); both byte
//      strings; decoded indices; decoded vertices. Numbers are little-endian u32.
import fs from 'node:fs';
import path from 'node:path';
import {pathToFileURL} from 'node:url';

const [folder, from, to] = process.argv.slice(2);
const part = async file => import(pathToFileURL(path.join(folder, file)));
const {MeshoptEncoder: encoder} = await part('meshopt_encoder.js');
const {MeshoptDecoder: decoder} = await part('meshopt_decoder.mjs');
await Promise.all([encoder.ready, decoder.ready]);

const input = new Uint8Array(fs.readFileSync(from)).buffer;
const [corners, count, stride] = new Uint32Array(input, 0, 3);
const indices = new Uint32Array(input, 12, corners);
const vertices = new Uint8Array(input, 12 + 4 * corners, count * stride);

const [found, used] = encoder.reorderMesh(indices, true, true);
const remap = new Uint32Array(count).fill(0xffffffff);
remap.set(found);
const ordered = new Uint8Array(used * stride);
remap.forEach((at, v) => {
  if (at !== 0xffffffff) ordered.set(vertices.subarray(v * stride, (v + 1) * stride), at * stride);
});
const coded = [
  encoder.encodeIndexBuffer(new Uint8Array(indices.buffer, 12, 4 * corners), corners, 4),
  encoder.encodeVertexBufferLevel(ordered, used, stride, 3, 1)
];
const decoded = [new Uint8Array(4 * corners), new Uint8Array(used * stride)];
decoder.decodeIndexBuffer(decoded[0], corners, 4, coded[0]);
decoder.decodeVertexBuffer(decoded[1], used, stride, coded[1]);

const bytes = array => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
const head = new Uint32Array([used, coded[0].length, coded[1].length]);
fs.writeFileSync(to, Buffer.concat([head, remap, ...coded, ...decoded].map(bytes)));
