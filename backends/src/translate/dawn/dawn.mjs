// Hands WGSL to Dawn: the far end of `process.rs`.
//
//   node --input-type=module --eval THIS PACKAGE PARENT OPTION..
//
// PACKAGE is the main file of the npm package `webgpu`, PARENT the process that is served, each OPTION one of Dawn's.
//
// Requests come by standard input, answers go by standard output, each as a frame: two numbers of 32 bits,
// little-endian, which are the lengths of the two parts that follow, a header in JSON and bytes. The first answer says
// what was opened, to no request. Reads and writes block: there is nothing else to do meanwhile.

import { readSync, writeSync } from 'node:fs';

/**
 * @typedef {'uniform' | 'read' | 'read_write'} Kind
 * @typedef {{ group: number, binding: number, kind: Kind, bytes: number }} Binding
 * @typedef {{ wgsl: string, entry: string, groups: [number, number, number], bindings: Binding[] }} Job
 * @typedef {'wgsl' | 'rejected' | 'memory' | 'lost' | 'open'} Fault
 */

const [PACKAGE, PARENT, ...OPTIONS] = process.argv.slice(1);

/** None of these changes what a shader without them computes. */
const FEATURES = ['shader-f16', 'subgroups', 'float32-filterable', 'primitive-index', 'clip-distances'];
const LIMITS = [
  'maxBufferSize', 'maxStorageBufferBindingSize', 'maxUniformBufferBindingSize', 'maxStorageBuffersPerShaderStage',
  'maxComputeInvocationsPerWorkgroup', 'maxComputeWorkgroupSizeX', 'maxComputeWorkgroupSizeY',
  'maxComputeWorkgroupSizeZ', 'maxComputeWorkgroupStorageSize', 'maxComputeWorkgroupsPerDimension', 'maxBindGroups',
  'maxBindingsPerBindGroup',
];
/** Past this many pipelines all are dropped. */
const PIPELINES = 64;

/** What is wrong, and whose fault it is. */
class Refusal extends Error {
  /** @param {Fault} fault @param {string} message */
  constructor(fault, message) {
    super(message);
    this.fault = fault;
  }
}

// ---- Frames

/** @param {Uint8Array} target @returns {boolean} whether it was filled; not if the input has ended */
function fill(target) {
  for (let at = 0; at < target.length;) {
    const count = readSync(0, target, at, target.length - at, null);
    if (count === 0) return false;
    at += count;
  }
  return true;
}

let payload = Buffer.alloc(0);

/** @returns {{ header: any, bytes: Buffer } | undefined} the bytes are good until the next call */
function receive() {
  const lengths = Buffer.alloc(8);
  if (!fill(lengths)) return undefined;
  const header = Buffer.alloc(lengths.readUInt32LE(0));
  const length = lengths.readUInt32LE(4);
  if (payload.length < length) payload = Buffer.alloc(length);
  const bytes = payload.subarray(0, length);
  return fill(header) && fill(bytes) ? { header: JSON.parse(header.toString()), bytes } : undefined;
}

/** @param {object} header @param {Uint8Array[]} parts */
function send(header, parts = []) {
  const text = Buffer.from(JSON.stringify(header));
  const lengths = Buffer.alloc(8);
  lengths.writeUInt32LE(text.length, 0);
  lengths.writeUInt32LE(parts.reduce((sum, part) => sum + part.length, 0), 4);
  for (const part of [lengths, text, ...parts]) {
    for (let at = 0; at < part.length;) at += writeSync(1, part, at);
  }
}

// ---- The device

/** @type {GPUDevice} */
let device;
/** Why the device was lost, once it is. @type {string | undefined} */
let loss;
/** Ends the job that is at work when that happens. */
let endJob = () => {};

