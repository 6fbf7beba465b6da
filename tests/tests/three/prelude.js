// What a page says of faults, and its picture; put before all other scripts of a page.

const said = [];
for (const level of ['warn', 'error']) {
    console[level] = (...words) => said.push(`${level}: ${words.map(String).join(' ')}`);
}
const send = (name, body) => fetch(`/sent/${name}`, { method: 'POST', body });
const done = () => send('done', JSON.stringify(said));

// What nobody catches ends a page.
const end = (fault) => {
    said.push(fault);
    done();
};
addEventListener('error', (event) => end(`error: ${event.error?.stack ?? event.message ?? event.target?.src}`), true);
addEventListener('unhandledrejection', (event) => end(`rejection: ${event.reason?.stack ?? event.reason}`));

// A browser without a window has nothing to show a canvas of WebGPU on, and ends its driver when it tries; so what a
// page draws to is an ordinary texture.
const drawn = {};
GPUCanvasContext.prototype.configure = function ({ device, format }) {
    Object.assign(drawn, { device, format, canvas: this.canvas, texture: null });
};
GPUCanvasContext.prototype.getCurrentTexture = function () {
    const { width, height } = this.canvas;
    if (drawn.texture?.width !== width || drawn.texture?.height !== height) {
        const usage = GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC | GPUTextureUsage.TEXTURE_BINDING;
        drawn.texture = drawn.device.createTexture({ size: [width, height], format: drawn.format, usage });
    }
    return drawn.texture;
};

// The picture as bytes, red first, alpha left out of account.
async function pixels() {
    const { device, format, texture } = drawn;
    const { width, height } = texture;
    const bytesPerRow = Math.ceil(width * 4 / 256) * 256;
    const buffer = device.createBuffer({ size: bytesPerRow * height, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
    const encoder = device.createCommandEncoder();
    encoder.copyTextureToBuffer({ texture }, { buffer, bytesPerRow }, [width, height]);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const rows = new Uint8Array(buffer.getMappedRange());
    const image = new ImageData(width, height);
    const order = format.startsWith('bgra') ? [2, 1, 0] : [0, 1, 2];
    for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) {
        const from = y * bytesPerRow + 4 * x, to = 4 * (y * width + x);
        order.forEach((channel, i) => { image.data[to + i] = rows[from + channel]; });
        image.data[to + 3] = 255;
    }
    return image;
}

// Sends the picture, and the colour in the middle, once a page has drawn.
async function sendPicture() {
    const image = await pixels();
    const canvas = new OffscreenCanvas(image.width, image.height);
    canvas.getContext('2d').putImageData(image, 0, 0);
    await send('picture.png', await canvas.convertToBlob());
    const middle = 4 * (Math.floor(image.height / 2) * image.width + Math.floor(image.width / 2));
    await send('middle', JSON.stringify([...image.data.slice(middle, middle + 3)]));
    await done();
}
