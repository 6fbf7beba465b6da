// Data comes as scripts, since a page that was opened as a file may load nothing else.

const STAMP = document.documentElement.dataset.stamp;
const handed = new Map();

// What every file in `page/data` calls.
window.lobe_golden = (key, stamp, text) => handed.set(key, { stamp, text });

/** What the file `page/data/KEY.js` hands over. */
function load(key) {
  return new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = `page/data/${key}.js`;
    script.onload = () => {
      script.remove();
      const found = handed.get(key);
      handed.delete(key);
      try {
        resolve(opened(key, found));
      } catch (error) {
        reject(error);
      }
    };
    script.onerror = () => {
      script.remove();
      reject(new Error(`page/data/${key}.js is not there`));
    };
    document.head.append(script);
  });
}

function opened(key, found) {
  if (!found) throw new Error(`page/data/${key}.js is damaged`);
  if (found.stamp !== STAMP) throw new Error(`page/data/${key}.js belongs to another report: write the page again`);
  return JSON.parse(found.text);
}

/** A picture: its size, values a pixel, and the values. `baseOf` gives the values of another slot. */
async function loadPicture(key, baseOf) {
  const { size, channels, base, packed } = await load(key);
  const from = base ? await baseOf(base) : null;
  const values = await unpacked(packed, channels, from);
  if (values.length !== size[0] * size[1] * channels) throw new Error(`page/data/${key}.js is damaged: it has ${values.length} values`);
  return { size, channels, values };
}
