// CPython in a Web Worker: one WebAssembly module, with its files in memory. After a finished turn its
// stack is empty, so that its linear memory is its whole state: an image of it starts another worker.
import { WASI, File, Directory, PreopenDirectory, ConsoleStdout, OpenFile } from "@bjorn3/browser_wasi_shim";

const MEMORY_PAGE = 65536;
const NOT_SUPPORTED = 58;
const ENVIRONMENT = [
  "HOME=/tmp", "TMPDIR=/tmp", "MPLCONFIGDIR=/tmp", "MPLBACKEND=Agg", "NO_COLOR=1",
  "PYTHONHASHSEED=0", "PYTHONDONTWRITEBYTECODE=1", "PYTHONTZPATH=",
];

const codeFile = new File([]), resultFile = new File([]);
const encoder = new TextEncoder(), decoder = new TextDecoder();
let python = null, printed = "";

function put(folder, path, file) {
  const parts = path.split("/").filter(Boolean), name = parts.pop();
  for (const part of parts) {
    if (!folder.has(part)) folder.set(part, new Directory(new Map()));
    folder = folder.get(part).contents;
  }
  folder.set(name, file);
}

const bytesOf = async blob => new Uint8Array(await blob.arrayBuffer());

function fileOf(bytes) {
  const file = new File([], { readonly: true });
  file.data = bytes; // not copied
  return file;
}

// The entries of a tar archive: a header of 512 bytes, the content, zeros up to the next 512.
function* entriesOf(tar) {
  const text = (from, length) => decoder.decode(tar.subarray(from, from + length)).split("\0")[0];
  for (let at = 0; at + 512 <= tar.length && tar[at];) {
    const size = parseInt(text(at + 124, 12), 8), prefix = text(at + 345, 155);
    yield [(prefix && prefix + "/") + text(at, 100), tar.subarray(at + 512, at + 512 + size)];
    at += 512 + Math.ceil(size / 512) * 512;
  }
}

async function boot({ module, stdlib, library, image, script }) {
  const root = new Map([["tmp", new Directory(new Map())]]);
  put(root, "/usr/local/lib/python315.zip", fileOf(await bytesOf(stdlib)));
  for (const [path, bytes] of entriesOf(await bytesOf(library))) put(root, `/library/${path}`, fileOf(bytes));
  put(root, "/run/code.py", codeFile);
  put(root, "/run/result.json", resultFile);
  const output = new ConsoleStdout(bytes => { printed += decoder.decode(bytes, { stream: true }); });
  const wasi = new WASI(["/usr/local/bin/python.wasm"], ENVIRONMENT,
    [new OpenFile(new File([])), output, output, new PreopenDirectory("/", root)], { debug: false });
  const refused = () => NOT_SUPPORTED;
  python = await WebAssembly.instantiate(module, {
    wasi_snapshot_preview1: {
      ...wasi.wasiImport, sched_yield: () => 0,
      sock_recv: refused, sock_send: refused, sock_shutdown: refused, sock_accept: refused,
    },
    host: { call: () => -1 },
  });
  wasi.inst = python;
  if (image) {
    const { memory } = python.exports;
    memory.grow((image.size - memory.buffer.byteLength) / MEMORY_PAGE);
    new Uint8Array(memory.buffer).set(await bytesOf(image));
  } else {
    python.exports._initialize();
    if (turn(script)) throw new Error(`Python did not start: ${printed.trim().split("\n").pop()}`);
  }
}

// Run a text in the interpreter's main namespace; return its exit status.
function turn(text) {
  const bytes = encoder.encode(text), pointer = python.exports.host_alloc(bytes.length) >>> 0;
  new Uint8Array(python.exports.memory.buffer).set(bytes, pointer);
  return python.exports.turn(pointer, bytes.length);
}

function execute(code) {
  codeFile.data = encoder.encode(code);
  resultFile.data = new Uint8Array();
  printed = "";
  const status = turn("execute()");
  if (status) throw new Error(printed.trim().split("\n").pop() || `exit status ${status}`);
  return { stdout: printed, ...JSON.parse(decoder.decode(resultFile.data)) };
}

onmessage = async ({ data: { id, type, ...message } }) => {
  try {
    if (type === "boot") postMessage({ id, value: await boot(message) });
    else if (type === "execute") postMessage({ id, value: execute(message.code) });
    else {
      const image = new Uint8Array(python.exports.memory.buffer).slice();
      postMessage({ id, value: image }, [image.buffer]);
    }
  } catch (error) { // a trap of WebAssembly, after which the memory is worth nothing
    postMessage({ id, failure: `${error.name}: ${error.message}` });
  }
};