async function open() {
  const { create, globals } = await import(PACKAGE);
  Object.assign(globalThis, globals);
  const gpu = create(OPTIONS);
  const adapter = await gpu.requestAdapter();
  if (!adapter) throw new Error(`Dawn finds no device (${OPTIONS.join(', ')})`);
  const limits = Object.fromEntries(LIMITS.map((name) => [name, adapter.limits[name]]));
  const features = FEATURES.filter((name) => adapter.features.has(name));
  device = await adapter.requestDevice({ requiredFeatures: features, requiredLimits: limits });
  device.lost.then((info) => {
    loss = info.message || info.reason;
    endJob();
  });
  send({ device: adapter.info.device, features, limits });
  // Whatever is not waited for keeps the instance alive no longer than the process.
  globalThis.gpu = gpu;
}

/** Does `body`, and throws what Dawn reports of it. @template T @param {() => T | Promise<T>} body */
async function scoped(body) {
  for (const filter of ['internal', 'out-of-memory', 'validation']) device.pushErrorScope(filter);
  const outcome = await Promise.resolve().then(body).then((value) => ({ value }), (error) => ({ error }));
  const errors = await Promise.all([0, 1, 2].map(() => device.popErrorScope()));
  const error = errors.find(Boolean);
  if (error) throw new Refusal(error instanceof GPUOutOfMemoryError ? 'memory' : 'rejected', error.message);
  if ('error' in outcome) throw outcome.error;
  return outcome.value;
}

// ---- WGSL

/** @param {string} wgsl @returns {Promise<GPUShaderModule>} */
async function compile(wgsl) {
  device.pushErrorScope('validation');
  const module = device.createShaderModule({ code: wgsl });
  const [info, error] = await Promise.all([module.getCompilationInfo(), device.popErrorScope()]);
  const errors = info.messages.filter((message) => message.type === 'error');
  const lines = errors.map((m) => `${m.lineNum}:${m.linePos}: error: ${m.message}`);
  if (lines.length > 0 || error) throw new Refusal('wgsl', lines.join('\n') || error.message);
  return module;
}

/** @type {Map<string, { pipeline: GPUComputePipeline, layouts: (GPUBindGroupLayout | null)[] }>} */
const pipelines = new Map();

/** @param {Job} job */
async function pipelineOf(job) {
  const key = JSON.stringify([job.wgsl, job.entry, job.bindings.map((b) => [b.group, b.binding, b.kind])]);
  const known = pipelines.get(key);
  if (known) return known;
  const module = await compile(job.wgsl);
  const layouts = layoutsOf(job);
  const layout = device.createPipelineLayout({ bindGroupLayouts: layouts });
  const compute = { module, entryPoint: job.entry };
  let pipeline;
  try {
    pipeline = await device.createComputePipelineAsync({ layout, compute });
  } catch (error) {
    throw new Refusal(error?.reason === 'validation' ? 'wgsl' : 'rejected', String(error?.message ?? error));
  }
  if (pipelines.size >= PIPELINES) pipelines.clear();
  const made = { pipeline, layouts };
  pipelines.set(key, made);
  return made;
}

const TYPES = { uniform: 'uniform', read: 'read-only-storage', read_write: 'storage' };

/** @param {Job} job @returns {GPUBindGroupLayout[]} a group that is skipped is empty */
function layoutsOf(job) {
  const count = job.bindings.reduce((most, b) => Math.max(most, b.group + 1), 0);
  return Array.from({ length: count }, (_, group) => device.createBindGroupLayout({
    entries: job.bindings.filter((b) => b.group === group).map((b) => ({
      binding: b.binding,
      visibility: GPUShaderStage.COMPUTE,
      buffer: { type: TYPES[b.kind] },
    })),
  }));
}

// ---- Buffers

/** Those of the last job, for the next to reuse: a long run holds no more than its largest job. @type {GPUBuffer[]} */
let spare = [];

/** @param {GPUBuffer[]} used @param {number} size @param {number} usage */
function take(used, size, usage) {
  const at = spare.findIndex((buffer) => buffer.size === size && buffer.usage === usage);
  const buffer = at >= 0 ? spare.splice(at, 1)[0] : device.createBuffer({ size, usage });
  used.push(buffer);
  return buffer;
}

