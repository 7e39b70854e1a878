// One worker with one Python in it; both end together.
import workerText from "worker.bundle";

export class Session {
  #asked = 0;
  #waiting = new Map();

  // parts: the module; the blobs stdlib, library and image; the script to start with without an image
  constructor(parts) {
    const address = URL.createObjectURL(new Blob([workerText], { type: "text/javascript" }));
    this.worker = new Worker(address);
    this.worker.onmessage = ({ data: { id, value, failure } }) => {
      const { resolve, reject } = this.#waiting.get(id);
      this.#waiting.delete(id);
      failure === undefined ? resolve(value) : reject(new Error(failure));
    };
    this.worker.onerror = event => this.end(event.message || "the worker failed");
    this.ready = this.ask("boot", parts).finally(() => URL.revokeObjectURL(address));
    this.ready.catch(() => {}); // each run that waits for it gets the error
  }

  ask(type, message = {}) {
    const id = this.#asked++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, type, ...message });
    });
  }

  end(reason) {
    this.worker.terminate();
    for (const { reject } of this.#waiting.values()) reject(new Error(reason));
    this.#waiting.clear();
  }
}
