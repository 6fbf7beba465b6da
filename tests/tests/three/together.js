// All kernels in one shader, beside everything that three.js' largest material brings, in both of its stages.

import * as THREE from 'three/webgpu';
import * as tsl from 'three/tsl';
import * as lobe from './lobe.js';

const { float, positionLocal, select, uint, vec3 } = tsl;

// A value of a type, and a float of one.
const value = (type) => {
    if (type.structure) return lobe[type.structure](Object.fromEntries(type.members.map(([name, ty]) => [name, value(ty)])));
    const part = type.column ?? { name: type.scalar };
    if (type.size) return tsl[type.name](...Array.from({ length: type.size }, () => value(part)));
    return { float: () => positionLocal.x, int: () => tsl.int(1), uint: () => uint(1), bool: () => positionLocal.x.greaterThan(0) }[type.name]();
};
const number = (type, node) => {
    if (type.structure) return number(type.members[0][1], node.get(type.members[0][0]));
    if (type.column) return number(type.column, node.element(0));
    if (type.size) return number({ name: type.scalar }, node.x);
    return type.name === 'bool' ? select(node, float(1), float(0)) : float(node);
};

const kernels = await (await fetch('/kernels.json')).json();
const all = kernels.map(({ name, parameters, result }) => {
    const args = Object.fromEntries(parameters.map(([name, type]) => [name, value(type)]));
    return number(result, lobe[name](args));
});
// By halves: a sum of as many terms is nested too deeply for parsers.
const sum = (nodes) => {
    const half = nodes.length >> 1;
    return half === 0 ? nodes[0] : sum(nodes.slice(0, half)).add(sum(nodes.slice(half)));
};
const total = sum(all);

const material = new THREE.MeshPhysicalNodeMaterial({
    anisotropy: 0.5, clearcoat: 0.5, dispersion: 0.1, iridescence: 0.5, sheen: 0.5, transmission: 0.5, thickness: 0.5, transparent: true,
});
material.colorNode = vec3(total);
material.positionNode = positionLocal.add(total);
const scene = new THREE.Scene().add(new THREE.Mesh(new THREE.SphereGeometry(), material));
scene.add(new THREE.AmbientLight(), new THREE.HemisphereLight(), new THREE.SpotLight(), new THREE.PointLight());
const sun = new THREE.DirectionalLight();
sun.castShadow = true;
scene.add(sun);
scene.fog = new THREE.Fog(0xffffff);

const renderer = new THREE.WebGPURenderer();
await renderer.init();
renderer.shadowMap.enabled = true;
const camera = new THREE.PerspectiveCamera();
await renderer.compileAsync(scene, camera);
// The driver has judged the shaders when it has answered something else.
await renderer.backend.device.queue.onSubmittedWorkDone();
const { fragmentShader, vertexShader } = await renderer.debug.getShaderAsync(scene, camera, scene.children[0]);
for (const { name } of kernels) {
    for (const text of [fragmentShader, vertexShader]) {
        if (text.split(`fn lobe_${name} (`).length !== 2) said.push(`error: ${name} is not declared once`);
    }
}
await done();
