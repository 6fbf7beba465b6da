// Applies each kernel to rows of arguments, as a compute shader that three.js builds, and sends its results.

import * as THREE from 'three/webgpu';
import { Fn, bitcast, instanceIndex, instancedArray, select, uint } from 'three/tsl';
import * as tsl from 'three/tsl';
import * as lobe from './lobe.js';

const renderer = new THREE.WebGPURenderer();
await renderer.init();
if (!renderer.backend.isWebGPUBackend) throw new Error('no WebGPU');

// A value of a type out of words, and the words of a value; `next` gives a place.
const read = (type, next) => {
    if (type.structure) {
        return lobe[type.structure](Object.fromEntries(type.members.map(([name, ty]) => [name, read(ty, next)])));
    }
    const part = type.column ?? { name: type.scalar };
    if (type.size) return tsl[type.name](...Array.from({ length: type.size }, () => read(part, next)));
    const word = next();
    return { float: () => bitcast(word, 'float'), int: () => bitcast(word, 'int'), uint: () => word, bool: () => word.notEqual(uint(0)) }[type.name]();
};
const write = (type, value, put) => {
    if (type.structure) return type.members.forEach(([name, ty]) => write(ty, value.get(name), put));
    if (type.column) return Array.from({ length: type.size }, (_, i) => write(type.column, value.element(i), put));
    if (type.size) return [...'xyzw'].slice(0, type.size).forEach((axis) => write({ name: type.scalar }, value[axis], put));
    put({ float: () => bitcast(value, 'uint'), int: () => bitcast(value, 'uint'), uint: () => value, bool: () => select(value, uint(1), uint(0)) }[type.name]());
};

async function run({ name, rows, parameters, result, width, words }) {
    const given = instancedArray(new Uint32Array(words), 'uint');
    const results = instancedArray(rows * width, 'uint');
    const node = Fn(() => {
        let at = 0;
        const first = instanceIndex.mul(uint(words.length / rows));
        const next = () => given.element(first.add(uint(at++))).toVar();
        const args = Object.fromEntries(parameters.map(([name, type]) => [name, read(type, next)]));
        const value = lobe[name](args).toVar();
        let to = 0;
        const start = instanceIndex.mul(uint(width));
        write(result, value, (word) => results.element(start.add(uint(to++))).assign(word));
    })().compute(rows);
    await renderer.computeAsync(node);
    return [...new Uint32Array(await renderer.getArrayBufferAsync(results.value))];
}

const all = {};
for (const kernel of await (await fetch('/kernels.json')).json()) {
    const before = said.length;
    try {
        all[kernel.name] = await run(kernel);
    } catch (error) {
        said.push(`error: ${error.stack}`);
    }
    for (let i = before; i < said.length; i++) said[i] = `${kernel.name}: ${said[i]}`;
}
await send('results', JSON.stringify(all));
await done();