/** @param {Binding} binding */
function usageOf({ kind }) {
  const { UNIFORM, STORAGE, COPY_SRC, COPY_DST } = GPUBufferUsage;
  if (kind === 'uniform') return UNIFORM | COPY_DST;
  return kind === 'read' ? STORAGE | COPY_DST : STORAGE | COPY_DST | COPY_SRC;
}

// ---- Requests

/** @param {Job} job @param {Buffer} bytes */
async function run(job, bytes) {
  const used = [];
  try {
    await dispatch(job, bytes, used);
  } catch (error) {
    used.forEach((buffer) => buffer.destroy());
    throw error;
  }
  spare.forEach((buffer) => buffer.destroy());
  spare = used;
}

/** @param {Job} job @param {Buffer} bytes @param {GPUBuffer[]} used takes the buffers that are made */
async function dispatch(job, bytes, used) {
  const reads = await scoped(async () => {
    const { pipeline, layouts } = await pipelineOf(job);
    let at = 0;
    const buffers = job.bindings.map((binding) => {
      const buffer = take(used, binding.bytes, usageOf(binding));
      device.queue.writeBuffer(buffer, 0, bytes, at, binding.bytes);
      at += binding.bytes;
      return buffer;
    });
    return submit(job, pipeline, layouts, buffers, used);
  });
  await Promise.all(reads.map((read) => read.mapAsync(GPUMapMode.READ)));
  const parts = reads.map((read) => new Uint8Array(read.getMappedRange()));
  send({ outputs: parts.map((part) => part.length) }, parts);
  reads.forEach((read) => read.unmap());
}

/** @returns {GPUBuffer[]} what the shader wrote, where it can be read */
function submit(job, pipeline, layouts, buffers, used) {
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  layouts.forEach((layout, group) => {
    const entries = job.bindings
      .map((b, index) => ({ group: b.group, binding: b.binding, resource: { buffer: buffers[index] } }))
      .filter((entry) => entry.group === group);
    pass.setBindGroup(group, device.createBindGroup({ layout, entries }));
  });
  pass.dispatchWorkgroups(...job.groups);
  pass.end();
  const written = buffers.filter((_, index) => job.bindings[index].kind === 'read_write');
  const reads = written.map((buffer) => {
    const read = take(used, buffer.size, GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST);
    encoder.copyBufferToBuffer(buffer, 0, read, 0, buffer.size);
    return read;
  });
  device.queue.submit([encoder.finish()]);
  return reads;
}

/** @param {any} header @param {Buffer} bytes */
async function answer(header, bytes) {
  if (header.job) return run(header.job, bytes);
  await compile(header.validate);
  send({ valid: true });
}

/** Does what is asked; it ends when the device does. @param {any} header @param {Buffer} bytes */
function answerOrLose(header, bytes) {
  return new Promise((resolve, reject) => {
    endJob = () => reject(new Refusal('lost', loss));
    answer(header, bytes).then(resolve, reject);
  });
}

/** @param {any} error @param {Fault} otherwise */
function report(error, otherwise) {
  send({ error: { fault: error instanceof Refusal ? error.fault : otherwise, message: String(error?.message ?? error) } });
}

// A shader that hangs keeps no process that nobody waits for.
setInterval(() => {
  if (process.ppid !== Number(PARENT)) process.kill(process.pid, 'SIGKILL');
}, 1000);

try {
  await open();
} catch (error) {
  report(error, 'open');
  process.exit(1);
}
for (let request = receive(); request; request = receive()) {
  try {
    await answerOrLose(request.header, request.bytes);
  } catch (error) {
    await new Promise(setImmediate); // A loss may be told after what comes of it.
    report(loss === undefined ? error : new Refusal('lost', loss), 'rejected');
    if (loss !== undefined) process.exit(1);
  }
}
device.destroy();
process.exit(0);
