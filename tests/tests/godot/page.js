// Gives Godot one shader after the other, and sends what it says against each.

let against = [];
let version = '';
const print = (...words) => { version ||= words.join(' '); };
const printError = (...words) => against.push(words.join(' '));
const send = (name, body) => fetch(`/sent/${name}`, { method: 'POST', body });
const end = (fault) => send('done', JSON.stringify({ page: [fault] }));
addEventListener('error', (event) => end(event.message ?? 'an error'), true);
addEventListener('unhandledrejection', (event) => end(String(event.reason?.stack ?? event.reason)));

// What Godot makes of a shader for the driver, where it calls something of the library.
let drawn = [];
const { shaderSource } = WebGL2RenderingContext.prototype;
WebGL2RenderingContext.prototype.shaderSource = function (shader, source) {
    if (source.includes('lobe_')) drawn.push({ context: this, shader, source });
    return shaderSource.call(this, shader, source);
};
const compiled = ({ context, shader }) => context.getShaderParameter(shader, context.COMPILE_STATUS);

const frame = () => new Promise(requestAnimationFrame);
const engine = new Engine({
    args: [], canvasResizePolicy: 0, executable: '/godot/index', fileSizes: {}, focusCanvas: false, gdextensionLibs: [],
});
const canvas = document.querySelector('canvas');
await engine.startGame({ canvas, mainPack: '/godot/index.pck', onPrint: print, onPrintError: printError });
while (!window.GodotShaderViewer?.loadShader) await frame();

const found = {};
const sources = {};
for (const [name, shader] of Object.entries(await (await fetch('/shaders.json')).json())) {
    against = [];
    drawn = [];
    GodotShaderViewer.loadShader(shader);
    // The driver compiles what is drawn.
    for (let i = 0; i < 5; i++) await frame();
    found[name] = against;
    sources[name] = drawn.filter(compiled).map(({ source }) => source).join('\n');
}
await send('version', version);
await send('sources', JSON.stringify(sources));
await send('done', JSON.stringify(found));
