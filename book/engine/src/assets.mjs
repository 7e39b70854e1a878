// The packed files: gzip streams over http; from file://, where nothing can be fetched, scripts with
// the same bytes in base64, `workbookEngineData(name, part, text)`.
const { files } = window.workbookEngineFiles;
const total = Object.values(files).reduce((sum, file) => sum + file.bytes, 0);

export class Assets {
  constructor(base, onProgress) {
    this.base = base;
    this.onProgress = onProgress;
    this.received = 0;
  }

  // The unpacked file as the body of a response.
  async response(name, type = "application/octet-stream") {
    const packed = this.base.startsWith("file:") ? this.#fromScripts(name) : await this.#fetched(name);
    const counted = packed.pipeThrough(new TransformStream({
      transform: (chunk, controller) => {
        this.received += chunk.length;
        this.onProgress(Math.min(this.received / total, 1));
        controller.enqueue(chunk);
      },
    }));
    return new Response(counted.pipeThrough(new DecompressionStream("gzip")), { headers: { "content-type": type } });
  }

  // The browser holds a blob outside of the page's memory, and hands it to a worker without a copy.
  async blob(name) {
    return (await this.response(name)).blob();
  }

  async #fetched(name) {
    const address = `${this.base}${name}.bin?${files[name].sha256.slice(0, 12)}`;
    const response = await fetch(address);
    if (!response.ok) throw new Error(`${address}: ${response.status}`);
    return response.body;
  }

  #fromScripts(name) {
    let part = 0;
    return new ReadableStream({
      pull: async controller => {
        controller.enqueue(await script(this.base, name, part++));
        if (part === files[name].parts) controller.close();
      },
    });
  }
}

const waiting = new Map();

window.workbookEngineData = (name, part, text) => waiting.get(`${name}.${part}`)(decoded(text));

function script(base, name, part) {
  return new Promise((resolve, reject) => {
    waiting.set(`${name}.${part}`, resolve);
    const element = document.createElement("script");
    element.src = `${base}${name}.${part}.js`;
    element.onload = () => element.remove();
    element.onerror = () => reject(new Error(`${element.src} is missing`));
    document.head.append(element);
  });
}

function decoded(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const characters = atob(text), bytes = new Uint8Array(characters.length);
  for (let k = 0; k < characters.length; k++) bytes[k] = characters.charCodeAt(k);
  return bytes;
}
